// Is a division of the plane the Voronoi diagram of some sites, and of which?
// Source: [For92] 3.2, after P. Ash and E. Bolker, "Recognizing Dirichlet tessellations" (1985).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/dual/voronoi.hpp"

namespace delone {

/// Convex cells that cover the plane, edge to edge. A cell is a loop of places that runs counter-clockwise, its inside
/// to the left. Places are numbered together: first the vertices, then the directions, which are places at infinity
/// where rays end, so that an unbounded cell is a loop, too: out along a ray to a direction, back from another one
/// along the next ray. Where the two rays are parallel they may end in one direction. A line without a vertex is two
/// rays from any point of it.
struct PlanarComplex {
  std::vector<std::array<double, 2>> vertices;
  std::vector<std::array<double, 2>> directions;  ///< of any length but 0; place vertices.size() + i is directions[i]
  std::vector<std::vector<Index>> cells;
};

/// A Voronoi diagram, or a power diagram, its vertices rounded to the nearest doubles. Cells ascend by their rows.
/// @throws InputError unless its points span the plane
PlanarComplex planar_complex(const Diagram& diagram);

struct Recognition {
  bool is_voronoi = false;
  std::vector<std::array<double, 2>> sites;  ///< one per cell; empty when it is no Voronoi diagram
  /// Of the choice of sites: 0 when they are the only ones, else 1 or 2, where one site can be moved along a line or in
  /// the plane, the others follow, and one choice is given, about in the middle of all.
  int freedom = 0;
  /// How far it is from being a diagram: the largest difference between the distances of a vertex from the sites of its
  /// cells, and the largest part of a step between two sites along the ray between their cells, both relative to the
  /// size. 0 in exact arithmetic.
  double residual = 0;
  std::string reason;  ///< why it is none, in one line; else empty
};

/// @param tolerance  0: coordinates are taken as they are, and the answer is exact; sites are rounded once, to the
///     nearest doubles. Else coordinates are rounded ones: each vertex is within tolerance * size of its true place,
///     each direction within that angle, where the size is the longer side of the box around all vertices. The answer
///     is yes when there are sites with a residual of at most the tolerance, each inside of its cell by more than that.
///     Since sites are found from neighbour to neighbour, it should be some orders above the rounding: 1e-12 serves for
///     thousands of cells whose vertices are the nearest doubles.
/// @throws InputError for what is no division of the plane into convex cells, naming the cell, the edge or the vertex;
///     for edges within the rounding, whose ends should be one vertex; for NaN and infinity
/// Cost: O(n log n) for n edges; without tolerance of rationals, whose length grows with the number of cells between
/// two cells, unless the cells are regular.
Recognition recognise(const PlanarComplex& complex, double tolerance = 0);

}  // namespace delone
