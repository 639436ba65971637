// Power centres of sites, the vertices of power and Voronoi diagrams, and the directions in which diagrams run to
// infinity. Every number is the double nearest to the true one, so a vertex has the same coordinates whichever of the
// cells on its sphere it is computed from.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/sites.hpp"

namespace delone {

/// A point or a direction; components beyond the dimension of the points are 0.
using Vector = std::array<double, kMaxDimension>;

/// numerator / denominator in lowest terms, decimal, the denominator positive.
struct Rational {
  std::string numerator, denominator;
  bool operator==(const Rational&) const = default;
};

/// The point of the flat of affinely independent sites that has the same power to all of them: of equal weights the
/// circumcentre. Each coordinate is rounded to the nearest double, once; beyond the largest double it is infinite.
/// @param cell  1 to D + 1 sites
/// Cost: a microsecond; some more where pairs of doubles do not tell the rounding.
Vector power_centre(const Sites& sites, std::span<const VertexId> cell);

/// The same seen from the first site of the cell: what is left when that site is subtracted, rounded once. Far from the
/// origin this has digits that the coordinates lack.
Vector power_centre_offset(const Sites& sites, std::span<const VertexId> cell);

/// The same point exactly, a number per axis.
std::vector<Rational> exact_power_centre(const Sites& sites, std::span<const VertexId> cell);

/// The direction in the flat of facet and apex that is orthogonal to the facet and leads away from the apex. Scaled so
/// that the largest component is 1 or -1; the others are rounded to the nearest double.
/// @param facet  affinely independent sites, and the apex with them
Vector outward_normal(const Sites& sites, std::span<const VertexId> facet, VertexId apex);

/// Directions that span all that is orthogonal to the flat of these sites, one for each axis on which the flat of all
/// sites depends on others (Flat::axes lacks it), scaled and rounded likewise.
std::vector<Vector> orthogonal_directions(const Sites& sites, std::span<const VertexId> cell);

}  // namespace delone
