#include "delone/build/insert.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/order/brio.hpp"
#include "mesh/incremental.hpp"

namespace delone {
namespace {

std::size_t size(int n) { return static_cast<std::size_t>(n); }

bool leave_flat(const AnyTriangulation& t, PointsView batch) {
  if (t.affine_dimension() == t.dimension()) return false;
  std::vector<double> points = spanning_points(t);
  points.insert(points.end(), batch.coordinates().begin(), batch.coordinates().end());
  return affine_dimension(PointsView(points, t.dimension())) > t.affine_dimension();
}

/// The triangulation of all rows of `t` and of `batch`, from scratch.
AnyTriangulation build_anew(const AnyTriangulation& t, PointsView batch, const BuildOptions& options) {
  std::vector<double> coordinates = t.coordinates();
  std::vector<double> weights = t.weights();
  coordinates.insert(coordinates.end(), batch.coordinates().begin(), batch.coordinates().end());
  if (t.weighted()) {
    for (std::size_t row = 0; row < batch.size(); ++row) weights.push_back(batch.weight(row));
  }
  return build(PointsView(coordinates, t.dimension(), weights), options);
}

void require_fit(const AnyTriangulation& t, PointsView batch) {
  if (batch.dimension() != t.dimension()) {
    throw InputError("points of " + std::to_string(batch.dimension()) + " coordinates: expected " +
                     std::to_string(t.dimension()) + ", as the triangulation has");
  }
  if (!t.weighted() && std::ranges::any_of(batch.weights(), [](double w) { return w != 0.0; })) {
    throw InputError("weights: the triangulation was made without any");
  }
  require_finite(batch);
  require_row_count(t.row_count() + batch.size(), t.dimension());
}

Outcome outcome_of(RowStatus status) {
  switch (status.status) {
    case Status::vertex:
      return Outcome::inserted;
    case Status::duplicate:
      return Outcome::duplicate;
    case Status::hidden:
      break;
  }
  return Outcome::hidden;
}

/// Inserts the last site, alone.
template <int K>
Outcome insert_last(Mesh& mesh, const InsertOptions& options) {
  const VertexId q{static_cast<Index>(mesh.sites.size() - 1)};
  Inserter<K> inserter(mesh);
  const CellId start = options.near == kNoCell ? mesh.complex.incident_cell(kGhost) : options.near;
  const Outcome outcome = inserter.insert(q, start);
  if (outcome == Outcome::inserted && options.on_edit) options.on_edit(inserter.edit());
  return outcome;
}

}  // namespace

Inserted insert(AnyTriangulation& t, std::span<const double> point, double weight, const InsertOptions& options) {
  const ExactEnvironment environment;
  const std::array<double, 1> weights{weight};
  if (point.size() != size(t.dimension())) {
    throw InputError("a point of " + std::to_string(point.size()) + " coordinates: expected " +
                     std::to_string(t.dimension()));
  }
  const PointsView one(point, t.dimension(), weights);
  require_fit(t, one);
  const auto row = static_cast<Index>(t.row_count());
  if (t.affine_dimension() < 0 || leave_flat(t, one)) {
    AnyTriangulation anew = build_anew(t, one, {});
    std::swap(t, anew);
    if (options.on_edit) options.on_edit({.rebuilt = true});
    return {row, outcome_of(t.status(row))};
  }
  Mesh& mesh = t.mesh();
  mesh.sites.reserve_more(1);
  mesh.complex.reserve_more(0, t.row_count() + 1);
  mesh.sites.append(point, weight, row);
  mesh.complex.grow_vertices(mesh.sites.size());
  try {
    return {row, with_dimension(t.affine_dimension(), [&](auto k) { return insert_last<k>(mesh, options); })};
  } catch (...) {
    mesh.sites.drop_last();
    mesh.complex.grow_vertices(mesh.sites.size());
    throw;
  }
}

void insert(AnyTriangulation& t, PointsView batch, const BuildOptions& options) {
  if (batch.empty()) return;
  const ExactEnvironment environment;
  require_fit(t, batch);
  if (batch.size() >= t.row_count() || leave_flat(t, batch)) {
    AnyTriangulation anew = build_anew(t, batch, options);
    std::swap(t, anew);
    return;
  }
  Mesh mesh = t.mesh();
  const std::size_t first = mesh.sites.size();
  const auto axes = std::span(mesh.sites.flat().axes).first(size(std::max(t.affine_dimension(), 0)));
  mesh.sites.append(batch, brio_order(batch, axes, options.threads), static_cast<Index>(first));
  insert_from(mesh, first, options.progress);
  AnyTriangulation grown(std::move(mesh));
  std::swap(t, grown);
}

}  // namespace delone
