// The neighbours of vertices, kept for a while: queries along a curve ask for the same ones again and again, and above
// the plane going through the star of a vertex costs many times what looking at its neighbours does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "delone/base/buffer.hpp"
#include "delone/topology/complex.hpp"
#include "query/id_set.hpp"

namespace delone::query_detail {

template <int K>
class Neighbours {
 public:
  /// @param kept  of how many vertices the neighbours are kept at most; a power of two
  Neighbours(const ConstComplexView<K>& complex, std::size_t kept) : complex_(complex), slots_(kept) {}

  bool knows(VertexId v) const { return slot(v).vertex == v; }

  /// All neighbours of v, each once, the ghost left out; valid until the next call.
  std::span<const VertexId> operator()(VertexId v) {
    Slot& s = slots_[raw(v) & (slots_.size() - 1)];
    if (s.vertex != v) fill(s, v);
    return {s.neighbours.data(), s.neighbours.size()};
  }

 private:
  struct Slot {
    VertexId vertex = kGhost;
    Buffer<VertexId> neighbours{};
  };
  /// A few vertices may have most of all others as neighbours: room for so many ids is all that is kept.
  static constexpr std::size_t kMostHeld = 1 << 20;

  const Slot& slot(VertexId v) const { return slots_[raw(v) & (slots_.size() - 1)]; }

  [[gnu::noinline]] void fill(Slot& s, VertexId v) {
    s.vertex = kGhost;  // should memory run out
    const std::size_t held = s.neighbours.capacity();
    s.neighbours.clear();
    if constexpr (K == 1) {
      collect_on_line(s.neighbours, v);
    } else if constexpr (K == 2) {
      collect_around(s.neighbours, v);
    } else if constexpr (K > 2) {
      collect_from_star(s.neighbours, v);
    }
    s.vertex = v;
    held_ += s.neighbours.capacity() - held;
    if (held_ > kMostHeld) [[unlikely]]
      forget_all_but(s);
  }

  void forget_all_but(Slot& kept) {
    for (Slot& s : slots_) {
      if (&s != &kept) s = Slot{};
    }
    held_ = 0;  // the one that is kept may be large by itself, and is let go when its place is needed
    if (kept.neighbours.capacity() > kMostHeld / 2) kept.neighbours.shrink_to_fit();
  }

  void collect_on_line(Buffer<VertexId>& found, VertexId v) const {
    const CellId c = complex_.incident_cell(v);
    const int other = 1 - complex_.slot_of(c, v);
    for (const VertexId u : {complex_.vertex(c, other), complex_.vertex(complex_.twin(c, other))}) {
      if (u != kGhost) found.push_back(u);
    }
  }

  /// All cells turn the same way (I3), so crossing the edge after the slot of v again and again goes round v.
  void collect_around(Buffer<VertexId>& found, VertexId v) const {
    const CellId start = complex_.incident_cell(v);
    CellId c = start;
    int slot = complex_.slot_of(c, v);
    do {
      const FacetId across = complex_.twin(c, complex_.turned(slot, 1));
      const VertexId u = complex_.vertex(across);
      if (u != kGhost) found.push_back(u);
      c = complex_.cell(across);
      slot = complex_.turned(complex_.slot(across), 1);
    } while (c != start);
  }

  /// Cells are entered across facets, and each leaves one vertex that can be new. Whether a cell or a vertex is new is
  /// a coin toss: it moves the ends of lists instead of steering the program.
  void collect_from_star(Buffer<VertexId>& found, VertexId v) {
    const CellId start = complex_.incident_cell(v);
    seen_.clear();
    seen_.insert(raw(start));
    entered_.clear();
    {
      Refill<FacetId> entered(entered_);
      const auto enter_around = [&](CellId c) {
        const int slot = complex_.slot_of(c, v);
        entered.make_room(K);
        for (int i = 1; i <= K; ++i) {
          const FacetId across = complex_.twin(c, complex_.turned(slot, i));
          const CellId n = complex_.cell(across);
          complex_.prefetch(n);
          const bool is_new = seen_.insert(raw(n));
          entered.push_if(is_new, across);
        }
      };
      enter_around(start);
      for (std::size_t next = 0; next < entered.size(); ++next) enter_around(complex_.cell(entered[next]));
    }
    seen_.clear();
    seen_.insert(raw(kGhost));
    found.reserve(entered_.size() + K + 1);
    Refill<VertexId> fresh(found);
    const int slot = complex_.slot_of(start, v);
    for (int i = 1; i <= K; ++i) {
      const VertexId u = complex_.vertex(start, complex_.turned(slot, i));
      fresh.push_if(seen_.insert(raw(u)), u);
    }
    for (const FacetId f : entered_) {
      const VertexId u = complex_.vertex(f);
      fresh.push_if(seen_.insert(raw(u)), u);
    }
  }

  ConstComplexView<K> complex_;
  std::vector<Slot> slots_;
  std::size_t held_ = 0;
  IdSet seen_;
  Buffer<FacetId> entered_;
};

}  // namespace delone::query_detail
