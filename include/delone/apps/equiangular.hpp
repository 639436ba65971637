// The most equiangular triangulation: where sites are cocircular, the Delaunay triangulation whose sorted angles are
// the lexicographic maximum. Delone's own choice among ties says nothing about angles.
// Source: [For92] 3.1, which leaves the task to D. Mount and A. Saalfeld, "Globally-equiangular triangulations of
// co-circular points in O(n log n) time", Symposium on Computational Geometry 1988.
#pragma once

#include "delone/mesh/cell_table.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// The triangles of the plane, with every polygon of cocircular sites cut so that the ascending sequence of all angles
/// is lexicographically largest among all triangulations of the sites. Where several cuts have the same angles, the
/// choice goes round the polygon from its lexicographically smallest site, so that it depends on the points alone.
/// @return  in the order of cells(t), with the neighbours unless they are left out; sites on one line have their edges
/// @throws  InputError unless the triangulation has dimension 2 and no weights
/// Cost     O(cells), and O(k^2 log k) for a polygon with k corners, with k^2 bytes. Exact.
CellTable equiangular_cells(const AnyTriangulation& t, bool with_neighbours = true);

}  // namespace delone
