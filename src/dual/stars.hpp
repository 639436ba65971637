// Cells of diagrams, read from the triangulation: with whom a site shares a facet of its cell, and around which centres
// that facet runs.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "delone/mesh/triangulation.hpp"
#include "dual/centres.hpp"
#include "query/id_set.hpp"

namespace delone::dual_detail {

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

  void read_in_space(VertexId v, Star& star) {
    cells_.clear();
    neighbours_.clear();
    edges_.clear();
    stack_.assign(1, complex_.incident_cell(v));
    cells_.insert(raw(stack_[0]));
    for (std::size_t next = 0; next < stack_.size(); ++next) {
      const CellId c = stack_[next];
      const int i = complex_.slot_of(c, v);
      for (int by = 1; by <= K; ++by) {
        const int j = View::turned(i, by);
        const CellId across = complex_.cell(complex_.twin(c, j));
        if (cells_.insert(raw(across))) stack_.push_back(across);
        const VertexId u = complex_.vertex(c, j);
        if (u != kGhost && neighbours_.insert(raw(u))) edges_.push_back({u, c});
      }
    }
    for (const auto& [u, c] : edges_) turn_about(v, u, c, star);
  }

  /// The facet between v and u. Of a positive cell (v, u, a, b), a turns towards b about the axis from v to u, seen
  /// from its end. It has an extent when at least three vertices or rays of the diagram follow each other around it.
  void turn_about(VertexId v, VertexId u, CellId first, Star& star) {
    const std::size_t begin = star.ring.size();
    const int i = complex_.slot_of(first, v);
    const int j = complex_.slot_of(first, u);
    int a = View::turned(i, 1);
    while (a == j) a = View::turned(a, 1);
    const int rest = 6 - i - j - a;
    // (i, j, a, rest) is an even permutation of (0, 1, 2, 3) or not
    const bool even = ((i > j) + (i > a) + (i > rest) + (j > a) + (j > rest) + (a > rest)) % 2 == 0;
    VertexId behind = complex_.vertex(first, even ? a : rest);
    VertexId ahead = complex_.vertex(first, even ? rest : a);
    RingCell c = ring_cell(first);
    do {
      const FacetId across = complex_.twin(c.cell, complex_.slot_of(c.cell, behind));
      const RingCell next = ring_cell(complex_.cell(across));
      if (!coincide(c, next, complex_.vertex(across))) star.ring.push_back(c);
      behind = std::exchange(ahead, complex_.vertex(across));
      c = next;
    } while (c.cell != first);
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
  query_detail::IdSet cells_, neighbours_;
  std::vector<CellId> stack_;
  struct Edge {
    VertexId to;
    CellId cell;
  };
  std::vector<Edge> edges_;
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
