#include "delone/base/random.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace delone {
namespace {

TEST(Mix, is_the_splitmix64_step) {
  // The first outputs of the published generator from state 0, whose state grows by the golden ratio.
  EXPECT_EQ(mix(0), 0xE220A8397B1DCDAFU);
  EXPECT_EQ(mix(0x9E3779B97F4A7C15U), 0x6E789E6AA1B965F4U);
  EXPECT_EQ(mix(2 * 0x9E3779B97F4A7C15U), 0x06C45D188009454FU);
}

TEST(Mix, a_flipped_bit_changes_about_half_of_the_bits) {
  std::set<std::uint64_t> seen;
  int changed = 0;
  for (int bit = 0; bit < 64; ++bit) {
    changed += std::popcount(mix(12345) ^ mix(12345 ^ std::uint64_t{1} << bit));
    seen.insert(mix(std::uint64_t{1} << bit));
  }
  EXPECT_EQ(seen.size(), 64U);
  EXPECT_NEAR(changed / 64.0, 32.0, 3.0);
}

}  // namespace
}  // namespace delone
