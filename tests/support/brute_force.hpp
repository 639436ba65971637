// The slow and obvious truth: every (k + 1)-subset of a small point set, tried with integers of any size.
// Written from the definition alone; it shares no predicate with the engine or with the checker.
#pragma once

#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"

namespace delone::test {

/// The one canonical triangulation of a point set, and what became of each row.
struct Truth {
  int affine_dimension = -1;
  std::vector<std::vector<Index>> cells;  ///< each ascending, sorted
  std::vector<int> status;                ///< per row: 0 vertex, 1 duplicate of a vertex, 2 hidden
  std::vector<Index> of;                  ///< a vertex: itself; a duplicate: its vertex; hidden: kNone
};

/// Delaunay (regular, with weights) cells by trying every subset. Ties are broken by lowering each lifted height by an
/// infinitesimal, the lexicographically smallest point's dominating all others.
/// Cost: (n choose k + 1) * n determinants of order k + 1; meant for n up to about 14, dimension up to 6.
Truth brute_force(PointsView points);

}  // namespace delone::test
