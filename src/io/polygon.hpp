// The boundary of a convex polygon given as a set of points of the plane, decided exactly.
#pragma once

#include <span>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone::io {

/// +1 if a, b, c turn left, -1 if right, 0 exactly if collinear; for any finite doubles.
int turn(std::span<const double, 2> a, std::span<const double, 2> b, std::span<const double, 2> c);

/// Appends the rows of `polygon` that lie on the boundary of their convex hull, counter-clockwise from the
/// lexicographically smallest point. Points within an edge are kept: a neighbour may have its corner there.
void append_polygon(std::span<const double> coordinates, std::span<const Index> polygon, std::vector<Index>& boundary);

}  // namespace delone::io
