#include "delone/geometry/sweep_predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "support/families.hpp"

namespace delone {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;
using test::Random;

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

struct Vector {
  Rational x, y;

  explicit Vector(Point2 p) : x(p[0]), y(p[1]) {}
  Vector(Rational a, Rational b) : x(std::move(a)), y(std::move(b)) {}
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
};

Rational cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Rational squared_length(const Vector& a) { return a.x * a.x + a.y * a.y; }
Rational area(const Circle& k) { return cross(Vector(k.b) - Vector(k.a), Vector(k.c) - Vector(k.a)); }

/// Centre and squared radius.
struct TrueCircle {
  Vector centre{0, 0};
  Rational square;

  explicit TrueCircle(const Circle& k) {
    const Vector a(k.a);
    const Vector b = Vector(k.b) - a;
    const Vector c = Vector(k.c) - a;
    const Rational twice = 2 * cross(b, c);
    const Vector m{(squared_length(b) * c.y - squared_length(c) * b.y) / twice,
                   (squared_length(c) * b.x - squared_length(b) * c.x) / twice};
    square = squared_length(m);
    centre = {a.x + m.x, a.y + m.y};
  }
};

/// A rational below sqrt(x) and nearer to it than 2^-bits.
Rational root_from_below(const Rational& x, unsigned bits) {
  const Integer scaled = (numerator(x) << (2 * bits)) / denominator(x);
  return Rational(sqrt(scaled), Integer(1) << bits);
}

/// The sign of p + sqrt(a) - sqrt(b) by ever closer roots; zero when they still agree to 4000 bits, which for the small
/// numbers here is further than a difference can hide.
int true_sign_with_roots(const Rational& p, const Rational& a, const Rational& b) {
  for (unsigned bits = 32; bits <= 4096; bits *= 2) {
    const Rational near = p + root_from_below(a, bits) - root_from_below(b, bits);
    const Rational error(2, Integer(1) << bits);
    if (near > error) return 1;
    if (near < -error) return -1;
  }
  return 0;
}

int true_compare_tops(const Circle& a, const Circle& b) {
  const TrueCircle k(a);
  const TrueCircle l(b);
  const int by_top = true_sign_with_roots(k.centre.y - l.centre.y, k.square, l.square);
  if (by_top != 0) return by_top;
  const int by_x = Rational(k.centre.x - l.centre.x).sign();
  return by_x != 0 ? by_x : Rational(k.square - l.square).sign();
}

int true_compare_top(const Circle& a, Point2 s) {
  const TrueCircle k(a);
  const int by_top = true_sign_with_roots(k.centre.y - Rational(s[1]), k.square, 0);
  return by_top != 0 ? by_top : (k.centre.x < Rational(s[0]) ? -1 : 1);
}

/// By radii of circles along a line whose tilt is tiny but no infinitesimal: for small integers it is small enough.
int true_touched_first(Point2 s, Point2 u, Point2 v) {
  const Rational tilt(1, 1'000'000'000);
  const auto radius = [&](Point2 p) {
    const Vector sp = Vector(s) - Vector(p);
    return Rational(squared_length(sp) / (sp.y + tilt * sp.x));
  };
  return Rational(radius(v) - radius(u)).sign();
}

std::vector<Point2> points_of(const test::PointSet& set) {
  std::vector<Point2> points;
  for (std::size_t row = 0; row < set.size(); ++row) points.push_back({set.view()[row][0], set.view()[row][1]});
  return points;
}

/// Sets on which roots of a few thousand bits settle everything.
std::vector<test::PointSet> moderate_sets() {
  std::vector<test::PointSet> sets{test::uniform(2, 30, 1), test::circle_of_24_bits(2, 30, 2)};
  for (int side = 2; side <= 6; ++side) sets.push_back(test::lattice(2, 30, side, 3));
  return sets;
}

/// Three random points, turned left if they turn at all.
Circle random_circle(const std::vector<Point2>& points, Random& random) {
  for (int trial = 0; trial < 100; ++trial) {
    Circle k{points[random() % points.size()], points[random() % points.size()], points[random() % points.size()]};
    const Rational twice = area(k);
    if (twice < 0) std::swap(k.a, k.b);
    if (twice != 0) return k;
  }
  return {{0, 0}, {1, 0}, {0, 1}};
}

/// The same circle, named by its points from another one on.
Circle turned(const Circle& k) { return {k.b, k.c, k.a}; }

TEST(SweepPredicates, touched_first_has_the_sign_of_rationals_and_its_symmetry) {
  int ties = 0;
  for (int side = 2; side <= 7; ++side) {
    const std::vector<Point2> points = points_of(test::lattice(2, 40, side, 1));
    Random random(7);
    for (int trial = 0; trial < 3000; ++trial) {
      std::array<Point2, 3> p;
      for (Point2& x : p) x = points[random() % points.size()];
      std::ranges::sort(p, passed_before);
      const auto& [u, v, s] = p;
      if (u == v || v == s) continue;
      const int truth = true_touched_first(s, u, v);
      ASSERT_NE(truth, 0);
      EXPECT_EQ(touched_first(s, u, v), truth);
      EXPECT_EQ(touched_first(s, v, u), -truth);
      EXPECT_EQ(sweep::slow_touched_first(s, u, v).sign, truth);
      ties += sweep::filtered_touched_first(s, u, v) == filter::kUnsure ? 1 : 0;
    }
  }
  EXPECT_GT(ties, 100);
}

TEST(SweepPredicates, filters_of_touched_first_agree_with_integers_on_every_family) {
  for (const test::PointSet& set : test::unweighted_families(2, 24, 5)) {
    const std::vector<Point2> points = points_of(set);
    Random random(8);
    for (int trial = 0; trial < 100; ++trial) {
      std::array<Point2, 3> p;
      for (Point2& x : p) x = points[random() % points.size()];
      std::ranges::sort(p, passed_before);
      const auto& [u, v, s] = p;
      if (v == s) continue;
      const int sign = touched_first(s, u, v);
      EXPECT_EQ(sign, sweep::slow_touched_first(s, u, v).sign);
      EXPECT_EQ(sign, -touched_first(s, v, u));
      EXPECT_EQ(sign == 0, u == v);
    }
  }
}

TEST(SweepPredicates, touched_first_decides_at_the_expected_stage) {
  const auto expect = [](Point2 s, Point2 u, Point2 v, int sign, Stage stage) {
    EXPECT_EQ(sweep::filtered_touched_first(s, u, v), stage == Stage::filter ? sign : filter::kUnsure);
    const SlowSign slow = sweep::slow_touched_first(s, u, v);
    EXPECT_EQ(slow.sign, sign);
    EXPECT_EQ(stage == Stage::filter ? stage : slow.stage, stage);
  };
  expect({0, 2}, {0, 0}, {3, 0}, +1, Stage::filter);
  expect({5, 1}, {0, 0}, {4, 1}, +1, Stage::filter);     // the interval of v has no width yet
  expect({2, 0}, {0, 0}, {1, 0}, -1, Stage::adaptive);   // nor have both: the nearer one
  expect({0, 1}, {-1, 0}, {1, 0}, +1, Stage::adaptive);  // on a breakpoint: the line rises to the left
  expect({0, 1 + 0x1p-52}, {-1, 0}, {1, 0}, +1, Stage::exact);
  expect({0, kLargest}, {-kLargest, 0}, {kLargest, 0}, +1, Stage::exact);
  expect({0, kLargest}, {-kLargest, kDenormal}, {kLargest, 0}, -1, Stage::exact);
  expect({0, kDenormal}, {-kDenormal, 0}, {2 * kDenormal, 0}, +1, Stage::adaptive);
}

TEST(SweepPredicates, breakpoints_part_the_line_as_intervals_lie) {
  const Point2 low{0, 0};
  const Point2 high{1, 3};
  for (int x = -20; x <= 20; ++x) {
    const Point2 s{static_cast<double>(x), 5};
    const bool in_high = true_touched_first(s, high, low) > 0;
    EXPECT_EQ(right_of_breakpoint(s, low, high), in_high || x > 1) << x;
    EXPECT_EQ(right_of_breakpoint(s, high, low), !in_high && x > 1) << x;
  }
  EXPECT_TRUE(right_of_breakpoint({3, 0}, {0, 0}, {1, 0}));
  EXPECT_FALSE(right_of_breakpoint({3, 0}, {1, 0}, {0, 0}));  // this one is far to the right
}

TEST(SweepPredicates, compare_tops_has_the_sign_of_close_roots_and_its_symmetries) {
  int ties = 0;
  for (const test::PointSet& set : moderate_sets()) {
    const std::vector<Point2> points = points_of(set);
    Random random(11);
    for (int trial = 0; trial < 150; ++trial) {
      const Circle a = random_circle(points, random);
      const Circle b = random_circle(points, random);
      const int truth = true_compare_tops(a, b);
      EXPECT_EQ(compare_tops(a, b), truth);
      EXPECT_EQ(compare_tops(b, a), -truth);
      EXPECT_EQ(compare_tops(turned(a), b), truth);
      EXPECT_EQ(sweep::slow_compare_tops(a, turned(b)).sign, truth);
      EXPECT_EQ(compare_tops(a, turned(a)), 0);
      ties += truth == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(ties, 20);
}

TEST(SweepPredicates, compare_top_has_the_sign_of_close_roots) {
  for (const test::PointSet& set : moderate_sets()) {
    const std::vector<Point2> points = points_of(set);
    Random random(12);
    for (int trial = 0; trial < 150; ++trial) {
      const Circle a = random_circle(points, random);
      const Point2 s = points[random() % points.size()];
      const int truth = true_compare_top(a, s);
      EXPECT_EQ(compare_top(a, s), truth);
      EXPECT_EQ(compare_top(turned(a), s), truth);
      EXPECT_EQ(sweep::slow_compare_top(a, s).sign, truth);
    }
  }
}

TEST(SweepPredicates, filters_of_tops_agree_with_integers_on_every_family) {
  for (const test::PointSet& set : test::unweighted_families(2, 24, 5)) {
    const std::vector<Point2> points = points_of(set);
    Random random(13);
    for (int trial = 0; trial < 40; ++trial) {
      const Circle a = random_circle(points, random);
      const Circle b = random_circle(points, random);
      const Point2 s = points[random() % points.size()];
      EXPECT_EQ(compare_tops(a, b), sweep::slow_compare_tops(a, b).sign);
      EXPECT_EQ(compare_tops(b, a), -compare_tops(a, b));
      EXPECT_EQ(compare_tops(a, turned(a)), 0);
      EXPECT_EQ(compare_top(a, s), sweep::slow_compare_top(a, s).sign);
    }
  }
}

Circle scaled(const Circle& k, double by) {
  const auto times = [by](Point2 p) { return Point2{by * p[0], by * p[1]}; };
  return {times(k.a), times(k.b), times(k.c)};
}

/// Far out only integers decide: they must say what is known of the same figures near 1.
TEST(SweepPredicates, powers_of_two_change_nothing) {
  for (const test::PointSet& set : moderate_sets()) {
    const std::vector<Point2> points = points_of(set);
    Random random(15);
    for (int trial = 0; trial < 60; ++trial) {
      const Circle a = random_circle(points, random);
      const Circle b = random_circle(points, random);
      const Point2 s = points[random() % points.size()];
      for (const double by : {0x1p900, 0x1p300, 0x1p-300, 0x1p-900}) {
        EXPECT_EQ(compare_tops(scaled(a, by), scaled(b, by)), true_compare_tops(a, b));
        EXPECT_EQ(compare_top(scaled(a, by), {by * s[0], by * s[1]}), true_compare_top(a, s));
      }
    }
  }
}

/// All that a rough top says is true: the top lies within the error.
TEST(SweepPredicates, rough_tops_keep_their_bounds) {
  for (const test::PointSet& set : moderate_sets()) {
    const std::vector<Point2> points = points_of(set);
    Random random(14);
    for (int trial = 0; trial < 100; ++trial) {
      const Circle a = random_circle(points, random);
      const RoughTop top = rough_top(a);
      if (!std::isfinite(top.error)) continue;
      const TrueCircle k(a);
      EXPECT_GT(true_sign_with_roots(k.centre.y - Rational(top.y) + Rational(top.error), k.square, 0), 0);
      EXPECT_LT(true_sign_with_roots(k.centre.y - Rational(top.y) - Rational(top.error), k.square, 0), 0);
    }
  }
}

void expect_tops(const Circle& a, const Circle& b, int sign, Stage stage) {
  EXPECT_EQ(sweep::filtered_compare_tops(rough_top(a), rough_top(b)), stage == Stage::filter ? sign : filter::kUnsure);
  for (const auto& [slow, truth] :
       {std::pair{sweep::slow_compare_tops(a, b), sign}, std::pair{sweep::slow_compare_tops(b, a), -sign}}) {
    EXPECT_EQ(slow.sign, truth);
    EXPECT_EQ(stage == Stage::filter ? stage : slow.stage, stage);
  }
}

/// Centre (x, y), radius 5 times the scale.
Circle circle_of_radius_five(double x, double y, double scale = 1.0) {
  return {{x + 3 * scale, y - 4 * scale}, {x + 5 * scale, y}, {x - 4 * scale, y - 3 * scale}};
}

TEST(SweepPredicates, compare_tops_decides_at_the_expected_stage) {
  const Circle unit{{-1, 0}, {0, -1}, {1, 0}};
  expect_tops(unit, {{-2, 0}, {0, -2}, {2, 0}}, -1, Stage::filter);
  expect_tops(unit, {{0, 1}, {-1, 0}, {1, 0}}, 0, Stage::adaptive);
  expect_tops(unit, {{2, 0}, {3, -1}, {4, 0}}, -1, Stage::adaptive);   // equal tops, left to right
  expect_tops(unit, {{0, -3}, {2, -1}, {0, 1}}, -1, Stage::adaptive);  // they touch there
  expect_tops(circle_of_radius_five(0, 0), circle_of_radius_five(0, -5, 2), -1, Stage::exact);
  expect_tops(circle_of_radius_five(7, 0), circle_of_radius_five(0, -5, 2), +1, Stage::exact);
  expect_tops(circle_of_radius_five(0, 0), circle_of_radius_five(0, 0x1p-20), -1, Stage::filter);
  expect_tops(circle_of_radius_five(0, 0), circle_of_radius_five(-1, 0x1p-48), -1, Stage::adaptive);
  expect_tops(circle_of_radius_five(0, 0), circle_of_radius_five(0x1p-48, 0), -1, Stage::exact);
  expect_tops(unit, {{-1, 0}, {0, -1 - 0x1p-52}, {1, 0}}, +1, Stage::adaptive);
  expect_tops({{-1e300, 0}, {0, -1e300}, {1e300, 0}}, {{-2e300, 0}, {0, -2e300}, {2e300, 0}}, -1, Stage::exact);
  expect_tops({{-1e300, 0}, {0, -1e300}, {1e300, 0}}, {{0, 1e300}, {-1e300, 0}, {1e300, 0}}, 0, Stage::exact);
  expect_tops({{-kLargest, 0}, {0, -kDenormal}, {kLargest, 0}}, {{-kLargest, 0}, {0, -kLargest}, {kLargest, 0}}, +1,
              Stage::exact);
  expect_tops({{-kDenormal, 0}, {0, -kDenormal}, {kDenormal, 0}}, {{0, 0}, {kDenormal, -kDenormal}, {2 * kDenormal, 0}},
              -1, Stage::adaptive);
}

TEST(SweepPredicates, compare_top_decides_at_the_expected_stage) {
  const Circle unit{{-1, 0}, {0, -1}, {1, 0}};
  const auto expect = [](const Circle& a, Point2 s, int sign, Stage stage) {
    EXPECT_EQ(sweep::filtered_compare_top(rough_top(a), s), stage == Stage::filter ? sign : filter::kUnsure);
    const SlowSign slow = sweep::slow_compare_top(a, s);
    EXPECT_EQ(slow.sign, sign);
    EXPECT_EQ(stage == Stage::filter ? stage : slow.stage, stage);
  };
  expect(unit, {7, 0.5}, +1, Stage::filter);
  expect(unit, {7, 1.5}, -1, Stage::filter);
  expect(unit, {0, 1}, +1, Stage::adaptive);  // the topmost point itself comes first
  expect(unit, {-1, 1}, +1, Stage::adaptive);
  expect(unit, {1, 1}, -1, Stage::adaptive);
  expect(unit, {0, 1 + 0x1p-52}, -1, Stage::exact);
  expect({{-1e300, 0}, {0, -1e300}, {1e300, 0}}, {1e300, 1e300}, -1, Stage::exact);
  expect({{-1e300, 0}, {0, -1e300}, {1e300, 0}}, {0.5, 1e300}, -1, Stage::exact);
  expect({{-kDenormal, 0}, {0, -kDenormal}, {kDenormal, 0}}, {0, kDenormal}, +1, Stage::adaptive);
  expect({{-kDenormal, 0}, {0, -kDenormal}, {kDenormal, 0}}, {0, 2 * kDenormal}, -1, Stage::adaptive);
}

}  // namespace
}  // namespace delone
