#include "delone/locate/quad_buckets.hpp"

#include <cmath>

#include "locate/follow.hpp"

namespace delone {
namespace {

using namespace test;

static_assert(Locator<QuadBuckets>);

TEST(QuadBuckets, lead_to_every_query_on_every_family) {
  expect_to_follow_every_family([] { return QuadBuckets{}; });
}

TEST(QuadBuckets, lead_to_every_query_when_they_are_small) {
  expect_to_follow_small_families([] {
    QuadBuckets locator;
    locator.capacity = 2;
    return locator;
  });
}

TEST(QuadBuckets, walks_take_as_few_steps_among_many_points_as_among_few) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const std::size_t n : {1000U, 10000U, 100000U}) {
      if (n > 50000 && dimension > 2) continue;
      if (n > 5000 && dimension > 3) continue;
      AnyTriangulation t = build(uniform(dimension, n, 3).view());
      QuadBuckets locator;
      attach(locator, t);
      EXPECT_LT(mean_steps(locator, t, 500, 4), dimension == 4 ? 16.0 : 3.0 * dimension) << dimension << "D " << n;
      EXPECT_LT(static_cast<double>(locator.counts().visited) / 500,
                std::log2(static_cast<double>(n)) / dimension + 2.0);
    }
  }
}

TEST(QuadBuckets, follow_clusters_where_a_grid_crowds) {
  PointSet points = uniform(2, 20000, 3);
  for (std::size_t i = 0; i < points.coordinates.size(); ++i) {
    double& x = points.coordinates[i];
    x = i % 40 < 2 ? x : 0.3 + 1e-6 * x;  // one point in twenty is spread, all others lie in a small square
  }
  AnyTriangulation t = build(points.view());
  QuadBuckets locator;
  attach(locator, t);
  Random random(1);
  std::uint64_t steps = 0;
  const ComplexView<2> complex(t.mesh().complex);
  Kernel<2> kernel(t.sites());
  for (int i = 0; i < 500; ++i) {
    const std::vector<double> q{0.3 + 1e-6 * unit_random(random), 0.3 + 1e-6 * unit_random(random)};
    WalkStats stats;
    walk(complex, kernel, q.data(), locator.hint(t, q), stats);
    steps += stats.steps;
  }
  EXPECT_LT(static_cast<double>(steps) / 500, 5.0);
}

TEST(QuadBuckets, nodes_stay_fewer_than_vertices) {
  for (int dimension = 1; dimension <= 6; ++dimension) {
    const std::size_t n = dimension < 5 ? 2000 : 100;
    const AnyTriangulation t = build(uniform(dimension, n, 1).view());
    QuadBuckets locator;
    attach(locator, t);
    EXPECT_LE(locator.node_count(), 2 * n + 2) << dimension;
  }
}

TEST(QuadBuckets, follow_removals) {
  const PointSet points = uniform(2, 6000, 9);
  AnyTriangulation t(2);
  QuadBuckets locator;
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
