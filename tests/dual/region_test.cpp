#include "delone/dual/region.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace delone {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Region, box_has_sides_corners_and_a_measure) {
  const std::vector<double> low{1, 2}, high{4, 4};
  const Region plane = Region::box(low, high);
  EXPECT_EQ(plane.measure(), 6);
  EXPECT_TRUE(plane.convex());
  EXPECT_EQ(plane.sides().size(), 4U);
  const Region space = Region::box(std::vector<double>{0, 0, 0}, std::vector<double>{1, 2, 3});
  EXPECT_EQ(space.measure(), 6);
  EXPECT_EQ(space.faces().size(), 6U);
}

TEST(Region, box_far_from_the_origin_keeps_its_volume) {
  const std::vector<double> low{1e15, 1e15, 1e15}, high{1e15 + 1, 1e15 + 1, 1e15 + 2};
  EXPECT_DOUBLE_EQ(Region::box(low, high).measure(), 2);
}

TEST(Region, box_without_extent_is_refused) {
  const auto box = [](double low, double high) {
    return Region::box(std::vector<double>{0, low}, std::vector<double>{1, high});
  };
  EXPECT_THAT([&] { box(1, 1); }, ThrowsMessage<InputError>(HasSubstr("axis 1")));
  EXPECT_THAT([&] { box(0, INFINITY); }, ThrowsMessage<InputError>(HasSubstr("axis 1")));
  EXPECT_THAT([&] { Region::box(std::vector<double>{0}, std::vector<double>{1}); },
              ThrowsMessage<InputError>(HasSubstr("dimension 2 or 3")));
}

/// {x : |x_1| + ... + |x_D| <= 1}, moved.
std::vector<HalfSpace> cross_polytope(int dimension, double at) {
  std::vector<HalfSpace> sides;
  for (int signs = 0; signs < 1 << dimension; ++signs) {
    HalfSpace side;
    side.offset = 1;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      side.normal[axis] = (signs >> axis & 1) != 0 ? 1 : -1;
      side.offset += side.normal[axis] * at;
    }
    sides.push_back(side);
  }
  return sides;
}

TEST(Region, half_spaces_enclose_a_cross_polytope) {
  for (const double at : {0.0, 1.0, 1e6}) {
    EXPECT_NEAR(Region::half_spaces(2, cross_polytope(2, at)).measure(), 2, 1e-15 * (8 + 8 * at));
    const Region octahedron = Region::half_spaces(3, cross_polytope(3, at));
    EXPECT_NEAR(octahedron.measure(), 4.0 / 3, 1e-15 * (8 + 8 * at));
    EXPECT_EQ(octahedron.faces().size(), 8U);
    for (const auto& face : octahedron.faces()) EXPECT_GE(face.size(), 3U);  // more where rounding parts corners
  }
}

TEST(Region, half_spaces_that_touch_nothing_are_left_out) {
  auto sides = cross_polytope(2, 0);
  sides.push_back({{1, 0, 0}, 5});
  sides.push_back({{1, 1, 0}, 1});
  const Region region = Region::half_spaces(2, sides);
  EXPECT_NEAR(region.measure(), 2, 1e-15);
  EXPECT_EQ(region.rings()[0].size(), 4U);
}

TEST(Region, half_spaces_far_away_do_not_harm_the_others) {
  for (const double far : {1e3, 2e15, 8e15, 1e16, 1e30}) {
    std::vector<HalfSpace> sides;
    for (int i = 0; i < 8; ++i) {
      const double angle = 0.1 + i * std::numbers::pi / 4;
      sides.push_back({{std::cos(angle), std::sin(angle), 0}, 1});
    }
    sides.push_back({{1, 0.3, 0}, far});
    const Region octagon = Region::half_spaces(2, sides);
    EXPECT_NEAR(octagon.measure(), 8 * std::tan(std::numbers::pi / 8), 1e-14) << far;
    EXPECT_EQ(octagon.sides().size(), 8U);
  }
}

TEST(Region, half_spaces_may_be_tiny_or_huge) {
  for (const double unit : {1e-110, 1e110}) {
    std::vector<HalfSpace> sides = cross_polytope(3, 0);
    for (HalfSpace& side : sides) side.offset *= unit;
    const Region octahedron = Region::half_spaces(3, sides);
    EXPECT_DOUBLE_EQ(octahedron.high()[1], unit);
    EXPECT_EQ(octahedron.faces().size(), 8U);
  }
}

TEST(Region, half_spaces_that_leave_nothing_or_no_end_are_refused) {
  const auto refused = [](std::vector<HalfSpace> sides, const char* why) {
    EXPECT_THAT([&] { Region::half_spaces(2, sides); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  refused({{{1, 0, 0}, 0}, {{-1, 0, 0}, -1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}}, "no interior");
  refused({{{1, 0, 0}, 0}, {{-1, 0, 0}, 0}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}}, "no interior");  // a segment
  refused({{{1, 0, 0}, 1}, {{0, 1, 0}, 1}}, "without end");
  refused({}, "without end");
  refused({{{0, 0, 1}, 1}}, "half-space 0: its normal is zero");
  refused({{{1, 0, 0}, NAN}}, "half-space 0: a number is not finite");
}

const Ring kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Ring kInner{{1, 1}, {1, 3}, {3, 3}, {3, 1}};
const Ring kInnermost{{1.5, 1.5}, {2.5, 1.5}, {2.5, 2.5}};

TEST(Region, rings_within_rings_are_holes_and_islands_whatever_their_direction) {
  for (const bool turned : {false, true}) {
    std::vector<Ring> rings{kInnermost, kSquare, kInner};
    if (turned) {
      for (Ring& ring : rings) std::reverse(ring.begin(), ring.end());
    }
    const Region region = Region::polygon(rings);
    EXPECT_EQ(region.measure(), 16 - 4 + 0.5);
    EXPECT_FALSE(region.convex());
  }
}

TEST(Region, rings_may_share_a_corner) {
  EXPECT_EQ(Region::polygon({kSquare, {{4, 4}, {5, 4}, {5, 5}}}).measure(), 16.5);
  EXPECT_EQ(Region::polygon({kSquare, {{0, 0}, {2, 1}, {1, 2}}}).measure(), 14.5);  // a hole
}

TEST(Region, bad_rings_are_named) {
  const auto refused = [](std::vector<Ring> rings, const char* why) {
    EXPECT_THAT([&] { Region::polygon(rings); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  refused({}, "at least one ring");
  refused({kSquare, {{0, 0}, {1, 1}}}, "ring 1 has 2 corners");
  refused({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, "ring 0, edge from corner 0: crosses the edge from corner 2 of ring 0");
  refused({kSquare, {{2, 2}, {6, 2}, {6, 5}}}, "crosses the edge");
  refused({kSquare, {{1, 0}, {2, 1}, {1, 1}}}, "touches the edge");
  refused({kSquare, {{4, 1}, {4, 3}, {6, 2}}}, "lies on the edge");
  refused({{{0, 0}, {1, 0}, {2, 0}}}, "lies on");
  refused({{{0, 0}, {4, 0}, {4, 4}, {4, 0}, {0, 4}}}, "lies on");
  refused({{{0, 0}, {1, NAN}, {2, 2}}}, "ring 0, corner 1: coordinate is not finite");
  refused({{{0, 0}, {0, 0}, {2, 2}, {0, 2}}}, "the next corner is the same");
  refused({kSquare, {{0, 0}, {-1, 2}, {2, 1}, {2, -1}}}, "crosses");
  refused({{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}}, {{1, 1}, {0.5, 1}, {2, 0}, {3, 0.5}, {1.8, 1}}},
          "crosses ring 1 at its corner 0");
}

}  // namespace
}  // namespace delone
