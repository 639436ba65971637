#include "delone/lab/devillers.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "delone/base/errors.hpp"

namespace delone::lab {
namespace {

std::vector<InsertionRun> small_runs() {
  InsertionOptions options;
  options.sizes = {400, 4000};
  return run_insertions(options);
}

TEST(Devillers, all_methods_build_the_same_triangulation) {
  const std::vector<InsertionRun> runs = small_runs();
  ASSERT_EQ(runs.size(), 5U * 2 * 4);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].measured, Measured::whole);
    EXPECT_EQ(runs[i].hash, runs[i / 4 * 4].hash);
    EXPECT_EQ(runs[i].distribution, runs[i / 4 * 4].distribution);
  }
}

// [Dev97] 5.5.2: on curves the walk takes far more than the hierarchy, on the circle they are level.
TEST(Devillers, hierarchy_saves_the_more_tests_the_longer_the_walk) {
  const std::vector<InsertionRun> runs = small_runs();
  for (std::size_t i = 0; i < runs.size(); i += 4) {
    if (runs[i].points != 4000) continue;
    const double saved = runs[i].orientations / (runs[i + 3].orientations + runs[i + 3].distances);
    if (runs[i].distribution == "circle") {
      EXPECT_NEAR(saved, 1.0, 0.4);
    } else if (runs[i].distribution == "ellipse" || runs[i].distribution == "parabola") {
      EXPECT_GT(saved, 8.0);
    } else {
      EXPECT_GT(saved, 2.0);
    }
  }
}

TEST(Devillers, entries_that_would_take_too_long_are_estimated_or_stopped) {
  InsertionOptions options;
  options.sizes = {2000, 200000};
  options.distributions = {"ellipse"};
  options.limit = 0.02;
  for (const InsertionRun& run : run_insertions(options)) {
    if (run.points == 2000) continue;
    EXPECT_NE(run.measured, Measured::whole);
    EXPECT_GT(run.seconds, options.limit);
  }
}

TEST(Devillers, unknown_distributions_are_refused) {
  InsertionOptions options;
  options.distributions = {"triangle"};
  EXPECT_THROW(run_insertions(options), InputError);
}

// [Dev97] 4.4, with two tests for every edge crossed.
TEST(Devillers, operations_follow_the_formula_where_levels_are_many) {
  TuningOptions options;
  options.ratios = {10, 20, 30};
  options.least_size = 5000;
  options.most_size = 50000;
  options.size_count = 6;
  options.queries = 200;
  for (const TuningPoint& p : run_tuning(options)) {
    EXPECT_NEAR(p.per_logarithm / p.doubled_per_logarithm, 1.0, 0.2) << p.ratio;
    EXPECT_GT(p.per_logarithm, 1.1 * p.paper_per_logarithm) << p.ratio;
  }
}

}  // namespace
}  // namespace delone::lab
