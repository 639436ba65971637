// Triangulations of the plane that are not Delaunay's: made from lists of triangles, changed by single flips.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"
#include "delone/topology/complex.hpp"

namespace delone::lab {

using Triangle = std::array<Index, 3>;

/// The closed complex of some triangles, which cover the convex hull once, each counter-clockwise. Sites are numbered
/// like rows.
Mesh closed_mesh(PointsView points, std::span<const Triangle> triangles);

/// The finite triangles of a mesh whose sites are numbered like rows, counter-clockwise.
std::vector<Triangle> triangles_of(const Mesh& mesh);

/// The triangulation that Lawson's method begins with: sites from left to right, each with all hull edges it sees.
/// Source: [For92] 4.2. Requires distinct sites that are not all on one line.
std::vector<Triangle> sorted_triangles(PointsView points);

/// Whether the edge f lies inside the hull, between two triangles that make a strictly convex quadrilateral.
bool is_flippable(ComplexView<2> complex, Kernel<2>& kernel, FacetId f);
/// Whether the edge f lies inside the hull and the lifted surface is not convex along it.
bool is_locally_non_regular(ComplexView<2> complex, Kernel<2>& kernel, FacetId f);

/// Flips `count` flippable edges chosen at random, Delaunay or not; fewer when there are hardly any.
void flip_at_random(Mesh& mesh, std::size_t count, std::uint64_t seed);

/// In which order the edges that may need a flip are looked at.
enum class Discipline : std::uint8_t { queue, stack, random };
/// Flips edges that are not locally Delaunay until there is none. @return how many flips that took
std::uint64_t make_delaunay(Mesh& mesh, Discipline discipline, std::uint64_t seed);

}  // namespace delone::lab
