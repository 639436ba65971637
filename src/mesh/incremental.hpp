// The loop of the incremental method, one instantiation per dimension.
#pragma once

#include <cstddef>
#include <span>

#include "delone/base/progress.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// The triangulation of `points`, ordered along a curve, in the flat that they span.
/// @throws Cancelled when `progress` says so; std::bad_alloc
Mesh triangulate_points(PointsView points, int threads, const Progress& progress);

/// The triangulation of some sites; row i of it is sites[i].
Mesh triangulate_sites(const Sites& all, std::span<const VertexId> sites, int threads = 1);

/// Makes the first simplex from sites 0 to k of a mesh without cells, then inserts all other sites in their order.
/// @throws Cancelled when `progress` says so; std::bad_alloc. The mesh is then half-built: callers work on their own.
void insert_all(Mesh& mesh, const Progress& progress);

/// Inserts the sites from `first` on, in their order, into a mesh that has cells.
void insert_from(Mesh& mesh, std::size_t first, const Progress& progress);

/// From now on the mesh knows which cell holds each hidden site. Cost of the first call: a walk per hidden site.
void keep_hidden_sites(Mesh& mesh);

}  // namespace delone
