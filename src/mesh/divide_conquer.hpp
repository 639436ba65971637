// Delaunay triangulations of the plane by divide and conquer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "delone/base/progress.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// How large a piece serves best: small enough for a cache; when it holds chains, which should be long, a thirty-second
/// of all, so that there still is something to share, up to where it no longer pays.
constexpr std::size_t piece_size(std::size_t sites, bool in_chains) {
  constexpr std::size_t kInCache = 1 << 13;
  return in_chains ? std::clamp<std::size_t>(sites / 32, kInCache, 1 << 17) : kInCache;
}

/// Triangulates the sites of a mesh of dimension 2 without cells and weights, which stand in the order of a CurveCuts.
/// @param cut        that of the same
/// @param in_chains  whether it pays to look for boxes whose sites lie along a line, as a piece of a curve does
/// @param threads    how many share the work; the mesh does not depend on it
/// @param piece      so many sites, at least 1, one thread triangulates by itself; only numbers of cells depend on it
/// Cost: O(n log n) for points that a few levels of boxes part evenly, O(n) expected for uniform ones [Dwyer87].
/// @throws Cancelled when `progress` says so; std::bad_alloc. The mesh is then half-built: callers work on their own.
void divide_and_conquer(Mesh& mesh, std::span<const std::uint16_t> cut, bool in_chains, int threads,
                        const Progress& progress, std::size_t piece);

}  // namespace delone
