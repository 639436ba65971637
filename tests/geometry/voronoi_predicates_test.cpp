#include "delone/geometry/voronoi_predicates.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "support/families.hpp"

namespace delone {
namespace {

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

Rational dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
Rational cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Rational squared_length(const Vector& a) { return dot(a, a); }

int true_nearer(Point2 q, Point2 a, Point2 b) {
  const Rational more = squared_length(Vector(q) - Vector(b)) - squared_length(Vector(q) - Vector(a));
  return more.sign();
}

/// By the centre of the circle itself: c - o solves 2 (c - o) . k = |k|^2 for both neighbours.
int true_side_of_ray(Point2 o, Point2 a, Point2 b, Heading d) {
  const Vector oa = Vector(a) - Vector(o);
  const Vector ob = Vector(b) - Vector(o);
  const Rational twice = 2 * cross(oa, ob);
  const Vector centre{(squared_length(oa) * ob.y - squared_length(ob) * oa.y) / twice,
                      (squared_length(ob) * oa.x - squared_length(oa) * ob.x) / twice};
  return cross(centre, Vector(d.to) - Vector(d.from)).sign();
}

bool turn_left(Point2 o, Point2 a, Point2 b) { return cross(Vector(a) - Vector(o), Vector(b) - Vector(o)) > 0; }

std::vector<Point2> points_of(const test::PointSet& set) {
  std::vector<Point2> points;
  for (std::size_t row = 0; row < set.size(); ++row) points.push_back({set.view()[row][0], set.view()[row][1]});
  return points;
}

/// Calls f(o, a, b, q) with points of every family.
template <class F>
void for_each_four(const F& f) {
  for (const test::PointSet& set : test::unweighted_families(2, 24, 5)) {
    const std::vector<Point2> points = points_of(set);
    Random random(8);
    const auto pick = [&] { return points[random() % points.size()]; };
    for (int trial = 0; trial < 60; ++trial) f(pick(), pick(), pick(), pick());
  }
}

Heading reversed(Heading d) { return {d.to, d.from}; }

TEST(VoronoiPredicates, nearer_has_the_sign_of_rationals_and_its_symmetry) {
  for_each_four([](Point2 q, Point2 a, Point2 b, Point2) {
    const int truth = true_nearer(q, a, b);
    EXPECT_EQ(nearer(q, a, b), truth);
    EXPECT_EQ(nearer(q, b, a), -truth);
    EXPECT_EQ(voronoi::slow_nearer(q, a, b).sign, truth);
  });
}

TEST(VoronoiPredicates, side_of_ray_has_the_sign_of_rationals_and_its_symmetries) {
  int compared = 0;
  for_each_four([&](Point2 o, Point2 a, Point2 b, Point2 q) {
    const Heading d{o, q};
    const int sign = side_of_ray(o, a, b, d);
    EXPECT_EQ(side_of_ray(o, b, a, d), -sign);
    EXPECT_EQ(side_of_ray(o, a, b, reversed(d)), -sign);
    if (!turn_left(o, a, b)) return;
    ++compared;
    EXPECT_EQ(sign, true_side_of_ray(o, a, b, d));
    EXPECT_EQ(voronoi::slow_side_of_ray(o, a, b, d).sign, sign);
    const Heading east{{0, 0}, {1, 0}};
    EXPECT_EQ(side_of_ray(o, a, b, east), true_side_of_ray(o, a, b, east));
  });
  EXPECT_GT(compared, 200);
}

TEST(VoronoiPredicates, same_way_has_the_sign_of_rationals_and_its_symmetries) {
  for_each_four([](Point2 o, Point2 a, Point2 b, Point2 q) {
    const int truth = dot(Vector(a) - Vector(o), Vector(q) - Vector(b)).sign();
    EXPECT_EQ(same_way({o, a}, {b, q}), truth);
    EXPECT_EQ(same_way({b, q}, {o, a}), truth);
    EXPECT_EQ(same_way({a, o}, {b, q}), -truth);
    EXPECT_EQ(voronoi::slow_same_way({o, a}, {b, q}).sign, truth);
  });
}

/// A site at infinity is the limit of sites far away.
TEST(VoronoiPredicates, a_neighbour_at_infinity_is_the_limit_of_far_neighbours) {
  const Point2 o{0, 0};
  const Point2 b{3, 1};
  for (const Point2 q : {Point2{5, -2}, Point2{-1, 4}, Point2{-2, -7}, Point2{1, -2}}) {
    EXPECT_EQ(same_way({o, b}, {o, q}), side_of_ray(o, {1e9, -1e9}, b, {o, q}));
    EXPECT_EQ(-same_way({o, b}, {o, q}), side_of_ray(o, b, {1e9, 1e9}, {o, q}));
  }
}

void expect_nearer(Point2 q, Point2 a, Point2 b, int sign, Stage stage) {
  const int filtered = voronoi::filtered_nearer(q, a, b);
  EXPECT_EQ(filtered, stage == Stage::filter ? sign : filter::kUnsure);
  const SlowSign slow = voronoi::slow_nearer(q, a, b);
  EXPECT_EQ(slow.sign, sign);
  EXPECT_TRUE(stage == Stage::filter || stage == slow.stage);
}

TEST(VoronoiPredicates, nearer_decides_at_the_expected_stage) {
  expect_nearer({0.25, 0}, {0, 0}, {1, 0}, +1, Stage::filter);
  expect_nearer({1e200, 7}, {0, 0}, {1, 0}, -1, Stage::filter);  // the squares overflow, their difference does not
  expect_nearer({1, 0}, {0, 1}, {0, -1}, 0, Stage::adaptive);
  expect_nearer({0x1p70, 0x1p-10}, {0, 1}, {0, -1}, +1, Stage::filter);
  expect_nearer({0.5, 0}, {0, 0}, {1 + 0x1p-52, 0}, +1, Stage::adaptive);
  expect_nearer({0.1, 0.3}, {0.2, 0.1}, {0.1, 0.2}, -1, Stage::filter);
  expect_nearer({0x1p60, 0}, {0, 1}, {0, -1}, 0, Stage::exact);
  expect_nearer({0x1p-500, 0}, {0, 0}, {0x1p-480, 0}, +1, Stage::adaptive);  // the bound would underflow
  expect_nearer({kDenormal, 0}, {0, 0}, {2 * kDenormal, 0}, 0, Stage::adaptive);
  expect_nearer({0, 0}, {kDenormal, 0}, {0, 2 * kDenormal}, +1, Stage::adaptive);
  expect_nearer({kLargest, 0}, {-kLargest, 1}, {-kLargest, 0}, -1, Stage::exact);
}

void expect_same_way(Heading a, Heading b, int sign, Stage stage) {
  EXPECT_EQ(voronoi::filtered_same_way(a, b), stage == Stage::filter ? sign : filter::kUnsure);
  const SlowSign slow = voronoi::slow_same_way(a, b);
  EXPECT_EQ(slow.sign, sign);
  EXPECT_TRUE(stage == Stage::filter || stage == slow.stage);
}

TEST(VoronoiPredicates, same_way_decides_at_the_expected_stage) {
  const Point2 o{0, 0};
  expect_same_way({o, {1, 1}}, {{5, 5}, {6, 7}}, +1, Stage::filter);
  expect_same_way({o, {1, 1}}, {o, {1, -1}}, 0, Stage::adaptive);
  expect_same_way({o, {1, 1}}, {o, {1, -1 - 0x1p-52}}, -1, Stage::adaptive);
  expect_same_way({o, {0x1p-500, 0}}, {o, {0x1p-500, 0}}, +1, Stage::adaptive);
  expect_same_way({{-kLargest, 0}, {kLargest, 1}}, {o, {-1, 0}}, -1, Stage::exact);
}

void expect_side(Point2 o, Point2 a, Point2 b, Point2 q, int sign, Stage stage) {
  const int filtered = voronoi::filtered_side_of_ray(o, a, b, {o, q});
  EXPECT_EQ(filtered, stage == Stage::filter ? sign : filter::kUnsure);
  const SlowSign slow = voronoi::slow_side_of_ray(o, a, b, {o, q});
  EXPECT_EQ(slow.sign, sign);
  EXPECT_TRUE(stage == Stage::filter || stage == slow.stage);
}

TEST(VoronoiPredicates, side_of_ray_decides_at_the_expected_stage) {
  const Point2 o{0, 0};
  expect_side(o, {1, 0}, {0, 1}, {1, 2}, +1, Stage::filter);
  expect_side(o, {1, 0}, {0, 1}, {2, 1}, -1, Stage::filter);
  expect_side(o, {1, 0}, {0, 1}, {3, 3}, 0, Stage::adaptive);
  expect_side(o, {1, 0}, {0, 1}, {-3, -3}, 0, Stage::adaptive);  // straight against the ray
  expect_side(o, {1, 0}, {0, 1}, o, 0, Stage::adaptive);
  expect_side(o, {1, 0}, {0, 1}, {1 + 0x1p-52, 1}, -1, Stage::exact);
  expect_side(o, {1e100, 0}, {0, 1e100}, {1, 2}, +1, Stage::exact);  // beyond the range where the bound holds
  expect_side(o, {1e-100, 0}, {0, 1e-100}, {1, 2}, +1, Stage::exact);
  expect_side(o, {kLargest, 0}, {0, kLargest}, {kDenormal, 2 * kDenormal}, +1, Stage::exact);
  expect_side({-kLargest, 0}, {kLargest, 0}, {0, kLargest}, {0, 1}, +1, Stage::exact);
}

}  // namespace
}  // namespace delone
