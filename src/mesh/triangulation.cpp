#include "delone/mesh/triangulation.hpp"

#include <algorithm>
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

AnyTriangulation::AnyTriangulation(int dimension, bool weighted)
    : mesh_(Sites(PointsView({}, dimension).dimension(), weighted)) {}

std::size_t AnyTriangulation::duplicate_count() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      mesh_.duplicates, [this](const auto& pair) { return mesh_.complex.incident_cell(pair.second) != kNoCell; }));
}

std::size_t AnyTriangulation::memory_bytes() const {
  return sizeof(*this) + mesh_.sites.memory_bytes() + mesh_.complex.memory_bytes() +
         mesh_.duplicates.capacity() * sizeof(mesh_.duplicates[0]) + mesh_.scratch.memory_bytes();
}

RowStatus AnyTriangulation::status(Index row) const {
  if (row >= row_count()) {
    throw InputError("row " + std::to_string(row) + ": there are only " + std::to_string(row_count()) + " rows");
  }
  const VertexId v = mesh_.sites.vertex(row);
  if (mesh_.complex.incident_cell(v) != kNoCell) return {Status::vertex, row};
  const auto found = std::ranges::lower_bound(mesh_.duplicates, v, {}, [](const auto& pair) { return pair.first; });
  if (found != mesh_.duplicates.end() && found->first == v && mesh_.complex.incident_cell(found->second) != kNoCell) {
    return {Status::duplicate, mesh_.sites.row(found->second)};
  }
  return {Status::hidden, row};
}

std::vector<double> AnyTriangulation::point(Index row) const {
  std::vector<double> x(static_cast<std::size_t>(dimension()));
  for (int axis = 0; axis < dimension(); ++axis) {
    x[static_cast<std::size_t>(axis)] = mesh_.sites.coordinate(mesh_.sites.vertex(row), axis);
  }
  return x;
}

std::vector<double> AnyTriangulation::coordinates() const {
  const auto d = static_cast<std::size_t>(dimension());
  std::vector<double> all(row_count() * d);
  for (std::size_t row = 0; row < row_count(); ++row) {
    const VertexId v = mesh_.sites.vertex(static_cast<Index>(row));
    for (std::size_t axis = 0; axis < d; ++axis) {
      all[row * d + axis] = mesh_.sites.coordinate(v, static_cast<int>(axis));
    }
  }
  return all;
}

std::vector<double> AnyTriangulation::weights() const {
  std::vector<double> all(weighted() ? row_count() : 0);
  for (std::size_t row = 0; row < all.size(); ++row) all[row] = weight(static_cast<Index>(row));
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
