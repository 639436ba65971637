#include "delone/geometry/points.hpp"

#include <cmath>
#include <string>

#include "delone/base/ids.hpp"

namespace delone {

PointsView::PointsView(std::span<const double> coordinates, int dimension, std::span<const double> weights)
    : coordinates_(coordinates), weights_(weights), dimension_(dimension) {
  if (dimension < 1 || dimension > kMaxDimension) {
    throw InputError("dimension " + std::to_string(dimension) + ": expected 1 to " + std::to_string(kMaxDimension));
  }
  const auto d = static_cast<std::size_t>(dimension);
  if (coordinates.size() % d != 0) {
    throw InputError(std::to_string(coordinates.size()) + " coordinates do not make whole rows of " +
                     std::to_string(dimension));
  }
  size_ = coordinates.size() / d;
  if (!weights.empty() && weights.size() != size_) {
    throw InputError(std::to_string(weights.size()) + " weights for " + std::to_string(size_) +
                     " points: expected one per point, or none");
  }
}

void require_finite(PointsView points) {
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (std::size_t axis = 0; axis < points[row].size(); ++axis) {
      if (!std::isfinite(points[row][axis])) {
        throw InputError("row " + std::to_string(row) + ", column " + std::to_string(axis) +
                         ": coordinate is not finite");
      }
    }
    if (!std::isfinite(points.weight(row))) {
      throw InputError("row " + std::to_string(row) + ": weight is not finite");
    }
  }
}

}  // namespace delone
