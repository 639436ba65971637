// Where one of several threads may change a triangulation: cells all of whose vertices are its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delone/base/ids.hpp"

namespace delone {

/// Each site belongs to a box; the ghost belongs to all. Cells of sites of several boxes stay as they are while threads
/// work: nobody changes their vertices, and at each of their facets at most one thread changes the twin. So a thread
/// reads only what is its own or stays. In dimension 2 and above:
///   A cell across a facet of a held cell has an own site, so it is held or stays; it is held if its apex is.
///   At a facet with an own site, on whichever cell, only this thread can change who is across: a cavity of another
///   thread has no own site. So a walk may cross it, and a test may look behind a ghost cell beside a held one.
struct Territory {
  const std::uint8_t* box_of = nullptr;  ///< per site; null where everything is one's own
  std::uint8_t own = 0;

  bool whole() const { return box_of == nullptr; }
  bool holds(VertexId v) const { return whole() || v == kGhost || box_of[raw(v)] == own; }
  template <std::size_t N>
  bool holds(const std::array<VertexId, N>& vertices) const {
    bool all = true;
    for (const VertexId v : vertices) all = all && holds(v);
    return all;
  }
  /// The same of sites, none of which is the ghost, without a branch for each; not where everything is one's own.
  template <std::size_t N>
  bool holds_sites(const std::array<VertexId, N>& sites) const {
    unsigned differ = 0;
    for (const VertexId site : sites) differ |= static_cast<unsigned>(box_of[raw(site)] ^ own);
    return differ == 0;
  }
  /// Whether a facet, of a cell whose vertices these are opposite one of them, has an own site.
  template <std::size_t N>
  bool touches(const std::array<VertexId, N>& vertices, int opposite) const {
    bool any = whole();
    for (std::size_t i = 0; i < N; ++i)
      any = any || (static_cast<int>(i) != opposite && vertices[i] != kGhost && box_of[raw(vertices[i])] == own);
    return any;
  }
};

}  // namespace delone
