// Build a triangulation from points: the main verb.
#pragma once

#include <cstdint>

#include "delone/base/progress.hpp"
#include "delone/build/method.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// None of these changes the triangulation.
struct BuildOptions {
  int threads = 1;         ///< share the work where points are many and the method can
  Progress progress = {};  ///< told of progress, may cancel
  Method method = Method::automatic;
  Order order = Order::automatic;  ///< of insertion, where the method inserts one by one
  std::uint64_t seed = 1;          ///< of random orders
};

/// The Delaunay triangulation of `points`, or with weights the regular triangulation.
/// Points that lie in a flat of a dimension which the method does not serve are triangulated by the automatic one.
/// @throws InputError for NaN, infinity, too many rows, a method that does not serve these points or takes no order,
/// before any work; Cancelled; std::bad_alloc
AnyTriangulation build(PointsView points, const BuildOptions& options = {});

/// The same with the dimension known to the compiler.
template <int D>
Triangulation<D> build(PointsView points, const BuildOptions& options = {}) {
  return Triangulation<D>(build(points, options));
}

}  // namespace delone
