// Regions made from the points that they are to hold.
#pragma once

#include "delone/apps/hull.hpp"
#include "delone/dual/region.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

/// The bounding box of the points, wider on every side by `margin` times its longest side; by 1 where they are all at
/// one place. Every point is inside, be the margin smaller than the rounding of the coordinates.
/// @throws InputError unless there are points, finite ones of dimension 2 or 3, and the box is within the range of
/// doubles
Region region_around(PointsView points, double margin = 0.1);

/// The convex hull of the points: in the plane its corners as they are, in space its faces, moved outwards where
/// rounding would leave a corner outside.
/// @throws InputError unless the points are finite and span the plane or space; Cancelled; std::bad_alloc
Region hull_region(PointsView points, const HullOptions& options = {});

}  // namespace delone
