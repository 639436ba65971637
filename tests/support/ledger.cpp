#include "support/ledger.hpp"

#include <algorithm>

#include "delone/build/build.hpp"
#include "delone/mesh/export.hpp"
#include "support/expectations.hpp"

namespace delone::test {

std::vector<Index> Ledger::present() const {
  std::vector<Index> present;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row]) present.push_back(static_cast<Index>(row));
  }
  return present;
}

PointSet Ledger::points() const {
  PointSet set{"ledger", dimension, {}, {}};
  for (const auto& entry : rows) {
    if (!entry) continue;
    set.coordinates.insert(set.coordinates.end(), entry->point.begin(), entry->point.end());
    if (weighted) set.weights.push_back(entry->weight);
  }
  return set;
}

std::string differs_from_building(const AnyTriangulation& t, const Ledger& ledger) {
  const std::vector<Index> rows = ledger.present();
  const PointSet points = ledger.points();
  const AnyTriangulation truth = rows.empty() ? AnyTriangulation(ledger.dimension, ledger.weighted) : built(points);
  if (t.row_count() != ledger.rows.size()) return "rows";
  if (t.removed_count() != ledger.rows.size() - rows.size()) return "removed rows";
  if (t.present_rows() != rows) return "the rows that are there";
  if (t.affine_dimension() != truth.affine_dimension()) return "affine dimension";
  if (t.vertex_count() != truth.vertex_count()) return "number of vertices";
  if (t.duplicate_count() != truth.duplicate_count()) return "number of duplicates";
  if (t.hidden_count() != truth.hidden_count()) return "number of hidden rows";
  if (const std::string broken = broken_invariant(t); !broken.empty()) return broken;
  std::vector<std::vector<Index>> expected = sorted_cells(truth);
  for (auto& cell : expected) {
    for (Index& row : cell) row = rows[row];
  }
  if (sorted_cells(t) != expected) return "cells";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    RowStatus status = truth.status(static_cast<Index>(i));
    status.of = rows[status.of];
    if (t.status(rows[i]) != status) return "status of row " + std::to_string(rows[i]);
    if (t.point(rows[i]) != ledger.rows[rows[i]]->point) return "place of row " + std::to_string(rows[i]);
  }
  for (std::size_t row = 0; row < ledger.rows.size(); ++row) {
    if (!ledger.rows[row] && t.status(static_cast<Index>(row)).status != Status::removed) return "a removed row";
  }
  if (canonical_hash(t) != canonical_hash(truth)) return "hash";
  return "";
}

}  // namespace delone::test
