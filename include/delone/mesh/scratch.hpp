// Working memory of an insertion, kept from one to the next so that nothing is allocated after warm-up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"

namespace delone {

/// In 3D: the facets of a new star by the directed edges of the cavity's boundary, on vertices numbered as they come.
struct EdgeTable {
  static constexpr std::size_t kVertices = 48;  ///< larger stars are linked by turning

  Buffer<std::uint8_t> number;  ///< per vertex + 1, the ghost at 0; valid when member[number] is the vertex
  std::array<VertexId, kVertices> member;
  std::array<std::array<FacetId, kVertices>, kVertices> facet;
  std::array<std::array<std::size_t, 3>, 2 * kVertices> numbers;  ///< per new cell, of its three boundary vertices
};

struct Scratch {
  enum Mark : std::uint8_t { unknown, conflicting, staying };

  Buffer<std::uint8_t> marks;     ///< per cell slot; all `unknown` between insertions
  std::vector<CellId> removed;    ///< the cavity
  std::vector<CellId> spared;     ///< cells around it that were tested and stay
  std::vector<FacetId> boundary;  ///< facets of removed cells towards spared ones
  std::vector<CellId> created;    ///< the star, in the order of `boundary`
  EdgeTable edges;

  /// Marks for cells below `slots`.
  void reserve_marks(std::size_t slots) {
    if (slots <= marks.size()) return;
    marks.reserve_more(slots - marks.size());
    marks.resize(marks.capacity(), unknown);
  }
  /// Room for a star beside the cavity just found; on std::bad_alloc the marks are clean.
  void prepare_star(std::size_t slots, std::size_t vertices) {
    created.resize(boundary.size());
    if (edges.number.size() <= vertices) edges.number.resize(2 * vertices + 1, 0);
    reserve_marks(slots + boundary.size());
  }
  std::size_t memory_bytes() const {
    return marks.capacity() + edges.number.capacity() +
           (removed.capacity() + spared.capacity() + created.capacity()) * sizeof(CellId) +
           boundary.capacity() * sizeof(FacetId);
  }
  void clean_marks() {
    for (const CellId c : removed) marks[raw(c)] = unknown;
    for (const CellId c : spared) marks[raw(c)] = unknown;
  }
};

}  // namespace delone
