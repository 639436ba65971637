#include "apps/plain_sites.hpp"

#include <cmath>
#include <string>

#include "delone/base/errors.hpp"

namespace delone {

void require_plain_sites(PointsView sites, const Region& region) {
  if (sites.dimension() != region.dimension()) {
    throw InputError("sites of dimension " + std::to_string(sites.dimension()) + " in a region of dimension " +
                     std::to_string(region.dimension()));
  }
  if (sites.weighted()) throw InputError("sites have no weights here: leave them out");
  require_row_count(sites.size(), sites.dimension());
  require_finite(sites);
}

void require_steps(int steps, double tolerance) {
  if (steps < 0) throw InputError(std::to_string(steps) + " steps: expected 0 or more");
  if (!(tolerance >= 0)) throw InputError("the tolerance is negative or not a number: expected 0 or more");
}

double distance(std::span<const double> a, std::span<const double> b) {
  double length = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) length = std::hypot(length, a[axis] - b[axis]);
  return length;
}

}  // namespace delone
