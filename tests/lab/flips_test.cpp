#include "delone/lab/flips.hpp"

#include <gtest/gtest.h>

#include "delone/base/errors.hpp"

namespace delone::lab {
namespace {

FlipCountOptions small() {
  FlipCountOptions options;
  options.sizes = {500, 1000, 2000};
  return options;
}

// [For92] 4.2: no edge comes back, so there are at most n (n - 1) / 2 flips.
TEST(Flips, lawson_takes_fewer_than_all_edges_there_can_be) {
  for (const FlipCounts& c : run_flip_counts(small())) {
    EXPECT_GT(c.lawson.mean, 0.0) << c.distribution;
    EXPECT_LT(c.lawson.mean, (static_cast<double>(c.n) - 1) / 2) << c.distribution;
  }
}

// [GKS92] 3: the expected degree of a new site is less than 6 for any points; it comes in with degree 3.
TEST(Flips, random_order_takes_less_than_three_by_site) {
  for (const FlipCounts& c : run_flip_counts(small())) {
    EXPECT_LT(c.incremental.mean, 3.0 + 0.1) << c.distribution << ' ' << c.n;
    EXPECT_GT(c.incremental.mean, 1.5) << c.distribution << ' ' << c.n;
  }
}

TEST(Flips, exponent_of_a_power_is_found) {
  std::vector<FlipCounts> counts;
  for (const std::size_t n : {100U, 200U, 400U}) {
    const auto x = static_cast<double>(n);
    counts.push_back({"uniform", n, {x * x * x / x / 7, 0}, {}});
  }
  EXPECT_NEAR(lawson_exponent(counts, "uniform"), 3.0, 1e-9);
}

// [For92] 4.2, figure 8: as many flips in every order.
TEST(Flips, two_rows_force_a_square_of_flips) {
  for (const std::size_t m : {2U, 3U, 10U, 32U, 100U}) {
    const ForcedFlips f = run_forced_flips(m, 5);
    const std::uint64_t square = (m - 1) * (m - 1);
    EXPECT_TRUE(f.convex) << m;
    EXPECT_TRUE(f.delaunay) << m;
    EXPECT_EQ(f.queue, square) << m;
    EXPECT_EQ(f.stack, square) << m;
    EXPECT_EQ(f.random, square) << m;
    EXPECT_LT(f.enough, 2 * f.n) << m;
  }
}

TEST(Flips, rows_that_are_too_short_are_refused) { EXPECT_THROW(run_forced_flips(1, 1), InputError); }

// [ES96] 5.
TEST(Flips, six_weighted_sites_get_stuck) {
  const StuckFlips s = run_stuck_flips();
  EXPECT_EQ(s.edges.size(), 9U);
  int regular = 0, flippable = 0;
  for (const auto& e : s.edges) {
    regular += e.regular ? 1 : 0;
    flippable += e.flippable ? 1 : 0;
    EXPECT_EQ(e.regular, e.flippable) << e.a << '-' << e.b;
  }
  EXPECT_EQ(regular, 3);
  EXPECT_EQ(flippable, 3);
  EXPECT_EQ(s.least_degree, 4U);
  EXPECT_TRUE(s.stuck());
  EXPECT_NE(s.triangles.size(), s.by_insertion.size());
}

TEST(Flips, insertion_by_flips_is_not_stuck) {
  const StuckFlips s = run_stuck_flips();
  EXPECT_EQ(s.by_insertion, s.by_cavities);
  EXPECT_EQ(s.by_insertion, (std::vector<std::array<Index, 3>>{{0, 1, 2}}));
  EXPECT_EQ(s.hidden, 3U);
}

}  // namespace
}  // namespace delone::lab
