// Take points out of a triangulation: one, or a batch.
#pragma once

#include <functional>
#include <span>

#include "delone/base/ids.hpp"
#include "delone/base/progress.hpp"
#include "delone/mesh/edit.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

struct Removed {
  Status was;          ///< what the row was: vertex, duplicate or hidden
  Index heir = kNone;  ///< the duplicate that stands for its place now, if there was one
};

struct RemoveOptions {
  std::function<void(const Edit&)> on_edit = nullptr;  ///< hears of the change after it is made; must not throw
};

/// Removes a row. What stays is bit for bit the canonical triangulation of the other points: points that it hid are
/// vertices again, and the lowest duplicate takes its place. Other rows keep their numbers; this one is never used
/// again. Where what stays may lie in a flat, all is built anew, since every cell changes.
/// @throws InputError when there is no such row, or it was removed before; std::bad_alloc. Then `t` is as it was.
/// Cost: for a vertex with k neighbours that of triangulating them (in the plane k log k expected, in small stars a few
/// tests per new cell); with weights the first removal looks for the cell of each hidden point.
Removed remove(AnyTriangulation& t, Index row, const RemoveOptions& options = {});

/// Removes rows, in any order, each once.
/// @throws InputError as above, or when a row is named twice; Cancelled; std::bad_alloc. Then `t` is as it was: the
/// work is done on a copy. Cost: O(cells) for the copy, then as for one after the other; no more than building the
/// rest.
void remove(AnyTriangulation& t, std::span<const Index> rows, const Progress& progress = {});

}  // namespace delone
