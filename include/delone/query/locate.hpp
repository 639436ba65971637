// Where a point lies: at a vertex, inside a face of a cell, inside a cell, or outside. Exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"
#include "delone/query/options.hpp"

namespace delone {

/// The face of lowest dimension that contains the point, which then lies in its relative interior.
enum class Place : std::uint8_t {
  vertex,
  face,  ///< an edge, triangle, ... of lower dimension than cells
  cell,
  outside,  ///< outside the hull; of flat input also off the flat
};

struct Location {
  Place place = Place::outside;
  std::uint8_t row_count = 0;
  /// A live cell that has the face. Outside the hull a ghost cell whose facet the point lies strictly beyond, kNoCell
  /// off the flat of flat input. Where there are several, which one may depend on where the walk began.
  CellId cell = kNoCell;
  std::array<Index, kMaxDimension + 1> corners{};  ///< the first row_count are set, ascending

  /// Rows of the face's vertices, ascending; none outside.
  std::span<const Index> rows() const { return std::span(corners).first(row_count); }
  int face_dimension() const { return row_count - 1; }  ///< -1 outside
};

/// @param q     D finite coordinates
/// @param near  a live cell from which to walk; a near one is fast
/// @throws InputError for a wrong number of coordinates, NaN, infinity
/// Cost: the walk, and D + 1 orientations. Of flat input also one exact rank.
Location locate(const AnyTriangulation& t, std::span<const double> q, CellId near = kNoCell);

/// The same for every row of `queries`. Places and rows are those of single calls, and nothing depends on the threads.
/// @throws InputError when the dimension does not fit, for NaN and infinity; Cancelled; std::bad_alloc
std::vector<Location> locate(const AnyTriangulation& t, PointsView queries, const QueryOptions& options = {});

}  // namespace delone
