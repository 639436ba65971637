#include "delone/locate/jump_and_walk.hpp"

#include <cmath>

#include "locate/follow.hpp"

namespace delone {
namespace {

using namespace test;

static_assert(Locator<JumpAndWalk>);

TEST(JumpAndWalk, leads_to_every_query_on_every_family) {
  expect_to_follow_every_family([] { return JumpAndWalk{}; });
}

TEST(JumpAndWalk, sample_follows_the_number_of_vertices) {
  const PointSet points = uniform(2, 3000, 5);
  AnyTriangulation t(2);
  JumpAndWalk locator;
  for (std::size_t row = 0; row < points.size(); ++row) {
    insert(t, points.view()[row], 0.0, locator);
    ASSERT_EQ(locator.sample().size(), locator.size_for(row + 1, 2));
  }
  EXPECT_EQ(locator.sample().size(), 14U);  // the cube root of 3000
}

TEST(JumpAndWalk, every_vertex_is_sampled_with_the_same_probability) {
  constexpr std::size_t kTrials = 300;
  const PointSet points = uniform(2, 400, 6);
  double late = 0.0;
  double members = 0.0;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    AnyTriangulation t = build(rows(points, 0, 200).view());
    JumpAndWalk locator;
    locator.seed = trial;
    attach(locator, t);
    for (std::size_t row = 200; row < 400; ++row) insert(t, points.view()[row], 0.0, locator);
    for (const VertexId v : locator.sample()) late += t.row(v) >= 200 ? 1.0 : 0.0;
    members += static_cast<double>(locator.sample().size());
  }
  EXPECT_NEAR(late / members, 0.5, 0.05);
}

TEST(JumpAndWalk, hidden_vertices_leave_the_sample) {
  AnyTriangulation t = build(with_random_weights(uniform(2, 300, 7), 8).view());
  JumpAndWalk locator;
  locator.alpha = 5.0;
  attach(locator, t);
  for (std::size_t i = 0; i < 40; ++i) {
    insert(t, uniform(2, 1, i).view()[0], 1.5, locator);
    EXPECT_EQ(locator.sample().size(), locator.size_for(t.vertex_count(), 2));
    for (const VertexId v : locator.sample()) EXPECT_NE(t.complex().incident_cell(v), kNoCell);
  }
}

// [Dev97] 4.5: the distance to the nearest of n^(1/3) is crossed in about n^(1/3) steps.
TEST(JumpAndWalk, steps_and_distances_grow_with_the_cube_root_of_n) {
  for (const std::size_t n : {1000U, 10000U, 100000U}) {
    const PointSet points = uniform(2, n, 3);
    AnyTriangulation t = build(points.view());
    JumpAndWalk locator;
    attach(locator, t);
    const double root = std::cbrt(static_cast<double>(n));
    const double steps = mean_steps(locator, t, 500, 4) / root;
    EXPECT_GT(steps, 0.7) << n;
    EXPECT_LT(steps, 1.8) << n;
    EXPECT_NEAR(static_cast<double>(locator.counts().distances) / 500, root, 1.0);
  }
}

TEST(JumpAndWalk, same_seed_gives_the_same_hints) {
  const PointSet points = uniform(3, 500, 3);
  AnyTriangulation t = build(points.view());
  JumpAndWalk a, b, c;
  c.seed = 2;
  for (JumpAndWalk* locator : {&a, &b, &c}) attach(*locator, t);
  EXPECT_TRUE(std::ranges::equal(a.sample(), b.sample()));
  EXPECT_FALSE(std::ranges::equal(a.sample(), c.sample()));
}

}  // namespace
}  // namespace delone
