#include "delone/geometry/points.hpp"

#include <array>
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

std::size_t max_row_count(int dimension) {
  // Facets per point of random points: 2 (1D), 6 (2D), 27.1 (3D); from 4D on 159 and more, measured.
  constexpr std::array<double, kMaxDimension> kFacetsPerPoint{2.0, 6.0, 27.1, 159.0, 1100.0, 8600.0, 75000.0, 720000.0};
  return static_cast<std::size_t>(static_cast<double>(kNone) /
                                  kFacetsPerPoint[static_cast<std::size_t>(dimension - 1)]);
}

void require_row_count(std::size_t rows, int dimension) {
  if (rows > max_row_count(dimension)) {
    throw InputError(std::to_string(rows) + " points in dimension " + std::to_string(dimension) +
                     ": ids of this build name at most " + std::to_string(max_row_count(dimension)) +
                     ", build with 64-bit ids (DELONE_WIDE_IDS)");
  }
}

}  // namespace delone
