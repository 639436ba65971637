#include "delone/build/build.hpp"

#include <span>
#include <utility>

#include "build/conflict_graph.hpp"
#include "build/flip.hpp"
#include "build/gift_wrap.hpp"
#include "build/history_simplices.hpp"
#include "build/lawson.hpp"
#include "build/shelling.hpp"
#include "build/sweep.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/stopwatch.hpp"
#include "delone/geometry/affine.hpp"
#include "mesh/anew.hpp"
#include "mesh/distinct.hpp"
#include "mesh/incremental.hpp"
#include "mesh/triangulate.hpp"

namespace delone {
namespace {

Order usual_order(Method method) { return method == Method::cavity ? Order::brio : Order::random; }

void build_cells(Mesh& mesh, std::size_t count, const BuildOptions& options) {
  switch (options.method) {
    case Method::automatic:
    case Method::divide_conquer:
    case Method::cavity:
      return insert_first(mesh, count, options.progress);
    case Method::flip:
      return build_by_flips(mesh, count, FlipForm::stack, options.progress);
    case Method::flip_loop:
      return build_by_flips(mesh, count, FlipForm::loop, options.progress);
    case Method::flip_legalize:
      return build_by_flips(mesh, count, FlipForm::legalize, options.progress);
    case Method::history_simplices:
      return build_by_history_simplices(mesh, count, options.progress);
    case Method::conflict_graph:
      return build_by_conflict_graph(mesh, count, options.progress);
    case Method::lawson:
      return build_by_lawson(mesh, count, options.progress);
    case Method::sweep:
      return build_by_sweep(mesh, count, options.progress);
    case Method::gift_wrap:
      return build_by_gift_wrapping(mesh, count, options.progress);
    case Method::shelling:
      return build_by_shelling(mesh, count, options.progress);
  }
}

Mesh divided(PointsView points, const Flat& flat, const BuildOptions& options) {
  if (options.order == Order::automatic) return triangulate_plane(points, flat, options.threads, options.progress);
  const auto cut = options.order == Order::hilbert ? curve_cuts : strip_cuts;
  const CutPlan plan{cut(points, std::span(flat.axes).first(2), options.threads)};
  return triangulate_plane(points, flat, plan, options.threads, options.progress);
}

AnyTriangulation built_by_method(PointsView points, const BuildOptions& options) {
  Stopwatch watch;
  const Order order = options.order == Order::automatic ? usual_order(options.method) : options.order;
  DistinctSites sites = distinct_sites(points, order, options.seed, options.threads);
  sites.mesh.statistics.order_seconds = watch.lap();
  build_cells(sites.mesh, sites.count, options);
  sites.mesh.statistics.insert_seconds = watch.lap();
  return finished(std::move(sites.mesh));
}

}  // namespace

AnyTriangulation build(PointsView points, const BuildOptions& options) {
  require_row_count(points.size(), points.dimension());
  require_served(options.method, points.dimension(), points.weighted());
  require_ordered(options.method, options.order);
  require_finite(points);
  const ExactEnvironment environment;
  if (options.method == Method::automatic && options.order == Order::automatic) {
    return triangulated(points, options.threads, options.progress);
  }
  const AffineHull hull = affine_hull(points);
  if (hull.flat.dimension < info(options.method).least_dimension) {
    return triangulated(points, options.threads, options.progress);
  }
  if (options.method == Method::divide_conquer) return finished(divided(points, hull.flat, options));
  return built_by_method(points, options);
}

}  // namespace delone
