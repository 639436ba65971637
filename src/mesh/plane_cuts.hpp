// Which cuts of the plane leave divide and conquer little to do in vain.
//
// A part is triangulated for nothing where its cells do not outlive the merges to come. Of points that fill an area,
// boxes lose little [Dwyer87]. Of points on a curve they lose nearly all: a piece of a curve alone is triangulated
// otherwise than beside the piece that it faces, level after level. Strips hold both pieces if the curve is its own
// image in a coordinate axis, as an ellipse or a parabola that is not turned, or two walls of a corridor along it; then
// they lose next to nothing. Other curves gain nothing, and of points that fill an area strips lose all while they are
// thin. So a sample is tried. Where boxes and strips lose much, pieces of curves are knit from one end to the other
// (divide_conquer.cpp).
#pragma once

#include "delone/geometry/points.hpp"
#include "delone/geometry/sites.hpp"
#include "delone/order/brio.hpp"

namespace delone {

/// How divide and conquer goes about some points.
struct CutPlan {
  CurveCuts cuts;
  bool in_chains = false;  ///< whether it looks for boxes whose points lie along a line
};

/// Cuts of points that span a plane, on the two axes of their flat: into boxes, or, if a sample of many points is
/// triangulated with many cells by these, into strips across the axis that needs few, if one does. Cost: O(n), and that
/// of triangulating the sample, at most 2,048 points and a sixty-fourth of all, once, or up to three times if boxes do
/// badly.
CutPlan plane_cuts(PointsView points, const Flat& flat, int threads);

}  // namespace delone
