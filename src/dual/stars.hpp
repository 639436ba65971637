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

/// A facet of a cell: the sites on both sides have it in common, and it has an extent.
struct Facet {
  VertexId neighbour;
  std::size_t end;  ///< of its run in Star::ring
};

/// A cell of the triangulation at a site.
struct StarCell {
  Centre centre;  ///< unless it is a ghost
  CellId cell;
  bool ghost;
};

/// What surrounds one site. Delaunay edges whose dual has no extent, since cells on one sphere only happen to be cut
/// that way, are left out; so it does not depend on how ties are broken.
struct Star {
  std::vector<Facet> facets;  ///< in the plane counter-clockwise
  std::vector<StarCell> cells;
  /// Of full dimension: the cells around each facet, by their places in `cells`, counter-clockwise from outside, no two
  /// that follow each other with the same centre, or for ghosts the same ray. In the plane one per facet, where its
  /// edge begins.
  std::vector<std::uint32_t> ring;

  const StarCell& at(std::size_t i) const { return cells[ring[i]]; }
  void clear() {
    facets.clear();
    cells.clear();
    ring.clear();
  }
};

template <int K>
class StarReader {
 public:
  /// @param centres  null when the points span no more than a flat: its centres are not those of the diagram
  StarReader(const AnyTriangulation& t, Centres<K>* centres)
      : triangulation_(t),
        complex_(t.complex()),
        kernel_(t.sites()),
        centres_(centres),
        numbers_(K == 3 ? complex_.slot_count() : 0) {}

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

  /// In the plane, counter-clockwise: visit(cell, neighbour, has_extent) for each cell at v. The facet to the neighbour
  /// begins at its centre; without extent, there is none. Ends and returns false as soon as `visit` does.
  template <class Visit>
  [[gnu::always_inline]] bool turn_in_plane(VertexId v, const Visit& visit) requires(K == 2) {
    StarCell c = star_cell(complex_.incident_cell(v));
    const CellId first = c.cell;
    do {
      // With v in slot i of a positive triangle, the edge to the corner in slot i + 2 follows its centre.
      const int i = complex_.slot_of(c.cell, v);
      const VertexId u = complex_.vertex(c.cell, View::turned(i, 2));
      const FacetId across = complex_.twin(c.cell, View::turned(i, 1));
      const StarCell next = star_cell(complex_.cell(across));
      if (!visit(c, u, u != kGhost && !coincide(c, next, complex_.vertex(across)))) return false;
      c = next;
    } while (c.cell != first);
    return true;
  }

 private:
  using View = ConstComplexView<K>;

  StarCell star_cell(CellId c) {
    const bool ghost = complex_.is_ghost(c);
    if (ghost || centres_ == nullptr) return {{}, c, ghost};
    return {(*centres_)[c], c, false};
  }

  /// Are the duals of two neighbouring cells the same vertex, or the same ray? @param apex  of d, which c lacks
  [[gnu::always_inline]] bool coincide(const StarCell& c, const StarCell& d, VertexId apex) {
    if (c.ghost != d.ghost) return false;
    if (c.ghost) return on_common_hyperplane<K>(kernel_, triangulation_.complex(), c.cell, apex);
    return centres_ != nullptr ? centres_->coincide(c.centre, d.centre, c.cell, apex)
                               : on_common_orthosphere<K>(kernel_, triangulation_.complex(), c.cell, apex);
  }

  void read_on_line(VertexId v, Star& star) {
    const CellId first = complex_.incident_cell(v);
    const CellId second = complex_.cell(complex_.twin(first, 1 - complex_.slot_of(first, v)));
    for (const CellId c : {first, second}) {
      const VertexId other = complex_.vertex(c, 1 - complex_.slot_of(c, v));
      if (other != kGhost) star.facets.push_back({other, 0});
    }
  }

  void read_in_plane(VertexId v, Star& star) {
    turn_in_plane(v, [&](const StarCell& c, VertexId u, bool has_extent) {
      star.cells.push_back(c);
      if (!has_extent) return true;
      star.ring.push_back(static_cast<std::uint32_t>(star.cells.size() - 1));
      star.facets.push_back({u, star.ring.size()});
      return true;
    });
  }

  /// Reads the link of v, a triangulated sphere, and goes around each of its vertices.
  void read_in_space(VertexId v, Star& star) {
    link_.clear();
    number_of(complex_.incident_cell(v), star);
    for (std::size_t t = 0; t < link_.size(); ++t) {
      const CellId c = star.cells[t].cell;
      star.cells[t] = star_cell(c);
      const int i = complex_.slot_of(c, v);
      // (v, corner 0, 1, 2) is positive: turning a cell's four slots round is an odd permutation.
      const std::array slots{View::turned(i, 1), View::turned(i, i % 2 == 0 ? 2 : 3),
                             View::turned(i, i % 2 == 0 ? 3 : 2)};
      for (std::size_t s = 0; s < 3; ++s) {
        const std::uint32_t next = number_of(complex_.cell(complex_.twin(c, slots[s])), star);
        link_[t].corner[s] = complex_.vertex(c, slots[s]);
        link_[t].next[s] = next;
      }
    }
    star.ring.resize(3 * link_.size());  // a place for every corner of every triangle
    std::size_t used = 0;
    for (std::uint32_t t = 0; t < link_.size(); ++t) {
      for (std::uint32_t s = 0; s < 3; ++s) {
        if (link_[t].done[s] || link_[t].corner[s] == kGhost) continue;
        const std::size_t length = turn_about(t, s, star.cells.data(), star.ring.data() + used);
        if (length < 3) continue;
        used += length;
        star.facets.push_back({link_[t].corner[s], used});
      }
    }
    star.ring.resize(used);
  }

  /// A cell at v as a triangle of its link, counter-clockwise from outside; of the same number as in Star::cells.
  struct LinkTriangle {
    std::array<VertexId, 3> corner;
    std::array<std::uint32_t, 3> next;  ///< the triangle opposite each corner
    std::array<bool, 3> done;           ///< the facet with that corner was read
  };

  /// The number that is noted for a cell is its own when the cell of that number is it.
  std::uint32_t number_of(CellId c, Star& star) {
    const std::uint32_t number = numbers_[raw(c)];
    if (number < link_.size() && star.cells[number].cell == c) return number;
    complex_.prefetch(c);
    centres_->prefetch(c);
    link_.push_back({});
    star.cells.push_back({{}, c, false});
    return numbers_[raw(c)] = static_cast<std::uint32_t>(link_.size() - 1);
  }

  /// The facet between v and a corner u of its link. It has an extent when at least three vertices or rays of the
  /// diagram follow each other around it. Returns how many do.
  std::size_t turn_about(std::uint32_t first, std::uint32_t slot, const StarCell* cells, std::uint32_t* ring) {
    LinkTriangle* const link = link_.data();
    const VertexId u = link[first].corner[slot];
    std::uint32_t t = first;
    std::size_t length = 0;
    do {
      link[t].done[slot] = true;
      const std::uint32_t next = link[t].next[slot == 2 ? 0 : slot + 1];
      const std::array<VertexId, 3>& corner = link[next].corner;
      slot = corner[0] == u ? 0 : corner[1] == u ? 1 : 2;
      ring[length] = t;
      length += coincide(cells[t], cells[next], corner[slot == 0 ? 2 : slot - 1]) ? 0 : 1;
      t = next;
    } while (t != first);
    return length;
  }

  const AnyTriangulation& triangulation_;
  View complex_;
  Kernel<K> kernel_;
  Centres<K>* centres_;
  std::vector<std::uint32_t> numbers_;  ///< per cell, in space
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
