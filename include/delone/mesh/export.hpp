// A triangulation as plain arrays of input rows, in the one order that files and hashes use (cell_table.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "delone/mesh/cell_table.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// The finite cells, with their neighbours unless they are left out, which saves time. Cost O(cells).
CellTable cells(const AnyTriangulation& t, bool with_neighbours = true);

/// The ids of the finite cells, in the order of cells(t).
std::vector<CellId> cell_ids(const AnyTriangulation& t);

/// The facets of the convex hull: k rows each, ordered like cells; a facet's outward normal followed by its edge
/// vectors is positively oriented, so hull edges run counter-clockwise and hull triangles do so seen from outside.
CellTable hull_facets(const AnyTriangulation& t);

/// Cells with a common orthosphere merged: the Delaunay polytopes, which do not depend on how ties are broken
/// ([For92] 2.1). Each is its ascending rows; the polytopes are sorted.
PolytopeTable merged_cells(const AnyTriangulation& t);

/// One number for one triangulation: equal for equal point sets, however their rows are ordered. To compute it
/// elsewhere: number the distinct points of the input in lexicographic order of their coordinates from 0 on (hidden
/// ones and each place of duplicates once); write each cell as its ascending numbers; sort the cells; then start with h
/// = 0 and feed the dimension of the points, the affine dimension, the number of distinct points, the number of cells,
/// and all numbers of all cells, each as a 64-bit word w, by h = mix(h xor w), where mix is the splitmix64 step: h +=
/// 0x9E3779B97F4A7C15; h = (h xor h >> 30) * 0xBF58476D1CE4E5B9; h = (h xor h >> 27) * 0x94D049BB133111EB; h xor h
/// >> 31.
std::uint64_t canonical_hash(const AnyTriangulation& t);

}  // namespace delone
