#include "mesh/halves.hpp"

#include <gtest/gtest.h>

#include <array>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/mesh/export.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

constexpr std::array<int, 3> kAxes{0, 1, 2};

TEST(Halves, make_the_whole_whatever_the_number_of_threads) {
  for (const PointSet& points : {uniform(3, 70000, 1), with_random_weights(uniform(3, 70000, 2), 3)}) {
    const std::uint64_t hash = canonical_hash(build(points.view(), {.threads = 1}));
    for (const int threads : {2, 3, 64}) {
      auto mesh = triangulate_in_halves(points.view(), kAxes, threads, {});
      ASSERT_TRUE(mesh) << points.name;
      const AnyTriangulation t(std::move(*mesh));
      EXPECT_EQ(broken_invariant(t), "") << points.name;
      EXPECT_EQ(canonical_hash(t), hash) << points.name << ", " << threads << " threads";
    }
  }
}

TEST(Halves, repeated_rows_are_named_as_ever) {
  PointSet points = uniform(3, 40000, 1);
  points.coordinates.insert(points.coordinates.end(), points.coordinates.begin(), points.coordinates.end());
  const AnyTriangulation t = build(points.view(), {.threads = 2});
  EXPECT_EQ(t.duplicate_count(), 40000U);
  EXPECT_EQ(t.status(40007), (RowStatus{Status::duplicate, 7}));
  EXPECT_EQ(description(t), description(build(points.view())));
}

TEST(Halves, few_points_and_those_of_a_plane_are_not_cut) {
  EXPECT_FALSE(triangulate_in_halves(uniform(3, 1000, 1).view(), kAxes, 2, {}));
  EXPECT_FALSE(triangulate_in_halves(uniform(3, 70000, 1).view(), kAxes, 1, {}));
  PointSet steps = uniform(3, 70000, 1);
  for (std::size_t i = 0; i < steps.coordinates.size(); i += 3) steps.coordinates[i] = 0.0;
  steps.coordinates[0] = 1e-3;
  EXPECT_EQ(canonical_hash(build(steps.view(), {.threads = 2})), canonical_hash(build(steps.view())));
}

TEST(Halves, a_caller_may_cancel_both) {
  const PointSet points = uniform(3, 70000, 1);
  EXPECT_THROW(build(points.view(), {.threads = 2, .progress = [](double done) { return done < 0.3; }}), Cancelled);
}

}  // namespace
}  // namespace delone
