// Where one of several threads may change a triangulation: cells all of whose vertices are its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delone/base/ids.hpp"

namespace delone {

/// Each site belongs to one part; the ghost to all. Cells of sites of several parts stay as they are while threads
/// work: nobody changes their vertices, and at each of their facets at most one thread changes the twin. So a thread
/// reads only what is its own or stays.
struct Territory {
  const std::uint8_t* part_of = nullptr;  ///< per site; null where everything is one's own
  std::uint8_t own = 0;

  bool whole() const { return part_of == nullptr; }
  bool holds(VertexId v) const { return whole() || v == kGhost || part_of[raw(v)] == own; }
  template <std::size_t N>
  bool holds(const std::array<VertexId, N>& vertices) const {
    bool all = true;
    for (const VertexId v : vertices) all = all && holds(v);
    return all;
  }
  /// The same of sites only, without a branch for each, where there are parts.
  template <std::size_t N>
  bool holds_all(const std::array<VertexId, N>& sites) const {
    unsigned differ = 0;
    for (const VertexId site : sites) differ |= static_cast<unsigned>(part_of[raw(site)] ^ own);
    return differ == 0;
  }
  /// Whether a facet, of a cell whose vertices these are opposite one of them, has a site of one's own. Then nobody
  /// else changes the cells on its sides, nor what they know of each other.
  template <std::size_t N>
  bool touches(const std::array<VertexId, N>& vertices, int opposite) const {
    bool any = whole();
    for (std::size_t i = 0; i < N; ++i)
      any = any || (static_cast<int>(i) != opposite && vertices[i] != kGhost && part_of[raw(vertices[i])] == own);
    return any;
  }
};

}  // namespace delone
