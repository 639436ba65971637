#include "delone/base/pair.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace delone {
namespace {

void expect_pair(Pair p, double first, double second) {
  EXPECT_EQ(p[0], first);
  EXPECT_EQ(p[1], second);
}

TEST(Pair, is_loaded_from_any_double) {
  const std::array<double, 3> x{1.0, 2.0, 3.0};
  expect_pair(load_pair(x.data()), 1.0, 2.0);
  expect_pair(load_pair(x.data() + 1), 2.0, 3.0);
}

TEST(Pair, lanes_are_picked_from_two) {
  const Pair a{1.0, 2.0};
  const Pair b{3.0, 4.0};
  expect_pair(firsts(a, b), 1.0, 3.0);
  expect_pair(seconds(a, b), 2.0, 4.0);
  expect_pair(turned(a, b), 2.0, 3.0);
  expect_pair(turned(b, a), 4.0, 1.0);
  expect_pair(larger(Pair{1.0, 5.0}, Pair{3.0, 4.0}), 3.0, 5.0);
  expect_pair(smaller(Pair{1.0, 5.0}, Pair{3.0, 4.0}), 1.0, 4.0);
}

TEST(Pair, a_magnitude_is_that_of_each_lane) {
  expect_pair(magnitude(Pair{-1.0, 2.0}), 1.0, 2.0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  expect_pair(magnitude(Pair{-kInfinity, -0x1p-1074}), kInfinity, 0x1p-1074);
  const Pair nothing = magnitude(Pair{-0.0, 0.0});
  EXPECT_FALSE(std::signbit(nothing[0]) || std::signbit(nothing[1]));
}

TEST(Pair, a_numbered_lane_tells_its_number_and_is_off_by_little) {
  for (const double x : {1.0, -1.0, 3.0, std::nextafter(2.0, 0.0), -std::nextafter(1.0, 2.0), 1e300, -0x1p-1000}) {
    for (int number = 0; number < 4; ++number) {
      const Pair p = numbered(Pair{x, -x}, number, 3 - number);
      EXPECT_EQ(number_in(p[0]), number);
      EXPECT_EQ(number_in(p[1]), 3 - number);
      for (const double off : {p[0] - x, p[1] + x}) EXPECT_LE(std::abs(off), 6 * 0x1p-53 * std::abs(x)) << x;
    }
  }
  expect_pair(numbered(Pair{0.0, -0x1p-1074}, 3, 2), 0x3p-1074, -0x1p-1073);
}

TEST(Pair, every_lane_is_rounded_as_a_double_is) {
  const Pair third = Pair{1.0, 2.0} / Pair{3.0, 3.0};
  expect_pair(third, 1.0 / 3.0, 2.0 / 3.0);
  expect_pair(third * third - third, 1.0 / 3.0 * (1.0 / 3.0) - 1.0 / 3.0, 2.0 / 3.0 * (2.0 / 3.0) - 2.0 / 3.0);
}

}  // namespace
}  // namespace delone
