// The flat that points span, decided by integers of any size.
#pragma once

#include <array>

#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"

namespace delone::check_detail {

/// `axes` lists all axes of the input: first the `dimension` ones on which the points stay independent, chosen greedily
/// from axis 0 on, then the others; both ascending.
struct AffineHull {
  int dimension = -1;
  std::array<int, kMaxDimension> axes{};
};

/// Cost: constant for points that soon span everything, else n * k * D products.
AffineHull affine_hull(PointsView points);

}  // namespace delone::check_detail
