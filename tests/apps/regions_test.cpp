// Regions from points: every point is inside, and nothing is wider than it must be.
#include "delone/apps/regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace delone {
namespace {

using Plane = std::vector<std::array<double, 2>>;
using Space = std::vector<std::array<double, 3>>;

TEST(RegionAround, is_the_bounding_box_and_a_tenth_of_its_longest_side) {
  const Region box = region_around(Plane{{0, 1}, {10, 3}, {5, 2}});
  EXPECT_EQ(box.low(), (std::array<double, 3>{-1, 0, 0}));
  EXPECT_EQ(box.high(), (std::array<double, 3>{11, 4, 0}));
  EXPECT_EQ(region_around(Space{{0, 0, 0}, {2, 4, 0}}, 0.25).measure(), 4 * 6 * 2);
}

TEST(RegionAround, flat_sides_have_room_too) {
  const Region line = region_around(Plane{{0, 7}, {10, 7}});
  EXPECT_EQ(line.measure(), 12 * 2);
  const Region place = region_around(Plane{{3, 4}, {3, 4}});
  EXPECT_EQ(place.measure(), 4);
}

TEST(RegionAround, far_points_are_inside) {
  for (const Plane& points : {Plane{{1e17, 0}, {1e17, 1}}, Plane{{1e17, -1e300}}, Plane{{4e-320, 0}, {0, 4e-320}}}) {
    const Region box = region_around(points);
    for (const auto& point : points) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        EXPECT_LT(box.low()[axis], point[axis]);
        EXPECT_GT(box.high()[axis], point[axis]);
      }
    }
  }
}

TEST(RegionAround, no_points_and_other_dimensions_are_refused) {
  EXPECT_THROW(region_around(Plane{}), InputError);
  EXPECT_THROW(region_around(PointsView(std::vector<double>{1, 2, 3, 4}, 4)), InputError);
  EXPECT_THROW(region_around(PointsView(std::vector<double>{1, 2, 3}, 1)), InputError);
  EXPECT_THROW(region_around(Plane{{0, 0}, {NAN, 1}}), InputError);
}

/// Its faces are not quite flat, so its hull has facets of corners that are nearly in line.
TEST(HullRegion, of_a_grid_on_a_turned_cube_is_the_cube) {
  Space points;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) {
        if (x % 4 != 0 && y % 4 != 0 && z % 4 != 0) continue;
        const double a = x / 4.0, b = y / 4.0, c = z / 4.0;
        points.push_back({(2 * a - b + 2 * c) / 3, (2 * a + 2 * b - c) / 3, (-a + 2 * b + 2 * c) / 3});
      }
    }
  }
  EXPECT_NEAR(hull_region(PointsView(points)).measure(), 1, 1e-12);
}

TEST(HullRegion, of_the_plane_has_the_corners_as_they_are) {
  const Region hull = hull_region(Plane{{1, 1}, {0, 0}, {0.1, 4}, {2, 0}, {4, 0}, {4, 4}, {4, 0}});
  ASSERT_EQ(hull.rings().size(), 1u);
  Ring ring = hull.rings()[0];
  std::ranges::rotate(ring, std::ranges::min_element(ring));
  EXPECT_EQ(ring, (Ring{{0, 0}, {4, 0}, {4, 4}, {0.1, 4}}));
}

TEST(HullRegion, of_a_cube_has_six_sides) {
  Space corners;
  for (int i = 0; i < 8; ++i) corners.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  corners.push_back({0.5, 0.5, 1});
  const Region cube = hull_region(corners);
  EXPECT_EQ(cube.sides().size(), 6u);
  EXPECT_NEAR(cube.measure(), 1, 1e-15);
}

TEST(HullRegion, of_space_holds_all_points_and_measures_what_the_hull_does) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double far : {0.0, 1e6}) {
    Space points;
    for (int i = 0; i < 200; ++i) points.push_back({far + uniform(random), far + uniform(random), uniform(random)});
    const Region region = hull_region(points);
    EXPECT_NEAR(region.measure(), convex_hull(points).volume, 1e-12 * (1 + far));
    for (const HalfSpace& side : region.sides()) {
      for (const auto& p : points) {
        const double beyond = side.normal[0] * p[0] + side.normal[1] * p[1] + side.normal[2] * p[2] - side.offset;
        EXPECT_LE(beyond, 4e-16 * (1 + far));
      }
    }
  }
}

TEST(HullRegion, flat_points_have_none) {
  EXPECT_THROW(hull_region(Plane{{0, 0}, {1, 1}, {2, 2}}), InputError);
  EXPECT_THROW(hull_region(Plane{}), InputError);
  EXPECT_THROW(hull_region(Space{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}), InputError);
}

}  // namespace
}  // namespace delone
