// Points in, a mesh out: the default method for each kind of input.
//   few, in 2D without weights, 3D  gift wrapping, where the processor has the instructions for it
//   in the plane, without weights   divide and conquer, whose parts need nothing of each other
//   else                            insertion one by one along a curve, for many points by several threads
#pragma once

#include <span>

#include "delone/base/progress.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"
#include "mesh/plane_cuts.hpp"

namespace delone {

/// The triangulation of `points` in the flat that they span. It does not depend on the number of threads, but the
/// numbers of its cells do, and which of several equal sites is the vertex.
/// @throws Cancelled when `progress` says so; std::bad_alloc
Mesh triangulate_points(PointsView points, int threads, const Progress& progress);

/// The triangulation of points in a plane, without weights, by divide and conquer. @throws as above
Mesh triangulate_plane(PointsView points, const Flat& flat, int threads, const Progress& progress);

/// The same along cuts on the two axes of their flat. Where all lie on a line it has ghosts only, where all stand at
/// one place no cell. @throws as above
Mesh triangulate_plane(PointsView points, const Flat& flat, const CutPlan& plan, int threads, const Progress& progress);

/// The triangulation of some sites; row i of it is sites[i].
Mesh triangulate_sites(const Sites& all, std::span<const VertexId> sites);

}  // namespace delone
