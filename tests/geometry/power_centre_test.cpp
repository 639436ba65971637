#include "delone/geometry/power_centre.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delone/mesh/export.hpp"
#include "exact/integer.hpp"
#include "exact/quotient.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using exact::BigInt;

/// A rational number, compared exactly.
struct Exact {
  BigInt top, bottom;

  explicit Exact(const Rational& x) : top(x.numerator), bottom(x.denominator) {}
  explicit Exact(double x) {
    const exact::Scaled s = exact::decompose(x);
    top = BigInt(s.mantissa) << std::max(s.exponent, 0);
    bottom = BigInt(1) << std::max(-s.exponent, 0);
  }
  Exact(BigInt t, BigInt b) : top(std::move(t)), bottom(std::move(b)) {}
  friend Exact operator-(const Exact& a, const Exact& b) {
    return {a.top * b.bottom - b.top * a.bottom, a.bottom * b.bottom};
  }
  friend Exact operator+(const Exact& a, const Exact& b) {
    return {a.top * b.bottom + b.top * a.bottom, a.bottom * b.bottom};
  }
  friend Exact operator*(const Exact& a, const Exact& b) { return {a.top * b.top, a.bottom * b.bottom}; }
  friend bool operator==(const Exact& a, const Exact& b) { return a.top * b.bottom == b.top * a.bottom; }
  friend bool operator<=(const Exact& a, const Exact& b) { return a.top * b.bottom <= b.top * a.bottom; }
};

Exact size(const Exact& a) { return a.top < 0 ? Exact(-a.top, a.bottom) : a; }

bool is_nearest(double x, const Exact& truth) {
  const Exact error = size(Exact(x) - truth);
  return error <= size(Exact(std::nextafter(x, -INFINITY)) - truth) &&
         error <= size(Exact(std::nextafter(x, INFINITY)) - truth);
}

std::vector<VertexId> corners(const AnyTriangulation& t, CellId c) {
  std::vector<VertexId> v;
  for (int i = 0; i < t.complex().corners(); ++i) v.push_back(t.complex().vertex(c, i));
  return v;
}

Exact power(const std::vector<Rational>& centre, const Sites& sites, VertexId v) {
  Exact sum(-sites.weight(v));
  for (int axis = 0; axis < sites.dimension(); ++axis) {
    const Exact d = Exact(centre[static_cast<std::size_t>(axis)]) - Exact(sites.coordinate(v, axis));
    sum = sum + d * d;
  }
  return sum;
}

TEST(NearestDouble, rounds_quotients_once) {
  EXPECT_EQ(exact::nearest_double(BigInt(1), BigInt(3), 0), 1.0 / 3.0);
  EXPECT_EQ(exact::nearest_double(BigInt(-2), BigInt(3), 5), -64.0 / 3.0);
  EXPECT_EQ(exact::nearest_double((BigInt(1) << 53) + 1, BigInt(1), 0), 0x1p53);      // halfway, to even
  EXPECT_EQ(exact::nearest_double((BigInt(1) << 54) + 3, BigInt(2), 0), 0x1p53 + 2);  // above halfway
  EXPECT_EQ(exact::nearest_double((BigInt(1) << 53) + 3, BigInt(1), 0), 0x1p53 + 4);  // halfway, to even
  EXPECT_EQ(exact::nearest_double(BigInt(1), BigInt(1), -1074), 5e-324);
  EXPECT_EQ(exact::nearest_double(BigInt(1), BigInt(2), -1074), 0.0);  // halfway, to even
  EXPECT_EQ(exact::nearest_double(BigInt(3), BigInt(4), -1074), 5e-324);
  EXPECT_EQ(exact::nearest_double(BigInt(1), BigInt(1), 1024), INFINITY);
  EXPECT_EQ(exact::nearest_double(BigInt(0), BigInt(7), 0), 0.0);
}

TEST(PowerCentre, exact_one_has_equal_power_to_all_corners_and_doubles_are_nearest_to_it) {
  for (int d = 1; d <= 4; ++d) {
    for (const auto& points : test::families(d, 9, 3)) {
      const AnyTriangulation t = test::built(points);
      std::vector<CellId> few = cell_ids(t);
      few.resize(std::min<std::size_t>(few.size(), 3));
      for (const CellId c : few) {
        const std::vector<VertexId> v = corners(t, c);
        const std::vector<Rational> centre = exact_power_centre(t.sites(), v);
        for (const VertexId corner : v)
          EXPECT_EQ(power(centre, t.sites(), corner), power(centre, t.sites(), v[0])) << points;
        const Vector rounded = power_centre(t.sites(), v);
        const Vector offset = power_centre_offset(t.sites(), v);
        for (int axis = 0; axis < d; ++axis) {
          const auto a = static_cast<std::size_t>(axis);
          EXPECT_TRUE(is_nearest(rounded[a], Exact(centre[a]))) << points << rounded[a];
          EXPECT_TRUE(is_nearest(offset[a], Exact(centre[a]) - Exact(t.sites().coordinate(v[0], axis)))) << points;
        }
      }
    }
  }
}

TEST(PowerCentre, of_nearly_flat_simplices_far_from_the_origin_is_the_nearest_double) {
  test::Random random(5);
  for (int d = 2; d <= 4; ++d) {
    for (int round = 0; round < 60; ++round) {
      test::PointSet points{"thin", d, {}};
      for (int i = 0; i <= d; ++i) {
        for (int axis = 0; axis < d; ++axis) {
          const double thin = axis == d - 1 ? std::ldexp(1.0, -10 - round % 30) : 1.0;
          points.coordinates.push_back(std::ldexp(1.0, round % 40) + thin * test::unit_random(random));
        }
      }
      const AnyTriangulation t = test::built(points);
      if (t.affine_dimension() < d) continue;
      const std::vector<VertexId> v = corners(t, cell_ids(t)[0]);
      const std::vector<Rational> centre = exact_power_centre(t.sites(), v);
      const Vector rounded = power_centre(t.sites(), v);
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(d); ++axis)
        EXPECT_TRUE(is_nearest(rounded[axis], Exact(centre[axis]))) << points;
    }
  }
}

TEST(PowerCentre, of_a_right_triangle_is_the_middle_of_its_longest_side) {
  const test::PointSet points{"right", 2, {0, 0, 2, 0, 0, 1}};
  const AnyTriangulation t = test::built(points);
  const std::vector<VertexId> v = corners(t, cell_ids(t)[0]);
  EXPECT_EQ(power_centre(t.sites(), v), (Vector{1, 0.5}));
  EXPECT_EQ(exact_power_centre(t.sites(), v), (std::vector<Rational>{{"1", "1"}, {"1", "2"}}));
}

TEST(OutwardNormal, is_orthogonal_to_the_facet_and_leads_away_from_the_apex) {
  const test::PointSet points{"corner", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 3}};
  const AnyTriangulation t = test::built(points);
  const auto v = [&](Index row) { return t.vertex(row); };
  EXPECT_EQ(outward_normal(t.sites(), std::vector{v(0), v(1), v(2)}, v(3)), (Vector{0, 0, -1}));
  EXPECT_EQ(outward_normal(t.sites(), std::vector{v(1), v(2), v(3)}, v(0)), (Vector{1, 1, 1.0 / 3}));
}

TEST(OrthogonalDirections, complete_a_flat) {
  const test::PointSet points{"plane", 3, {0, 0, 0, 1, 0, 1, 0, 1, 0, 3, 2, 3}};  // z = x
  const AnyTriangulation t = test::built(points);
  ASSERT_EQ(t.affine_dimension(), 2);
  const std::vector<Vector> directions = orthogonal_directions(t.sites(), corners(t, cell_ids(t)[0]));
  ASSERT_EQ(directions.size(), 1U);
  EXPECT_EQ(directions[0], (Vector{-1, 0, 1}));
}

}  // namespace
}  // namespace delone
