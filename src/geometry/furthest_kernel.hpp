// The kernel with the lift turned over: heights are -|x|^2, so cells are those of the upper hull, and a site is in
// conflict with a cell when it lies outside the circumscribing ball. Ties are broken as ever, by lowering heights.
// Source: [GKS92] 4.1, the remark after theorem 4.2.
#pragma once

#include "delone/geometry/kernel.hpp"
#include "delone/geometry/perturb.hpp"

namespace delone {

template <int K>
class FurthestKernel : public Kernel<K> {
 public:
  using typename Kernel<K>::Cell;
  using Kernel<K>::Kernel;

  bool conflict(const Cell& cell, VertexId q) {
    int sign = this->filtered_conflict(cell, q);
    if (sign == Kernel<K>::kUnsure) sign = this->slow_conflict_sign(cell, q).sign;
    if (sign != 0) return sign < 0;
    return perturbed_conflict<K>(
        cell, q, [this](VertexId a, VertexId b) { return this->before(a, b); },
        [this](const Cell& v) { return this->orient(v); });
  }
};

}  // namespace delone
