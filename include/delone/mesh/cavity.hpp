// The conflict region of a vertex to be inserted, in any dimension.
// Source: [For92] 4.3 (incremental, beneath-beyond); the region is a ball (I5), so a search from one of its cells finds
// it. Cost: O(K * cells in it and around it); no allocation after warm-up.
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

/// Whether inserting q destroys ghost cell c: when q lies beyond its facet; on the facet's hyperplane the finite cell
/// behind decides, so that no special case is left on the hull.
/// @param below  below(f): whether the lifted q lies below the hyperplane of finite cell f
template <int K, class Below>
[[gnu::noinline]] bool beyond_facet(const ComplexView<K>& complex, Kernel<K>& kernel, CellId c, VertexId q,
                                    const Below& below) {
  const int ghost = complex.ghost_slot(c);
  auto v = complex.vertices(c);
  v[static_cast<std::size_t>(ghost)] = q;
  if (const int side = kernel.orient(v); side != 0) return side > 0;
  return below(complex.cell(complex.twin(c, ghost)));
}

/// Whether inserting q destroys cell c.
template <int K, class Below>
[[gnu::always_inline]] inline bool in_conflict(const ComplexView<K>& complex, Kernel<K>& kernel, CellId c, VertexId q,
                                               const Below& below) {
  if (complex.is_ghost(c)) [[unlikely]]
    return beyond_facet(complex, kernel, c, q, below);
  return below(c);
}

/// The same with the hyperplanes that `scratch` keeps.
template <int K>
[[gnu::always_inline]] inline bool in_conflict(const ComplexView<K>& complex, Kernel<K>& kernel, Scratch& scratch,
                                               CellId c, VertexId q) {
  const auto below = [&](CellId f) __attribute__((always_inline)) {
    return below_hyperplane(complex, kernel, scratch, f, q);
  };
  return in_conflict(complex, kernel, c, q, below);
}

/// Asks memory for what tests of the neighbours of c will read.
template <int K>
[[gnu::always_inline]] inline void fetch_neighbours(const ComplexView<K>& complex, const Scratch& scratch, CellId c) {
  for (int i = 0; i <= K; ++i) {
    const CellId across = complex.cell(complex.twin(c, i));
    complex.prefetch(across);
    if constexpr (K > 3) __builtin_prefetch(scratch.planes.data() + raw(across) * Scratch::plane_size(K));
  }
}

/// Finds all cells in conflict with q, from one of them, into `scratch`. Changes nothing else; on std::bad_alloc every
/// marked cell is listed. Breadth first: the list is the queue. No branch depends on the outcome of a test, which
/// nobody can predict.
template <int K>
void find_cavity(ComplexView<K> complex, Kernel<K>& kernel, VertexId q, CellId start, Scratch& scratch) {
  Refill cavity(scratch.cavity);
  Refill boundary(scratch.boundary);
  Scratch::Mark* const marks = scratch.marks.data();
  cavity.make_room(1);
  cavity.push(complex.facet(start, 0));
  marks[raw(start)] = Scratch::Mark::conflicting;
  for (std::size_t next = 0; next < cavity.size(); ++next) {
    cavity.make_room(K + 1);
    boundary.make_room(K + 1);
    if (next + 2 < cavity.size()) fetch_neighbours(complex, scratch, complex.cell(cavity[next + 2]));
    const CellId c = complex.cell(cavity[next]);
    const int entry = complex.slot(cavity[next]);
    for (int i = next == 0 ? 0 : 1; i <= K; ++i) {
      const int slot = complex.turned(entry, i);
      const FacetId outside = complex.twin(c, slot);
      const CellId across = complex.cell(outside);
      if (marks[raw(across)] == Scratch::Mark::conflicting) continue;
      const bool conflicting = in_conflict(complex, kernel, scratch, across, q);
      marks[raw(across)] = static_cast<Scratch::Mark>(conflicting);
      cavity.push_if(conflicting, outside);
      boundary.push_if(!conflicting, complex.facet(c, slot));
    }
  }
}

/// In 2D depth first, the edges of a cell in turning order: this lists the boundary as the cycle that it is (cells are
/// crossed along a tree, and what is not crossed hangs from the boundary by one vertex).
template <>
inline void find_cavity(ComplexView<2> complex, Kernel<2>& kernel, VertexId q, CellId start, Scratch& scratch) {
  Refill cavity(scratch.cavity);
  Refill pending(scratch.pending);
  Refill boundary(scratch.boundary);
  Scratch::Mark* const marks = scratch.marks.data();
  cavity.make_room(1);
  cavity.push(complex.facet(start, 0));
  marks[raw(start)] = Scratch::Mark::conflicting;
  pending.make_room(3);
  for (int i = 2; i >= 0; --i) pending.push(complex.twin(start, i));
  while (!pending.empty()) {
    cavity.make_room(1);
    pending.make_room(2);
    boundary.make_room(1);
    const FacetId outside = pending.pop();
    const CellId c = complex.cell(outside);
    const int entry = complex.slot(outside);
    if (marks[raw(c)] == Scratch::Mark::conflicting) continue;
    if (!in_conflict(complex, kernel, scratch, c, q)) {
      boundary.push(complex.twin(c, entry));
      continue;
    }
    marks[raw(c)] = Scratch::Mark::conflicting;
    cavity.push(outside);
    for (int i = 2; i > 0; --i) {
      const FacetId ahead = complex.twin(c, complex.turned(entry, i));
      complex.prefetch(complex.cell(ahead));
      pending.push(ahead);
    }
  }
}

}  // namespace delone
