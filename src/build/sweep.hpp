// A line sweeps the plane upwards, and what lies below is triangulated.
// Source: [For92] 4.5.
#pragma once

#include <cstddef>

#include "delone/base/progress.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Triangulates sites 0 to count - 1 of a mesh without cells as distinct_sites makes it.
/// @throws Cancelled when `progress` says so; std::bad_alloc
void build_by_sweep(Mesh& mesh, std::size_t count, const Progress& progress);

}  // namespace delone
