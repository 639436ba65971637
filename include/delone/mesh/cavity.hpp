// The conflict region of a vertex to be inserted, and the star that fills it, in any dimension.
// Source: [For92] 4.3 (incremental, beneath-beyond); the region is a ball (I5), so a search from one of its cells finds
// it. Departure: the facets of the star are linked by turning about the ridges of the cavity's boundary inside the old
// cells, each ridge once, without a table of facets. Cost: O(K * cells removed and created); no allocation after
// warm-up.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

#include "delone/geometry/kernel.hpp"
#include "delone/mesh/scratch.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

/// Whether the lifted q lies below the hyperplane of finite cell c, which is kept for the next test above dimension 3.
template <int K>
[[gnu::always_inline]] inline bool below_hyperplane(const ComplexView<K>& complex, Kernel<K>& kernel, Scratch& scratch,
                                                    CellId c, VertexId q) {
  const auto v = complex.vertices(c);
  if constexpr (K <= 3) {
    return kernel.conflict(v, q);
  } else {
    constexpr std::size_t kSize = Scratch::plane_size(K);
    static_assert(sizeof(Hyperplane<K>) == kSize * sizeof(double));
    double* kept = scratch.planes.data() + raw(c) * kSize;
    Hyperplane<K> plane;
    if (std::isnan(*kept)) {
      plane = kernel.hyperplane(v);
      std::memcpy(kept, &plane, sizeof plane);
    } else {
      std::memcpy(&plane, kept, sizeof plane);
    }
    return kernel.conflict(plane, v, q);
  }
}

/// Whether inserting q destroys cell c. A ghost cell is destroyed when q lies beyond its facet; on the facet's
/// hyperplane the finite cell behind decides, so that no special case is left on the hull.
template <int K>
[[gnu::always_inline]] inline bool in_conflict(const ComplexView<K>& complex, Kernel<K>& kernel, Scratch& scratch,
                                               CellId c, VertexId q) {
  const int ghost = complex.ghost_slot(c);
  if (ghost < 0) return below_hyperplane(complex, kernel, scratch, c, q);
  auto v = complex.vertices(c);
  v[static_cast<std::size_t>(ghost)] = q;
  if (const int side = kernel.orient(v); side != 0) return side > 0;
  return below_hyperplane(complex, kernel, scratch, complex.cell(complex.twin(c, ghost)), q);
}

/// Asks memory for what a test of cell c will read.
template <int K>
[[gnu::always_inline]] inline void fetch_ahead(const ComplexView<K>& complex, const Scratch& scratch, CellId c) {
  complex.prefetch(c);
  if constexpr (K > 3) __builtin_prefetch(scratch.planes.data() + raw(c) * Scratch::plane_size(K));
}

/// Finds all cells in conflict with q, from one of them, into `scratch`. Changes nothing else; on std::bad_alloc every
/// marked cell is in the lists.
template <int K>
void find_cavity(const ComplexView<K>& complex, Kernel<K>& kernel, VertexId q, CellId start, Scratch& scratch) {
  auto& [marks, removed, spared, boundary, created, edges, planes] = scratch;
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
        if (in_conflict(complex, kernel, scratch, across, q)) {
          for (int j = 0; j <= K; ++j) fetch_ahead(complex, scratch, complex.cell(complex.twin(across, j)));
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
