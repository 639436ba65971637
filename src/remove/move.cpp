#include "delone/remove/move.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "mesh/anew.hpp"
#include "remove/detach.hpp"

namespace delone {
namespace {

struct Position {
  std::vector<double> point;
  double weight;
};

Position position_of(const Mesh& mesh, VertexId v) {
  Position position{std::vector<double>(static_cast<std::size_t>(mesh.sites.dimension())), mesh.sites.weight(v)};
  mesh.sites.copy_point(v, position.point);
  return position;
}

Motion rebuild(AnyTriangulation& t, Index row, const Position& to, const Listener& on_edit) {
  NamedPoints points = points_of(t, t.present_rows());
  const auto place = static_cast<std::size_t>(std::ranges::lower_bound(points.rows, row) - points.rows.begin());
  std::ranges::copy(to.point, points.coordinates.begin() + static_cast<std::ptrdiff_t>(place * to.point.size()));
  if (t.weighted()) points.weights[place] = to.weight;
  AnyTriangulation anew = triangulated_anew(t, points, t.row_count());
  std::swap(t, anew);
  if (on_edit) on_edit({.rebuilt = true});
  return Motion::rebuilt;
}

/// Inserts site v, which is in no cell, at its new position. On an exception it is in no cell, at its old one.
void arrive(Mesh& mesh, VertexId v, const Position& to, CellId start, const Listener& on_edit) {
  const Position from = position_of(mesh, v);
  mesh.sites.move(v, to.point, to.weight);
  try {
    insert_one(mesh, v, start, on_edit);
  } catch (...) {
    mesh.sites.move(v, from.point, from.weight);
    throw;
  }
}

/// A vertex that no other row repeats.
Motion move_vertex(AnyTriangulation& t, Index row, const Position& to, const Listener& on_edit) {
  Mesh& mesh = t.mesh();
  const VertexId v = mesh.sites.vertex(row);
  if (move_in_place(mesh, v, to.point, to.weight, on_edit)) return Motion::in_place;
  if (!detach(mesh, v, Return::possible, on_edit)) return rebuild(t, row, to, on_edit);
  try {
    arrive(mesh, v, to, mesh.scratch.hole.made.front(), on_edit);
    return Motion::reinserted;
  } catch (...) {
    bring_back(mesh, v, on_edit);
    throw;
  }
}

/// A row that is in no cell, or shares its place with another row that can stand for it.
Motion move_other(Mesh& mesh, Index row, const Position& to, const InsertOptions& options) {
  VertexId v = mesh.sites.vertex(row);
  VertexId repeated = mesh.duplicates.vertex_of(v);
  CellId holder = kNoCell;
  Duplicates::Node entry;
  if (repeated != kGhost) {
    entry = mesh.duplicates.take(v, row);
  } else if (!mesh.duplicates.at(v).empty()) {
    repeated = std::exchange(v, hand_over(mesh, v, entry));
  } else if (mesh.hidden.holds(v)) {
    holder = mesh.hidden.cell(v);
    mesh.hidden.remove(v);
  }
  try {
    const CellId start = options.near == kNoCell ? mesh.complex.incident_cell(kGhost) : options.near;
    arrive(mesh, v, to, start, options.on_edit);
    return Motion::reinserted;
  } catch (...) {
    if (holder != kNoCell) mesh.hidden.add(v, holder);
    if (!entry.empty()) {
      if (mesh.sites.row(v) < mesh.sites.row(repeated)) mesh.sites.swap_rows(v, repeated);
      mesh.duplicates.put_back(std::move(entry), v);
    }
    throw;
  }
}

/// One of the three ways, whichever fits.
Motion move_row(AnyTriangulation& t, Index row, const Position& to, const InsertOptions& options) {
  if (leave_flat(t, PointsView(to.point, t.dimension()))) return rebuild(t, row, to, options.on_edit);
  const Mesh& mesh = t.mesh();
  const VertexId v = mesh.sites.vertex(row);
  if (mesh.complex.incident_cell(v) != kNoCell && mesh.duplicates.at(v).empty()) {
    return move_vertex(t, row, to, options.on_edit);
  }
  return move_other(t.mesh(), row, to, options);
}

}  // namespace

Moved move(AnyTriangulation& t, Index row, std::span<const double> point, std::optional<double> weight,
           const InsertOptions& options) {
  const ExactEnvironment environment;
  require_present(t, row);
  const Position to{{point.begin(), point.end()}, weight.value_or(t.weight(row))};
  require_fit(t, to.point, to.weight);
  const Motion motion = move_row(t, row, to, options);
  return {outcome_of(t.status(row).status), motion};
}

}  // namespace delone
