// Triangulate the sorted sites of a plane, then flip edges until all are locally Delaunay.
// Source: [For92] 4.2.
#pragma once

#include <cstddef>

#include "delone/base/progress.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Triangulates sites 0 to count - 1 of a mesh without cells as distinct_sites makes it.
/// @throws Cancelled when `progress` says so; std::bad_alloc
void build_by_lawson(Mesh& mesh, std::size_t count, const Progress& progress);

}  // namespace delone
