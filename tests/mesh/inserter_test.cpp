#include "delone/mesh/inserter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "delone/build/insert.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// Distinct points close to a sphere about the origin, with few bits.
PointSet shell(int dimension, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  PointSet points{"shell", dimension, {}, {}};
  while (points.size() < n) {
    std::vector<double> x;
    double square = 0.0;
    for (int axis = 0; axis < dimension; ++axis) {
      x.push_back(unit_random(random) - 0.5);
      square += x.back() * x.back();
    }
    if (square > 0.25 || square < 0.01) continue;
    for (const double value : x) points.coordinates.push_back(std::nearbyint(value / std::sqrt(square) * 0x1p20));
  }
  return points;
}

/// One insertion that removes nearly everything: its star meets every vertex.
TEST(Inserter, a_star_may_be_as_large_as_the_whole) {
  for (int dimension = 2; dimension <= 5; ++dimension) {
    for (const std::size_t n : {20U, 47U, 48U, 49U, 60U, 400U}) {
      if (dimension > 3 && n > 60) continue;
      PointSet points = shell(dimension, n, n);
      AnyTriangulation t = built(points);
      const std::vector<double> centre(static_cast<std::size_t>(dimension), 0.0);
      insert(t, centre);
      points.coordinates.insert(points.coordinates.end(), centre.begin(), centre.end());
      EXPECT_EQ(broken_invariant(t), "");
      EXPECT_EQ(fails_check(t, points), "") << dimension << ' ' << n;
      EXPECT_GT(t.star(t.vertex(static_cast<Index>(n))).size(), n / 2);
    }
  }
}

TEST(Inserter, a_point_far_outside_sees_half_of_the_hull) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    PointSet points = shell(dimension, dimension < 4 ? 200 : 30, 1);
    AnyTriangulation t = built(points);
    for (const double far : {0x1p30, -0x1p60, 0x1p200, -0x1p900}) {
      std::vector<double> q(static_cast<std::size_t>(dimension), 1.0);
      q.back() = far;
      insert(t, q);
      points.coordinates.insert(points.coordinates.end(), q.begin(), q.end());
    }
    EXPECT_EQ(description(t), description(built(points))) << dimension;
    EXPECT_EQ(broken_invariant(t), "");
  }
}

TEST(Inserter, a_heavy_point_hides_the_vertices_around_it) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    PointSet points = shell(dimension, 40, 2);
    points.weights.assign(points.size(), 0.0);
    const PointSet inside = uniform(dimension, 30, 3);
    points.coordinates.insert(points.coordinates.end(), inside.coordinates.begin(), inside.coordinates.end());
    points.weights.resize(points.size(), 0.0);
    AnyTriangulation t = built(points);
    EXPECT_EQ(t.hidden_count(), 0U);
    const std::vector<double> centre(static_cast<std::size_t>(dimension), 0.5);
    insert(t, centre, 0x1p30);
    EXPECT_EQ(t.hidden_count(), 30U);
    points.coordinates.insert(points.coordinates.end(), centre.begin(), centre.end());
    points.weights.push_back(0x1p30);
    EXPECT_EQ(description(t), description(built(points)));
    EXPECT_EQ(fails_check(t, points), "");
  }
}

TEST(Inserter, of_dimension_zero_keeps_the_heaviest) {
  AnyTriangulation t(2, true);
  const std::vector<double> place{0.1, 0.2};
  for (const double weight : {1.0, 3.0, 2.0, 3.0}) insert(t, place, weight);
  EXPECT_EQ(t.affine_dimension(), 0);
  EXPECT_EQ(t.status(1), (RowStatus{Status::vertex, 1}));
  EXPECT_EQ(t.status(3), (RowStatus{Status::duplicate, 1}));
  EXPECT_EQ(t.hidden_count(), 2U);
  EXPECT_EQ(broken_invariant(t), "");
}

}  // namespace
}  // namespace delone
