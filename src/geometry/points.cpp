#include "delone/geometry/points.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "delone/base/ids.hpp"

namespace delone {
namespace {

/// Looks at all, without a branch for each.
bool all_finite(std::span<const double> numbers) {
  constexpr std::uint64_t kExponent = std::uint64_t{0x7FF} << 52;
  bool all = true;
  for (const double x : numbers) all &= (std::bit_cast<std::uint64_t>(x) & kExponent) != kExponent;
  return all;
}

}  // namespace

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
  if (all_finite(points.coordinates()) && all_finite(points.weights())) return;
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
  // Of random points: 1 (1D), 2 (2D), 6.775 (3D); from 4D on measured. The ids of its facets are rounded up to a power
  // of two.
  constexpr std::array<double, kMaxDimension> kCellsPerPoint{1.0, 2.0, 6.775, 31.8, 183.0, 1230.0, 9400.0, 80000.0};
  const auto ids = static_cast<double>(std::bit_ceil(static_cast<unsigned>(dimension + 1)));
  return static_cast<std::size_t>(static_cast<double>(kNone) /
                                  (ids * kCellsPerPoint[static_cast<std::size_t>(dimension - 1)]));
}

void require_row_count(std::size_t rows, int dimension) {
  if (rows > max_row_count(dimension)) {
    throw InputError(std::to_string(rows) + " points in dimension " + std::to_string(dimension) +
                     ": ids of this build name at most " + std::to_string(max_row_count(dimension)) +
                     ", build with 64-bit ids (DELONE_WIDE_IDS)");
  }
}

}  // namespace delone
