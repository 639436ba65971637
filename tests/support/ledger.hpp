// Sequences of insertions, removals and moves beside a plain list of the points as they should be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delone/mesh/triangulation.hpp"
#include "support/families.hpp"

namespace delone::test {

/// Rows with their points, as a user would keep them: removed rows are empty.
struct Ledger {
  struct Entry {
    std::vector<double> point;
    double weight = 0.0;
  };
  int dimension = 1;
  bool weighted = false;
  std::vector<std::optional<Entry>> rows;

  std::vector<Index> present() const;
  PointSet points() const;  ///< of the rows that are there, ascending
};

/// The first way in which `t` differs from building from the points of the ledger: cells, statuses of rows, counts, the
/// hash, an invariant of the complex; or an empty text.
std::string differs_from_building(const AnyTriangulation& t, const Ledger& ledger);

}  // namespace delone::test
