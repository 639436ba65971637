// Convex hulls of points, in their own dimension: facets, corners, faces, measure.
// Source: [GKS92] 4.1 (randomized insertion, located through all facets that ever were).
#pragma once

#include <cstdint>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/cell_table.hpp"

namespace delone {

struct HullOptions {
  int threads = 1;         ///< order the points; inserting them takes one
  Progress progress = {};  ///< told of progress, may cancel
  std::uint64_t seed = 1;  ///< of the random order, on which nothing depends but time
};

struct ConvexHull {
  int affine_dimension = -1;  ///< k; the hull is that of the points within their flat
  /// Rows of the extreme points, ascending; of equal points the lowest row. Points within a face or an edge are none.
  std::vector<Index> corners;
  /// k corners each, in the order and orientation of hull_facets(t): seen from outside, triangles run
  /// counter-clockwise. A face with more corners is divided by pulling its corners, the lexicographically smallest
  /// first: the same facets whatever the order of the rows. Of collinear points the two ends, of one place nothing.
  CellTable facets;
  PolytopeTable faces;  ///< facets of one hyperplane merged: the corners of each face, ascending
  double volume = 0;    ///< k-dimensional, and of the boundary; rounded, every part is positive
  double area = 0;
};

/// @throws InputError for NaN, infinity or too many rows, before any work; Cancelled; std::bad_alloc
/// Exact: what is a corner or lies in one hyperplane is decided without rounding.
/// Cost: expected O(n log n) for k <= 3, else O(n^(k / 2)) at most; interior points cost little.
ConvexHull convex_hull(PointsView points, const HullOptions& options = {});

}  // namespace delone
