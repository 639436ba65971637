#include "delone/lab/batch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delone/base/errors.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

TEST(Batch, bound_stays_below_its_simple_form) {
  for (const std::size_t m : {3U, 50U, 5000U}) {
    for (const std::size_t n : {1U, 2U, 3U, 40U, 4000U}) {
      const auto old_count = static_cast<double>(m), count = static_cast<double>(n);
      EXPECT_LE(added_triangles_bound(m, n), 2 * old_count * harmonic(n) + 8 * count) << m << " " << n;
    }
  }
}

TEST(Batch, created_triangles_stay_below_the_bound_and_in_the_worst_case_close_to_it) {
  BatchOptions options;
  options.old_sizes = {50, 400};
  options.new_sizes = {8, 64, 512};
  options.runs = 20;
  const double root = std::sqrt(static_cast<double>(options.runs));
  for (const BatchRow& row : run_batch(options)) {
    const double bound = added_triangles_bound(row.m, row.n);
    EXPECT_LT(row.uniform.mean - 3 * row.uniform.deviation / root, bound) << row.m << " " << row.n;
    EXPECT_LT(row.worst.mean - 3 * row.worst.deviation / root, bound) << row.m << " " << row.n;
    EXPECT_NEAR(row.worst.mean, worst_case_expected(row.m, row.n), 3 * row.worst.deviation / root)
        << row.m << " " << row.n;
    EXPECT_GT(worst_case_expected(row.m, row.n), 0.95 * added_triangles_scale(row.m, row.n));
    EXPECT_LT(row.uniform.mean, 7 * static_cast<double>(row.n));
  }
}

// A new site that is the leftmost so far makes m + 1 triangles, any other one 4.
TEST(Batch, worst_case_follows_from_the_number_of_leftmost_sites) {
  BatchOptions options;
  options.old_sizes = {10, 101};
  options.new_sizes = {1, 2, 50};
  options.runs = 1;
  for (const BatchRow& row : run_batch(options)) {
    const auto m = static_cast<double>(row.m), n = static_cast<double>(row.n);
    const double leftmost = (row.worst.mean - 4 * n) / (m - 3);
    EXPECT_EQ(leftmost, std::floor(leftmost)) << row.m << " " << row.n;
    EXPECT_GE(leftmost, 1);
    EXPECT_LE(leftmost, n);
  }
}

TEST(Batch, few_old_sites_are_refused) {
  BatchOptions options;
  options.old_sizes = {2};
  EXPECT_THROW(run_batch(options), InputError);
}

}  // namespace
}  // namespace delone::lab
