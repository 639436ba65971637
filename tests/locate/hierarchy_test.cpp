#include "delone/locate/hierarchy.hpp"

#include <cmath>

#include "locate/follow.hpp"
#include "support/expectations.hpp"

namespace delone {
namespace {

using namespace test;

static_assert(Locator<Hierarchy>);

/// With small levels, so that few points make several.
Hierarchy steep() {
  Hierarchy locator;
  locator.ratio = 3.0;
  locator.minimal_size = 1;
  locator.minimal_sample_size = 4;
  return locator;
}

TEST(Hierarchy, leads_to_every_query_on_every_family) {
  expect_to_follow_every_family([] { return steep(); });
}

TEST(Hierarchy, leads_to_every_query_in_all_its_variants) {
  for (int variant = 0; variant < 16; ++variant) {
    expect_to_follow_small_families([&] {
      Hierarchy locator = steep();
      locator.jump_and_walk = (variant & 1) != 0;
      locator.exact_nearest = (variant & 2) != 0;
      locator.straight = (variant & 4) != 0;
      locator.arrive = (variant & 8) != 0;
      return locator;
    });
    if (HasFailure()) return;
  }
}

TEST(Hierarchy, hint_contains_the_query_when_it_shall_arrive) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    AnyTriangulation t = build(uniform(dimension, 2000, 1).view());
    Hierarchy locator = steep();
    locator.arrive = true;
    attach(locator, t);
    EXPECT_EQ(mean_steps(locator, t, 300, 2), 0.0);
  }
}

TEST(Hierarchy, every_level_is_the_exact_triangulation_of_about_one_point_in_ratio_of_the_level_below) {
  const PointSet points = uniform(2, 4000, 2);
  AnyTriangulation t(2);
  Hierarchy locator;
  locator.ratio = 10.0;
  for (std::size_t row = 0; row < points.size(); ++row) insert(t, points.view()[row], 0.0, locator);
  ASSERT_GE(locator.level_count(), 3U);
  EXPECT_NEAR(static_cast<double>(locator.level(0).vertex_count()), 400.0, 80.0);
  EXPECT_NEAR(static_cast<double>(locator.level(1).vertex_count()), 40.0, 25.0);
  for (std::size_t i = 0; i < locator.level_count(); ++i) {
    EXPECT_EQ(broken_invariant(locator.level(i)), "");
    EXPECT_EQ(locator.level(i).vertex_count(), locator.level(i).row_count());
  }
}

TEST(Hierarchy, goes_down_from_the_very_nearest_vertex_when_asked_to) {
  const PointSet points = uniform(2, 1000, 4);
  AnyTriangulation t = build(points.view());
  Hierarchy locator = steep();
  locator.exact_nearest = true;
  attach(locator, t);
  const AnyTriangulation& above = locator.level(0);
  const PointSet queries = uniform(2, 200, 5);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto q = queries.view()[i];
    const auto distance = [&](const std::vector<double>& x) { return std::hypot(x[0] - q[0], x[1] - q[1]); };
    Index nearest = 0;
    for (Index row = 0; row < above.row_count(); ++row) {
      if (distance(above.point(row)) < distance(above.point(nearest))) nearest = row;
    }
    const CellId hint = locator.hint(t, q);
    bool at_nearest = false;
    for (int slot = 0; slot < 3; ++slot) {
      const Index row = t.row(t.complex().vertex(hint, slot));
      at_nearest = at_nearest || (row != kNone && t.point(row) == above.point(nearest));
    }
    EXPECT_TRUE(at_nearest);
  }
}

/// Tests and distances of a hint that arrives, on average.
double cost(const LocateCounts& counts) {
  return static_cast<double>(counts.line_tests + counts.facet_tests + counts.distances) /
         static_cast<double>(counts.hints);
}

// [Dev97] 4.4: 13 to 14 log2(n) operations for about 6 a test.
TEST(Hierarchy, tests_grow_with_the_logarithm_of_n) {
  double smallest = 0.0;
  for (const std::size_t n : {1000U, 10000U, 100000U}) {
    AnyTriangulation t = build(uniform(2, n, 3).view());
    Hierarchy locator;
    locator.arrive = true;
    attach(locator, t);
    mean_steps(locator, t, 1000, 4);
    const double per_level = cost(locator.counts()) / std::log2(static_cast<double>(n));
    EXPECT_GT(per_level, 2.0) << n;
    EXPECT_LT(per_level, 5.0) << n;
    if (smallest == 0.0) smallest = per_level;
    EXPECT_LT(per_level, 1.7 * smallest) << n;
  }
}

TEST(Hierarchy, random_order_insertion_walks_a_bounded_number_of_steps) {
  for (const char* kind : {"square", "circle"}) {
    const bool square = kind[0] == 's';
    std::vector<double> per_point;
    for (const std::size_t n : {2000U, 20000U}) {
      const PointSet points = square ? uniform(2, n, 1) : circle_of_24_bits(2, n, 1);
      AnyTriangulation t(2);
      Hierarchy locator;
      for (std::size_t row = 0; row < n; ++row) insert(t, points.view()[row], 0.0, locator);
      EXPECT_EQ(t.statistics().walk_fallbacks, 0U);
      const double walked = static_cast<double>(t.statistics().walk_steps);
      per_point.push_back((cost(locator.counts()) * static_cast<double>(n) + walked) / static_cast<double>(n));
    }
    EXPECT_LT(per_point[1], 2.2 * per_point[0]) << kind;  // a root would be 3.2
    EXPECT_LT(per_point[1], 80.0) << kind;
  }
}

TEST(Hierarchy, hidden_vertices_leave_all_levels) {
  PointSet points = uniform(2, 300, 7);
  points.weights.assign(300, 0.0);
  AnyTriangulation t = build(points.view());
  Hierarchy locator = steep();
  attach(locator, t);
  const std::size_t before = locator.level(0).vertex_count();
  for (std::size_t i = 0; i < 40; ++i) insert(t, uniform(2, 1, i).view()[0], 0.01, locator);
  EXPECT_LT(locator.level(0).vertex_count(), before);
  std::size_t found = 0;
  const AnyTriangulation& level = locator.level(0);
  for (const Index row : level.present_rows()) {
    ++found;
    bool alive = false;
    for (Index base = 0; base < t.row_count() && !alive; ++base) {
      alive = t.status(base).status == Status::vertex && t.point(base) == level.point(row);
    }
    EXPECT_TRUE(alive);
  }
  EXPECT_EQ(found, level.vertex_count());
}

TEST(Hierarchy, removed_vertices_leave_all_levels_and_rows_that_left_do_not_pile_up) {
  const PointSet points = uniform(2, 3000, 9);
  AnyTriangulation t(2);
  Hierarchy locator = steep();
  const auto listen = [&](const Edit& e) { locator.update(t, e); };
  for (std::size_t row = 0; row < points.size(); ++row) {
    insert(t, points.view()[row], 0.0, locator);
    if (row >= 300) remove(t, static_cast<Index>(row - 300), {.on_edit = listen});  // 300 points at a time
  }
  ASSERT_EQ(t.vertex_count(), 300U);
  EXPECT_NEAR(static_cast<double>(locator.level(0).vertex_count()), 100.0, 40.0);
  for (std::size_t i = 0; i < locator.level_count(); ++i) {
    const AnyTriangulation& level = locator.level(i);
    EXPECT_EQ(broken_invariant(level), "");
    EXPECT_LE(level.removed_count(), level.vertex_count() + 64);
    for (const Index row : level.present_rows()) {
      const auto newest = points.coordinates.end() - 600;
      const std::vector<double> x = level.point(row);
      EXPECT_NE(std::search(newest, points.coordinates.end(), x.begin(), x.end()), points.coordinates.end());
    }
  }
  EXPECT_LT(mean_steps(locator, t, 300, 4), 6.0);
}

TEST(Hierarchy, costs_little_memory) {
  const AnyTriangulation t = build(uniform(2, 50000, 2).view());
  Hierarchy locator;
  attach(locator, t);
  EXPECT_LT(locator.memory_bytes(), t.memory_bytes() / 12);
}

}  // namespace
}  // namespace delone
