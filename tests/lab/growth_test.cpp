#include "lab/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delone::lab {
namespace {

TEST(Growth, sizes_end_with_the_largest) {
  EXPECT_EQ(sizes_up_to(1000, 10, 10), (std::vector<std::size_t>{10, 100, 1000}));
  EXPECT_EQ(sizes_up_to(300, 100, 2), (std::vector<std::size_t>{100, 200, 300}));
  EXPECT_EQ(sizes_up_to(7, 100, 2), (std::vector<std::size_t>{7}));
}

TEST(Growth, powers_are_found_from_their_values) {
  std::vector<std::array<double, 2>> points;
  for (const double x : {2.0, 3.0, 7.0}) points.push_back({x, 5 * x * std::sqrt(x)});
  EXPECT_NEAR(exponent(points), 1.5, 1e-12);
  points.resize(1);
  EXPECT_TRUE(std::isnan(exponent(points)));
}

TEST(Growth, harmonic_numbers_are_sums) {
  EXPECT_EQ(harmonic(0), 0);
  EXPECT_NEAR(harmonic(4), 25.0 / 12, 1e-15);
}

}  // namespace
}  // namespace delone::lab
