#include "delone/exact/eft.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/integer.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using exact::BigInt;
using test::Random;

constexpr int kUnit = -2200;

BigInt integer(double x, int unit = kUnit) { return exact::to_integer<BigInt>(exact::decompose(x), unit); }

/// 53 random bits of either sign, 2^-range to 2^range.
double number(Random& random, int range) {
  const double x = std::ldexp(test::unit_random(random) - 0.5, static_cast<int>(random() % (2 * range)) - range);
  return random() % 4 == 0 ? std::nearbyint(x) : x;
}

TEST(ErrorFree, a_sum_and_its_error_are_exact) {
  Random random(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const double a = number(random, trial % 2 == 0 ? 40 : 900);
    const double b = trial % 3 == 0 ? -a * (1 + 0x1p-50) : number(random, 40);
    const TwoParts<double> s = two_sum(a, b);
    ASSERT_EQ(s.high, a + b);
    ASSERT_EQ(integer(s.high) + integer(s.low), integer(a) + integer(b)) << a << ' ' << b;
    const TwoParts<double> q = std::abs(a) >= std::abs(b) ? quick_two_sum(a, b) : quick_two_sum(b, a);
    ASSERT_EQ(q.low, s.low);
  }
}

TEST(ErrorFree, a_product_and_its_error_are_exact) {
  Random random(2);
  for (int trial = 0; trial < 20000; ++trial) {
    const double a = number(random, 200);
    const double b = number(random, 200);
    const TwoParts<double> p = two_product(a, b);
    ASSERT_EQ(p.high, a * b);
    ASSERT_EQ(integer(p.high) + integer(p.low), integer(a, kUnit / 2) * integer(b, kUnit / 2)) << a << ' ' << b;
  }
}

}  // namespace
}  // namespace delone
