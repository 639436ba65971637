#include "delone/build/insert.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "delone/order/brio.hpp"
#include "mesh/anew.hpp"
#include "mesh/in_parts.hpp"
#include "mesh/insert_one.hpp"

namespace delone {
namespace {

/// All points of `t` and then those of `batch`, from scratch.
AnyTriangulation with_batch(const AnyTriangulation& t, PointsView batch, const BuildOptions& options) {
  NamedPoints points = points_of(t, t.present_rows());
  points.coordinates.insert(points.coordinates.end(), batch.coordinates().begin(), batch.coordinates().end());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    points.rows.push_back(static_cast<Index>(t.row_count() + i));
    if (t.weighted()) points.weights.push_back(batch.weight(i));
  }
  return triangulated_anew(t, points, t.row_count() + batch.size(), options.threads, options.progress);
}

}  // namespace

Inserted insert(AnyTriangulation& t, std::span<const double> point, double weight, const InsertOptions& options) {
  const ExactEnvironment environment;
  require_fit(t, point, weight);
  const PointsView one(point, t.dimension(), {&weight, 1});
  const auto row = static_cast<Index>(t.row_count());
  if (t.affine_dimension() < 0 || leave_flat(t, one)) {
    AnyTriangulation anew = with_batch(t, one, {});
    std::swap(t, anew);
    if (options.on_edit) options.on_edit({.rebuilt = true});
    return {row, outcome_of(t.status(row).status)};
  }
  Mesh& mesh = t.mesh();
  mesh.sites.reserve_more(1);
  mesh.sites.reserve_empty(1);
  mesh.complex.reserve_more(0, mesh.sites.size() + 1);
  const VertexId q = mesh.sites.put(point, weight, row);
  mesh.complex.grow_vertices(mesh.sites.size());
  try {
    const CellId start = options.near == kNoCell ? mesh.complex.incident_cell(kGhost) : options.near;
    return {row, insert_one(mesh, q, start, options.on_edit)};
  } catch (...) {
    mesh.sites.take_back(q);
    throw;
  }
}

void insert(AnyTriangulation& t, PointsView batch, const BuildOptions& options) {
  if (batch.empty()) return;
  const ExactEnvironment environment;
  require_fit(t, batch);
  const std::size_t present = t.sites().present_count();
  const bool many_empty = t.sites().size() > 2 * present + batch.size();  // a batch is appended; start afresh at times
  if (batch.size() >= present || many_empty || leave_flat(t, batch)) {
    AnyTriangulation anew = with_batch(t, batch, options);
    std::swap(t, anew);
    return;
  }
  Mesh mesh = t.mesh();
  const std::size_t first = mesh.sites.size();
  const auto axes =
      std::span(mesh.sites.flat().axes).first(static_cast<std::size_t>(std::max(t.affine_dimension(), 0)));
  const Buffer<Index> order = brio_order(batch, axes, options.threads);
  mesh.sites.append(batch, order, static_cast<Index>(t.row_count()));
  std::vector<std::size_t> rounds = round_ends(order, t.affine_dimension());
  for (std::size_t& end : rounds) end += first;
  insert_rounds(mesh, first, rounds, options.threads, options.progress);
  AnyTriangulation grown(std::move(mesh));
  std::swap(t, grown);
}

}  // namespace delone
