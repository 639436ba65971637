// Neighbouring cells with one orthosphere are parts of one Delaunay polytope and have one Voronoi vertex. Ghost cells
// of one such polytope that stand on one hyperplane are parts of one of its facets and have one ray.
#pragma once

#include "delone/geometry/kernel.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

/// Does the orthosphere of the finite cell c pass through `apex`, exactly?
template <int K>
bool on_common_orthosphere(const Kernel<K>& kernel, const Complex& complex, CellId c, VertexId apex) {
  typename Kernel<K>::Cell cell;
  for (int i = 0; i <= K; ++i) cell[static_cast<std::size_t>(i)] = complex.vertex(c, i);
  const int sign = kernel.filtered_conflict(cell, apex);
  return sign == 0 || (sign == Kernel<K>::kUnsure && kernel.slow_conflict_sign(cell, apex).sign == 0);
}

/// Does the hyperplane of the ghost cell c pass through `apex`, exactly?
template <int K>
bool on_common_hyperplane(Kernel<K>& kernel, const Complex& complex, CellId c, VertexId apex) {
  typename Kernel<K>::Cell flat;
  for (int i = 0; i <= K; ++i) {
    const VertexId v = complex.vertex(c, i);
    flat[static_cast<std::size_t>(i)] = v == kGhost ? apex : v;
  }
  return kernel.orient(flat) == 0;
}

}  // namespace delone
