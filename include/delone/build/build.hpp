// Build a triangulation from points: the main verb.
#pragma once

#include "delone/base/progress.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

struct BuildOptions {
  int threads = 1;         ///< share the work where points are many. Never changes the triangulation
  Progress progress = {};  ///< told of progress, may cancel
};

/// The Delaunay triangulation of `points`, or with weights the regular triangulation.
/// @throws InputError for NaN, infinity or too many rows, before any work; Cancelled; std::bad_alloc
AnyTriangulation build(PointsView points, const BuildOptions& options = {});

/// The same with the dimension known to the compiler.
template <int D>
Triangulation<D> build(PointsView points, const BuildOptions& options = {}) {
  return Triangulation<D>(build(points, options));
}

}  // namespace delone
