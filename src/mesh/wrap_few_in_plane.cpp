// Cells come from searches in floats; whether they are the triangulation is asked when all are found.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "delone/base/buffer.hpp"
#include "geometry/sixteen_in_plane.hpp"
#include "mesh/found_cells.hpp"
#include "mesh/wrap_few.hpp"

namespace delone {

#ifdef DELONE_SIXTEENS

namespace {

using sixteen::InPlane;
using sixteen::kNobody;

/// An edge as seen by the cell to come on its left, and the facet of the cell on its right.
class OpenEdge {
 public:
  OpenEdge() = default;
  OpenEdge(Index from, Index to, Index facet) : entry_(static_cast<std::uint32_t>(facet << 16 | to << 8 | from)) {}

  Index from() const { return entry_ & 0xFF; }
  Index to() const { return entry_ >> 8 & 0xFF; }
  Index facet() const { return entry_ >> 16; }

 private:
  std::uint32_t entry_;  // all three in one word: what is written at once can be read at once
};

/// Which edges have a cell on their left, each direction for itself, and of which that cell is to come.
class EdgeTable {
 public:
  /// Of vertices below `count`.
  explicit EdgeTable(std::size_t count) : shift_(static_cast<int>(std::bit_width(count - 1))), table_(count << shift_) {
    std::ranges::fill(table_, 0);
  }

  bool is_open(const OpenEdge& e) const { return table_[place(e.from(), e.to())] == e.facet() + 1; }
  void open(const OpenEdge& e) { table_[place(e.from(), e.to())] = static_cast<std::uint16_t>(e.facet() + 1); }
  void close(const OpenEdge& e) { table_[place(e.from(), e.to())] = kTaken; }
  /// A cell takes the edge from a to b with its facet f. Returns the facet on the other side; f where that is to come.
  [[gnu::always_inline]] inline Index take(Index a, Index b, Index f) {
    std::uint16_t& here = table_[place(a, b)];
    const Index state = here;
    taken_twice_ |= state == kTaken;
    here = kTaken;
    if (state - 1 < kTaken - 1) {
      table_[place(b, a)] = kTaken;
      return state - 1;
    }
    table_[place(b, a)] = static_cast<std::uint16_t>(f + 1);
    return f;
  }
  bool taken_twice() const { return taken_twice_; }

 private:
  static constexpr Index kTaken = 0xFFFF;  // 0: not known; others: the facet on the right, plus 1

  std::size_t place(std::size_t a, std::size_t b) const { return a << shift_ | b; }

  int shift_;
  bool taken_twice_ = false;
  Buffer<std::uint16_t> table_;
};

class Wrapper {
 public:
  Wrapper(const InPlane& sites, FoundCells& cells) : sites_(sites), cells_(cells), edges_(cells.ghost + 1) {}

  /// False where it is seen to go wrong on the way.
  DELONE_BY_SIXTEENS bool wrap() { return add_first() && add_others(); }

 private:
  DELONE_BY_SIXTEENS bool add_first() {
    constexpr Index kBase = 2;  // its last facet
    Index a = 0, b = sites_.nearest(a);
    if (b == kNobody) return false;
    Index c = sites_.apex(a, b);
    if (c == kNobody) {
      std::swap(a, b);
      c = sites_.apex(a, b);
    }
    if (c == kNobody || sites_.has_tie(sites_.plane(a, b, c))) return false;  // of ties, one seldom comes alone
    edges_.open({a, b, kBase});
    add({a, b, kBase}, c);
    edges_.open({b, a, kBase});
    stack_[stack_size_++] = {b, a, kBase};
    return true;
  }
  /// A search begins before the cell is added that the last one has found: each step of it waits for the one before,
  /// but the processor need not.
  DELONE_BY_SIXTEENS bool add_others() {
    OpenEdge last{}, next{};
    Index apex = kNobody;
    bool found = false;
    while (true) {
      const bool more = take_open(next);
      const Index next_apex = more ? search(next) : kNobody;
      if (found && edges_.is_open(last)) {
        if (cells_.count == cells_.due() || edges_.taken_twice()) return false;
        add(last, apex);
      } else if (!more) {
        return true;
      }
      last = next;
      apex = next_apex;
      found = more;
    }
  }
  [[gnu::always_inline]] inline bool take_open(OpenEdge& edge) {
    while (stack_size_ > 0) {
      edge = stack_[--stack_size_];
      if (edges_.is_open(edge)) return true;
    }
    return false;
  }

  // Neither of these is inlined: together they would need more registers than there are.
  DELONE_BY_SIXTEENS [[gnu::noinline]] Index search(OpenEdge edge) const { return sites_.apex(edge.from(), edge.to()); }
  /// Adds the cell on the left of an open edge; without an apex it is a ghost cell.
  [[gnu::noinline]] void add(OpenEdge edge, Index apex) {
    const Index first_facet = 4 * static_cast<Index>(cells_.count);
    const bool finite = apex != kNobody;
    const Index end = finite ? apex : cells_.ghost;
    cells_.corners[cells_.count++] = {edge.from(), edge.to(), end};
    edges_.close(edge);
    cells_.glue(first_facet + 2, edge.facet());
    meet(first_facet, edge.to(), end, finite);
    meet(first_facet + 1, end, edge.from(), finite);
  }
  [[gnu::always_inline]] inline void meet(Index f, Index from, Index to, bool finite) {
    const Index other = edges_.take(from, to, f);
    cells_.glue(f, other);
    if (other != f) {
      cells_.met[cells_.met_count++] = f;
    } else if (finite) {
      stack_[stack_size_++] = {to, from, f};
    }
  }

  const InPlane& sites_;
  FoundCells& cells_;
  EdgeTable edges_;
  std::size_t stack_size_ = 0;
  std::array<OpenEdge, 2 * FoundCells::kMost> stack_;  // some of them have been met since
};

}  // namespace

bool wrap_few_in_plane(Mesh& mesh) {
  const InPlane sites(mesh.sites);
  FoundCells cells(mesh.sites.size());
  return sites.usable() && Wrapper(sites, cells).wrap() && prove(mesh, sites, cells);
}

#endif

}  // namespace delone
