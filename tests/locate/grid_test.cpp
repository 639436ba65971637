#include "delone/locate/grid.hpp"

#include <cmath>

#include "locate/follow.hpp"

namespace delone {
namespace {

using namespace test;

static_assert(Locator<Grid>);

TEST(Grid, leads_to_every_query_on_every_family) {
  expect_to_follow_every_family([] { return Grid{}; });
}

TEST(Grid, has_about_one_vertex_a_bucket_in_any_dimension) {
  for (int dimension = 1; dimension <= 6; ++dimension) {
    const std::size_t n = dimension < 5 ? 3000 : 100;
    const AnyTriangulation t = build(uniform(dimension, n, 1).view());
    Grid locator;
    attach(locator, t);
    EXPECT_LE(locator.bucket_count(), n);
    EXPECT_GE(locator.bucket_count() * (std::size_t{1} << dimension), n);
  }
}

TEST(Grid, grows_with_the_points_also_when_they_come_in_sorted_order) {
  PointSet points = uniform(2, 5000, 3);
  AnyTriangulation t(2);
  Grid locator;
  for (std::size_t row = 0; row < points.size(); ++row) {
    points.coordinates[2 * row] = static_cast<double>(row);
    points.coordinates[2 * row + 1] *= 100.0;
    insert(t, points.view()[row], 0.0, locator);
  }
  EXPECT_GT(locator.bucket_count(), 2000U);
  EXPECT_LE(locator.bucket_count(), 5000U);
  EXPECT_LT(static_cast<double>(t.statistics().walk_steps), 8.0 * 5000);
}

TEST(Grid, walks_take_as_few_steps_among_many_points_as_among_few) {
  for (int dimension = 2; dimension <= 3; ++dimension) {
    for (const std::size_t n : {1000U, 10000U, 100000U}) {
      if (dimension == 3 && n > 50000) continue;
      AnyTriangulation t = build(uniform(dimension, n, 3).view());
      Grid locator;
      attach(locator, t);
      EXPECT_LT(mean_steps(locator, t, 500, 4), dimension == 2 ? 4.0 : 7.0) << n;
      EXPECT_LT(static_cast<double>(locator.counts().visited) / 500, dimension == 2 ? 6.0 : 15.0);
    }
  }
}

TEST(Grid, memory_is_a_few_ids_a_vertex) {
  const AnyTriangulation t = build(uniform(2, 20000, 2).view());
  Grid locator;
  attach(locator, t);
  EXPECT_LE(locator.memory_bytes(), sizeof locator + 20000 * 4 * sizeof(Index));
}

TEST(Grid, follows_removals) {
  const PointSet points = uniform(2, 6000, 9);
  AnyTriangulation t(2);
  Grid locator;
  const auto listen = [&](const Edit& e) { locator.update(t, e); };
  for (std::size_t row = 0; row < points.size(); ++row) {
    insert(t, points.view()[row], 0.0, locator);
    if (row >= 500) remove(t, static_cast<Index>(row - 500), {.on_edit = listen});  // 500 points at a time
  }
  EXPECT_LT(mean_steps(locator, t, 300, 4), 6.0);
  EXPECT_LT(locator.memory_bytes(), sizeof locator + 500 * 80U);
}

}  // namespace
}  // namespace delone
