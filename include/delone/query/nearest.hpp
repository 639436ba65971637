// Nearest vertices: the nearest one, the k nearest, all within a radius. Exact, ties included.
//
// A vertex that is not the nearest has a neighbour strictly nearer to the query: |q - p|^2 - w is, up to a term that
// depends on q alone, a linear function of the lifted point, so on the triangulation it is a convex function, linear on
// every cell, which falls along an edge wherever it is not least. So going down ends at a nearest vertex, the nearest
// ones are connected by edges, and so are all within any radius.
//
// With weights distances are powers |q - p|^2 - w. Results are vertices, and the duplicate rows of a vertex as rows of
// their own; rows hidden by their weight are never results, although their power may be less than that of some vertex.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"
#include "delone/query/options.hpp"

namespace delone {

struct Neighbour {
  Index row = kNone;  ///< kNone when there are no vertices
  /// In doubles, with a relative error below (D + 2) 2^-53 without weights; with weights the power.
  double squared_distance = std::numeric_limits<double>::infinity();
  bool operator==(const Neighbour&) const = default;
};

/// Lists of neighbours end to end: those of query i stand at offsets[i] to offsets[i + 1] - 1.
struct NeighbourLists {
  std::vector<std::size_t> offsets{0};
  std::vector<Index> rows;
  std::vector<double> squared_distances;

  std::size_t size() const { return offsets.size() - 1; }
};

/// The vertex nearest to q; of several at equal distance the one with the lowest row.
/// @param q     D finite coordinates
/// @param near  a live cell from which to walk; a near one is fast, as t.complex().incident_cell(t.vertex(row)) of the
///              last answer is. Never changes the result
/// @throws InputError for a wrong number of coordinates, NaN, infinity
/// Cost: the walk (without `near` from the nearest of a sample of the vertices: O(n^(1/(D+1))) expected for random
/// points), then the stars of the vertices on the way down, most often one.
Neighbour nearest(const AnyTriangulation& t, std::span<const double> q, CellId near = kNoCell);

/// The k rows nearest to q, ascending by distance, equal distances by row; all there are when they are fewer.
/// Cost: as above, then O(k log k) and the stars of k vertices.
std::vector<Neighbour> nearest(const AnyTriangulation& t, std::span<const double> q, std::size_t k,
                               CellId near = kNoCell);

/// All rows at a squared distance (power) of at most radius^2, which is not rounded; in the same order.
/// @throws InputError also for a radius that is negative or not finite
/// Cost: as for nearest, then the stars of the results, and sorting them.
std::vector<Neighbour> within(const AnyTriangulation& t, std::span<const double> q, double radius,
                              CellId near = kNoCell);

/// The same for every row of `queries`, whose weights are not looked at.
/// @throws InputError when the dimension does not fit, for NaN and infinity; Cancelled; std::bad_alloc
std::vector<Neighbour> nearest(const AnyTriangulation& t, PointsView queries, const QueryOptions& options = {});
NeighbourLists nearest(const AnyTriangulation& t, PointsView queries, std::size_t k, const QueryOptions& options = {});
NeighbourLists within(const AnyTriangulation& t, PointsView queries, double radius, const QueryOptions& options = {});

}  // namespace delone
