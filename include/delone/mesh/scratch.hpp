// Working memory of an insertion, kept from one to the next so that nothing is allocated after warm-up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"

namespace delone {

struct Scratch {
  enum Mark : std::uint8_t { unknown, conflicting, staying };

  Buffer<std::uint8_t> marks;     ///< per cell slot; all `unknown` between insertions
  std::vector<CellId> removed;    ///< the cavity
  std::vector<CellId> spared;     ///< cells around it that were tested and stay
  std::vector<FacetId> boundary;  ///< facets of removed cells towards spared ones
  std::vector<CellId> created;    ///< the star, in the order of `boundary`

  /// Marks for cells below `slots`.
  void reserve_marks(std::size_t slots) {
    if (slots <= marks.size()) return;
    marks.reserve_more(slots - marks.size());
    marks.resize(marks.capacity(), unknown);
  }
  /// Room for a star beside the cavity just found; on std::bad_alloc the marks are clean.
  void prepare_star(std::size_t slots) {
    created.resize(boundary.size());
    reserve_marks(slots + boundary.size());
  }
  std::size_t memory_bytes() const {
    return marks.capacity() + (removed.capacity() + spared.capacity() + created.capacity()) * sizeof(CellId) +
           boundary.capacity() * sizeof(FacetId);
  }
  void clean_marks() {
    for (const CellId c : removed) marks[raw(c)] = unknown;
    for (const CellId c : spared) marks[raw(c)] = unknown;
  }
};

}  // namespace delone
