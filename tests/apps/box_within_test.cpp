#include "apps/box_within.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace delone {
namespace {

TEST(BoxWithin, of_a_box_is_the_box) {
  const Box plane = box_within(Region::box(std::vector{1.0, -2.0}, std::vector{5.0, -1.0}));
  const Box space = box_within(Region::box(std::vector{1.0, -2.0, 0.0}, std::vector{5.0, -1.0, 1e-6}));
  const std::array<double, 3> low{1, -2, 0};
  const std::array<double, 3> high{5, -1, 1e-6};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(space.low[axis], low[axis], 1e-15);
    EXPECT_NEAR(space.high[axis], high[axis], 1e-15);
    EXPECT_NEAR(plane.low[axis], axis < 2 ? low[axis] : 0, 1e-15);
    EXPECT_NEAR(plane.high[axis], axis < 2 ? high[axis] : 0, 1e-15);
  }
}

TEST(BoxWithin, of_a_simplex_touches_a_side) {
  const Region simplex = Region::half_spaces(3, {{{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, 0}, {{1, 1, 1}, 1}});
  const Box box = box_within(simplex);  // the centroid is at 1/4, so 1/4 are left to the slanted side
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.low[axis], 0.25 - 0.25 / 3, 1e-15);
    EXPECT_NEAR(box.high[axis], 0.25 + 0.25 / 3, 1e-15);
  }
}

/// The square is in the region, given how far its center is from the boundary at the most.
void expect_square(const std::vector<Ring>& rings, double largest_radius) {
  const Box box = box_within(Region::polygon(rings));
  const double side = box.high[0] - box.low[0];
  EXPECT_NEAR(box.high[1] - box.low[1], side, 1e-10 * side);
  EXPECT_GE(side, largest_radius / std::sqrt(2.0));
  const Ring square{
      {box.low[0], box.low[1]}, {box.high[0], box.low[1]}, {box.high[0], box.high[1]}, {box.low[0], box.high[1]}};
  std::vector<Ring> with_hole = rings;
  with_hole.push_back(square);  // refused if it crosses the boundary
  double without = Region::polygon(rings).measure();
  EXPECT_NEAR(Region::polygon(with_hole).measure(), without - side * side, 1e-10 * without);
}

TEST(BoxWithin, of_other_polygons_is_a_square_inside) {
  expect_square({{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}, 2 - std::sqrt(2.0));
  expect_square({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{0.1, 0.1}, {2.9, 0.1}, {2.9, 2.9}, {0.1, 2.9}}}, 0.05);
  expect_square({{{0, 0}, {1000, 1}, {1000, 2}, {500, 1.1}, {0, 1}}}, 0.2);
  expect_square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{5, 5}, {9, 5}, {9, 9}, {5, 9}}}, 2);
  expect_square({{{1e6, 0}, {1e6 + 2, 0}, {1e6 + 1, 0.5}, {1e6 + 1, 3}}}, 0.2);
}

}  // namespace
}  // namespace delone
