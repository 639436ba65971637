// Triangulate points of the plane and print the cells. Row 5 repeats row 1, and every row says what became of it.
#include <array>
#include <iostream>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/mesh/export.hpp"

int main() {
  const std::vector<std::array<double, 2>> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {2, 0}};
  const auto t = delone::build(delone::PointsView(std::span(points)));

  const auto table = delone::cells(t);
  for (std::size_t c = 0; c < table.size(); ++c)
    std::cout << "triangle " << table[c][0] << ' ' << table[c][1] << ' ' << table[c][2] << '\n';

  for (delone::Index row = 0; row < t.row_count(); ++row)
    if (const auto s = t.status(row); s.status == delone::Status::duplicate)
      std::cout << "row " << row << " repeats row " << s.of << '\n';
}
