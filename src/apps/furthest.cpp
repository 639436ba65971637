#include "delone/apps/furthest.hpp"

#include <utility>

#include "build/flip.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"
#include "delone/base/stopwatch.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/export.hpp"
#include "mesh/anew.hpp"
#include "mesh/distinct.hpp"

namespace delone {
namespace {

AnyTriangulation triangulated_by_furthest(PointsView points, const BuildOptions& options) {
  if (affine_dimension(points) < 1) return triangulated(points, 1, {});  // nothing, or one place
  Stopwatch watch;
  DistinctSites sites = distinct_sites(points, Order::random, options.seed, options.threads);
  sites.mesh.statistics.order_seconds = watch.lap();
  build_furthest_by_flips(sites.mesh, sites.count, options.progress);
  sites.mesh.statistics.insert_seconds = watch.lap();
  return finished(std::move(sites.mesh));
}

}  // namespace

FurthestDelaunay furthest_delaunay(PointsView points, const BuildOptions& options) {
  require_row_count(points.size(), points.dimension());
  if (points.weighted()) throw InputError("furthest sites have no weights here");
  require_finite(points);
  const ExactEnvironment environment;
  const AnyTriangulation t = triangulated_by_furthest(points, options);
  FurthestDelaunay result{.affine_dimension = t.affine_dimension(),
                          .cells = cells(t),
                          .polytopes = merged_cells(t),
                          .status = {},
                          .hull_facets = t.hull_facet_count(),
                          .memory_bytes = t.memory_bytes(),
                          .statistics = t.statistics()};
  result.status.reserve(points.size());
  for (std::size_t row = 0; row < points.size(); ++row) result.status.push_back(t.status(static_cast<Index>(row)));
  return result;
}

}  // namespace delone
