// Neighbours and boundary of a list of cells, from the ids alone.
#pragma once

#include <array>
#include <vector>

#include "delone/mesh/cell_table.hpp"

namespace delone::io {

/// The neighbours of every cell: those of the table, or where it has none, found by sorting facets.
/// Column i is the cell opposite vertex i, kNone outside. Cost: O(m log m) for the latter.
std::vector<Index> neighbours_of(const CellTable& cells);

/// The triangles of tetrahedra that no two of them share, turned outwards for positively oriented tetrahedra, in the
/// order of the cells.
std::vector<std::array<Index, 3>> boundary_triangles(const CellTable& cells);

}  // namespace delone::io
