// The tie rule: one triangulation for every point set, by perturbing heights and never positions.
//
// Each lifted height is lowered by an infinitesimal; that of the lexicographically smallest site dominates all others,
// and so on. When q lies exactly on the hyperplane of a cell, the first of the K + 2 sites, in lexicographic order,
// whose lowering moves the comparison decides: lowering q puts it below; lowering a vertex v lowers the hyperplane at q
// by the barycentric coordinate of q at v. This is the pulling triangulation: every cospherical group is coned from its
// smallest vertex, and so are its faces, consistently. (Perturbing only the lift is the idea of [DT11], who raise.)
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "delone/base/ids.hpp"

namespace delone {

/// Whether q, exactly on the lifted hyperplane of the positively oriented `cell`, counts as below it.
/// @param before  lexicographic order of vertices
/// @param orient  exact sign of the orientation of K + 1 vertices
template <int K, class Before, class Orient>
bool perturbed_conflict(const std::array<VertexId, K + 1>& cell, VertexId q, Before before, Orient orient) {
  constexpr std::size_t kQuery = K + 1;
  std::array<std::size_t, K + 2> order;
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto id = [&](std::size_t i) { return i == kQuery ? q : cell[i]; };
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return before(id(a), id(b)); });
  for (const std::size_t i : order) {
    if (i == kQuery) return true;
    auto replaced = cell;
    replaced[i] = q;
    if (const int sign = orient(replaced); sign != 0) return sign < 0;
  }
  return true;  // not reached: q is among the sites
}

}  // namespace delone
