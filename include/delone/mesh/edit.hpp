// One change of a triangulation, as whoever must follow changes hears of it: locators, attributes, replay.
#pragma once

#include <cstdint>
#include <span>

#include "delone/base/ids.hpp"

namespace delone {

/// What became of a point that was offered.
enum class Outcome : std::uint8_t { inserted, duplicate, hidden };

/// Ids of vertices and cells that are gone may be used again, from this very change on: forget first, then learn.
struct Edit {
  std::span<const VertexId> gone = {};   ///< vertices that left: removed, or hidden by a heavier one
  std::span<const VertexId> came = {};   ///< vertices that entered: inserted, or no longer hidden
  std::span<const CellId> removed = {};  ///< cells that are gone
  std::span<const CellId> created = {};  ///< cells in their place; of one vertex that came alone, its star
  bool rebuilt = false;                  ///< every vertex and cell is new, and none is listed
};

}  // namespace delone
