// The regular triangulation of balls: the weight of a centre is its squared radius. The small ball inside the large one
// is hidden: nowhere in space is it the nearest in power distance |x - p|^2 - r^2.
#include <iostream>

#include "delone/delone.hpp"

int main() {
  const std::vector<std::array<double, 3>> centres{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}, {1, 1, 1.25}};
  std::vector<double> weights;
  for (const double radius : {1.0, 1.0, 1.0, 1.0, 2.0, 0.25}) weights.push_back(radius * radius);

  const auto t = delone::triangulate(centres, weights);
  std::cout << t.vertex_count() << " vertices, " << t.cell_count() << " tetrahedra\n";
  for (delone::Index row = 0; row < t.row_count(); ++row)
    if (t.status(row).status == delone::Status::hidden) std::cout << "ball " << row << " is hidden\n";
}
