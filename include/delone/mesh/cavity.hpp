// The conflict region of a vertex to be inserted, and the star that fills it, in any dimension.
// Source: [For92] 4.3 (incremental, beneath-beyond); the region is a ball (I5), so a search from one of its cells finds
// it. Departure: the facets of the star are linked by turning about the ridges of the cavity's boundary inside the old
// cells, each ridge once, without a table of facets. Cost: O(K * cells removed and created); no allocation after
// warm-up.
#pragma once

#include <cstdint>

#include "delone/geometry/kernel.hpp"
#include "delone/mesh/scratch.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

/// Whether inserting q destroys cell c. A ghost cell is destroyed when q lies beyond its facet; on the facet's
/// hyperplane the finite cell behind decides, so that no special case is left on the hull.
template <int K>
[[gnu::always_inline]] inline bool in_conflict(const ComplexView<K>& complex, Kernel<K>& kernel, CellId c, VertexId q) {
  auto v = complex.vertices(c);
  const int ghost = complex.ghost_slot(c);
  if (ghost < 0) return kernel.conflict(v, q);
  v[static_cast<std::size_t>(ghost)] = q;
  if (const int side = kernel.orient(v); side != 0) return side > 0;
  const CellId behind = complex.cell(complex.twin(c, ghost));
  return kernel.conflict(complex.vertices(behind), q);
}

/// Finds all cells in conflict with q, from one of them, into `scratch`. Changes nothing else; on std::bad_alloc every
/// marked cell is in the lists.
template <int K>
void find_cavity(const ComplexView<K>& complex, Kernel<K>& kernel, VertexId q, CellId start, Scratch& scratch) {
  auto& [marks, removed, spared, boundary, created, edges] = scratch;
  using Mark = Scratch::Mark;
  removed.clear();
  spared.clear();
  boundary.clear();
  removed.push_back(start);
  marks[raw(start)] = Mark::conflicting;
  for (std::size_t next = 0; next < removed.size(); ++next) {  // breadth first; the list is the queue
    const CellId c = removed[next];
    for (int i = 0; i <= K; ++i) {
      const FacetId outside = complex.twin(c, i);
      const CellId across = complex.cell(outside);
      const Mark mark = marks[raw(across)];
      if (mark == Mark::conflicting) continue;
      if (mark == Mark::unknown) {
        if (in_conflict(complex, kernel, across, q)) {
          for (int j = 0; j <= K; ++j) complex.prefetch(complex.cell(complex.twin(across, j)));
          removed.push_back(across);
          marks[raw(across)] = Mark::conflicting;
          continue;
        }
        spared.push_back(across);
        marks[raw(across)] = Mark::staying;
      }
      boundary.push_back({c, i, outside});
    }
  }
}

}  // namespace delone
