#include "delone/mesh/triangulation.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <unordered_set>

namespace delone {

PredicateStats& PredicateStats::operator+=(const PredicateStats& other) {
  orient_filter += other.orient_filter;
  orient_exact += other.orient_exact;
  conflict_filter += other.conflict_filter;
  conflict_adaptive += other.conflict_adaptive;
  conflict_exact += other.conflict_exact;
  conflict_symbolic += other.conflict_symbolic;
  return *this;
}

BuildStatistics& BuildStatistics::operator+=(const BuildStatistics& other) {
  order_seconds += other.order_seconds;
  insert_seconds += other.insert_seconds;
  finish_seconds += other.finish_seconds;
  predicates += other.predicates;
  walk_steps += other.walk_steps;
  walk_fallbacks += other.walk_fallbacks;
  cells_created += other.cells_created;
  put_off += other.put_off;
  in_turn += other.in_turn;
  flips += other.flips;
  history_steps += other.history_steps;
  return *this;
}

AnyTriangulation::AnyTriangulation(int dimension, bool weighted)
    : mesh_(Sites(PointsView({}, dimension).dimension(), weighted)) {}

std::size_t AnyTriangulation::duplicate_count() const {
  if (!weighted()) return mesh_.duplicates.size();
  return static_cast<std::size_t>(std::ranges::count_if(
      mesh_.duplicates, [this](const auto& entry) { return mesh_.complex.incident_cell(entry.first) != kNoCell; }));
}

std::size_t AnyTriangulation::memory_bytes() const {
  return sizeof(*this) + mesh_.sites.memory_bytes() + mesh_.complex.memory_bytes() + mesh_.duplicates.memory_bytes() +
         mesh_.hidden.memory_bytes() + mesh_.scratch.memory_bytes();
}

RowStatus AnyTriangulation::status(Index row) const {
  if (row >= row_count()) {
    throw InputError("row " + std::to_string(row) + ": there are only " + std::to_string(row_count()) + " rows");
  }
  if (mesh_.sites.is_removed(row)) return {Status::removed, row};
  const VertexId v = mesh_.sites.vertex(row);
  if (mesh_.complex.incident_cell(v) != kNoCell) return {Status::vertex, row};
  const VertexId repeated = mesh_.duplicates.vertex_of(v);
  if (repeated != kGhost && mesh_.complex.incident_cell(repeated) != kNoCell) {
    return {Status::duplicate, mesh_.sites.row(repeated)};
  }
  return {Status::hidden, row};
}

std::vector<double> AnyTriangulation::point(Index row) const {
  require_present(*this, row);
  std::vector<double> x(static_cast<std::size_t>(dimension()));
  mesh_.sites.copy_point(mesh_.sites.vertex(row), x);
  return x;
}

double AnyTriangulation::weight(Index row) const {
  require_present(*this, row);
  return mesh_.sites.weight(mesh_.sites.vertex(row));
}

void require_present(const AnyTriangulation& t, Index row) {
  if (row >= t.row_count()) {
    throw InputError("row " + std::to_string(row) + ": there are only " + std::to_string(t.row_count()) + " rows");
  }
  if (t.sites().is_removed(row)) throw InputError("row " + std::to_string(row) + ": it was removed before");
}

std::vector<Index> AnyTriangulation::present_rows() const {
  std::vector<Index> rows;
  rows.reserve(mesh_.sites.present_count());
  for (std::size_t row = 0; row < row_count(); ++row) {
    if (!mesh_.sites.is_removed(static_cast<Index>(row))) rows.push_back(static_cast<Index>(row));
  }
  return rows;
}

std::vector<double> AnyTriangulation::coordinates() const {
  const auto d = static_cast<std::size_t>(dimension());
  std::vector<double> all(row_count() * d, std::numeric_limits<double>::quiet_NaN());
  for (const Index row : present_rows()) {
    mesh_.sites.copy_point(mesh_.sites.vertex(row), std::span(all).subspan(row * d, d));
  }
  return all;
}

std::vector<double> AnyTriangulation::weights() const {
  if (!weighted()) return {};
  std::vector<double> all(row_count(), std::numeric_limits<double>::quiet_NaN());
  for (const Index row : present_rows()) all[row] = weight(row);
  return all;
}

std::vector<CellId> AnyTriangulation::star(VertexId v) const {
  const Complex& complex = mesh_.complex;
  std::vector<CellId> cells;
  if (complex.incident_cell(v) == kNoCell) return cells;
  cells.push_back(complex.incident_cell(v));
  std::unordered_set<Index> seen{raw(cells.front())};
  for (std::size_t next = 0; next < cells.size(); ++next) {
    for (int i = 0; i < complex.corners(); ++i) {
      if (complex.vertex(cells[next], i) == v) continue;
      const CellId across = complex.cell(complex.twin(cells[next], i));
      if (seen.insert(raw(across)).second) cells.push_back(across);
    }
  }
  return cells;
}

std::vector<double> spanning_points(const AnyTriangulation& t) {
  std::vector<double> points;
  const Complex& complex = t.complex();
  const CellId ghost = complex.incident_cell(kGhost);
  if (ghost == kNoCell) return points;
  int opposite = 0;
  while (complex.vertex(ghost, opposite) != kGhost) ++opposite;
  const CellId finite = complex.cell(complex.twin(ghost, opposite));
  for (int i = 0; i < complex.corners(); ++i) {
    for (int axis = 0; axis < t.dimension(); ++axis) {
      points.push_back(t.sites().coordinate(complex.vertex(finite, i), axis));
    }
  }
  return points;
}

}  // namespace delone
