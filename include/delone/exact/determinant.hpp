// Determinants without division, over any ring: doubles, integers of every width, double-doubles.
// Laplace expansion shared over column subsets: the k x k minors of the first k rows are kept for every set of k
// columns, so an N x N determinant costs N 2^(N-1) products instead of N!.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace delone {

template <int N, class T>
using Matrix = std::array<std::array<T, static_cast<std::size_t>(N)>, static_cast<std::size_t>(N)>;

namespace detail {

/// Expansion along the last row of every leading block; `Alternate` gives determinants, its absence permanents.
/// @param entry  entry(row, column) of the matrix
template <int N, bool Alternate, class T, class Entry>
T laplace(Entry entry) {
  constexpr auto kRows = [] {  // a set of k columns takes rows 0 to k - 1; the last of them
    std::array<std::uint8_t, std::size_t{1} << N> last{};
    for (unsigned s = 1; s < last.size(); ++s) last[s] = static_cast<std::uint8_t>(std::popcount(s) - 1);
    return last;
  }();
  std::array<T, std::size_t{1} << N> minor;  // minor[s] of columns s; subsets precede supersets
  for (unsigned s = 1; s < (1U << N); ++s) {
    const std::size_t row = kRows[s];
    if (row == 0) {
      minor[s] = entry(row, static_cast<std::size_t>(std::countr_zero(s)));
      continue;
    }
    T sum(0);
    std::size_t place = 0;  // how many columns of s lie left of the one that row `row` takes
    for (unsigned rest = s; rest != 0; rest &= rest - 1, ++place) {
      const unsigned bit = rest & (~rest + 1);
      const T product = entry(row, static_cast<std::size_t>(std::countr_zero(bit))) * minor[s ^ bit];
      if (!Alternate || (row - place) % 2 == 0) {
        sum = sum + product;
      } else {
        sum = sum - product;
      }
    }
    minor[s] = sum;
  }
  return minor[(1U << N) - 1];
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
    return detail::laplace<N, true, T>([&](std::size_t i, std::size_t j) { return m[i][j]; });
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
  return detail::laplace<N, false, double>([&](std::size_t i, std::size_t j) { return std::abs(m[i][j]); });
}

}  // namespace delone
