// Sites that were thrown into a corner of a square spread over it: each goes to the centroid of its cell, many times.
#include "delone/apps/relax.hpp"

#include <cstdio>
#include <vector>

int main() {
  const std::vector<double> low{0, 0};
  const std::vector<double> high{4, 4};
  const delone::Region square = delone::Region::box(low, high);
  const std::vector<double> sites{0.1, 0.1, 0.9, 0.2, 0.2, 0.8, 1.0, 1.1};

  const delone::Relaxed relaxed =
      delone::relax(delone::PointsView(sites, 2), square, {.steps = 500, .tolerance = 1e-9});
  std::printf("energy %.3f at first, %.3f in the end\n", relaxed.energy.front(), relaxed.energy.back());
  for (std::size_t i = 0; i < relaxed.coordinates.size(); i += 2) {
    std::printf("%.3f %.3f\n", relaxed.coordinates[i], relaxed.coordinates[i + 1]);
  }
}
