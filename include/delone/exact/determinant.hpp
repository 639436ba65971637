// Determinants without division, over any ring: doubles, integers of every width, double-doubles.
// Laplace expansion shared over column subsets: the k x k minors of the first k rows are kept for every set of k
// columns, so an N x N determinant costs N 2^(N-1) products instead of N!.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace delone {

template <int N, class T>
using Matrix = std::array<std::array<T, static_cast<std::size_t>(N)>, static_cast<std::size_t>(N)>;

namespace detail {

/// One product of the expansion: the minor of columns `set` gains entry(row, column) times the minor of columns `rest`.
struct Term {
  std::uint16_t set, rest;
  std::uint8_t row, column;
  bool minus;
  bool first;  ///< of its set
};

/// All products of the expansions of the minors of the first `Rows` rows, small sets of columns before large ones.
template <int Rows, int Columns>
constexpr auto terms() {
  constexpr std::size_t kCount = [] {
    std::size_t count = 0;
    for (unsigned s = 1; s < (1U << Columns); ++s) {
      if (std::popcount(s) <= Rows) count += static_cast<std::size_t>(std::popcount(s));
    }
    return count;
  }();
  std::array<Term, kCount> list{};
  std::size_t next = 0;
  for (unsigned s = 1; s < (1U << Columns); ++s) {
    const int row = std::popcount(s) - 1;
    if (row >= Rows) continue;
    int place = 0;  // how many columns of s lie left of the one that `row` takes
    for (unsigned rest = s; rest != 0; rest &= rest - 1, ++place) {
      const auto column = static_cast<std::uint8_t>(std::countr_zero(rest));
      list[next++] = {static_cast<std::uint16_t>(s),  static_cast<std::uint16_t>(s ^ (1U << column)),
                      static_cast<std::uint8_t>(row), column,
                      (row - place) % 2 != 0,         place == 0};
    }
  }
  return list;
}

template <bool Alternate, class T, std::size_t Size, class Entry>
[[gnu::always_inline]] inline void add_term(const Term& term, std::array<T, Size>& minor, const Entry& entry) {
  if (term.rest == 0) {
    minor[term.set] = entry(term.row, term.column);
    return;
  }
  const T product = entry(term.row, term.column) * minor[term.rest];
  const bool minus = Alternate && term.minus;
  if (term.first) {
    minor[term.set] = minus ? T(0) - product : product;
  } else {
    minor[term.set] = minus ? minor[term.set] - product : minor[term.set] + product;
  }
}

/// The minors of the first `Rows` rows for every set of as many columns; without `Alternate` the permanents.
/// @param entry  entry(row, column) of the matrix
template <int Rows, int Columns, bool Alternate, class T, class Entry>
std::array<T, std::size_t{1} << Columns> minors(const Entry& entry) {
  static constexpr auto kTerms = terms<Rows, Columns>();
  std::array<T, std::size_t{1} << Columns> minor;
  if constexpr (std::is_floating_point_v<T> ? kTerms.size() <= 500 : kTerms.size() <= 32) {  // straight-line code
    [&]<std::size_t... I>(std::index_sequence<I...>) { (add_term<Alternate>(kTerms[I], minor, entry), ...); }
    (std::make_index_sequence<kTerms.size()>{});
  } else {
    for (const Term& term : kTerms) add_term<Alternate>(term, minor, entry);
  }
  return minor;
}

}  // namespace detail

/// The determinant of an N x N matrix. Cost N 2^(N-1) products.
template <int N, class T>
T determinant(const Matrix<N, T>& m) {
  if constexpr (N == 0) {
    return T(1);
  } else if constexpr (N == 1) {
    return m[0][0];
  } else if constexpr (N == 2) {
    return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  } else if constexpr (N == 3) {
    const T a = m[1][0] * m[2][1] - m[1][1] * m[2][0];
    const T b = m[1][0] * m[2][2] - m[1][2] * m[2][0];
    const T c = m[1][1] * m[2][2] - m[1][2] * m[2][1];
    return m[0][0] * c - m[0][1] * b + m[0][2] * a;
  } else {
    const auto entry = [&](std::size_t i, std::size_t j) -> const T& { return m[i][j]; };
    return detail::minors<N, N, true, T>(entry)[(1U << N) - 1];
  }
}

/// The permanent of |m|, the determinant with every sign taken as plus: it bounds the rounding errors of
/// determinant(m).
template <int N>
double absolute_permanent(const Matrix<N, double>& m) {
  if constexpr (N == 3) {
    const auto at = [&](std::size_t i, std::size_t j) { return std::abs(m[i][j]); };
    const double a = at(1, 0) * at(2, 1) + at(1, 1) * at(2, 0);
    const double b = at(1, 0) * at(2, 2) + at(1, 2) * at(2, 0);
    const double c = at(1, 1) * at(2, 2) + at(1, 2) * at(2, 1);
    return at(0, 0) * c + at(0, 1) * b + at(0, 2) * a;
  }
  const auto entry = [&](std::size_t i, std::size_t j) { return std::abs(m[i][j]); };
  return detail::minors<N, N, false, double>(entry)[(1U << N) - 1];
}

/// The K + 1 minors of K rows of K + 1 entries, each leaving out one column: up to alternating signs the cofactors of a
/// last row, so the coefficients of the hyperplane through the rows.
template <int K>
std::array<double, K + 1> minors_without_column(const std::array<std::array<double, K + 1>, K>& rows) {
  const auto entry = [&](std::size_t i, std::size_t j) { return rows[i][j]; };
  const auto all = detail::minors<K, K + 1, true, double>(entry);
  std::array<double, K + 1> result;
  for (std::size_t j = 0; j <= K; ++j) result[j] = all[((std::size_t{1} << (K + 1)) - 1) ^ (std::size_t{1} << j)];
  return result;
}

}  // namespace delone
