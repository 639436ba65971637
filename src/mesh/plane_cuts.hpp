// Which cuts of the plane leave divide and conquer little to do in vain.
//
// A part is triangulated for nothing where its cells do not outlive the merges to come. Of points that fill an area,
// boxes lose little [Dwyer87]. Of points on a closed curve they lose all: a piece of a curve, alone, is triangulated
// otherwise than beside the piece across from it, level after level. Strips hold both, if they lie across the curve,
// and lose next to nothing. But of points that fill an area strips lose all while they are thin.
#pragma once

#include "delone/geometry/affine.hpp"
#include "delone/geometry/points.hpp"
#include "delone/order/brio.hpp"

namespace delone {

/// Cuts of points that span the plane `hull`, on the two axes of its flat: into boxes, or into strips across either
/// axis if a sample of many points is triangulated with far fewer cells by these. Cost: O(n), and 1 % of what follows.
CurveCuts plane_cuts(PointsView points, const AffineHull& hull, int threads);

}  // namespace delone
