// Point location by walking: from cell to cell across facets that separate the cell from the point.
// Source: [For92] 4.3; the visibility walk ends on Delaunay and regular triangulations because it climbs the lower
// hull. It is bounded all the same, and past the bound every cell is looked at.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "delone/geometry/kernel.hpp"
#include "delone/mesh/territory.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

struct WalkStats {
  std::uint64_t steps = 0;
  std::uint64_t fallbacks = 0;
};

/// The closed cell that contains q (see walk), by looking at every cell.
template <int K, class C>
CellId exhaustive_locate(const ComplexView<K, C>& complex, Kernel<K>& kernel, const double* q) {
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c)) continue;
    const auto v = complex.vertices(c);
    const int ghost = complex.ghost_slot(c);
    bool inside = true;
    for (int i = 0; i <= K && inside; ++i) {
      if (ghost >= 0 && i != ghost) continue;
      const int side = kernel.orient(v, i, q);
      inside = ghost >= 0 ? side > 0 : side >= 0;
    }
    if (inside) return c;
  }
  DELONE_ASSERT(false, "I6 the cells cover space");
  return kNoCell;
}

struct Outside {
  CellId cell;
  bool arrived;  ///< q lies strictly beyond its facet
};

/// From ghost cell c a few steps along the hull towards q, each across the ridge opposite the vertex farthest from q.
/// A shortcut for points in convex position, where the way through the inside leads round long fans.
template <int K, class C>
Outside walk_outside(const ComplexView<K, C>& complex, Kernel<K>& kernel, const double* q, CellId c,
                     const Territory& territory) {
  constexpr int kSteps = K == 2 ? 256 : 8;  // in the plane they lead straight, above they may circle
  CellId last = kNoCell;
  for (int step = 0; step < kSteps; ++step) {
    const auto v = complex.vertices(c);
    const int ghost = complex.ghost_slot(c);
    int farthest = ghost;
    double distance = -1.0;
    for (int i = 0; i <= K; ++i) {
      if (i == ghost) continue;
      const double d = kernel.squared_distance(v[static_cast<std::size_t>(i)], q);
      farthest = d > distance ? i : farthest;
      distance = std::max(d, distance);
    }
    if (kernel.orient(v, ghost, q) > 0) return {c, true};
    if (!territory.touches(v, farthest)) break;
    const CellId next = complex.cell(complex.twin(c, farthest));
    if (next == last) break;
    last = std::exchange(c, next);
  }
  return {c, false};
}

/// The closed cell that contains q: finite if q lies in the hull, else a ghost cell whose facet q lies strictly beyond.
/// @param q      K leading coordinates, of a site or of any other point in the range that the kernel knows
/// @param start  any live cell; a near one is fast
/// @param territory  of which the start has a site; kNoCell when the walk comes to a facet that has none, or to its
/// bound
template <int K, class C>
CellId walk(const ComplexView<K, C>& complex, Kernel<K>& kernel, const double* q, CellId start, WalkStats& stats,
            const Territory& territory = {}) {
  CellId c = start;
  if (complex.is_ghost(c)) {
    const Outside outside = walk_outside(complex, kernel, q, c, territory);
    if (outside.arrived) return outside.cell;
    c = outside.cell;
    const int ghost = complex.ghost_slot(c);
    if (!territory.touches(complex.vertices(c), ghost)) return kNoCell;
    c = complex.cell(complex.twin(c, ghost));
  }
  int entered = -1;  // the facet that the walk came through: q lies on this side of it
  for (std::uint64_t left = 16 + 4 * static_cast<std::uint64_t>(complex.slot_count()); left != 0; --left) {
    const auto v = complex.vertices(c);
    const int leave = kernel.separating_slot(v, q, entered);
    if (leave < 0) return c;
    ++stats.steps;
    if (!territory.touches(v, leave)) return kNoCell;
    const FacetId across = complex.twin(c, leave);
    c = complex.cell(across);
    if (complex.is_ghost(c)) return c;
    entered = complex.slot(across);
  }
  if (!territory.whole()) return kNoCell;
  ++stats.fallbacks;
  return exhaustive_locate(complex, kernel, q);
}

}  // namespace delone
