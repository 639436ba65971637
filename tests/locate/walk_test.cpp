#include "delone/locate/walk.hpp"

#include <cmath>

#include "locate/follow.hpp"

namespace delone {
namespace {

using namespace test;

static_assert(Locator<Walk>);

Walk walk_by(Walk::Method method, Walk::Start start) {
  Walk walk;
  walk.method = method;
  walk.start = start;
  return walk;
}

TEST(WalkLocator, leads_to_every_query_on_every_family) {
  expect_to_follow_every_family([] { return Walk{}; });
}

TEST(WalkLocator, leads_to_every_query_by_every_method_and_from_every_start) {
  for (const auto method : {Walk::Method::visibility, Walk::Method::remembering}) {
    for (const auto start : {Walk::Start::last_cell, Walk::Start::first_vertex}) {
      expect_to_follow_small_families([&] { return walk_by(method, start); });
    }
  }
}

TEST(WalkLocator, its_hint_contains_the_query) {
  const PointSet points = uniform(2, 500, 1);
  AnyTriangulation t = build(points.view());
  for (const auto method : {Walk::Method::visibility, Walk::Method::remembering}) {
    Walk locator = walk_by(method, Walk::Start::last_cell);
    attach(locator, t);
    EXPECT_EQ(mean_steps(locator, t, 200, 2), 0.0);
  }
}

// A straight line through n uniform points crosses about 2 l sqrt(n) edges [Dev97] 4.2, l = 0.52 on average.
TEST(WalkLocator, crosses_about_the_root_of_n_triangles) {
  for (const auto method : {Walk::Method::visibility, Walk::Method::remembering}) {
    for (const std::size_t n : {1000U, 10000U, 100000U}) {
      const PointSet points = uniform(2, n, 3);
      AnyTriangulation t = build(points.view());
      Walk locator = walk_by(method, Walk::Start::last_cell);
      attach(locator, t);
      mean_steps(locator, t, 300, 4);
      const double per_root = static_cast<double>(locator.counts().crossed) / 300 / std::sqrt(static_cast<double>(n));
      EXPECT_GT(per_root, 0.9) << n;
      EXPECT_LT(per_root, 1.5) << n;
    }
  }
}

TEST(WalkLocator, remembering_takes_fewer_than_two_tests_a_triangle) {
  const PointSet points = uniform(2, 20000, 3);
  AnyTriangulation t = build(points.view());
  Walk locator = walk_by(Walk::Method::remembering, Walk::Start::last_cell);
  attach(locator, t);
  mean_steps(locator, t, 300, 4);
  const double tests = static_cast<double>(locator.counts().facet_tests);
  const double cells = static_cast<double>(locator.counts().crossed);
  EXPECT_GT(tests / cells, 1.1);
  EXPECT_LT(tests / cells, 1.7);
}

TEST(WalkLocator, refuses_queries_that_are_no_points) {
  AnyTriangulation t = build(uniform(2, 10, 1).view());
  Walk locator;
  EXPECT_THROW(locator.hint(t, std::vector<double>{1.0}), InputError);
  EXPECT_THROW(locator.hint(t, std::vector<double>{1.0, std::nan("")}), InputError);
}

}  // namespace
}  // namespace delone
