#include "delone/exact/double_double.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delone/exact/determinant.hpp"
#include "exact/integer.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using exact::BigInt;
using test::Random;

TEST(DoubleDouble, a_difference_of_doubles_is_exact) {
  const DoubleDouble d = DoubleDouble::difference(1.0, 0x1p-80) - DoubleDouble(1.0);
  EXPECT_EQ(d.high(), -0x1p-80);
}

TEST(DoubleDouble, small_integers_are_computed_exactly) {
  const DoubleDouble a(0x1p50 + 1);
  const DoubleDouble b(0x1p50 - 1);
  EXPECT_EQ((a * b - DoubleDouble(0x1p100)).high(), -1.0);  // 2^100 - 1 takes 100 bits
  EXPECT_EQ((a + b).high(), 0x1p51);
  EXPECT_EQ((-a).high(), -0x1p50 - 1);
}

/// The bound that the predicates rest on: 7 u^2 for each product and 3 u^2 for each sum, relative to the permanent.
TEST(DoubleDouble, determinants_of_four_columns_stay_within_their_bound) {
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    Matrix<4, double> m;
    Matrix<4, DoubleDouble> wide;
    Matrix<4, BigInt> exact;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        m[i][j] = i == 3 && trial % 2 == 0 ? m[0][j] + m[1][j] : std::floor(0x1p53 * (test::unit_random(random) - 0.5));
        wide[i][j] = DoubleDouble(m[i][j]);
        exact[i][j] = exact::to_integer<BigInt>(exact::decompose(m[i][j]), 0);
      }
    }
    const double value = determinant<4>(wide).high();
    const BigInt truth = determinant<4>(exact);
    const BigInt error = exact::to_integer<BigInt>(exact::decompose(std::nearbyint(value)), 0) - truth;
    const double bound = 0x1p-106 * (7 * 4 + 3 * 6) * absolute_permanent<4>(m) + std::abs(value) * 0x1p-53 + 1;
    ASSERT_LE(std::abs(error.convert_to<double>()), bound);
  }
}

}  // namespace
}  // namespace delone
