// Walks that count what they do, and the march of a hierarchy's level: from a vertex to the cell that contains q.
// Source: [Dev97] 2.2, phases 1 and 2; [DPT02], the straight walk.
// Departure from [Dev97] 2.2: where the way round the vertex leads outside the hull, the visibility walk goes on.
#pragma once

#include <algorithm>
#include <limits>

#include "delone/geometry/kernel.hpp"
#include "delone/locate/locator.hpp"
#include "delone/mesh/walk.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

template <int K>
CellId counted_walk(const ConstComplexView<K>& complex, Kernel<K>& kernel, const double* q, CellId start,
                    LocateCounts& counts) {
  WalkStats stats;
  const CellId c = walk(complex, kernel, q, start, stats);
  counts.crossed += stats.steps;
  counts.facet_tests += stats.steps + 1;
  return c;
}

/// Triangle (v, right, left) with the ray from v to q between `right`, which may lie on its line, and `left`, which
/// does not.
struct Wedge {
  CellId cell;
  VertexId right, left;
  int apex;  ///< the slot of v
};

/// Along the segment from vertex v to q, to the closed cell that contains q.
class StraightWalk {
 public:
  StraightWalk(const ConstComplexView<2>& complex, Kernel<2>& kernel, const double* q, LocateCounts& counts)
      : complex_(complex), kernel_(&kernel), q_(q), counts_(&counts) {}

  CellId from(VertexId v) {
    const Wedge wedge = turn(v);
    if (complex_.is_ghost(wedge.cell)) return counted_walk(complex_, *kernel_, q_, wedge.cell, *counts_);
    return wedge.right == wedge.left ? wedge.cell : cross(v, wedge);
  }

 private:
  bool left_of_line(VertexId v, VertexId w) {
    ++counts_->line_tests;
    return kernel_->orient({kernel_->at(v), q_, kernel_->at(w)}) > 0;
  }
  bool beyond_edge(VertexId right, VertexId left) {
    ++counts_->facet_tests;
    return kernel_->orient({q_, kernel_->at(right), kernel_->at(left)}) < 0;
  }
  Wedge wedge_in(CellId c, VertexId v) const {
    if (complex_.is_ghost(c)) return {c, v, v, 0};
    const int apex = complex_.slot_of(c, v);
    return {c, complex_.vertex(c, complex_.turned(apex, 1)), complex_.vertex(c, complex_.turned(apex, 2)), apex};
  }
  /// The triangle at v on the other side of the facet that lies `by` slots after v.
  Wedge next(const Wedge& at, VertexId v, int by) {
    ++counts_->turned;
    return wedge_in(complex_.cell(complex_.twin(at.cell, complex_.turned(at.apex, by))), v);
  }

  /// Phase 1: to the triangle at v that the ray enters; both vertices are v when q is v itself. A ghost cell when the
  /// turn leaves the hull.
  Wedge turn(VertexId v) {
    CellId c = complex_.incident_cell(v);
    if (const int ghost = complex_.ghost_slot(c); ghost >= 0) c = complex_.cell(complex_.twin(c, ghost));
    if (std::equal(q_, q_ + 2, kernel_->at(v))) return {c, v, v, 0};
    Wedge at = wedge_in(c, v);
    if (left_of_line(v, at.left)) {
      while (!complex_.is_ghost(at.cell) && left_of_line(v, at.right)) at = next(at, v, 2);
    } else {
      do {
        at = next(at, v, 1);
      } while (!complex_.is_ghost(at.cell) && !left_of_line(v, at.left));
    }
    return at;
  }

  /// Phase 2: across the edges that the segment meets. A vertex on the line counts as right of it: the walk then turns
  /// about that vertex until the segment goes on, so it ends on any input.
  CellId cross(VertexId v, Wedge at) {
    FacetId ahead = complex_.facet(at.cell, at.apex);
    while (beyond_edge(at.right, at.left)) {
      ++counts_->crossed;
      const FacetId across = complex_.twin(ahead);
      const CellId c = complex_.cell(across);
      if (complex_.is_ghost(c)) return c;
      const VertexId w = complex_.vertex(across);
      if (left_of_line(v, w)) {
        ahead = complex_.facet(c, complex_.slot_of(c, at.left));
        at.left = w;
      } else {
        ahead = complex_.facet(c, complex_.slot_of(c, at.right));
        at.right = w;
      }
    }
    return complex_.cell(ahead);
  }

  ConstComplexView<2> complex_;
  Kernel<2>* kernel_;
  const double* q_;
  LocateCounts* counts_;
};

}  // namespace delone
