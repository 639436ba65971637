// What is furthest away: the diagram that tells of each place which point is, the smallest ball that holds all points,
// and the two points that are furthest from each other.
// Source: [For92] 1 for the diagram, [GKS92] 4.1 for the triangulation that is dual to it.
#pragma once

#include <cstddef>
#include <vector>

#include "delone/apps/furthest.hpp"
#include "delone/dual/clip.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

/// The furthest-site Voronoi diagram. Only corners of the convex hull have cells, all of them without end; equal points
/// have one cell, that of the lowest row.
struct FurthestVoronoi {
  std::vector<Index> rows;              ///< cell i is that of row rows[i], ascending
  std::vector<std::size_t> offsets{0};  ///< cell i has cuts offsets[i] to offsets[i + 1]
  /// Where a cell ends, ascending by the row beyond it: `far` owns the cell, `near` and `across` are the other row.
  /// Cells that meet in less than D - 1 dimensions, as four cells of one circle do, do not cut each other.
  std::vector<Bisector> cuts;

  std::size_t size() const { return rows.size(); }
};

/// The diagram in any dimension, flat points and duplicates included: no cell without points, one cell without cuts
/// when all are equal. cut_cells(points, region, diagram.offsets, diagram.cuts) gives the shapes in the plane and in
/// space.
/// @throws InputError for weights, NaN, infinity or too many rows, before any work; Cancelled; std::bad_alloc
/// Cost: that of furthest_delaunay() and convex_hull(), and O(m log m) for m cells of the former. Exact.
FurthestVoronoi furthest_voronoi(PointsView points, const BuildOptions& options = {});

struct EnclosingBall {
  std::vector<double> centre;  ///< the coordinates, each rounded once to the nearest double; empty without points
  double radius = 0;           ///< rounded to the nearest double; infinite when it is larger than all of them
  double squared_radius = 0;   ///< the same of its square
  /// Rows that determine the ball, ascending: 1 to D + 1 affinely independent points with the centre strictly inside of
  /// their simplex. Where there are several such sets, one of them.
  std::vector<Index> support;
  std::vector<Index> on_sphere;  ///< all rows that lie on the sphere, ascending, duplicates included
};

/// The one smallest ball that holds all points.
/// @throws InputError for weights, NaN, infinity or too many rows, before any work; std::bad_alloc
/// Exact: support and sphere are decided by integers. Cost: O(n D) for each of some ten balls on random points; each
/// row that doubles do not tell from the sphere takes some microseconds more.
EnclosingBall smallest_enclosing_ball(PointsView points);

struct FarthestPair {
  Index first = kNone, second = kNone;  ///< first < second; of several pairs the lexicographically smallest
  double distance = 0;                  ///< rounded, to a few units in the last place
};

/// The two rows of the largest distance; kNone for less than two rows.
/// @throws InputError for weights, NaN, infinity or too many rows, before any work; std::bad_alloc
/// Exact. Cost: that of convex_hull() and, with h corners, O(h log h) in the plane and O(h^2) in space; O(n^2 D) above.
FarthestPair farthest_pair(PointsView points);

}  // namespace delone
