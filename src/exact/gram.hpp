// Linear equations with the products of vectors, in integers.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "exact/integer.hpp"

namespace delone::exact {

using Integers = std::vector<BigInt>;

inline BigInt dot(const Integers& a, const Integers& b) {
  BigInt sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
  return sum;
}

/// Solves G m = b, where G_ij is the product of edges i and j: m = result / determinant, the latter 0 exactly when
/// edges depend on each other. Elimination without fractions [Bar68]: pivots are leading minors of G, which are
/// positive.
inline std::pair<Integers, BigInt> solve_gram(const std::vector<Integers>& edges, const Integers& b) {
  const std::size_t n = edges.size();
  std::vector<Integers> m(n, Integers(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = dot(edges[i], edges[j]);
    m[i][n] = b[i];
  }
  BigInt last = 1;
  for (std::size_t k = 0; k < n; ++k) {
    if (m[k][k] == 0) return {{}, 0};
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const BigInt factor = m[i][k];
      for (std::size_t j = 0; j <= n; ++j) m[i][j] = BigInt((m[k][k] * m[i][j] - factor * m[k][j]) / last);
    }
    last = m[k][k];
  }
  Integers result;
  for (std::size_t i = 0; i < n; ++i) result.push_back(m[i][n]);
  return {std::move(result), last};
}

}  // namespace delone::exact
