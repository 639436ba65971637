// Source: [ES96] 4 (flips), 6 (flippable facets), 7 (the stack of link facets, the history dag, redundant points found
// early), 8 (why it ends); [GKS92] 3 and [Slides] for the two forms in the plane.
//
// A point p comes into a cell of its region. First that cell gives way to the star of p. Then, while a cell c next to
// the star is in conflict with p, c and those cells of the star that touch it give way to others of the star: a flip.
// With I the slots of c whose facets the star touches, the removed cells are c and, for i in I, the one beyond facet i;
// the new ones are c with p in the place of vertex j, for each j not in I. |I| = 0 is the first flip ("1 to K + 1"),
// |I| = K makes one cell of K + 1, and hides a vertex.
//
// c is flippable when the star touches every facet of c that faces p: cells are taken in an order in which they lie
// behind each other, as a point sees them that sinks from far above p, in the lifted picture, down to its place there.
// Whether a facet faces p is the sign of a determinant with p in it. Facets of ghost cells that hold the ghost are
// walls from the origin o of the history (mesh/history.hpp): of two ghost cells the one on the side of o comes first,
// since the lifted point comes from above o and enters the hull's outside straight towards p.
//
// Departures: the ghost vertex in place of the far points S0 of [ES96] 7 and p0, p-1, p-2 of [Slides]. A point on a
// facet, an edge, ... of its cell ([Slides]' case 2) is treated as infinitely near it, inside: p' = p + e (v0 - p) +
// e^2 (v1 - p) + ... with the finite vertices v of the cell that it comes into. So no case is left; cells without
// volume may come, and go again before the insertion ends: what the flips remove is exactly what p is in conflict
// with, and that does not depend on e. Ties of heights are broken by the kernel, which [ES96] 2 leaves to a simulation
// of general position.
#include "build/flip.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "base/grown.hpp"
#include "delone/base/buffer.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/cavity.hpp"
#include "delone/topology/complex.hpp"
#include "geometry/furthest_kernel.hpp"
#include "mesh/history.hpp"
#include "mesh/one_by_one.hpp"

namespace delone {
namespace {

/// @tparam K  dimension   @tparam Lift  a Kernel, or one that turns heights over
template <int K, class Lift>
class Flipper {
  using View = ComplexView<K>;
  using Cell = std::array<VertexId, K + 1>;
  static constexpr std::size_t kCorners = K + 1;

 public:
  /// @param all_are_vertices  no site is redundant, so that none is asked about it
  Flipper(Mesh& mesh, FlipForm form, bool all_are_vertices)
      : mesh_(&mesh), complex_(mesh.complex), kernel_(mesh.sites), form_(form), all_are_vertices_(all_are_vertices) {
    for (std::size_t s = 0; s < complex_.slot_count(); ++s) {
      const CellId c{static_cast<Index>(s)};
      history_.add(c, complex_.vertices(c));
    }
  }
  ~Flipper() { mesh_->statistics.predicates += kernel_.stats(); }
  Flipper(const Flipper&) = delete;
  Flipper& operator=(const Flipper&) = delete;

  void insert(VertexId p) {
    const CellId start = locate(p);
    if (start == kNoCell) return;
    p_ = p;
    see(start);
    ++mesh_->vertex_count;
    link_.clear();
    flip(start, {});
    if constexpr (K == 2) {
      if (form_ == FlipForm::loop) return flip_around();
      if (form_ == FlipForm::legalize) return legalize_all();
    }
    while (!link_.empty()) flip_at(pop());
  }

 private:
  /// Per slot of a cell whether the star of p touches the facet opposite.
  using Touched = std::array<bool, kCorners>;

  /// The live cell whose region p comes into, or kNoCell when p is redundant: then a cell of the past that contains it
  /// is enough to know.
  CellId locate(VertexId p) {
    const auto redundant = [&](const Cell& cell) {
      if (all_are_vertices_ || std::ranges::find(cell, kGhost) != cell.end()) return false;
      return kernel_.orient(cell) > 0 && !kernel_.conflict(cell, p);
    };
    const Index found = history_.locate(kernel_, kernel_.at(p), K + 2, mesh_->statistics.history_steps, redundant);
    if (!history_[found].is_leaf() || redundant(history_[found].vertices)) return kNoCell;
    const CellId c = history_[found].cell();
    const int ghost = complex_.ghost_slot(c);
    if (ghost < 0 || kernel_.orient(complex_.vertices(c), ghost, kernel_.at(p)) > 0) return c;
    const CellId behind = complex_.cell(complex_.twin(c, ghost));  // p lies on the hull
    return redundant(complex_.vertices(behind)) ? kNoCell : behind;
  }

  /// p and the finite vertices of the cell that it comes into: p' in the order of its terms.
  void see(CellId start) {
    seen_.clear();
    seen_.push_back(kernel_.at(p_));
    for (const VertexId v : complex_.vertices(start)) {
      if (v != kGhost) seen_.push_back(kernel_.at(v));
    }
  }

  bool has_p(CellId c) const { return complex_.has(c, p_); }

  /// Asked at most once of each cell. A ghost cell whose facet's hyperplane holds p asks the finite cell behind, which
  /// may be gone by then: if so, it was in conflict.
  bool conflicts(CellId c) {
    Verdict& verdict = grown(verdicts_, raw(c), {kGhost, false});
    if (verdict.asked_by != p_) {
      const bool conflict = in_conflict(
          complex_, kernel_, c, p_, [&](CellId f) { return has_p(f) || kernel_.conflict(complex_.vertices(f), p_); });
      verdict = {p_, conflict};
    }
    return verdict.conflict;
  }

  /// Whether facet i of cell c, which p is in conflict with, faces p.
  bool faces(const Cell& cell, int ghost, int i) {
    typename Kernel<K>::Points points;
    const int moving = ghost < 0 ? i : ghost;  // the slot that p takes
    for (std::size_t j = 0; j < kCorners; ++j) {
      if (static_cast<int>(j) != moving) points[j] = kernel_.at(cell[j]);
    }
    for (const double* q : std::span(seen_.data(), seen_.size())) {
      points[static_cast<std::size_t>(moving)] = q;
      const int sign = i == moving ? kernel_.orient(points) : History<K>::side_of_origin(kernel_, points, i);
      if (sign != 0) return sign < 0;
    }
    DELONE_ASSERT(false, "p' lies in no hyperplane of sites");
    return false;
  }

  /// Flips at a facet of the link if that is due and possible. If it is not possible yet, the flip that makes it so
  /// will come to this cell again, by another facet.
  void flip_at(FacetId f) {
    const CellId star = complex_.cell(f);
    if (!complex_.is_live(star) || complex_.vertex(f) != p_) return;  // not a facet of the link any more
    const CellId c = complex_.cell(complex_.twin(f));
    if (!conflicts(c)) return;
    const Touched touched = touched_facets(c);
    const Cell cell = complex_.vertices(c);
    const int ghost = complex_.ghost_slot(c);
    for (int i = 0; i <= K; ++i) {
      if (!touched[static_cast<std::size_t>(i)] && faces(cell, ghost, i)) return;
    }
    flip(c, touched);
  }

  Touched touched_facets(CellId c) const {
    Touched touched;
    for (int i = 0; i <= K; ++i) touched[static_cast<std::size_t>(i)] = has_p(complex_.cell(complex_.twin(c, i)));
    return touched;
  }

  /// Replaces c and the cells of the star beyond its touched facets. The new facets of the link are put on the stack.
  void flip(CellId c, const Touched& touched) {
    mesh_->complex.reserve_more(kCorners, mesh_->sites.size());
    const Cell cell = complex_.vertices(c);
    // What the new cell without vertex j will have beyond its facet opposite slot i: beyond[j][i].
    std::array<std::array<FacetId, kCorners>, kCorners> beyond;
    std::array<CellId, kCorners> removed;
    std::size_t removed_count = 0;
    removed[removed_count++] = c;
    for (std::size_t i = 0; i < kCorners; ++i) {
      const FacetId across = complex_.twin(c, static_cast<int>(i));
      if (!touched[i]) {
        beyond[i][i] = across;
        continue;
      }
      const CellId star = complex_.cell(across);
      removed[removed_count++] = star;
      for (std::size_t j = 0; j < kCorners; ++j) {
        if (!touched[j]) beyond[j][i] = complex_.twin(star, complex_.slot_of(star, cell[j]));
      }
    }
    const auto first = static_cast<Index>(history_.size());
    const auto count = static_cast<Index>(kCorners + 1 - removed_count);
    for (const CellId gone : std::span(removed).first(removed_count)) {
      history_.succeed(history_.node_of(gone), first, count);
      complex_.destroy(gone);
    }
    if (removed_count == kCorners && K > 0) forget_enclosed(cell, touched);
    std::array<CellId, kCorners> created;
    for (std::size_t j = 0; j < kCorners; ++j) {
      if (touched[j]) continue;
      Cell fresh = cell;
      fresh[j] = p_;
      created[j] = complex_.create();
      complex_.set_vertices(created[j], fresh);
      complex_.count_ghost(created[j]);
      history_.add(created[j], fresh);
    }
    for (std::size_t j = 0; j < kCorners; ++j) {
      if (touched[j]) continue;
      for (std::size_t i = 0; i < kCorners; ++i) {
        const FacetId mine = complex_.facet(created[j], static_cast<int>(i));
        if (i == j || touched[i]) {
          complex_.link(mine, beyond[j][i]);
        } else {
          complex_.set_twin(mine, complex_.facet(created[i], static_cast<int>(j)));
        }
      }
      complex_.settle(created[j]);
      link_.push_back(complex_.facet(created[j], static_cast<int>(j)));
    }
    ++mesh_->statistics.flips;
    mesh_->statistics.cells_created += count;
  }

  /// The one vertex of a cell whose facet opposite is not touched, where all others are.
  void forget_enclosed(const Cell& cell, const Touched& touched) {
    for (std::size_t j = 0; j < kCorners; ++j) {
      if (touched[j]) continue;
      complex_.forget(cell[j]);
      --mesh_->vertex_count;
    }
  }

  FacetId pop() {
    const FacetId f = link_[link_.size() - 1];
    link_.resize(link_.size() - 1);
    return f;
  }

  // In the plane without weights a cell in conflict next to the star can always be flipped: it brings a vertex that the
  // star does not have yet.

  /// [GKS92] 3: X goes round p, and stays where the edge XY is flipped.
  void flip_around() requires(K == 2) {
    FacetId edge = link_[0];
    const VertexId last = complex_.vertex(complex_.cell(edge), View::turned(complex_.slot(edge), 1));
    for (;;) {
      const CellId c = complex_.cell(complex_.twin(edge));
      if (conflicts(c)) {
        const VertexId x = complex_.vertex(complex_.cell(edge), View::turned(complex_.slot(edge), 1));
        link_.clear();
        flip(c, touched_facets(c));
        const bool first = complex_.vertex(complex_.cell(link_[0]), View::turned(complex_.slot(link_[0]), 1)) == x;
        edge = link_[first ? 0 : 1];
      } else {
        // The cell of p beyond Y.
        const CellId star = complex_.cell(edge);
        const FacetId across = complex_.twin(star, View::turned(complex_.slot(edge), 1));
        const CellId next = complex_.cell(across);
        edge = complex_.facet(next, complex_.slot_of(next, p_));
        if (complex_.vertex(next, View::turned(complex_.slot(edge), 1)) == last) return;
      }
    }
  }

  /// [Slides]: LegalizeEdge for the edges of the cell that p came into, in turn.
  void legalize_all() requires(K == 2) {
    std::reverse(link_.begin(), link_.end());
    while (!link_.empty()) {
      const CellId c = complex_.cell(complex_.twin(pop()));
      if (conflicts(c)) flip(c, touched_facets(c));
    }
  }

  struct Verdict {
    VertexId asked_by;
    bool conflict;
  };

  Mesh* mesh_;
  View complex_;
  Lift kernel_;
  FlipForm form_;
  bool all_are_vertices_;
  History<K> history_;
  VertexId p_ = kGhost;
  Buffer<const double*> seen_;
  Buffer<FacetId> link_;
  Buffer<Verdict> verdicts_;  // per cell slot
};

template <int K>
using NearestFlipper = Flipper<K, Kernel<K>>;
template <int K>
using FurthestFlipper = Flipper<K, FurthestKernel<K>>;

}  // namespace

void build_by_flips(Mesh& mesh, std::size_t count, FlipForm form, const Progress& progress) {
  insert_one_by_one<NearestFlipper>(mesh, count, progress, form, !mesh.sites.weighted());
}

void build_furthest_by_flips(Mesh& mesh, std::size_t count, const Progress& progress) {
  insert_one_by_one<FurthestFlipper>(mesh, count, progress, FlipForm::stack, false);
}

}  // namespace delone
