// Heights that doubles are sure of are so, and they are sure of most; floats find the right apex nearly always.
#include "geometry/sixteen_in_plane.hpp"

#include <gtest/gtest.h>

#ifdef DELONE_SIXTEENS

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/topology/complex.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using sixteen::InPlane;
using test::PointSet;
using test::Random;
using test::unit_random;

Sites sites_of(const PointSet& points) {
  Sites sites(2, false, Flat{2, {0, 1}});
  std::vector<Index> order;
  for (Index row = 0; row < points.size(); ++row) order.push_back(row);
  sites.append(points.view(), order, 0);
  return sites;
}

struct Count {
  std::size_t sure = 0, all = 0, wrong = 0;

  /// A number that says that something is so, or the opposite, if it is large enough.
  void add(double number, bool is_so, bool is_opposite) {
    ++all;
    if (std::abs(number) > InPlane::kBound) ++sure;
    if (number > InPlane::kBound ? !is_so : number < -InPlane::kBound && !is_opposite) ++wrong;
  }
};

DELONE_BY_SIXTEENS Count count_of(const Sites& sites) {
  const InPlane sixteen(sites);
  Kernel<2> kernel(sites);
  Count count;
  const auto n = static_cast<Index>(sites.size());
  if (!sixteen.usable()) return count;
  for (Index a = 0; a < n; ++a) {
    for (Index b = 0; b < n; ++b) {
      for (Index c = 0; c < n; ++c) {
        if (a == b || b == c || c == a) continue;
        const Kernel<2>::Cell cell{VertexId{a}, VertexId{b}, VertexId{c}};
        const InPlane::Plane plane = sixteen.plane(a, b, c);
        const int side = kernel.exact_orient(cell);
        count.add(InPlane::orientation(plane), side > 0, side < 0);
        count.add(sixteen.height(sixteen.wall(a, b), c), side<0, side> 0);
        if (side <= 0) continue;
        for (Index v = 0; v < n; ++v) {
          if (v == a || v == b || v == c) continue;
          const bool below = kernel.conflict(cell, VertexId{v});
          count.add(sixteen.height(plane, v), !below, below);
        }
        if (InPlane::orientation(plane) > InPlane::kBound) count.add(sixteen.height(plane, n), true, false);
      }
    }
  }
  return count;
}

/// Returns the share of what is sure.
double expect_right(const PointSet& points) {
  if (!sixteen::possible()) return 1.0;
  const Count count = count_of(sites_of(points));
  EXPECT_EQ(count.wrong, 0U) << points;
  return static_cast<double>(count.sure) / static_cast<double>(count.all);
}

/// Most sites close to a line or a circle, as close to each other as doubles allow or not: there rounding matters most.
PointSet near_a_curve(Random& random, bool line) {
  PointSet points{"near a curve", 2, {}, {}};
  const double jitter = std::pow(10.0, -16.0 * unit_random(random));
  for (int i = 0; i < 14; ++i) {
    const double along = 7 * unit_random(random);
    const double place[] = {line ? 0.9 * along : std::cos(along), line ? -0.4 * along : std::sin(along)};
    for (const double x : place) {
      points.coordinates.push_back(i < 4 ? unit_random(random) : x + jitter * (unit_random(random) - 0.5));
    }
  }
  return points;
}

TEST(SixteenInPlane, what_is_sure_is_so) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    PointSet points = near_a_curve(random, i % 2 == 0);
    EXPECT_TRUE(InPlane(sites_of(points)).usable());
    expect_right(points);
    for (double& x : points.coordinates) x += 1000.0 * static_cast<double>(i);
    expect_right(points);
  }
}

/// One axis has two numbers, side by side, and the other one numbers as close to each other or closer: the middle is
/// one of the two.
TEST(SixteenInPlane, numbers_side_by_side) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    PointSet points{"side by side", 2, {}, {}};
    const double odd = i % 2 == 0 ? 1.0 : 1.0 + 0x1p-52;
    for (int j = 0; j < 8; ++j) {
      const double x = j % 2 == 0 ? odd : std::nextafter(odd, 2.0), y = std::ldexp(unit_random(random), -52 - i / 6);
      points.coordinates.insert(points.coordinates.end(), {i % 4 < 2 ? x : y, i % 4 < 2 ? y : x});
    }
    EXPECT_TRUE(InPlane(sites_of(points)).usable());
    expect_right(points);
  }
}

TEST(SixteenInPlane, sites_at_one_place_are_not_usable) {
  EXPECT_FALSE(InPlane(sites_of({"", 2, {1, 2, 1, 2, 1, 2}, {}})).usable());
  EXPECT_FALSE(InPlane(sites_of({"", 2, {0, 0, 0, 0x1p-1010, 0x1p-1010, 0}, {}})).usable());
  EXPECT_TRUE(InPlane(sites_of({"", 2, {0, 0, 0, 1, 1, 0}, {}})).usable());
}

TEST(SixteenInPlane, every_family) {
  for (const PointSet& points : test::unweighted_families(2, 12, 5)) {
    if (affine_dimension(points.view()) == 2) expect_right(points);
  }
}

TEST(SixteenInPlane, uniform_sites_leave_little_open) { EXPECT_GT(expect_right(test::uniform(2, 20, 1)), 0.999); }

/// How many facets of the triangulation have another apex than searches find.
DELONE_BY_SIXTEENS std::size_t missed_apices(const Triangulation<2>& t) {
  const InPlane sixteen(t.sites());
  const ConstComplexView<2> complex(t.complex());
  std::size_t missed = 0;
  for (Index c = 0; c < complex.slot_count(); ++c) {
    const CellId cell{c};
    for (int i = 0; i < 3; ++i) {
      const VertexId apex = complex.vertex(cell, i), a = complex.vertex(cell, ComplexView<2>::turned(i, 1)),
                     b = complex.vertex(cell, ComplexView<2>::turned(i, 2));
      if (a == kGhost || b == kGhost) continue;
      const Index found = sixteen.apex(raw(a), raw(b));
      missed += found != (apex == kGhost ? sixteen::kNobody : raw(apex)) ? 1U : 0U;
    }
  }
  return missed;
}

TEST(SixteenInPlane, searches_find_the_apex) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  std::size_t missed = 0;
  for (const std::size_t n : {4U, 15U, 16U, 17U, 100U, 240U}) {
    missed += missed_apices(build<2>(test::uniform(2, n, n).view()));
  }
  EXPECT_LT(missed, 3U);  // of some 2,000
}

DELONE_BY_SIXTEENS bool has_tie(const PointSet& points) {
  const InPlane sixteen(sites_of(points));
  return sixteen.has_tie(sixteen.plane(0, 1, 2));
}

TEST(SixteenInPlane, ties_are_seen) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  PointSet points{"", 2, {0, 0, 1, 0, 0, 1, 3, 1, 2, 5}, {}};
  EXPECT_FALSE(has_tie(points));
  points.coordinates[6] = 1.0 + 1e-9;
  EXPECT_TRUE(has_tie(points));
  points.coordinates[6] = 0.5;  // within the circle
  EXPECT_TRUE(has_tie(points));
}

TEST(SixteenInPlane, the_nearest_site) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  const auto nearest = [](const PointSet& points, Index i) { return InPlane(sites_of(points)).nearest(i); };
  const PointSet points{"", 2, {0, 0, 1, 0, 0, 0.5, 3, 1, 3, 0}, {}};
  EXPECT_EQ(nearest(points, 0), 2U);
  EXPECT_EQ(nearest(points, 1), 0U);
  EXPECT_EQ(nearest(points, 3), 4U);
}

}  // namespace
}  // namespace delone

#endif
