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

/// Whether q, exactly on the lifted hyperplane of the positively oriented `cell`, counts as below it. No two of the
/// sites stand at one place.
/// @param before  lexicographic order of vertices
/// @param orient  exact sign of the orientation of K + 1 vertices
template <int K, class Before, class Orient>
bool perturbed_conflict(const std::array<VertexId, K + 1>& cell, VertexId q, Before before, Orient orient) {
  std::array<VertexId, K + 2> left;  // whose lowering has not been tried
  std::ranges::copy(cell, left.begin());
  left[K + 1] = q;
  for (std::size_t count = left.size(); count != 0; --count) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < count; ++i) first = before(left[i], left[first]) ? i : first;
    if (left[first] == q) return true;
    auto replaced = cell;
    std::ranges::replace(replaced, left[first], q);
    if (const int sign = orient(replaced); sign != 0) return sign < 0;
    left[first] = left[count - 1];
  }
  return true;  // not reached: q is among the sites
}

}  // namespace delone
