#include "delone/apps/hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "delone/base/dispatch.hpp"
#include "delone/build/build.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "delone/query/locate.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// Whether a row is extreme: outside of the triangulation of all points at other places.
bool is_extreme(const PointSet& points, Index row) {
  PointSet others{"others", points.dimension, {}, {}};
  const PointsView all = points.view();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::ranges::equal(all[i], all[row])) {
      if (i < row) return false;
    } else {
      others.coordinates.insert(others.coordinates.end(), all[i].begin(), all[i].end());
    }
  }
  if (others.size() == 0) return true;
  return locate(built(others), all[row]).place == Place::outside;
}

/// On which side of a facet of full dimension a row lies: 1 outside, by integers of any size.
int side(const PointSet& points, std::span<const Index> facet, Index row) {
  return with_dimension<1>(points.dimension, [&](auto d) {
    std::array<const double*, d + 1> at;
    at[0] = points.view()[facet[0]].data();
    at[1] = points.view()[row].data();  // where the normal goes
    for (std::size_t i = 1; i < d; ++i) at[i + 1] = points.view()[facet[i]].data();
    return slow_orient<d>(at).sign;
  });
}

void expect_hull(const PointSet& points) {
  const ConvexHull hull = convex_hull(points.view());
  ASSERT_EQ(hull.affine_dimension, built(points).affine_dimension()) << points;
  for (std::size_t row = 0; row < points.size(); ++row) {
    EXPECT_EQ(std::ranges::binary_search(hull.corners, static_cast<Index>(row)),
              is_extreme(points, static_cast<Index>(row)))
        << row << "\n"
        << points;
  }
  if (hull.affine_dimension < 2) return;
  std::map<std::vector<Index>, int> ridges;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    const std::span facet = hull.facets[f];
    for (std::size_t i = 0; i < facet.size(); ++i) {
      EXPECT_TRUE(std::ranges::binary_search(hull.corners, facet[i])) << points;
      std::vector<Index> ridge(facet.begin(), facet.end());
      ridge.erase(ridge.begin() + static_cast<std::ptrdiff_t>(i));
      std::ranges::sort(ridge);
      ++ridges[ridge];
    }
    if (hull.affine_dimension < points.dimension) continue;
    for (std::size_t row = 0; row < points.size(); ++row) {
      EXPECT_LE(side(points, facet, static_cast<Index>(row)), 0) << "facet " << f << " row " << row << "\n" << points;
    }
  }
  for (const auto& [ridge, count] : ridges) EXPECT_EQ(count, 2) << points;
}

TEST(Hull, holds_all_points_and_its_corners_are_extreme) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const std::size_t n : {1, 2, 3, 4, 5, 7, 10, 14}) {
      for (const PointSet& points : unweighted_families(dimension, n, n)) expect_hull(points);
    }
    for (const PointSet& points : unweighted_families(dimension, dimension < 4 ? 40 : 20, 2)) expect_hull(points);
  }
}

TEST(Hull, in_high_dimensions) {
  for (const PointSet& points : {uniform(5, 11, 1), lattice(5, 11, 3, 2), cospherical(5, 11, 3), uniform(7, 11, 4)}) {
    expect_hull(points);
  }
}

TEST(Hull, does_not_depend_on_the_order_of_insertion) {
  for (int dimension = 2; dimension <= 4; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 80, 4)) {
      const ConvexHull one = convex_hull(points.view(), {.seed = 1});
      const ConvexHull other = convex_hull(points.view(), {.seed = 2});
      EXPECT_EQ(one.facets.vertices, other.facets.vertices) << points;
      EXPECT_EQ(one.faces.vertices, other.faces.vertices) << points;
      EXPECT_EQ(one.faces.offsets, other.faces.offsets) << points;
    }
  }
}

TEST(Hull, of_a_grid_is_a_cube) {
  PointSet grid{"grid", 3, {}, {}};
  for (int i = 0; i < 125; ++i) {
    for (const int x : {i % 5, i / 5 % 5, i / 25}) grid.coordinates.push_back(x);
  }
  const ConvexHull hull = convex_hull(grid.view());
  EXPECT_EQ(hull.corners, (std::vector<Index>{0, 4, 20, 24, 100, 104, 120, 124}));
  EXPECT_EQ(hull.facets.size(), 12U);
  EXPECT_EQ(hull.faces.size(), 6U);
  EXPECT_EQ(hull.faces[0].size(), 4U);
  EXPECT_NEAR(hull.volume, 64, 1e-12);
  EXPECT_NEAR(hull.area, 96, 1e-12);
}

TEST(Hull, of_a_square_runs_counter_clockwise) {
  const std::vector<double> square{0, 0, 0, 2, 2, 2, 2, 0, 1, 1, 1, 0, 2, 2};
  const ConvexHull hull = convex_hull(PointsView(square, 2));
  EXPECT_EQ(hull.corners, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(hull.facets.vertices, (std::vector<Index>{1, 0, 0, 3, 2, 1, 3, 2}));
  EXPECT_NEAR(hull.volume, 4, 1e-15);
  EXPECT_NEAR(hull.area, 8, 1e-15);
}

TEST(Hull, of_few_points) {
  const std::vector<double> line{3, 3, 1, 1, 2, 2, 1, 1};
  const ConvexHull hull = convex_hull(PointsView(line, 2));
  EXPECT_EQ(hull.affine_dimension, 1);
  EXPECT_EQ(hull.corners, (std::vector<Index>{0, 1}));
  EXPECT_NEAR(hull.volume, std::sqrt(8.0), 1e-15);
  EXPECT_EQ(convex_hull(PointsView({}, 3)).affine_dimension, -1);
  EXPECT_EQ(convex_hull(PointsView(std::span(line).first(2), 2)).corners, (std::vector<Index>{0}));
}

}  // namespace
}  // namespace delone
