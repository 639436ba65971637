#include "delone/order/brio.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

std::vector<int> all_axes(int dimension) {
  std::vector<int> axes(static_cast<std::size_t>(dimension));
  std::iota(axes.begin(), axes.end(), 0);
  return axes;
}

bool is_permutation_of_rows(Buffer<Index> order, std::size_t n) {
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] != i) return false;
  }
  return order.size() == n;
}

TEST(Brio, is_a_permutation_of_every_family) {
  for (int dimension = 1; dimension <= 8; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 300, 1)) {
      EXPECT_TRUE(is_permutation_of_rows(brio_order(points.view(), all_axes(dimension)), points.size())) << points.name;
    }
  }
}

TEST(Brio, is_a_permutation_when_the_extent_is_beyond_double) {
  PointSet points = uniform(3, 20000, 1);
  for (double& x : points.coordinates) x = (x - 0.5) * 2 * std::numeric_limits<double>::max();
  EXPECT_TRUE(is_permutation_of_rows(brio_order(points.view(), all_axes(3)), points.size()));
}

TEST(Brio, is_a_permutation_when_points_crowd_deeper_and_deeper) {
  PointSet points{"crowd", 2, {}, {}};
  for (int i = 0; i < 20000; ++i) {  // each scale holds some hundred points
    const double scale = std::ldexp(1.0, -5 * (i % 200));
    points.coordinates.insert(points.coordinates.end(), {scale * (1 + i % 7), scale * (1 + i % 11)});
  }
  EXPECT_TRUE(is_permutation_of_rows(brio_order(points.view(), all_axes(2)), points.size()));
  points.coordinates.assign(40000, 0.25);
  EXPECT_TRUE(is_permutation_of_rows(brio_order(points.view(), all_axes(2)), 20000));
}

TEST(Brio, few_points_and_none_are_ordered_too) {
  EXPECT_TRUE(brio_order(PointsView({}, 2), all_axes(2)).empty());
  EXPECT_TRUE(is_permutation_of_rows(brio_order(uniform(2, 1, 1).view(), all_axes(2)), 1));
  EXPECT_TRUE(is_permutation_of_rows(brio_order(uniform(2, 3, 1).view(), {}), 3));
}

/// Mean distance between points that follow each other, over that of neighbours on a grid of as many points.
double roughness(const PointSet& points, std::span<const Index> order) {
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    double square = 0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(points.dimension); ++axis) {
      const double d = points.view()[order[i]][axis] - points.view()[order[i - 1]][axis];
      square += d * d;
    }
    length += std::sqrt(square);
  }
  const auto n = static_cast<double>(order.size());
  return length / n * std::pow(n, 1.0 / points.dimension);
}

TEST(Brio, points_that_follow_each_other_are_close) {
  for (int dimension = 2; dimension <= 4; ++dimension) {
    const PointSet points = uniform(dimension, 30000, 7);
    EXPECT_LT(roughness(points, brio_order(points.view(), all_axes(dimension))), 2.0) << dimension;
  }
}

TEST(Brio, a_crowd_is_ordered_as_finely_as_everything_else) {
  PointSet points = uniform(2, 20000, 3);  // all but one in a cell of the first grid
  points.coordinates.insert(points.coordinates.end(), {1e9, 1e9});
  Buffer<Index> order = brio_order(points.view(), all_axes(2));
  order.resize(static_cast<std::size_t>(std::ranges::remove(order, Index{20000}).begin() - order.begin()));
  EXPECT_LT(roughness(points, order), 2.0);
}

TEST(CurveOrder, is_a_permutation_and_visits_near_points_one_after_the_other) {
  for (int dimension = 1; dimension <= 8; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 300, 1)) {
      EXPECT_TRUE(is_permutation_of_rows(curve_order(points.view(), all_axes(dimension)), points.size()))
          << points.name;
    }
  }
  // A lattice of 64 x 64: each step of Hilbert's curve leads to the next point of it. In rounds it could not.
  PointSet lattice{"lattice", 2, {}};
  for (int x = 0; x < 64; ++x) {
    for (int y = 0; y < 64; ++y) lattice.coordinates.insert(lattice.coordinates.end(), {double(x), double(y)});
  }
  const Buffer<Index> order = curve_order(lattice.view(), all_axes(2));
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto a = lattice.view()[order[i - 1]];
    const auto b = lattice.view()[order[i]];
    EXPECT_EQ(std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]), 1.0);
  }
}

/// Whether each cut parts what lies before it from what lies behind, on some axis, down to single places; of the cuts
/// among some rows in a line one is the least deep.
bool parts_everything(PointsView points, const CurveCuts& cuts, std::size_t begin, std::size_t end) {
  if (end - begin < 2) return true;
  std::size_t middle = begin + 1;
  for (std::size_t i = begin + 1; i < end; ++i) middle = cuts.cut[i] < cuts.cut[middle] ? i : middle;
  const auto least_deep = std::count(cuts.cut.begin() + begin + 1, cuts.cut.begin() + end, cuts.cut[middle]);
  if (least_deep > 1 && cuts.cut[middle] != CurveCuts::kSamePlace) return false;
  const auto coordinate = [&](std::size_t i, std::size_t axis) { return points[cuts.order[i]][axis]; };
  bool parted = false;
  bool one_place = true;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(points.dimension()); ++axis) {
    std::array<std::array<double, 2>, 2> range;  // of each side the lowest and the highest
    for (auto& side : range) side = {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (std::size_t i = begin; i < end; ++i) {
      auto& [low, high] = range[i < middle ? 0 : 1];
      low = std::min(low, coordinate(i, axis));
      high = std::max(high, coordinate(i, axis));
    }
    parted |= range[0][1] < range[1][0] || range[1][1] < range[0][0];
    one_place &= range[0] == range[1] && range[0][0] == range[0][1];
  }
  if (cuts.cut[middle] == CurveCuts::kSamePlace) return one_place;
  return parted && parts_everything(points, cuts, begin, middle) && parts_everything(points, cuts, middle, end);
}

TEST(CurveCuts, each_parts_the_rows_around_it_across_an_axis) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 700, 1)) {
      const CurveCuts cuts = curve_cuts(points.view(), all_axes(dimension));
      EXPECT_TRUE(is_permutation_of_rows(cuts.order, points.size())) << points.name;
      EXPECT_TRUE(parts_everything(points.view(), cuts, 0, points.size())) << points.name;
    }
  }
}

TEST(CurveCuts, of_few_rows_too) {
  for (int dimension = 1; dimension <= 8; ++dimension) {
    for (std::size_t n = 2; n <= 12; ++n) {
      for (const PointSet& points : unweighted_families(dimension, n, n)) {
        const CurveCuts cuts = curve_cuts(points.view(), all_axes(dimension));
        EXPECT_TRUE(is_permutation_of_rows(cuts.order, points.size())) << points;
        EXPECT_TRUE(parts_everything(points.view(), cuts, 0, points.size())) << points;
      }
    }
  }
}

/// On a diagonal, up to a dozen rows each that the first grid does not tell apart; zeros of both signs among them.
TEST(CurveCuts, crowds_of_every_size_are_parted) {
  PointSet points{"crowds", 2, {}, {}};
  Random random(4);
  for (int crowd = 0; crowd < 200; ++crowd) {
    for (int i = 0; i < crowd % 13; ++i) {
      const double x = crowd + std::ldexp(unit_random(random), -20 - crowd % 7);
      points.coordinates.insert(points.coordinates.end(), {x, i % 3 == 0 ? x : crowd + 0.0});
    }
  }
  for (const double x : {0.0, -0.0, 0.0, -0.0, 1e-20}) points.coordinates.insert(points.coordinates.end(), {x, -x});
  const CurveCuts cuts = curve_cuts(points.view(), all_axes(2));
  EXPECT_TRUE(is_permutation_of_rows(cuts.order, points.size()));
  EXPECT_TRUE(parts_everything(points.view(), cuts, 0, points.size()));
  Buffer<Index> order = brio_order(points.view(), all_axes(2));
  EXPECT_TRUE(is_permutation_of_rows(order, points.size()));
}

TEST(StripCuts, part_everything_in_any_dimension) {
  for (int dimension = 1; dimension <= 8; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 200, 2)) {
      EXPECT_TRUE(parts_everything(points.view(), strip_cuts(points.view(), all_axes(dimension)), 0, points.size()))
          << points.name;
    }
  }
}

TEST(StripCuts, part_rows_in_lexicographic_order_of_any_axes) {
  for (const std::size_t n : {2, 5, 9, 80, 3000}) {
    for (const PointSet& points : unweighted_families(2, n, 3)) {
      for (const std::vector<int>& axes : {std::vector{0, 1}, std::vector{1, 0}}) {
        const CurveCuts cuts = strip_cuts(points.view(), axes);
        EXPECT_TRUE(is_permutation_of_rows(cuts.order, points.size())) << points;
        EXPECT_TRUE(parts_everything(points.view(), cuts, 0, points.size())) << points;
        const auto place = [&](Index row) {
          const auto p = points.view()[row];
          return std::array{p[static_cast<std::size_t>(axes[0])], p[static_cast<std::size_t>(axes[1])]};
        };
        EXPECT_TRUE(std::ranges::is_sorted(cuts.order, {}, place)) << points;
      }
    }
  }
}

TEST(CurveCuts, the_smallest_numbers_beside_the_largest_are_parted) {
  const PointSet points{"ends", 2, {0, 0, 5e-324, 0, 0, 5e-324, 1.7e308, 1.7e308, -1.7e308, 1}, {}};
  EXPECT_TRUE(parts_everything(points.view(), curve_cuts(points.view(), all_axes(2)), 0, points.size()));
}

TEST(CurveCuts, threads_do_not_show) {
  PointSet curve{"few in a cell of the grid", 2, {100, 100}, {}};
  Random random(5);
  for (int i = 0; i < 100000; ++i) {
    const double x = unit_random(random);
    curve.coordinates.insert(curve.coordinates.end(), {x, x * x});
  }
  for (const PointSet& points : {lattice(2, 300000, 1000, 1), curve}) {
    for (const auto& cut : {curve_cuts, strip_cuts}) {
      const CurveCuts one = cut(points.view(), all_axes(2), 1);
      const CurveCuts many = cut(points.view(), all_axes(2), 3);
      EXPECT_TRUE(std::ranges::equal(one.order, many.order));
      EXPECT_TRUE(std::ranges::equal(std::ranges::subrange(one.cut.begin() + 1, one.cut.end()),
                                     std::ranges::subrange(many.cut.begin() + 1, many.cut.end())));
      EXPECT_TRUE(parts_everything(points.view(), one, 0, points.size())) << points.name;
    }
  }
}

}  // namespace
}  // namespace delone
