// The loop of the incremental method, one instantiation per dimension.
#pragma once

#include <cstddef>

#include "delone/base/progress.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Makes the first simplex from sites 0 to k of a mesh without cells, then inserts all other sites in their order.
/// @throws Cancelled when `progress` says so; std::bad_alloc. The mesh is then half-built: callers work on their own.
void insert_all(Mesh& mesh, const Progress& progress);

/// The same for sites 0 to count - 1 only.
void insert_first(Mesh& mesh, std::size_t count, const Progress& progress);

/// Inserts sites first to last - 1, in their order, into a mesh that has cells.
void insert_range(Mesh& mesh, std::size_t first, std::size_t last, const Progress& progress);

/// From now on the mesh knows which cell holds each hidden site. Cost of the first call: a walk per hidden site.
void keep_hidden_sites(Mesh& mesh);

}  // namespace delone
