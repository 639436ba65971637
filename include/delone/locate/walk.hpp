// The plain walk as a locator: from where the last point was, or always from the same place, to the query.
// Source: [For92] 4.3 (the visibility walk, mesh/walk.hpp); [DPT02] (the remembering stochastic walk).
// Departure from [DPT02]: a walk is bounded, and past the bound every cell is looked at, as in mesh/walk.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "delone/locate/locator.hpp"

namespace delone {

/// Walks itself: its hint is the closed cell that contains the query, and the caller's walk only sees that it has
/// arrived. Survives inserts and removes. A hint costs the walk, about n^(1/D) steps from a random place.
class Walk {
 public:
  enum class Method : std::uint8_t {
    visibility,   ///< all facets of a cell are tested at once, the most negative side is left by
    remembering,  ///< facets are tested one by one from a random one on, but not the one that the walk came through
  };
  enum class Start : std::uint8_t { last_cell, first_vertex };

  Method method = Method::visibility;
  Start start = Start::last_cell;
  std::uint64_t seed = 1;  ///< of the remembering walk

  CellId hint(const AnyTriangulation& t, std::span<const double> q);
  void update(const AnyTriangulation& t, const Edit& e) noexcept;

  const LocateCounts& counts() const { return counts_; }
  std::size_t memory_bytes() const { return sizeof *this; }

 private:
  CellId start_cell(const AnyTriangulation& t) const;

  CellId last_ = kNoCell;
  VertexId first_ = kGhost;
  std::uint64_t drawn_ = 0;
  LocateCounts counts_;
};

}  // namespace delone
