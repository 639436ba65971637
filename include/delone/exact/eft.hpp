// Error-free transformations: a sum or product of two doubles as a double and its exact rounding error.
// Source: [Shewchuk97] section 2 (Dekker, Knuth). The one place where std::fma may stand, and it stands by name.
// Valid for rounding to nearest, without overflow, and for products without underflow.
#pragma once

#include <cmath>

namespace delone {

struct TwoDoubles {
  double high, low;  ///< high + low is the exact value, |low| at most half an ulp of high
};

[[gnu::always_inline]] inline TwoDoubles two_sum(double a, double b) {
  const double s = a + b;
  const double bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// Requires |a| >= |b| or a == 0.
[[gnu::always_inline]] inline TwoDoubles quick_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

[[gnu::always_inline]] inline TwoDoubles two_product(double a, double b) {
  const double p = a * b;
#ifdef __FMA__
  return {p, std::fma(a, b, -p)};
#else
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  const double ta = kSplitter * a;
  const double ah = ta - (ta - a);
  const double al = a - ah;
  const double tb = kSplitter * b;
  const double bh = tb - (tb - b);
  const double bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
#endif
}

}  // namespace delone
