// What must hold for every triangulation, tried on one.
#pragma once

#include <string>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/mesh/triangulation.hpp"
#include "support/families.hpp"

namespace delone::test {

AnyTriangulation built(const PointSet& points);

/// Everything a user can see: cells, hull facets, merged cells, the status of every row and the hash, as one text.
std::string description(const AnyTriangulation& t);

/// The first invariant of the complex that is broken (I1 to I4, incidence, counts), or an empty text.
/// Orientation is decided by integers of any size.
std::string broken_invariant(const AnyTriangulation& t);

/// The first disagreement with trying every subset: affine dimension, cells, statuses; or an empty text.
std::string differs_from_brute_force(const AnyTriangulation& t, const PointSet& points);

/// The first violation that the exact check finds, the canonical choice among ties included, or a disagreement about
/// counts; or an empty text.
std::string fails_check(const AnyTriangulation& t, const PointSet& points);

/// The cells as ascending rows, sorted.
std::vector<std::vector<Index>> sorted_cells(const AnyTriangulation& t);

}  // namespace delone::test
