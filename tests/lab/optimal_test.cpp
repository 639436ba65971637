#include "delone/lab/optimal.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace delone::lab {
namespace {

ComparisonOptions small() {
  ComparisonOptions options;
  options.plane_sites = 100;
  options.space_sites = 60;
  options.runs = 5;
  return options;
}

// [For92] lemma 3.1 and its proof.
TEST(Optimal, delaunay_has_the_largest_angles_in_the_plane) {
  for (const Comparison& c : compare_in_plane(small())) {
    EXPECT_EQ(c.angle_at_least, c.runs) << c.other;
    EXPECT_EQ(c.sequence_at_least, c.runs) << c.other;
    EXPECT_GE(c.delaunay_angle.mean, c.other_angle.mean) << c.other;
  }
}

// [For92] lemma 3.2.
TEST(Optimal, delaunay_has_the_smallest_containment_balls) {
  std::vector<Comparison> all = compare_in_plane(small());
  for (const Comparison& c : compare_in_space(small())) all.push_back(c);
  for (const Comparison& c : all) {
    EXPECT_EQ(c.runs, 5);
    EXPECT_EQ(c.radius_at_most, c.runs) << c.other;
  }
}

// The comparisons say something: others are worse by far.
TEST(Optimal, many_random_flips_spoil_angles_and_balls) {
  const std::vector<Comparison> all = compare_in_plane(small());
  const auto many = std::ranges::find_if(all, [](const Comparison& c) { return c.flips == 100; });
  ASSERT_NE(many, all.end());
  EXPECT_LT(many->other_angle.mean, many->delaunay_angle.mean / 4);
  EXPECT_GT(many->other_radius.mean, many->delaunay_radius.mean * 1.2);
  for (const Comparison& c : compare_in_space(small())) {
    EXPECT_GT(c.other_radius.mean, c.delaunay_radius.mean) << c.other;
  }
}

TEST(Optimal, equiangular_completion_has_larger_angles_where_arcs_differ) {
  for (const Completion& c : compare_completions(1)) {
    EXPECT_TRUE(c.at_least) << c.points;
    EXPECT_GT(c.polygons, 0U) << c.points;
    EXPECT_EQ(c.canonical.front(), c.equiangular.front()) << c.points;  // the shortest side decides [For92] 3.1
    if (c.points == "square lattice") {
      EXPECT_EQ(c.differ_at, 0U);  // the diagonals of a square are equal
    } else {
      EXPECT_GT(c.equiangular_there, c.canonical_there) << c.points;
    }
  }
}

}  // namespace
}  // namespace delone::lab
