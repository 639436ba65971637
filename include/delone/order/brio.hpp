// The order in which points are inserted: random rounds of growing size, each along Hilbert's curve.
// Source: [ACR03] (biased randomized insertion order: the expected bounds of random insertion hold, memory stays
// local). Departure: rounds grow eightfold, not twofold, so that seven points of eight lie in one sweep of the curve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

/// A permutation of the rows of `points`.
/// @param axes  the coordinate axes that span the points (at least one; at most kMaxDimension)
/// @param threads  how many share the work; the order does not depend on it
/// Cost: O(n), a radix sort; where points crowd into one cell of the grid the crowd is sorted again, a few by their
/// coordinates, more on a finer grid.
Buffer<Index> brio_order(PointsView points, std::span<const int> axes, int threads = 1);

/// Where the rounds of brio_order(), called with so many axes, end in its result: ascending, the last is its size.
std::vector<std::size_t> round_ends(std::span<const Index> order, int axes);

/// The same without rounds: all rows along one curve. For queries, each of which starts where the last one ended.
Buffer<Index> curve_order(PointsView points, std::span<const int> axes, int threads = 1);

/// Rows along one curve, and the tree of boxes that it goes through: each box is cut in half by a plane across an axis,
/// and the curve leaves one half before it enters the other. Where few rows share a cell of the grid they stand in
/// lexicographic order, and are cut between any two places.
struct CurveCuts {
  static constexpr std::uint16_t kSamePlace = 0xFFFF;

  Buffer<Index> order;
  /// Per row the depth of the cut between it and the row before: of the cuts among some rows in a line the least deep
  /// is the one that all others lie beside. kSamePlace: both stand at one place, so that nothing parts them. That of
  /// the first row means nothing.
  Buffer<std::uint16_t> cut;
};

/// @param axes  as above, at least one
CurveCuts curve_cuts(PointsView points, std::span<const int> axes, int threads = 1);

/// The same in lexicographic order on the axes in this order: a tree of strips across the first axis; rows that it does
/// not tell apart are cut across the next.
CurveCuts strip_cuts(PointsView points, std::span<const int> axes, int threads = 1);

}  // namespace delone
