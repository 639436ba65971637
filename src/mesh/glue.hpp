// One triangulation from two whose sites lie in boxes that do not meet: in any dimension, with or without weights.
#pragma once

#include <optional>

#include "delone/mesh/triangulation.hpp"

namespace delone {

/// The triangulation of the sites of both meshes, which have one dimension K >= 2 and one flat and name their rows
/// apart. Nothing when the sites near the border span less than the flat, or are more than half of all.
/// @param threads  how many share the work; only the numbers of cells depend on it
/// Cost: O(n) to copy the cells of b, and the triangulation of the sites near the border.
std::optional<Mesh> glue(Mesh a, const Mesh& b, int threads);

/// The share of the sites of two such meshes that would be near the border. Cost: of the cells there.
double border_share(const Mesh& a, const Mesh& b);

}  // namespace delone
