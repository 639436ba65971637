// Rings of a polygon: refused where they cross, turned so that the region lies to their left.
#pragma once

#include <vector>

#include "delone/dual/region.hpp"

namespace delone::dual_detail {

/// @throws InputError naming ring and corner, both counted from 0: too few corners, a number that is not finite, a
/// corner
///         on an edge, edges that cross or lie on each other, rings that cross at a common corner
/// Exact. Cost O(m log m) plus the pairs of edges that overlap along the x axis.
void require_simple(const std::vector<Ring>& rings);

/// Of simple rings: counter-clockwise where an even number of others goes around, else clockwise.
void orient_rings(std::vector<Ring>& rings);

}  // namespace delone::dual_detail
