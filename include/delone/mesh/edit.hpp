// One change of a triangulation, as whoever must follow changes hears of it: locators, attributes, replay.
#pragma once

#include <cstdint>
#include <span>

#include "delone/base/ids.hpp"

namespace delone {

/// What became of a point that was offered.
enum class Outcome : std::uint8_t { inserted, duplicate, hidden };

struct Edit {
  VertexId vertex;                  ///< the vertex that came
  std::span<const CellId> removed;  ///< cells that are gone; their ids may be used again
  std::span<const CellId> created;  ///< cells in their place, the star of `vertex`
  bool rebuilt = false;             ///< every cell is new: the point left the flat that held all before it
};

}  // namespace delone
