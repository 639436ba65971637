#include "mesh/triangulate.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "delone/base/stopwatch.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/order/brio.hpp"
#include "mesh/divide_conquer.hpp"
#include "mesh/in_parts.hpp"
#include "mesh/incremental.hpp"
#include "mesh/wrap_few.hpp"

namespace delone {

Mesh triangulate_points(PointsView points, int threads, const Progress& progress) {
  Stopwatch watch;
  const AffineHull hull = affine_hull(points);
  if (std::optional<Mesh> mesh = wrap_few(points, hull, progress)) {
    mesh->statistics.insert_seconds = watch.lap();
    return *std::move(mesh);
  }
  const std::span axes = std::span(hull.flat.axes).first(static_cast<std::size_t>(std::max(hull.flat.dimension, 0)));
  if (axes.size() == 2 && !points.weighted()) {
    const double seconds = watch.lap();
    Mesh mesh = triangulate_plane(points, hull.flat, threads, progress);
    mesh.statistics.order_seconds += seconds;
    return mesh;
  }
  Mesh mesh(Sites(points.dimension(), points.weighted(), hull.flat));
  Buffer<Index> order = brio_order(points, axes, threads);
  const std::vector<std::size_t> rounds = round_ends(order, static_cast<int>(axes.size()));
  hull.bring_to_front(order);
  mesh.sites.append(points, order, 0, threads);
  mesh.statistics.order_seconds = watch.lap();
  insert_all_in_rounds(mesh, rounds, threads, progress);
  mesh.statistics.insert_seconds = watch.lap();
  return mesh;
}

Mesh triangulate_plane(PointsView points, const Flat& flat, int threads, const Progress& progress) {
  Stopwatch watch;
  const CutPlan plan = plane_cuts(points, flat, threads);
  const double seconds = watch.lap();
  Mesh mesh = triangulate_plane(points, flat, plan, threads, progress);
  mesh.statistics.order_seconds += seconds;
  return mesh;
}

Mesh triangulate_plane(PointsView points, const Flat& flat, const CutPlan& plan, int threads,
                       const Progress& progress) {
  Stopwatch watch;
  Mesh mesh(Sites(points.dimension(), false, flat));
  mesh.sites.append(points, plan.cuts.order, 0, threads);
  mesh.statistics.order_seconds = watch.lap();
  divide_and_conquer(mesh, {plan.cuts.cut.data(), plan.cuts.cut.size()}, plan.in_chains, threads, progress,
                     piece_size(mesh.sites.size(), plan.in_chains));
  mesh.statistics.insert_seconds = watch.lap();
  return mesh;
}

Mesh triangulate_sites(const Sites& all, std::span<const VertexId> sites) {
  const auto d = static_cast<std::size_t>(all.dimension());
  std::vector<double> coordinates(sites.size() * d);
  std::vector<double> weights;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    all.copy_point(sites[i], std::span(coordinates).subspan(i * d, d));
    if (all.weighted()) weights.push_back(all.weight(sites[i]));
  }
  return triangulate_points(PointsView(coordinates, all.dimension(), weights), 1, {});
}

}  // namespace delone
