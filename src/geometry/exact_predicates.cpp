#include "delone/geometry/exact_predicates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include "delone/base/ids.hpp"
#include "delone/exact/determinant.hpp"
#include "delone/exact/double_double.hpp"
#include "delone/exact/four_rows.hpp"
#include "exact/integer.hpp"

namespace delone {
namespace {

using exact::BigInt;
using exact::bit_width;
using exact::lower_unit;
using exact::Scaled;
using exact::with_integer;

constexpr std::size_t size(int n) { return static_cast<std::size_t>(n); }

constexpr double factorial(int n) { return n <= 1 ? 1.0 : n * factorial(n - 1); }

/// Bits of the sum of n! products: a determinant of n columns with entries of b_j bits has at most sum(b_j) + this.
constexpr int determinant_slack(int n) {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(factorial(n)))) + 1;
}

/// det(rows 1..K minus row 0) in integers.
template <int K, class Int, class Entry>
int sign_of_differences(const std::array<std::array<Entry, size(K)>, size(K + 1)>& x) {
  Matrix<K, Int> m;
  for (std::size_t i = 0; i < size(K); ++i) {
    for (std::size_t j = 0; j < size(K); ++j) m[i][j] = Int(x[i + 1][j] - x[0][j]);
  }
  return exact::sign(determinant<K>(m));
}

/// The lifted determinant from differences to the query; (-1)^K times it is positive when the query is in conflict.
template <int K, class Int>
int sign_of_lifted(const Matrix<K + 1, Int>& m) {
  const int s = exact::sign(determinant<K + 1>(m));
  return K % 2 == 0 ? s : -s;
}

/// Sign of a lifted determinant of double-doubles, 0 when it is not sure. Error, in units of u^2: a product of two
/// double-doubles adds at most 7, a sum 6 of the running magnitudes; a term of the determinant of n = K + 1 columns
/// passes n products and at most n (n - 1) / 2 sums, its lift K + E products and K + E + 1 sums. All relative to the
/// permanent, which is at most n! times the product of the columns' maxima. The factor 4 covers second-order terms, the
/// rounding of the bound, and a last maximum that lacks the rounding of its sum.
template <int K>
int sign_beyond_error(double value, const std::array<double, size(K + 1)>& maxima, int other_count) {
  constexpr int n = K + 1;
  double permanent = factorial(n);
  // Inside these limits nothing overflows, and what underflows is far below the bound.
  for (const double largest : maxima) {
    if (!(largest > 0x1p-80 && largest < 0x1p80)) return 0;
    permanent *= largest;
  }
  const double bound = 4.0 * 0x1p-106 * (7 * n + 3 * n * (n - 1) + 13 * (K + other_count) + 6) * permanent;
  return value > bound ? 1 : (value < -bound ? -1 : 0);
}

/// The middle stage for points that are no short integers; 0 when it cannot tell.
/// @tparam Plain  heights are the squares of the leading coordinates and nothing else
template <int K, bool Plain>
int double_double_conflict(const SiteRefs<K, K + 2>& s) {
  constexpr int n = K + 1;
  const int other_count = Plain ? 0 : s.other_count;
  Matrix<n, DoubleDouble> m;
  std::array<double, size(n)> maxima{};
  const std::size_t q = size(K + 1);
  for (std::size_t i = 0; i < size(n); ++i) {
    DoubleDouble lift(0.0);
    double magnitude = 0.0;
    const auto add_square = [&](DoubleDouble d) {
      lift = lift + d * d;
      magnitude += d.high() * d.high();
    };
    for (std::size_t j = 0; j < size(K); ++j) {
      m[i][j] = DoubleDouble::difference(s.leading[i][j], s.leading[q][j]);
      maxima[j] = std::max(maxima[j], std::abs(m[i][j].high()));
      add_square(m[i][j]);
    }
    if constexpr (!Plain) {
      for (std::size_t j = 0; j < size(other_count); ++j) {
        add_square(DoubleDouble::difference(s.others[i][j], s.others[q][j]));
      }
      if (s.weighted) {
        const DoubleDouble w = DoubleDouble::difference(s.weights[i], s.weights[q]);
        lift = lift - w;
        magnitude += std::abs(w.high());
      }
    }
    m[i][size(K)] = lift;
    maxima[size(K)] = std::max(maxima[size(K)], magnitude);
  }
  const int sign = sign_beyond_error<K>(determinant<n>(m).high(), maxima, other_count);
  return K % 2 == 0 ? sign : -sign;
}

/// The same in space, two rows at a time, which takes half the time: on a sphere all tests come here.
int double_double_conflict_in_space(const SiteRefs<3, 5>& s) {
  using Two = DoubleDoubles<Pair>;
  std::array<double, 4> maxima{};
  const auto rows = [&](std::size_t i, std::size_t axis) __attribute__((always_inline)) {
    const double q = s.leading[4][axis];
    const Two d = Two::difference(Pair{s.leading[i][axis], s.leading[i + 1][axis]}, Pair{q, q});
    maxima[axis] = std::max({maxima[axis], std::abs(d.high()[0]), std::abs(d.high()[1])});
    return d;
  };
  const Two x0 = rows(0, 0), x1 = rows(2, 0), y0 = rows(0, 1), y1 = rows(2, 1), z0 = rows(0, 2), z1 = rows(2, 2);
  const FourRows<Two> four = four_rows(x0, x1, y0, y1, z0, z1);
  const Pair lifts = larger(four.ab_lifts.high(), four.cd_lifts.high());
  maxima[3] = std::max(lifts[0], lifts[1]);
  const Two terms = lifted_terms(four);
  return sign_beyond_error<3>((terms[1] - terms[0]).high(), maxima, 0);
}

template <int K>
int double_double_conflict(const SiteRefs<K, K + 2>& s) {
  const bool plain = s.other_count == 0 && !s.weighted;
  if constexpr (K == 3) {
    if (plain) return double_double_conflict_in_space(s);
  }
  return plain ? double_double_conflict<K, true>(s) : double_double_conflict<K, false>(s);
}

}  // namespace

template <int K>
SlowSign slow_orient(const std::array<const double*, static_cast<std::size_t>(K + 1)>& points) {
  std::array<std::array<Scaled, size(K)>, size(K + 1)> scaled;
  int unit = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < size(K + 1); ++i) {
    for (std::size_t j = 0; j < size(K); ++j) {
      scaled[i][j] = exact::decompose(points[i][j]);
      lower_unit(unit, scaled[i][j]);
    }
  }
  int bits = 0;
  for (const auto& row : scaled) {
    for (const Scaled& x : row) bits = std::max(bits, exact::bit_length(x, unit));
  }
  if (bits <= 62) {
    std::array<std::array<std::int64_t, size(K)>, size(K + 1)> x;
    int longest = 0;
    for (std::size_t i = 0; i < size(K + 1); ++i) {
      for (std::size_t j = 0; j < size(K); ++j) {
        x[i][j] = exact::to_integer<std::int64_t>(scaled[i][j], unit);
        longest = std::max(longest, bit_width(x[i][j] - x[0][j]));
      }
    }
    const int needed = K * longest + determinant_slack(K);
    const int sign = with_integer(needed, [&]<class Int>(Int) { return sign_of_differences<K, Int>(x); });
    return {sign, needed < 127 ? Stage::adaptive : Stage::exact};
  }
  std::array<std::array<BigInt, size(K)>, size(K + 1)> x;
  for (std::size_t i = 0; i < size(K + 1); ++i) {
    for (std::size_t j = 0; j < size(K); ++j) x[i][j] = exact::to_integer<BigInt>(scaled[i][j], unit);
  }
  return {sign_of_differences<K, BigInt>(x), Stage::exact};
}

template <int K>
SlowSign slow_conflict(const SiteRefs<K, K + 2>& s) {
  if (!s.short_integers) {
    if (const int sign = double_double_conflict<K>(s); sign != 0) return {sign, Stage::adaptive};
  }
  const std::size_t columns = size(K + s.other_count);
  std::array<std::array<Scaled, kMaxDimension>, size(K + 2)> scaled;
  std::array<Scaled, size(K + 2)> weights;
  int unit = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < size(K + 2); ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      scaled[i][j] = exact::decompose(j < size(K) ? s.leading[i][j] : s.others[i][j - size(K)]);
      lower_unit(unit, scaled[i][j]);
    }
    weights[i] = s.weighted ? exact::decompose(s.weights[i]) : Scaled{};
    lower_unit(unit, weights[i], 2);  // heights are multiples of 2^(2 unit)
  }
  if (unit == std::numeric_limits<int>::max()) return {0, Stage::adaptive};  // everything is zero
  int bits = 0;
  int weight_bits = 0;
  for (std::size_t i = 0; i < size(K + 2); ++i) {
    for (std::size_t j = 0; j < columns; ++j) bits = std::max(bits, exact::bit_length(scaled[i][j], unit));
    weight_bits = std::max(weight_bits, exact::bit_length(weights[i], 2 * unit));
  }

  const std::size_t q = size(K + 1);
  if (bits <= 62 && weight_bits <= 124) {
    std::array<std::array<std::int64_t, kMaxDimension>, size(K + 1)> d;
    int longest = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      const auto xq = exact::to_integer<std::int64_t>(scaled[q][j], unit);
      for (std::size_t i = 0; i < size(K + 1); ++i) {
        d[i][j] = exact::to_integer<std::int64_t>(scaled[i][j], unit) - xq;
        longest = std::max(longest, bit_width(d[i][j]));
      }
    }
    const int lift_bits = std::max(2 * longest + 4, weight_bits + 1) + 1;  // at most 8 squares
    const int needed = K * longest + lift_bits + determinant_slack(K + 1);
    if (needed >= 127 && s.short_integers) {
      if (const int sign = double_double_conflict<K>(s); sign != 0) return {sign, Stage::adaptive};
    }
    const int sign = with_integer(needed, [&]<class Int>(Int) {
      Matrix<K + 1, Int> m;
      for (std::size_t i = 0; i < size(K + 1); ++i) {
        Int lift = 0;
        for (std::size_t j = 0; j < columns; ++j) {
          const Int x(d[i][j]);
          if (j < size(K)) m[i][j] = x;
          lift = lift + x * x;
        }
        if (s.weighted) {
          lift = lift - (exact::to_integer<Int>(weights[i], 2 * unit) - exact::to_integer<Int>(weights[q], 2 * unit));
        }
        m[i][size(K)] = lift;
      }
      return sign_of_lifted<K, Int>(m);
    });
    return {sign, needed < 127 ? Stage::adaptive : Stage::exact};
  }

  Matrix<K + 1, BigInt> m;
  for (std::size_t i = 0; i < size(K + 1); ++i) {
    BigInt lift = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      const BigInt x = exact::to_integer<BigInt>(scaled[i][j], unit) - exact::to_integer<BigInt>(scaled[q][j], unit);
      if (j < size(K)) m[i][j] = x;
      lift = lift + x * x;
    }
    m[i][size(K)] =
        lift - exact::to_integer<BigInt>(weights[i], 2 * unit) + exact::to_integer<BigInt>(weights[q], 2 * unit);
  }
  return {sign_of_lifted<K, BigInt>(m), Stage::exact};
}

#define DELONE_INSTANTIATE(K)                                                                          \
  template SlowSign slow_orient<K>(const std::array<const double*, static_cast<std::size_t>(K + 1)>&); \
  template SlowSign slow_conflict<K>(const SiteRefs<K, K + 2>&);
DELONE_INSTANTIATE(1)
DELONE_INSTANTIATE(2)
DELONE_INSTANTIATE(3)
DELONE_INSTANTIATE(4)
DELONE_INSTANTIATE(5)
DELONE_INSTANTIATE(6)
DELONE_INSTANTIATE(7)
DELONE_INSTANTIATE(8)
#undef DELONE_INSTANTIATE

}  // namespace delone
