// Cells in the order in which a line crosses their lifted hyperplanes, in any dimension, with weights.
// Source: [For92] 4.6 and [ES96] 3 and 10, after Seidel.
#pragma once

#include <cstddef>

#include "delone/base/progress.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Triangulates sites 0 to count - 1 of a mesh without cells as distinct_sites makes it.
/// @throws Cancelled when `progress` says so; std::bad_alloc
void build_by_shelling(Mesh& mesh, std::size_t count, const Progress& progress);

}  // namespace delone
