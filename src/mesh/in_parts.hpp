// Insertion by several threads into one mesh, each in a part of space.
#pragma once

#include <cstddef>
#include <span>

#include "delone/base/progress.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// As insert_range() in incremental.hpp, from site `first` to the last one. The triangulation does not depend on
/// `threads`; the numbers of its cells do, and which of several equal sites is the vertex.
/// @param round_ends  see brio.hpp: sites of one round are shared out, one round comes after the other
/// @param few  without as many sites in it, and as many there before it, a box is not worth a thread
void insert_rounds(Mesh& mesh, std::size_t first, std::span<const std::size_t> round_ends, int threads,
                   const Progress& progress, std::size_t few = 512);

/// As insert_all(): one thread inserts the first round, then as above.
/// @param round_ends  at least one
void insert_all_in_rounds(Mesh& mesh, std::span<const std::size_t> round_ends, int threads, const Progress& progress);

}  // namespace delone
