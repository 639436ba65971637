// Walk over cells and their neighbours: column i of `neighbours` is the cell across the facet opposite vertex i.
// The points are the corners of a cube: one of the many ways to cut it into tetrahedra is chosen by a fixed rule.
#include <array>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/mesh/export.hpp"

int main() {
  std::vector<std::array<double, 3>> corners;
  for (const double x : {0, 1})
    for (const double y : {0, 1})
      for (const double z : {0, 1}) corners.push_back({x, y, z});
  const auto t = delone::build(delone::PointsView(std::span(std::as_const(corners))));

  const auto table = delone::cells(t);
  for (std::size_t c = 0; c < table.size(); ++c) {
    std::cout << "tetrahedron " << c << ':';
    for (const delone::Index vertex : table[c]) std::cout << ' ' << vertex;
    std::cout << "  neighbours:";
    for (std::size_t i = 0; i < 4; ++i) {
      const delone::Index across = table.neighbours[4 * c + i];
      std::cout << ' ' << (across == delone::kNone ? "-" : std::to_string(across));
    }
    std::cout << '\n';
  }
  std::cout << "one polytope: " << (delone::merged_cells(t).size() == 1 ? "yes" : "no") << '\n';
}
