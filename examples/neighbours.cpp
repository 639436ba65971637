// Walk over cells and their neighbours: column i of `neighbours` is the cell across the facet opposite vertex i.
// The points are the corners of a cube. All eight lie on one sphere, so there are many ways to cut it into tetrahedra;
// the tie rule cuts it from the lexicographically smallest corner, and `merged_cells` gives the uncut cube back.
#include <iostream>
#include <string>

#include "delone/delone.hpp"

int main() {
  std::vector<std::array<double, 3>> corners;
  for (const double x : {0, 1})
    for (const double y : {0, 1})
      for (const double z : {0, 1}) corners.push_back({x, y, z});
  const auto t = delone::triangulate(corners);

  const delone::CellTable table = delone::cells(t);
  for (std::size_t c = 0; c < table.size(); ++c) {
    std::cout << "tetrahedron " << c << ':';
    for (const delone::Index row : table[c]) std::cout << ' ' << row;
    std::cout << "  neighbours:";
    for (std::size_t i = 0; i < 4; ++i) {
      const delone::Index across = table.neighbours[4 * c + i];
      std::cout << ' ' << (across == delone::kNone ? "-" : std::to_string(across));
    }
    std::cout << '\n';
  }
  std::cout << "polytopes: " << delone::merged_cells(t).size() << ", with " << delone::merged_cells(t)[0].size()
            << " corners\n";
}
