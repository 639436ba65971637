// Two triangulations of the plane with a line between them are knit together, from their lower common tangent upwards:
// [For92] 4.6, [GS85] section 9.
// Departures: cells instead of edges, with ghost cells along the hull as everywhere here: a ghost cell of the seam
// becomes the cell that is knit, an edge is deleted by a flip that makes two ghost cells, and a merge creates two
// cells. Two or three sites need not be knit at all.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "delone/base/buffer.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/topology/complex.hpp"
#include "mesh/few_sites.hpp"

namespace delone {

/// A triangulation of some sites, known by its outermost vertices: by x and then y, and by y and then x. Each site that
/// repeats no other one comes with two cells of the complex; those of the last site of a part stay unused.
struct Part {
  VertexId left, right, bottom, top;
  CellId last;  ///< the first of these two
};

/// Knits parts together. The sides of a seam are called left and right whatever the axis of the cut: nothing but the
/// choice of the first two vertices knows of axes.
class Knitter {
  using View = ComplexView<2>;
  using Triangle = Kernel<2>::Cell;

 public:
  /// @param hull  per site, see hull_; set by single() and few()
  Knitter(Mesh& mesh, Buffer<CellId>& hull) : complex_(mesh.complex), kernel_(mesh.sites), hull_(hull.data()) {}

  /// The part of one site, with its two cells.
  Part single(VertexId v, CellId last) {
    hull_[raw(v)] = kNoCell;
    return {v, v, v, v, last};
  }

  /// The part of two sites, which takes their cells, from `first` on.
  Part few(const std::array<VertexId, 2>& v, CellId first) { return write(kCellsOfTwo, v, first); }
  /// The same of three; nothing, and nothing is done, when they lie on a line.
  std::optional<Part> few(const std::array<VertexId, 3>& v, CellId first) {
    const int side = kernel_.orient(v);
    if (side == 0) return std::nullopt;
    const std::size_t turned = side < 0 ? 1 : 0;  // a place, so that there is no branch
    return write(kCellsOfThree, std::array{v[0], v[1 + turned], v[2 - turned]}, first);
  }

  /// One part from two that a line across an axis separates; the sites of b follow those of a.
  Part merge(const Part& a, const Part& b) {
    spare_ = a.last;
    if (x(a.right) < x(b.left)) return beside(a, b, b.last);
    if (x(b.right) < x(a.left)) return beside(b, a, b.last);
    return y(a.top) < y(b.bottom) ? above(a, b, b.last) : above(b, a, b.last);
  }

  /// Whether a chain, as far as four of its sites tell, bends more where it begins than where it ends, so that its
  /// first site is a corner of more cells than its last.
  bool bends_most_in_front(std::span<const VertexId> chain) {
    if (chain.size() < 4) return true;
    const std::size_t third = chain.size() / 3;
    Triangle triangle{chain[0], chain[third], chain[2 * third]};
    const int side = kernel_.orient(triangle);
    if (side < 0) std::swap(triangle[1], triangle[2]);
    return side == 0 || !kernel_.conflict(triangle, chain.back());
  }

  std::uint64_t cells_made() const { return cells_made_; }
  void add_to(BuildStatistics& statistics) const {
    statistics.predicates += kernel_.stats();
    statistics.cells_created += cells_made_;
  }

 private:
  // The slots of a ghost cell on a hull edge, which leads counter-clockwise from its tail to its head: the ghost stands
  // last (I4). Opposite the head is the ghost cell on the edge before, opposite the tail that on the edge after.
  static constexpr int kHead = 0;
  static constexpr int kTail = 1;
  static constexpr int kGhostSlot = 2;

  /// One side of a seam. Its next hull edge upwards leads from `end` to the candidate for the third corner of the next
  /// cell.
  template <bool Left>
  struct Bank {
    static constexpr int kCandidate = Left ? kHead : kTail;  ///< slots of the ghost cell on that edge
    static constexpr int kEnd = Left ? kTail : kHead;
    /// The same vertices in the cell inside the edge: so many slots after its third one.
    static constexpr int kCandidateTurn = Left ? 2 : 1;
    static constexpr int kEndTurn = Left ? 1 : 2;

    VertexId end;
    bool alone;                     ///< `end` is the whole part: there is no such edge
    CellId open;                    ///< the ghost cell on it; opposite the candidate it is linked to what lies below
    FacetId inner;                  ///< the edge, seen from the cell inside
    VertexId candidate;             ///< this and what follows is known once look() and see() were called
    VertexId beyond;                ///< the corner that would be the candidate if the edge to this one went
    Ray candidate_ray, beyond_ray;  ///< as the left end sees them
    double turn;                    ///< from the right end to the candidate

    Bank(VertexId v, CellId hull) : end(v), alone(hull == kNoCell), open(hull) {}
  };

  /// Writes the cells of a few sites, from `first` on.
  template <std::size_t N>
  Part write(const CellsOfFew<N>& cells, const std::array<VertexId, N>& v, CellId first) {
    std::array<VertexId, N + 1> corners{};
    std::ranges::copy(v, corners.begin());
    corners[N] = kGhost;
    const auto cell = [&](std::size_t i) { return CellId{raw(first) + static_cast<Index>(i)}; };
    const Index first_facet = raw(View::facet(first, 0));
    for (std::size_t c = 0; c < cells.kCount; ++c) {
      for (int i = 0; i < 3; ++i) {
        const auto slot = static_cast<std::size_t>(i);
        complex_.set_vertex(cell(c), i, corners[cells.corners[c][slot]]);
        complex_.set_twin(cell(c), i, FacetId{first_facet + cells.twins[c][slot]});
      }
    }
    Part part{v[0], v[0], v[0], v[0], cell(cells.kCount)};
    for (std::size_t i = 1; i < N; ++i) extend(part, v[i]);
    for (std::size_t i = 0; i < N; ++i) hull_[raw(v[i])] = cell(i);
    cells_made_ += cells.kCount;
    return part;
  }

  void extend(Part& part, VertexId v) const {
    part.left = first_by_x(part.left, v);
    part.right = last_by_x(part.right, v);
    part.bottom = first_by_y(part.bottom, v);
    part.top = last_by_y(part.top, v);
  }

  double x(VertexId v) const { return kernel_.at(v)[0]; }
  double y(VertexId v) const { return kernel_.at(v)[1]; }
  /// Without a branch: which of two vertices comes first nobody can predict.
  static VertexId select(bool second, VertexId a, VertexId b) {
    return VertexId{raw(a) ^ ((raw(a) ^ raw(b)) & (Index{0} - Index{second}))};
  }
  bool x_before(VertexId a, VertexId b) const {
    return static_cast<int>(x(a) < x(b)) | (static_cast<int>(x(a) == x(b)) & static_cast<int>(y(a) < y(b)));
  }
  bool y_before(VertexId a, VertexId b) const {
    return static_cast<int>(y(a) < y(b)) | (static_cast<int>(y(a) == y(b)) & static_cast<int>(x(a) < x(b)));
  }
  VertexId first_by_x(VertexId a, VertexId b) const { return select(x_before(b, a), a, b); }
  VertexId last_by_x(VertexId a, VertexId b) const { return select(x_before(a, b), a, b); }
  VertexId first_by_y(VertexId a, VertexId b) const { return select(y_before(b, a), a, b); }
  VertexId last_by_y(VertexId a, VertexId b) const { return select(y_before(a, b), a, b); }

  Part beside(const Part& left, const Part& right, CellId last) {
    knit(left.right, right.left);
    return {left.left, right.right, first_by_y(left.bottom, right.bottom), last_by_y(left.top, right.top), last};
  }
  Part above(const Part& lower, const Part& upper, CellId last) {
    knit(lower.top, upper.bottom);
    return {first_by_x(lower.left, upper.left), last_by_x(lower.right, upper.right), lower.bottom, upper.top, last};
  }

  /// Knits two parts, from vertices that face each other across the line between them.
  void knit(VertexId left_start, VertexId right_start) {
    Bank<true> left(left_start, hull_[raw(left_start)]);
    Bank<false> right(right_start, hull_[raw(right_start)]);
    if (!right.alone) right.open = above(right);
    while (descend(left, left.end, right.end) || descend(right, left.end, right.end)) {
    }

    const CellId bottom = spare_;
    complex_.set_vertices(bottom, {right.end, left.end, kGhost});
    close(left, bottom);
    close(right, bottom);
    hull_[raw(left.end)] = bottom;
    FacetId base = View::facet(bottom, kGhostSlot);
    look(left);
    look(right);
    see(left, left.end);
    see(right, left.end);
    for (;;) {
      const Ray across = kernel_.ray(right.end, left.end);
      const bool left_on = choose(left, left.end, right.end, across);
      const bool right_on = choose(right, left.end, right.end, across);
      if (!left_on && !right_on) break;
      if (left_on &&
          !(right_on && inside(left.end, right.end, across, left, right.candidate, right.candidate_ray, right.turn))) {
        base = attach(left, right.end, base);
        see(left, left.end);
      } else {
        base = attach(right, left.end, base);
      }
      see(right, left.end);
    }
    const CellId top{raw(spare_) + 1};
    complex_.set_vertices(top, {left.end, right.end, kGhost});
    complex_.link(View::facet(top, kHead), View::facet(right.open, right.kCandidate));
    complex_.link(View::facet(top, kTail), View::facet(left.open, left.kCandidate));
    complex_.link(View::facet(top, kGhostSlot), base);
    hull_[raw(left.end)] = left.open;
    hull_[raw(right.end)] = top;
    cells_made_ += 2;
  }

  /// The ghost cells on the next edges down and up a hull.
  template <bool Left>
  CellId below(const Bank<Left>& bank) const {
    return View::cell(complex_.twin(bank.open, bank.kCandidate));
  }
  template <bool Left>
  CellId above(const Bank<Left>& bank) const {
    return View::cell(complex_.twin(bank.open, bank.kEnd));
  }

  /// Moves the end of a bank down its hull if the next vertex lies below the line through both ends.
  template <bool Left>
  bool descend(Bank<Left>& bank, VertexId left, VertexId right) {
    if (bank.alone) return false;
    const CellId next = below(bank);
    const VertexId v = complex_.vertex(next, bank.kEnd);
    if (kernel_.orient({left, right, v}) >= 0) return false;
    bank.end = v;
    bank.open = next;
    return true;
  }

  /// Links the ghost cell below the seam to the hull of one side; a vertex alone has no hull and stays open upwards.
  template <bool Left>
  void close(Bank<Left>& bank, CellId bottom) {
    if (bank.alone) {
      bank.open = bottom;
    } else {
      complex_.link(View::facet(bottom, bank.kCandidate), View::facet(below(bank), bank.kEnd));
    }
  }

  /// Finds the two vertices of a bank that may come next.
  template <bool Left>
  void look(Bank<Left>& bank) {
    if (bank.alone) return;
    bank.candidate = complex_.vertex(bank.open, bank.kCandidate);
    bank.inner = complex_.twin(bank.open, kGhostSlot);
    bank.beyond = complex_.vertex(bank.inner);
  }
  /// How the left end sees them.
  template <bool Left>
  void see(Bank<Left>& bank, VertexId left) {
    if (bank.alone) return;
    bank.candidate_ray = kernel_.ray(bank.candidate, left);
    if (bank.beyond != kGhost) bank.beyond_ray = kernel_.ray(bank.beyond, left);
  }

  /// Makes the candidate of a bank the corner of the cell on the base that no vertex of its side is in conflict with:
  /// edges in its way are deleted. False when nothing of this side is above the base.
  template <bool Left>
  [[gnu::always_inline]] bool choose(Bank<Left>& bank, VertexId left, VertexId right, const Ray& across) {
    if (bank.alone) return false;
    bank.turn = across.turn(bank.candidate_ray);
    if (kernel_.orient_seen(across, bank.candidate_ray, bank.turn, [&] {
          return Triangle{left, right, bank.candidate};
        }) <= 0)
      return false;
    while (bank.beyond != kGhost) {
      const double turn = across.turn(bank.beyond_ray);
      if (!inside(left, right, across, bank, bank.beyond, bank.beyond_ray, turn)) return true;
      delete_edge(bank);
      bank.candidate_ray = bank.beyond_ray;
      bank.turn = turn;
      if (bank.beyond != kGhost) bank.beyond_ray = kernel_.ray(bank.beyond, left);
    }
    return true;
  }

  /// The edge between end and candidate goes; the cell inside becomes the ghost cell on its upper edge.
  template <bool Left>
  void delete_edge(Bank<Left>& bank) {
    constexpr int kCandidate = Bank<Left>::kCandidate;
    constexpr int kEnd = Bank<Left>::kEnd;
    const CellId open = bank.open;
    const CellId upper = View::cell(bank.inner);
    const int slot = View::slot(bank.inner);
    const FacetId lower_edge = complex_.twin(upper, View::turned(slot, Bank<Left>::kCandidateTurn));
    const FacetId upper_edge = complex_.twin(upper, View::turned(slot, Bank<Left>::kEndTurn));
    const CellId next = above(bank);
    complex_.set_vertex(upper, kCandidate, bank.candidate);
    complex_.set_vertex(upper, kEnd, bank.beyond);
    complex_.set_vertex(upper, kGhostSlot, kGhost);
    complex_.set_vertex(open, kCandidate, bank.beyond);
    complex_.link(View::facet(upper, kEnd), View::facet(next, kCandidate));
    complex_.link(View::facet(upper, kCandidate), View::facet(open, kEnd));
    complex_.link(View::facet(upper, kGhostSlot), upper_edge);
    complex_.link(View::facet(open, kGhostSlot), lower_edge);
    cells_made_ += 2;
    bank.candidate = bank.beyond;
    bank.inner = lower_edge;
    bank.beyond = complex_.vertex(lower_edge);
  }

  /// Whether q lies in the circle through the ends and the candidate of a bank.
  template <bool Left>
  bool inside(VertexId left, VertexId right, const Ray& across, const Bank<Left>& bank, VertexId q, const Ray& ray,
              double turn) {
    return kernel_.conflict_seen(across, bank.candidate_ray, ray, bank.turn, bank.candidate_ray.turn(ray), turn, q,
                                 [&] {
                                   return Triangle{left, right, bank.candidate};
                                 });
  }

  /// The ghost cell of a bank becomes the cell on the base. Returns the new base.
  template <bool Left>
  FacetId attach(Bank<Left>& bank, VertexId other_end, FacetId base) {
    const CellId made = bank.open;
    complex_.set_vertex(made, kGhostSlot, other_end);
    complex_.link(View::facet(made, bank.kCandidate), base);
    bank.end = bank.candidate;
    bank.open = above(bank);
    look(bank);
    ++cells_made_;
    return View::facet(made, bank.kEnd);
  }

  View complex_;
  Kernel<2> kernel_;
  CellId* hull_;    ///< per hull vertex the ghost cell on the edge that leaves it; kNoCell for a vertex alone
  CellId spare_{};  ///< two cells that the next merge may use
  std::uint64_t cells_made_ = 0;
};

}  // namespace delone
