// The regular triangulation of balls: the weight of a centre is its squared radius. The small ball in the middle of the
// large one is hidden: nothing in space is closer to it in power distance.
#include <array>
#include <iostream>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/mesh/export.hpp"

int main() {
  const std::vector<std::array<double, 3>> centres{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}, {1, 1, 1.25}};
  const std::vector<double> radii{1, 1, 1, 1, 2, 0.25};
  std::vector<double> weights;
  for (const double r : radii) weights.push_back(r * r);

  const auto t = delone::build(delone::PointsView(std::span(centres), weights));
  std::cout << t.vertex_count() << " vertices, " << t.cell_count() << " tetrahedra\n";
  for (delone::Index row = 0; row < t.row_count(); ++row)
    if (t.status(row).status == delone::Status::hidden) std::cout << "ball " << row << " is hidden\n";
}
