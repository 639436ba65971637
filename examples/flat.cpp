// Flat input is legal: these points of space lie on the plane x + y + z = 2, so their triangulation has triangles.
// Orientation is taken on the axes that stay independent; distances are those of space.
#include <iostream>

#include "delone/delone.hpp"

int main() {
  const std::vector<std::array<double, 3>> points{{0, 0, 2}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0.5, 0.5, 1}};
  const auto t = delone::triangulate(points);
  std::cout << "dimension " << t.dimension() << ", affine dimension " << t.affine_dimension() << '\n';

  const delone::CellTable triangles = delone::cells(t);
  for (std::size_t c = 0; c < triangles.size(); ++c)
    std::cout << triangles[c][0] << ' ' << triangles[c][1] << ' ' << triangles[c][2] << '\n';
}
