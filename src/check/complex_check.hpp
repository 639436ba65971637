// The checks that need the dimension K of the complex. Every cell has K + 1 corners, ascending.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "check/affine_hull.hpp"
#include "check/violations.hpp"
#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"

namespace delone::check_detail {

struct ComplexInput {
  PointsView points;
  AffineHull hull;
  std::span<const Index> cells;   ///< rows in range, ascending and distinct within each cell; at least one cell
  std::span<const Index> strays;  ///< rows that are at the position of no vertex: they must be redundant
  bool canonical = false;
  bool furthest = false;
  int threads = 1;
};

/// @return the number of facets that lie in one cell only
template <int K>
std::size_t check_complex(const ComplexInput& input, Violations& violations);

}  // namespace delone::check_detail
