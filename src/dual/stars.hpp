// Cells of diagrams, read from the triangulation: with whom a site shares a facet of its cell, and around which centres
// that facet runs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "delone/mesh/triangulation.hpp"
#include "dual/centres.hpp"

namespace delone::dual_detail {

/// Numbers for a few ids, forgotten in no time.
class IdNumbers {
 public:
  void clear() {
    size_ = 0;
    if (++round_ == 0 || slots_.empty()) {
      slots_.assign(std::max<std::size_t>(slots_.size(), 256), {});
      round_ = 1;
    }
  }
  /// The number of `id`, which is `number` when it is new.
  std::pair<std::uint32_t, bool> insert(Index id, std::uint32_t number) {
    if (4 * (size_ + 1) > slots_.size()) grow();
    Slot& slot = place(id);
    if (slot.round == round_) return {slot.number, false};
    slot = {id, number, round_};
    ++size_;
    return {number, true};
  }

 private:
  struct Slot {
    Index id = 0;
    std::uint32_t number = 0, round = 0;
  };
  Slot& place(Index id) {
    std::size_t at = (static_cast<std::uint64_t>(id) * 0x9E3779B97F4A7C15U >> 32) & (slots_.size() - 1);
    while (slots_[at].round == round_ && slots_[at].id != id) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
  }
  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.round == round_) place(slot.id) = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
  std::uint32_t round_ = 0;
};

/// A facet of a cell: the sites on both sides have it in common, and it has an extent.
struct Facet {
  VertexId neighbour;
  std::size_t end;  ///< of its run in Star::ring
};

struct RingCell {
  Centre centre;  ///< unless it is a ghost
  CellId cell;
  bool ghost;
};

/// What surrounds one site. Delaunay edges whose dual has no extent, since cells on one sphere only happen to be cut
/// that way, are left out; so it does not depend on how ties are broken.
struct Star {
  std::vector<Facet> facets;  ///< in the plane counter-clockwise
  /// Of full dimension: the cells around each facet, counter-clockwise from outside, no two that follow each other with
  /// the same centre, or for ghosts the same ray. In the plane one per facet, where its edge begins.
  std::vector<RingCell> ring;

  void clear() {
    facets.clear();
    ring.clear();
  }
};

template <int K>
class StarReader {
 public:
  /// @param centres  null when the points span no more than a flat: its centres are not those of the diagram
  StarReader(const AnyTriangulation& t, Centres<K>* centres)
      : triangulation_(t), complex_(t.complex()), kernel_(t.sites()), centres_(centres) {}

  /// Of a vertex of the triangulation.
  void read(VertexId v, Star& star) {
    star.clear();
    if constexpr (K == 1) {
      read_on_line(v, star);
    } else if constexpr (K == 2) {
      read_in_plane(v, star);
    } else {
      read_in_space(v, star);
    }
  }

 private:
  using View = ConstComplexView<K>;

  RingCell ring_cell(CellId c) {
    const bool ghost = complex_.is_ghost(c);
    if (ghost || centres_ == nullptr) return {{}, c, ghost};
    return {(*centres_)[c], c, false};
  }

  /// Are the duals of two neighbouring cells the same vertex, or the same ray? @param apex  of d, which c lacks
  bool coincide(const RingCell& c, const RingCell& d, VertexId apex) {
    if (c.ghost != d.ghost) return false;
    if (!c.ghost) {
      return centres_ != nullptr ? centres_->coincide(c.centre, d.centre, c.cell, apex)
                                 : on_common_orthosphere<K>(kernel_, triangulation_.complex(), c.cell, apex);
    }
    typename Kernel<K>::Cell flat = complex_.vertices(c.cell);
    flat[static_cast<std::size_t>(complex_.ghost_slot(c.cell))] = apex;
    return kernel_.orient(flat) == 0;
  }

  void read_on_line(VertexId v, Star& star) {
    const CellId first = complex_.incident_cell(v);
    const CellId second = complex_.cell(complex_.twin(first, 1 - complex_.slot_of(first, v)));
    for (const CellId c : {first, second}) {
      const VertexId other = complex_.vertex(c, 1 - complex_.slot_of(c, v));
      if (other != kGhost) star.facets.push_back({other, 0});
    }
  }

  /// Turns about v. With v in slot i of a positive triangle, the edge to the corner in slot i + 2 follows its centre.
  void read_in_plane(VertexId v, Star& star) {
    RingCell c = ring_cell(complex_.incident_cell(v));
    const CellId first = c.cell;
    do {
      const int i = complex_.slot_of(c.cell, v);
      const VertexId u = complex_.vertex(c.cell, View::turned(i, 2));
      const FacetId across = complex_.twin(c.cell, View::turned(i, 1));
      const RingCell next = ring_cell(complex_.cell(across));
      if (u != kGhost && !coincide(c, next, complex_.vertex(across))) {
        star.ring.push_back(c);
        star.facets.push_back({u, star.ring.size()});
      }
      c = next;
    } while (c.cell != first);
  }

  /// Reads the link of v, a triangulated sphere, and goes around each of its vertices.
  void read_in_space(VertexId v, Star& star) {
    cells_.clear();
    link_.clear();
    number_of(complex_.incident_cell(v));
    for (std::size_t t = 0; t < link_.size(); ++t) {
      const CellId c = link_[t].at.cell;
      link_[t].at = ring_cell(c);
      const int i = complex_.slot_of(c, v);
      // (v, corner 0, 1, 2) is positive: turning a cell's four slots round is an odd permutation.
      const std::array slots{View::turned(i, 1), View::turned(i, i % 2 == 0 ? 2 : 3),
                             View::turned(i, i % 2 == 0 ? 3 : 2)};
      for (std::size_t s = 0; s < 3; ++s) {
        const CellId across = complex_.cell(complex_.twin(c, slots[s]));
        const std::uint32_t next = number_of(across);
        link_[t].corner[s] = complex_.vertex(c, slots[s]);
        link_[t].next[s] = next;
      }
    }
    for (LinkTriangle& t : link_) {
      for (std::size_t s = 0; s < 3; ++s) {
        if (!t.done[s] && t.corner[s] != kGhost) turn_about(t, s, star);
      }
    }
  }

  /// A cell at v as a triangle of its link, counter-clockwise from outside.
  struct LinkTriangle {
    RingCell at;
    std::array<VertexId, 3> corner;
    std::array<std::uint32_t, 3> next;  ///< the triangle opposite each corner
    std::array<bool, 3> done;           ///< the facet with that corner was read
  };

  std::uint32_t number_of(CellId c) {
    const auto [number, is_new] = cells_.insert(raw(c), static_cast<std::uint32_t>(link_.size()));
    if (is_new) {
      complex_.prefetch(c);
      if (centres_ != nullptr) centres_->prefetch(c);
      link_.push_back({{{}, c, false}, {}, {}, {}});
    }
    return number;
  }

  /// The facet between v and a corner u of its link. It has an extent when at least three vertices or rays of the
  /// diagram follow each other around it.
  void turn_about(LinkTriangle& first, std::size_t slot, Star& star) {
    const std::size_t begin = star.ring.size();
    const VertexId u = first.corner[slot];
    LinkTriangle* t = &first;
    do {
      t->done[slot] = true;
      LinkTriangle& next = link_[t->next[slot == 2 ? 0 : slot + 1]];
      slot = next.corner[0] == u ? 0 : next.corner[1] == u ? 1 : 2;
      const VertexId apex = next.corner[slot == 0 ? 2 : slot - 1];
      if (!coincide(t->at, next.at, apex)) star.ring.push_back(t->at);
      t = &next;
    } while (t != &first);
    if (star.ring.size() - begin >= 3) {
      star.facets.push_back({u, star.ring.size()});
    } else {
      star.ring.resize(begin);
    }
  }

  const AnyTriangulation& triangulation_;
  View complex_;
  Kernel<K> kernel_;
  Centres<K>* centres_;
  IdNumbers cells_;
  std::vector<LinkTriangle> link_;
};

/// The same for a triangulation of any affine dimension up to 3.
class Stars {
 public:
  /// @param centres  of a triangulation of full dimension D
  template <int D>
  Stars(const AnyTriangulation& t, Centres<D>& centres) {
    const int k = t.affine_dimension();
    if (k == 1) reader_.emplace<StarReader<1>>(t, nullptr);
    if (k == D) {
      reader_.emplace<StarReader<D>>(t, &centres);
    } else if (k == 2) {
      reader_.emplace<StarReader<2>>(t, nullptr);
    }
  }

  void read(VertexId v, Star& star) {
    std::visit(
        [&](auto& reader) {
          if constexpr (std::is_same_v<std::decay_t<decltype(reader)>, std::monostate>) {
            star.clear();
          } else {
            reader.read(v, star);
          }
        },
        reader_);
  }

 private:
  std::variant<std::monostate, StarReader<1>, StarReader<2>, StarReader<3>> reader_;  // a single place has no reader
};

}  // namespace delone::dual_detail
