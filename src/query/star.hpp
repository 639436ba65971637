// The neighbours of a vertex, one after the other, until the caller has seen enough. Nothing is allocated once warm.
#pragma once

#include <cstddef>
#include <vector>

#include "delone/topology/complex.hpp"
#include "query/id_set.hpp"

namespace delone::query_detail {

/// Working memory of a traversal.
struct StarScratch {
  IdSet seen;
  std::vector<CellId> cells;
};

/// Calls visit(u, cell) for the neighbours u of v, each with a cell that has both, until it returns false. Above
/// dimension 2 a neighbour may come more than once: a cell is entered across a facet, which leaves one vertex that can
/// be new, and asking which is costs more than seeing it again.
/// @param start  a live cell that has v; neighbours in it and around it come first
template <int K, class Visit>
void for_neighbours(const ConstComplexView<K>& complex, VertexId v, CellId start, StarScratch& scratch, Visit visit) {
  if constexpr (K == 1) {
    const int slot = complex.slot_of(start, v);
    const VertexId one = complex.vertex(start, 1 - slot);
    if (one != kGhost && !visit(one, start)) return;
    const FacetId across = complex.twin(start, 1 - slot);
    const VertexId other = complex.vertex(across);
    if (other != kGhost) visit(other, complex.cell(across));
  } else if constexpr (K == 2) {
    // All cells turn the same way (I3), so crossing the edge after v's slot again and again goes round v.
    int slot = complex.slot_of(start, v);
    CellId c = start;
    const VertexId first = complex.vertex(start, complex.turned(slot, 2));
    if (first != kGhost && !visit(first, start)) return;
    do {
      const FacetId across = complex.twin(c, complex.turned(slot, 1));
      c = complex.cell(across);
      const VertexId u = complex.vertex(across);
      if (c != start && u != kGhost && !visit(u, c)) return;
      slot = complex.turned(complex.slot(across), 1);
    } while (c != start);
  } else if constexpr (K > 2) {
    scratch.seen.clear();
    scratch.cells.assign(1, start);
    scratch.seen.insert(raw(start));
    for (int i = 0; i <= K; ++i) {
      const VertexId u = complex.vertex(start, i);
      if (u != v && u != kGhost && !visit(u, start)) return;
    }
    for (std::size_t next = 0; next < scratch.cells.size(); ++next) {
      const CellId c = scratch.cells[next];
      for (int i = 0; i <= K; ++i) {
        if (complex.vertex(c, i) == v) continue;
        const FacetId across = complex.twin(c, i);
        const CellId n = complex.cell(across);
        if (!scratch.seen.insert(raw(n))) continue;
        scratch.cells.push_back(n);
        const VertexId u = complex.vertex(across);
        if (u != kGhost && !visit(u, n)) return;
      }
    }
  }
}

}  // namespace delone::query_detail
