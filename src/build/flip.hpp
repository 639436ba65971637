// Incremental topological flipping, in any dimension, with weights.
// Source: [ES96] 4 to 8; in the plane also the loop of [GKS92] 3 and the recursion of [Slides].
#pragma once

#include <cstddef>
#include <cstdint>

#include "delone/base/progress.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

enum class FlipForm : std::uint8_t {
  stack,     ///< [ES96] 7: a stack of link facets, in any dimension
  loop,      ///< [GKS92] 3: once round the point and back wherever something was flipped; in the plane, no weights
  legalize,  ///< [Slides]: LegalizeEdge, with a stack in place of recursion; in the plane, no weights
};

/// Triangulates sites 0 to count - 1, in their order, of a mesh without cells as distinct_sites makes it.
/// @throws Cancelled when `progress` says so; std::bad_alloc
void build_by_flips(Mesh& mesh, std::size_t count, FlipForm form, const Progress& progress);

/// The same with the lift turned over: the upper hull of the lifted sites, whose cells have all sites in their balls. A
/// site that is no corner of the convex hull becomes no vertex. Sites have no weights.
/// Source: [GKS92] 4.1, the remark after theorem 4.2.
void build_furthest_by_flips(Mesh& mesh, std::size_t count, const Progress& progress);

}  // namespace delone
