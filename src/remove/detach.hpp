// A vertex leaves the complex, but its site stays: what removing and moving share.
#pragma once

#include "mesh/insert_one.hpp"

namespace delone {

/// Another row stands for the place of v, the lowest of those that repeat it: the two trade their sites.
/// @param entry  is the other row's, which no longer waits
/// @return the site that was the other row's; it is in no cell
VertexId hand_over(Mesh& mesh, VertexId v, Duplicates::Node& entry);

/// Whether a vertex that leaves may be brought back.
enum class Return : bool { never, possible };

/// Takes the cells of vertex v away. False, and nothing has changed, when what stays may lie in a flat and is to be
/// built anew. On an exception nothing has changed.
bool detach(Mesh& mesh, VertexId v, Return back, const Listener& on_edit);

/// Undoes detach(), if a return was possible and nothing has changed since. Cannot fail.
void bring_back(Mesh& mesh, VertexId v, const Listener& on_edit);

/// Gives vertex v another place and weight if its cells keep their vertices; false, and nothing has changed, if not.
bool move_in_place(Mesh& mesh, VertexId v, std::span<const double> point, double weight, const Listener& on_edit);

}  // namespace delone
