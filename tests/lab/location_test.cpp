#include "delone/lab/location.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "delone/base/errors.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

TEST(Location, bound_grows_as_twelve_logarithms) {
  EXPECT_EQ(traced_bound(3), 1.75);
  EXPECT_EQ(mean_traced_bound(4), 1.75 / 4);
  EXPECT_NEAR(traced_bound(20000) - traced_bound(10000), 12 * std::log(2), 0.01);
  for (std::size_t r = 3; r < 2000; ++r) EXPECT_LT(traced_bound(r), 12 * std::log(static_cast<double>(r)));
}

TEST(Location, traced_triangles_grow_as_the_logarithm_on_all_kinds_of_points) {
  LocationOptions options;
  options.sizes = {100, 400, 1600, 6400};
  options.bad_sizes = {};
  options.runs = 2;
  const LocationResult result = run_location(options);
  ASSERT_EQ(result.rows.size(), 4 * options.kinds.size());
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    const LocationRow& row = result.rows[i];
    EXPECT_LT(row.traced.mean, mean_traced_bound(row.n)) << row.kind;
    if (i % 4 == 0) continue;
    const double grown = row.traced.mean - result.rows[i - 1].traced.mean;
    EXPECT_GT(grown, std::log(4)) << row.kind << row.n;
    EXPECT_LT(grown, 12 * std::log(4)) << row.kind << row.n;
  }
}

TEST(Location, bad_site_is_traced_through_all_bottom_sites) {
  for (const Method method : {Method::flip, Method::flip_loop, Method::flip_legalize}) {
    for (const std::size_t m : {10U, 100U, 1000U}) {
      const double traced = traced_for_bad_site(m, method, 1);
      EXPECT_GE(traced, static_cast<double>(m));
      EXPECT_LE(traced, static_cast<double>(m) + 12 * std::log(static_cast<double>(m)));
    }
  }
}

TEST(Location, bad_site_is_bad_in_random_orders_too) {
  LocationOptions options;
  options.sizes = {};
  options.bad_sizes = {50, 100, 200, 400};
  std::vector<std::array<double, 2>> curve;
  for (const RandomBadSiteRow& row : run_location(options).random_bad) {
    EXPECT_GT(row.traced_if_ordered.mean, row.before_x);
    const double error = row.traced.deviation / std::sqrt(static_cast<double>(options.bad_runs));
    EXPECT_GT(row.traced.mean + 3 * error, static_cast<double>(row.n - 3) / 12);
    curve.push_back({static_cast<double>(row.n), row.traced_if_ordered.mean});
  }
  EXPECT_NEAR(exponent(curve), 1, 0.25);
}

TEST(Location, unknown_kinds_are_refused) {
  LocationOptions options;
  options.kinds = {"triangle"};
  EXPECT_THROW(run_location(options), InputError);
}

}  // namespace
}  // namespace delone::lab
