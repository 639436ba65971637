// What shapes measure.
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "delone/dual/clip.hpp"

namespace delone::dual_detail {

/// Coordinates of the site of a cell as its corners are seen; those beyond the dimension are 0.
using SiteOfCell = std::function<std::array<double, 3>(std::size_t cell)>;

/// Appends the measures of all cells of `shapes`. Each is taken from the first corner of its cell, so that none drowns
/// in the distance of the cell from the origin.
void append_measures(const CellShapes& shapes, const SiteOfCell& site, CellMeasures& measures);

}  // namespace delone::dual_detail
