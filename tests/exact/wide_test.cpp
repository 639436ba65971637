#include "exact/wide.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>

namespace delone::exact {
namespace {

using Random = std::mt19937_64;

/// Random words, among them those whose carries and signs are delicate.
std::int64_t word(Random& random) {
  switch (random() % 6) {
    case 0:
      return 0;
    case 1:
      return -1;
    case 2:
      return std::numeric_limits<std::int64_t>::min();
    case 3:
      return std::numeric_limits<std::int64_t>::max();
    default:
      return static_cast<std::int64_t>(random());
  }
}

Int128 two_words(Random& random) { return static_cast<Int128>(word(random)) * word(random) + word(random); }

/// x modulo 2^bits, as two's complement reads it.
BigInt wrapped(BigInt x, unsigned bits) {
  const BigInt modulus = BigInt(1) << bits;
  x %= modulus;
  if (x < 0) x += modulus;
  return x >= modulus / 2 ? BigInt(x - modulus) : x;
}

TEST(Wide, sums_and_products_agree_with_integers_of_any_size_modulo_a_power_of_two) {
  Random random(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const Int128 a = two_words(random), b = two_words(random), c = two_words(random);
    const std::int64_t d = word(random);
    const BigInt truth = (BigInt(a) * BigInt(b) - BigInt(c)) * BigInt(d) + BigInt(b) * BigInt(c);
    const auto value = [&]<int L>(Wide<L>) {
      return (Wide<L>(a) * Wide<L>(b) - Wide<L>(c)) * d + Wide<L>(b) * Wide<L>(c);
    };
    EXPECT_EQ(sign(value(Wide<3>())), sign(wrapped(truth, 192)));
    EXPECT_EQ(sign(value(Wide<6>())), sign(truth));
    EXPECT_EQ(sign(Wide<6>(Wide<3>(a) * d) - Wide<6>(a) * d),
              sign(BigInt(wrapped(BigInt(a) * BigInt(d), 192) - BigInt(a) * BigInt(d))));
  }
}

TEST(Wide, a_sum_of_zero_has_no_sign) {
  const Wide<4> x(Int128{1} << 100);
  EXPECT_EQ(sign(x - x), 0);
  EXPECT_EQ(sign(Wide<4>(0) - x), -1);
  EXPECT_EQ(sign(x * x), 1);
}

}  // namespace
}  // namespace delone::exact
