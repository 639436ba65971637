// Is this list of cells a Delaunay (regular) triangulation of these points? Decided by exact integers only: nothing
// here shares a filter, a predicate stage or a data structure with the engine, so that a bug there cannot vouch for
// itself.
#pragma once

#include <string>
#include <vector>

#include "delone/geometry/points.hpp"
#include "delone/mesh/cell_table.hpp"

namespace delone {

struct CheckOptions {
  bool canonical = false;  ///< also demand Delone's own choice among cospherical ties
  bool furthest = false;   ///< of furthest sites: all points inside every circumscribing ball
  int threads = 1;
  std::size_t max_violations = 10;  ///< how many violations are put into words
};

struct CheckReport {
  std::vector<std::string> violations;  ///< the first ones, each one line naming cells and rows
  std::size_t violation_count = 0;
  int affine_dimension = -1;
  std::size_t cells = 0, vertices = 0, duplicates = 0, hidden = 0, hull_facets = 0;

  bool passed() const { return violation_count == 0; }
};

/// Checks any program's triangulation of `points`: positive volumes, facets matched on opposite sides, empty
/// orthospheres (or full ones), hull convex and covered exactly once, every row a vertex, a duplicate of one, or
/// redundant by weight.
/// @param cells  rows of `points`, corners = affine dimension + 1, orientation free; neighbours are not looked at
/// @throws InputError when a point is not finite, or furthest sites have weights
CheckReport check(PointsView points, const CellTable& cells, const CheckOptions& options = {});

}  // namespace delone
