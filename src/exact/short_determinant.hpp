// Signs of determinants of machine words, each minor held in as few words as it may need: the r x r minors of 61-bit
// integers are below r! 2^(61 r) < 2^(64 r - 1), so r words do. Expanding row by row, most products are cheap ones.
//
// Matrices are written with a row per axis and a column per point, so that a last row of heights, twice as long as the
// others, comes at the end.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "exact/wide.hpp"

namespace delone::exact {

/// Entries are at most 2^61.
inline constexpr int kShortBits = 61;

template <int Rows, int Columns>
using ShortMatrix =
    std::array<std::array<std::int64_t, static_cast<std::size_t>(Columns)>, static_cast<std::size_t>(Rows)>;

namespace detail {

constexpr int binomial(int n, int r) { return r == 0 ? 1 : binomial(n - 1, r - 1) * n / r; }

/// All sets of R out of N columns, as bits.
template <int N, int R>
inline constexpr auto kColumnSets = [] {
  std::array<unsigned, static_cast<std::size_t>(binomial(N, R))> sets{};
  std::size_t count = 0;
  for (unsigned s = 0; s < (1U << N); ++s) {
    if (std::popcount(s) == R) sets[count++] = s;
  }
  return sets;
}();

/// Minors of the first R rows, by the set of their columns.
template <int N, int R>
struct Minors {
  using Int = std::conditional_t<R == 1, std::int64_t, std::conditional_t<R == 2, Int128, Wide<R <= 2 ? 2 : R>>>;
  std::array<Int, std::size_t{1} << N> at;
};

template <int N, int R, class Table>
Minors<N, R> minors(const Table& m) {
  Minors<N, R> result;
  if constexpr (R == 1) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(N); ++j) result.at[std::size_t{1} << j] = m[0][j];
  } else {
    using Int = typename Minors<N, R>::Int;
    const auto shorter = minors<N, R - 1>(m);
    const auto& row = m[static_cast<std::size_t>(R - 1)];
    for (const unsigned s : kColumnSets<N, R>) {
      Int sum(0);
      unsigned rest = s;
      for (int place = 0; place < R; ++place, rest &= rest - 1) {
        const std::int64_t entry = row[static_cast<std::size_t>(std::countr_zero(rest))];
        const Int product = Int(shorter.at[s ^ (rest & (~rest + 1))]) * entry;
        sum = (R - 1 - place) % 2 == 0 ? sum + product : sum - product;
      }
      result.at[s] = sum;
    }
  }
  return result;
}

}  // namespace detail

/// The sign of the determinant of m.
template <int N>
int short_determinant_sign(const ShortMatrix<N, N>& m) {
  return sign(detail::minors<N, N>(m).at[(1U << N) - 1]);
}

/// The sign of the determinant of m with one more row, of heights up to 2^126.
/// It is below (N + 1)! 2^(61 N + 126) < 2^(64 (N + 2) - 1).
template <int N>
int short_determinant_sign(const ShortMatrix<N, N + 1>& m,
                           const std::array<Int128, static_cast<std::size_t>(N) + 1>& heights) {
  using Int = Wide<N + 2>;
  const auto cofactors = detail::minors<N + 1, N>(m);
  Int sum(0);
  for (std::size_t j = 0; j <= static_cast<std::size_t>(N); ++j) {
    const auto& minor = cofactors.at[((std::size_t{2} << N) - 1) ^ (std::size_t{1} << j)];
    const Int product = Int(minor) * Int(heights[j]);
    sum = (static_cast<std::size_t>(N) - j) % 2 == 0 ? sum + product : sum - product;
  }
  return sign(sum);
}

}  // namespace delone::exact
