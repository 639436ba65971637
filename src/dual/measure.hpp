// What shapes measure.
#pragma once

#include <vector>

#include "delone/dual/clip.hpp"
#include "dual/polytope.hpp"

namespace delone::dual_detail {

/// Appends the measures of all cells of `shapes`. Each is taken from the first corner of its cell, so that none drowns
/// in the distance of the cell from the origin.
/// @param sites  one per cell, seen as the corners are
void append_measures(const CellShapes& shapes, const std::vector<Point3>& sites, CellMeasures& measures);

}  // namespace delone::dual_detail
