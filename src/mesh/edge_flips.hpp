// Flipping edges of a triangulated plane, one by one, until every edge is locally Delaunay.
// Source: [For92] 4.2 and lemma 2.2.
#pragma once

#include <cstdint>
#include <utility>

#include "delone/base/buffer.hpp"
#include "delone/base/progress.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

/// Replaces the edge opposite slot i of a finite cell, whose other cell is finite too and makes a strictly convex
/// quadrilateral with it, by the other diagonal. The two cells keep their ids; afterwards the slots 1 and 2 of each are
/// those of its outer edges.
inline void flip_edge(ComplexView<2> complex, CellId c, int i) {
  using View = ComplexView<2>;
  const FacetId across = complex.twin(c, i);
  const CellId d = View::cell(across);
  const int j = View::slot(across);
  const VertexId p = complex.vertex(c, i);
  const VertexId q = complex.vertex(d, j);
  const VertexId a = complex.vertex(c, View::turned(i, 1));
  const VertexId b = complex.vertex(c, View::turned(i, 2));
  const FacetId beyond_pa = complex.twin(c, View::turned(i, 2));
  const FacetId beyond_bp = complex.twin(c, View::turned(i, 1));
  const FacetId beyond_aq = complex.twin(d, View::turned(j, 1));
  const FacetId beyond_qb = complex.twin(d, View::turned(j, 2));
  complex.set_vertices(c, {a, q, p});
  complex.set_vertices(d, {b, p, q});
  complex.link(View::facet(c, 0), View::facet(d, 0));
  complex.link(View::facet(c, 1), beyond_pa);
  complex.link(View::facet(c, 2), beyond_aq);
  complex.link(View::facet(d, 1), beyond_qb);
  complex.link(View::facet(d, 2), beyond_bp);
  complex.settle(c);
  complex.settle(d);
}

/// Looks at the edges in `queue`, and at those around every edge that it flips, until none is left.
/// Ends: a flip lowers the lifted surface. Two cells that are not locally Delaunay make a strictly convex
/// quadrilateral.
/// @return how many were flipped
inline std::uint64_t flip_until_delaunay(ComplexView<2> complex, Kernel<2>& kernel, Buffer<FacetId> queue,
                                         const Progress& progress) {
  std::uint64_t flips = 0;
  for (Buffer<FacetId> next; !queue.empty(); queue.swap(next)) {
    next.clear();
    for (std::size_t e = 0; e < queue.size(); ++e) {
      tell(progress, e, queue.size());
      const CellId c = complex.cell(queue[e]);
      const CellId d = complex.cell(complex.twin(queue[e]));
      if (complex.is_ghost(c) || complex.is_ghost(d)) continue;
      if (!kernel.conflict(complex.vertices(c), complex.vertex(complex.twin(queue[e])))) continue;
      flip_edge(complex, c, complex.slot(queue[e]));
      ++flips;
      for (const CellId changed : {c, d}) {
        for (const int outer : {1, 2}) next.push_back(complex.facet(changed, outer));
      }
    }
  }
  return flips;
}

}  // namespace delone
