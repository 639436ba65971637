// How flat is the input? Exact rank of a point set, the axes on which it stays independent, and rows that span it.
#pragma once

#include <array>
#include <span>

#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"
#include "delone/geometry/sites.hpp"

namespace delone {

struct AffineHull {
  Flat flat;
  std::array<Index, kMaxDimension + 1> basis{};  ///< flat.dimension + 1 affinely independent rows, ascending

  /// Moves the basis to the front of an order of all rows; what stood there takes its places.
  void bring_to_front(std::span<Index> order) const;
};

/// The affine hull of the rows, decided exactly; dimension -1 for no rows.
/// Cost: O(1) determinants when the first rows are independent, O(n) of them for flat input.
AffineHull affine_hull(PointsView points);

/// Dimension of the affine hull: -1 for no points, 0 when all are equal, up to the dimension of the points.
int affine_dimension(PointsView points);

}  // namespace delone
