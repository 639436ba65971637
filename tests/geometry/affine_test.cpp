#include "delone/geometry/affine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "support/brute_force.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;
using ::testing::ElementsAre;

TEST(AffineHull, dimension_agrees_with_brute_force_on_every_family) {
  for (int dimension = 1; dimension <= 6; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 5, 1)) {
      EXPECT_EQ(affine_dimension(points.view()), brute_force(points.view()).affine_dimension) << points;
    }
    for (int rank = 1; rank <= dimension; ++rank) {
      EXPECT_LE(affine_dimension(flat(dimension, rank, 30, 1).view()), rank);
    }
  }
}

TEST(AffineHull, axes_are_the_first_that_stay_independent) {
  const std::vector<double> wall{5, 1, 1, 5, 2, 7, 5, 3, 2, 5, 2, 2};  // x is constant
  const AffineHull hull = affine_hull(PointsView(wall, 3));
  EXPECT_EQ(hull.flat.dimension, 2);
  EXPECT_EQ(hull.flat.axes[0], 1);
  EXPECT_EQ(hull.flat.axes[1], 2);
  const std::vector<double> ramp{0, 0, 0, 1, 2, 3, 2, 4, 6, 1, 2, 4};  // y = 2x
  const AffineHull steep = affine_hull(PointsView(ramp, 3));
  EXPECT_EQ(steep.flat.dimension, 2);
  EXPECT_EQ(steep.flat.axes[0], 0);
  EXPECT_EQ(steep.flat.axes[1], 2);
  EXPECT_THAT(std::vector<Index>(steep.basis.begin(), steep.basis.begin() + 3), ElementsAre(0, 1, 3));
}

TEST(AffineHull, does_not_depend_on_the_order_of_the_rows) {
  Random random(1);
  for (int dimension = 2; dimension <= 5; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 8, 3)) {
      const Flat expected = affine_hull(points.view()).flat;
      for (int trial = 0; trial < 5; ++trial) {
        EXPECT_EQ(affine_hull(permuted(points, random_permutation(points.size(), random)).view()).flat, expected);
      }
    }
  }
}

TEST(AffineHull, a_point_off_by_the_smallest_double_counts) {
  const std::vector<double> almost{0, 0, 1e300, 1e300, 5e-324, 0};
  EXPECT_EQ(affine_dimension(PointsView(almost, 2)), 2);
  const std::vector<double> exactly{0, 0, 1e300, 1e300, 5e-324, 5e-324};
  EXPECT_EQ(affine_dimension(PointsView(exactly, 2)), 1);
}

TEST(AffineHull, of_nothing_is_less_than_a_point) {
  EXPECT_EQ(affine_dimension(PointsView({}, 4)), -1);
  const std::vector<double> x{1, 2, 1, 2};
  EXPECT_EQ(affine_dimension(PointsView(x, 2)), 0);
}

}  // namespace
}  // namespace delone
