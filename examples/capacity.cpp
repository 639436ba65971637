// Four schools and the parts of an L-shaped town that walk to them, when each school takes a given share of the town.
#include "delone/apps/capacity.hpp"

#include <cstdio>
#include <vector>

int main() {
  const delone::Region town = delone::Region::polygon({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}});
  const std::vector<double> schools{0.5, 0.5, 1.0, 1.0, 1.0, 3.5, 3.5, 1.5};
  const std::vector<double> shares{5, 4, 2, 1};  // of an area of 12

  const delone::Capacities fit = delone::fit_capacities(delone::PointsView(schools, 2), town, shares);
  std::printf("%s\n", fit.converged ? "converged" : "did not converge");
  for (std::size_t i = 0; i < shares.size(); ++i) {
    std::printf("weight %.3f, area %.6f\n", fit.weights[i], fit.measures[i]);
  }
}
