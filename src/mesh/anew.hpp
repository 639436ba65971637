// Whole triangulations from points: what building shares with changes that leave no cell as it was, where a point
// leaves the flat of all others, or the last one off a flat goes.
#pragma once

#include <span>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// A mesh that is ready, without spare memory.
AnyTriangulation finished(Mesh mesh);

/// The triangulation of finite points, without spare memory.
AnyTriangulation triangulated(PointsView points, int threads, const Progress& progress);

/// Rows of a triangulation with their numbers.
struct NamedPoints {
  std::vector<Index> rows;  ///< ascending
  std::vector<double> coordinates;
  std::vector<double> weights;  ///< empty when there are none
};

NamedPoints points_of(const AnyTriangulation& t, std::vector<Index> rows);

/// The triangulation of `points` under their rows, of `row_count` in all; otherwise like `t`.
AnyTriangulation triangulated_anew(const AnyTriangulation& t, const NamedPoints& points, std::size_t row_count,
                                   int threads = 1, const Progress& progress = {});

/// Whether one of the finite points lies off the flat that the points of `t` span.
bool leave_flat(const AnyTriangulation& t, PointsView points);

}  // namespace delone
