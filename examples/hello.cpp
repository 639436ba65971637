// The README's program: points in, exact triangles out. Row 5 repeats row 1, and the answer says so.
#include <iostream>

#include "delone/delone.hpp"

int main() {
  const std::vector<std::array<double, 2>> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {2, 0}};
  const delone::Triangulation<2> t = delone::triangulate(points);

  const delone::CellTable triangles = delone::cells(t);
  for (std::size_t c = 0; c < triangles.size(); ++c)
    std::cout << triangles[c][0] << ' ' << triangles[c][1] << ' ' << triangles[c][2] << '\n';

  std::cout << t.duplicate_count() << " duplicate: row 5 repeats row " << t.status(5).of << '\n';
}
