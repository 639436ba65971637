#include "mesh/incremental.hpp"

#include <algorithm>
#include <vector>

#include "delone/base/dispatch.hpp"
#include "delone/base/errors.hpp"
#include "delone/base/stopwatch.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/order/brio.hpp"
#include "mesh/divide_conquer.hpp"
#include "mesh/halves.hpp"

namespace delone {
namespace {

/// Cells that a uniform set of n points needs, for one reservation up front; beyond dimension 3 too many to promise.
std::size_t expected_cells(int k, std::size_t n) { return k <= 3 ? (k == 3 ? 7 * n : 2 * n) + 64 : 64; }

template <int K>
void insert_sites(Mesh& mesh, std::size_t first, const Progress& progress) {
  Inserter<K> inserter(mesh);
  CellId near = mesh.complex.incident_cell(kGhost);
  for (std::size_t i = first; i < mesh.sites.size(); ++i) {
    tell(progress, i - first, mesh.sites.size() - first);
    inserter.insert(VertexId{static_cast<Index>(i)}, near);
    near = inserter.last_cell();
  }
}

template <int K>
void find_hidden_sites(Mesh& mesh) {
  const ComplexView<K> complex(mesh.complex);
  Kernel<K> kernel(mesh.sites);
  mesh.hidden.reserve(mesh.sites.size(), mesh.complex.slot_count());
  WalkStats walked;
  CellId near = complex.incident_cell(kGhost);
  for (std::size_t i = 0; i < mesh.sites.size(); ++i) {
    const VertexId v{static_cast<Index>(i)};
    if (complex.has_vertex(v) || mesh.sites.is_empty(v) || mesh.duplicates.vertex_of(v) != kGhost) continue;
    near = walk(complex, kernel, kernel.at(v), near, walked);
    mesh.hidden.add(v, near);
  }
}

/// Moves `rows` to the front, which become the first simplex, and leaves the others in their order.
void bring_to_front(std::vector<Index>& order, std::span<const Index> rows) {
  auto kept = order.end();
  for (auto i = order.end(); i != order.begin();) {
    if (std::ranges::find(rows, *--i) == rows.end()) *--kept = *i;
  }
  std::ranges::copy(rows, order.begin());
}

}  // namespace

Mesh triangulate_points(PointsView points, int threads, const Progress& progress) {
  Stopwatch watch;
  const AffineHull hull = affine_hull(points);
  const std::span axes = std::span(hull.flat.axes).first(static_cast<std::size_t>(std::max(hull.flat.dimension, 0)));
  const bool plane = axes.size() == 2 && !points.weighted();
  if (!plane) {
    if (auto mesh = triangulate_in_halves(points, axes, threads, progress)) return std::move(*mesh);
  }
  Mesh mesh(Sites(points.dimension(), points.weighted(), hull.flat));
  const std::span basis = std::span(hull.basis).first(points.empty() ? 0 : axes.size() + 1);
  if (plane) {
    const CurveCuts cuts = curve_cuts(points, axes, threads);
    mesh.sites.append(points, cuts.order, 0, threads);
    mesh.statistics.order_seconds = watch.lap();
    divide_and_conquer(mesh, {cuts.cut.data(), cuts.cut.size()}, threads, progress);
    mesh.statistics.insert_seconds = watch.lap();
    return mesh;
  }
  std::vector<Index> order = brio_order(points, axes, threads);
  bring_to_front(order, basis);
  mesh.sites.append(points, order, 0, threads);
  mesh.statistics.order_seconds = watch.lap();
  insert_all(mesh, progress);
  mesh.statistics.insert_seconds = watch.lap();
  return mesh;
}

Mesh triangulate_sites(const Sites& all, std::span<const VertexId> sites, int threads) {
  const auto d = static_cast<std::size_t>(all.dimension());
  std::vector<double> coordinates(sites.size() * d);
  std::vector<double> weights;
  weights.reserve(all.weighted() ? sites.size() : 0);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    all.copy_point(sites[i], std::span(coordinates).subspan(i * d, d));
    if (all.weighted()) weights.push_back(all.weight(sites[i]));
  }
  return triangulate_points(PointsView(coordinates, all.dimension(), weights), threads, {});
}

void keep_hidden_sites(Mesh& mesh) {
  if (mesh.hidden.kept() || !mesh.sites.weighted() || mesh.complex.dimension() < 1) return;
  try {
    with_dimension<1>(mesh.complex.dimension(), [&](auto dimension) { find_hidden_sites<dimension>(mesh); });
  } catch (...) {
    mesh.hidden = {};
    throw;
  }
  mesh.hidden.keep();
}

void insert_from(Mesh& mesh, std::size_t first, const Progress& progress) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  mesh.complex.reserve_more(expected_cells(k, mesh.sites.size() - first), mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { insert_sites<dimension>(mesh, first, progress); });
}

void insert_all(Mesh& mesh, const Progress& progress) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  mesh.complex.reserve_more(expected_cells(k, mesh.sites.size()), mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { make_first_cells<dimension>(mesh); });
  insert_from(mesh, static_cast<std::size_t>(k) + 1, progress);
}

}  // namespace delone
