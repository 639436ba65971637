// Error-free transformations: a sum or product of two doubles as a double and its exact rounding error.
// Source: [Shewchuk97] section 2 (Dekker, Knuth). The one place where std::fma may stand, and it stands by name.
// Valid for rounding to nearest, without overflow, and for products without underflow.
#pragma once

#include <cmath>

#include "delone/base/pair.hpp"

namespace delone {

/// Each T is a double, or a Pair of doubles.
template <class T>
struct TwoParts {
  T high, low;  ///< high + low is the exact value, |low| at most half an ulp of high
};

template <class T>
[[gnu::always_inline]] inline TwoParts<T> two_sum(T a, T b) {
  const T s = a + b;
  const T bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// Requires |a| >= |b| or a == 0.
template <class T>
[[gnu::always_inline]] inline TwoParts<T> quick_two_sum(T a, T b) {
  const T s = a + b;
  return {s, b - (s - a)};
}

#ifdef __FMA__
[[gnu::always_inline]] inline double fused(double a, double b, double c) { return std::fma(a, b, c); }
[[gnu::always_inline]] inline Pair fused(Pair a, Pair b, Pair c) {
  return Pair{std::fma(a[0], b[0], c[0]), std::fma(a[1], b[1], c[1])};
}
#endif

template <class T>
[[gnu::always_inline]] inline TwoParts<T> two_product(T a, T b) {
  const T p = a * b;
#ifdef __FMA__
  return {p, fused(a, b, -p)};
#else
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  const T ta = kSplitter * a;
  const T ah = ta - (ta - a);
  const T al = a - ah;
  const T tb = kSplitter * b;
  const T bh = tb - (tb - b);
  const T bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
#endif
}

}  // namespace delone
