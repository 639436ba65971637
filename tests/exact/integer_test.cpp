#include "exact/integer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/families.hpp"

namespace delone::exact {
namespace {

using Limits = std::numeric_limits<double>;

TEST(Decompose, every_finite_double_comes_back) {
  test::Random random(1);
  for (int trial = 0; trial < 100000; ++trial) {
    const double x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    const Scaled s = decompose(x);
    ASSERT_TRUE(s.mantissa == 0 || s.mantissa % 2 != 0);
    ASSERT_LT(std::abs(s.mantissa), std::int64_t{1} << 53);
    ASSERT_EQ(std::ldexp(static_cast<double>(s.mantissa), s.exponent), x);
  }
}

TEST(Decompose, the_ends_of_the_range_are_right) {
  EXPECT_EQ(decompose(0.0).mantissa, 0);
  EXPECT_EQ(decompose(-0.0).mantissa, 0);
  EXPECT_EQ(decompose(Limits::denorm_min()).mantissa, 1);
  EXPECT_EQ(decompose(Limits::denorm_min()).exponent, -1074);
  EXPECT_EQ(decompose(-Limits::min()).mantissa, -1);
  EXPECT_EQ(decompose(-Limits::min()).exponent, -1022);
  EXPECT_EQ(decompose(Limits::max()).mantissa, (std::int64_t{1} << 53) - 1);
  EXPECT_EQ(decompose(Limits::max()).exponent, 971);
}

TEST(Decompose, bits_are_counted_from_the_common_unit) {
  EXPECT_EQ(bit_length(decompose(6.0), 0), 3);
  EXPECT_EQ(bit_length(decompose(6.0), -10), 13);
  EXPECT_EQ(bit_length(decompose(-Limits::max()), -1074), 2098);
  EXPECT_EQ(bit_length(decompose(0.0), -1074), 0);
  EXPECT_EQ(to_integer<std::int64_t>(decompose(-6.5), -3), -52);
  EXPECT_EQ(to_integer<BigInt>(decompose(0x1p200), 0), BigInt(1) << 200);
}

}  // namespace
}  // namespace delone::exact
