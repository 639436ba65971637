// Furthest-site Delaunay triangulations: the cells whose circumscribing balls hold all points. Dual to the diagram that
// tells of each place which point is furthest away.
// Source: [GKS92] 4.1, the remark after theorem 4.2: the upper hull of the lifted points, by the same method as the
// lower one.
#pragma once

#include <vector>

#include "delone/build/build.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/cell_table.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

struct FurthestDelaunay {
  int affine_dimension = -1;
  /// In the order of cells(t). They divide the convex hull; cospherical ties are broken by the engine's rule.
  CellTable cells;
  /// Cells with a common ball merged, which do not depend on how ties are broken.
  PolytopeTable polytopes;
  /// Per row. Only corners of the convex hull are vertices: all other places have a point that is further. The rest are
  /// hidden, or duplicates of a vertex.
  std::vector<RowStatus> status;
  std::size_t hull_facets = 0;
  std::size_t memory_bytes = 0;  ///< of the triangulation, while it was there
  BuildStatistics statistics;
};

/// @param options  method and order are not looked at
/// @throws InputError for weights, NaN, infinity or too many rows, before any work; Cancelled; std::bad_alloc
/// Cost: expected O(n log n) in the plane.
FurthestDelaunay furthest_delaunay(PointsView points, const BuildOptions& options = {});

}  // namespace delone
