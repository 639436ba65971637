#include "support/expectations.hpp"

#include <algorithm>
#include <sstream>

#include "delone/base/dispatch.hpp"
#include "delone/build/build.hpp"
#include "delone/check/delaunay.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "delone/mesh/export.hpp"
#include "support/brute_force.hpp"

namespace delone::test {
namespace {

std::string name(CellId c) { return "cell " + std::to_string(raw(c)); }

std::vector<VertexId> facet_vertices(const Complex& complex, CellId c, int without) {
  std::vector<VertexId> result;
  for (int i = 0; i < complex.corners(); ++i) {
    if (i != without) result.push_back(complex.vertex(c, i));
  }
  return result;
}

/// Whether sorting takes an odd number of swaps.
bool is_odd(const std::vector<VertexId>& list) {
  bool odd = false;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) odd ^= list[i] < list[j];
  }
  return odd;
}

bool same_facet(const Complex& complex, CellId c, int i, CellId d, int j) {
  auto mine = facet_vertices(complex, c, i);
  auto theirs = facet_vertices(complex, d, j);
  const bool turned = (is_odd(mine) != (i % 2 == 1)) != (is_odd(theirs) != (j % 2 == 1));
  std::ranges::sort(mine);
  std::ranges::sort(theirs);
  return mine == theirs && (turned || complex.dimension() == 0);
}

int orientation(const AnyTriangulation& t, CellId c) {
  if (t.affine_dimension() < 1) return 1;
  return with_dimension<1>(t.affine_dimension(), [&](auto k) {
    std::array<const double*, k + 1> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = t.sites().at(t.complex().vertex(c, static_cast<int>(i)));
    }
    return slow_orient<k>(points).sign;
  });
}

/// Whether finite cell c contains site v.
bool holds(const AnyTriangulation& t, CellId c, VertexId v) {
  return with_dimension<1>(t.affine_dimension(), [&](auto k) {
    const auto at = [&](VertexId w) { return t.sites().at(w); };
    for (std::size_t i = 0; i <= k; ++i) {
      std::array<const double*, k + 1> points;
      for (std::size_t j = 0; j <= k; ++j) points[j] = at(j == i ? v : t.complex().vertex(c, static_cast<int>(j)));
      if (slow_orient<k>(points).sign < 0) return false;
    }
    return true;
  });
}

std::string broken_cell(const AnyTriangulation& t, CellId c) {
  const Complex& complex = t.complex();
  int ghosts = 0;
  for (int i = 0; i < complex.corners(); ++i) {
    const VertexId v = complex.vertex(c, i);
    ghosts += v == kGhost ? 1 : 0;
    if (v != kGhost && (raw(v) >= t.sites().size() || t.sites().is_empty(v)))
      return name(c) + " names a vertex that does not exist";
    if (v == kGhost && i != complex.dimension() && complex.dimension() != 1)
      return "I4: the ghost is not last in " + name(c);
    if (complex.incident_cell(v) == kNoCell) return name(c) + " has a vertex that is in no cell";
    const FacetId across = complex.twin(c, i);
    const CellId d = complex.cell(across);
    if (raw(d) >= complex.slot_count() || !complex.is_live(d)) return "I1: a dead twin in " + name(c);
    const FacetId back = complex.twin(d, complex.slot(across));
    if (complex.cell(back) != c || complex.slot(back) != i || d == c) return "I1: twins differ in " + name(c);
    if (!same_facet(complex, c, i, d, complex.slot(across)))
      return "I2, I3: facets differ between " + name(c) + " and " + name(d);
  }
  if (ghosts > 1) return "two ghosts in " + name(c);
  if (ghosts == 0 && orientation(t, c) <= 0) return "I4: not positive: " + name(c);
  return "";
}

/// I13.
std::string broken_hidden_lists(const AnyTriangulation& t) {
  const Mesh& mesh = t.mesh();
  if (!mesh.hidden.kept()) return "";
  std::size_t listed = 0;
  for (std::size_t s = 0; s < t.complex().slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    for (VertexId v = mesh.hidden.first(c); v != kGhost; v = mesh.hidden.next(v)) {
      ++listed;
      if (!t.complex().is_live(c) || t.complex().is_ghost(c)) return "I13: a list at a cell that is not there";
      if (mesh.hidden.cell(v) != c) return "I13: a site in the list of another cell";
      if (t.complex().incident_cell(v) != kNoCell) return "I13: a vertex in a list of hidden sites";
      if (!holds(t, c, v)) return "I13: a hidden site outside its cell";
    }
  }
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < t.sites().size(); ++i) {
    const VertexId v{static_cast<Index>(i)};
    if (t.sites().is_empty(v) || t.complex().incident_cell(v) != kNoCell) continue;
    hidden += mesh.duplicates.vertex_of(v) == kGhost ? 1 : 0;
  }
  return listed == hidden ? "" : "I13: a hidden site is in no list";
}

}  // namespace

AnyTriangulation built(const PointSet& points) { return build(points.view()); }

std::string description(const AnyTriangulation& t) {
  std::ostringstream out;
  out << t.dimension() << ' ' << t.affine_dimension() << ' ' << canonical_hash(t) << " rows";
  for (std::size_t row = 0; row < t.row_count(); ++row) {
    const RowStatus status = t.status(static_cast<Index>(row));
    out << ' ' << static_cast<int>(status.status) << ':' << status.of;
  }
  const auto put = [&](const char* what, const auto& numbers) {
    out << ' ' << what;
    for (const auto number : numbers) out << ' ' << number;
  };
  put("cells", cells(t).vertices);
  put("neighbours", cells(t).neighbours);
  put("hull", hull_facets(t).vertices);
  put("merged", merged_cells(t).vertices);
  put("offsets", merged_cells(t).offsets);
  put("points", t.coordinates());
  put("weights", t.weights());
  return out.str();
}

std::string broken_invariant(const AnyTriangulation& t) {
  const Complex& complex = t.complex();
  std::size_t live = 0, ghosts = 0, vertices = 0;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c)) continue;
    ++live;
    ghosts += complex.is_ghost(c) ? 1 : 0;
    if (std::string broken = broken_cell(t, c); !broken.empty()) return broken;
  }
  if (live != complex.live_count() || ghosts != complex.ghost_count()) return "cells are miscounted";
  for (std::size_t i = 0; i < t.sites().size(); ++i) {
    const VertexId v{static_cast<Index>(i)};
    const CellId c = complex.dimension() < 0 ? kNoCell : complex.incident_cell(v);
    if (t.sites().is_empty(v) && c != kNoCell) return "a removed vertex is in a cell";
    if (t.sites().is_empty(v)) continue;
    if (t.vertex(t.row(v)) != v) return "rows and vertices are no permutation";
    if (c == kNoCell) continue;
    ++vertices;
    const auto corners = facet_vertices(complex, c, -1);
    if (!complex.is_live(c) || std::ranges::find(corners, v) == corners.end()) return "a wrong incident cell";
  }
  if (vertices != t.vertex_count()) return "vertices are miscounted";
  return broken_hidden_lists(t);
}

std::vector<std::vector<Index>> sorted_cells(const AnyTriangulation& t) {
  const CellTable table = cells(t);
  std::vector<std::vector<Index>> result;
  for (std::size_t c = 0; c < table.size(); ++c) {
    result.emplace_back(table[c].begin(), table[c].end());
    std::ranges::sort(result.back());
  }
  return result;
}

std::string differs_from_brute_force(const AnyTriangulation& t, const PointSet& points) {
  const Truth truth = brute_force(points.view());
  if (t.affine_dimension() != truth.affine_dimension) return "the affine dimension differs";
  if (sorted_cells(t) != truth.cells) return "the cells differ";
  for (std::size_t row = 0; row < points.size(); ++row) {
    const RowStatus status = t.status(static_cast<Index>(row));
    const Index of = truth.of[row] == kNone ? static_cast<Index>(row) : truth.of[row];
    if (static_cast<int>(status.status) != truth.status[row] || status.of != of) {
      return "the status of row " + std::to_string(row) + " differs";
    }
  }
  return "";
}

std::string fails_check(const AnyTriangulation& t, const PointSet& points) {
  const CheckReport report = check(points.view(), cells(t), {.canonical = true});
  if (!report.passed()) return report.violations.front();
  const bool counts_agree = report.affine_dimension == t.affine_dimension() && report.cells == t.cell_count() &&
                            report.vertices == t.vertex_count() && report.duplicates == t.duplicate_count() &&
                            report.hidden == t.hidden_count() && report.hull_facets == t.hull_facet_count();
  return counts_agree ? "" : "the counts differ from those of the check";
}

}  // namespace delone::test
