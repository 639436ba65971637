// Voronoi cells: the diagram itself, and the cells within a polygon with a hole.
#include <iostream>

#include "delone/delone.hpp"
#include "delone/dual/clip.hpp"
#include "delone/dual/voronoi.hpp"

int main() {
  const std::vector<std::array<double, 2>> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {9, 2}};
  const auto t = delone::triangulate(points);

  const delone::Diagram diagram(t);
  for (std::size_t v = 0; v < diagram.vertex_count(); ++v) {
    std::cout << "vertex " << diagram.vertices()[2 * v] << ' ' << diagram.vertices()[2 * v + 1] << " between rows";
    for (const delone::Index row : diagram.vertex_sites()[v]) std::cout << ' ' << row;
    std::cout << '\n';
  }
  std::cout << diagram.ray_count() << " rays, " << diagram.faces(1).size() << " edges\n";

  const delone::Ring land{{-2, -2}, {12, -2}, {12, 6}, {-2, 6}};
  const delone::Ring lake{{1, 1}, {3, 1}, {3, 3}, {1, 3}};
  const delone::CellMeasures cells = delone::measure_cells(t, delone::Region::polygon({land, lake}));
  for (std::size_t row = 0; row < cells.size(); ++row) {
    std::cout << "row " << row << ": area " << cells.volume[row] << ", neighbours";
    for (std::size_t e = cells.offsets[row]; e < cells.offsets[row + 1]; ++e)
      std::cout << ' ' << cells.neighbours[e] << " (" << cells.shared[e] << ')';
    std::cout << '\n';
  }
}
