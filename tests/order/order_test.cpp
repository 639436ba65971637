#include "delone/order/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "delone/base/errors.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

std::vector<int> axes_of(const PointSet& points) {
  std::vector<int> axes(static_cast<std::size_t>(points.dimension));
  std::iota(axes.begin(), axes.end(), 0);
  return axes;
}

TEST(Order, every_order_is_a_permutation) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 70, 1)) {
      for (const OrderInfo& order : orders()) {
        std::vector<Index> rows = ordered_rows(order.order, points.view(), axes_of(points));
        std::ranges::sort(rows);
        for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_EQ(rows[i], i) << order.name << "\n" << points;
      }
    }
  }
}

TEST(Order, random_order_follows_the_seed) {
  const PointSet points = uniform(2, 100, 1);
  const std::vector<int> axes = axes_of(points);
  EXPECT_EQ(ordered_rows(Order::random, points.view(), axes, 5), ordered_rows(Order::random, points.view(), axes, 5));
  EXPECT_NE(ordered_rows(Order::random, points.view(), axes, 5), ordered_rows(Order::random, points.view(), axes, 6));
}

TEST(Order, lexicographic_order_is_sorted) {
  const PointSet points = lattice(3, 200, 4, 1);
  const std::vector<Index> rows = ordered_rows(Order::lexicographic, points.view(), axes_of(points));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_FALSE(std::ranges::lexicographical_compare(points.view()[rows[i]], points.view()[rows[i - 1]]));
  }
}

// A cell of the grid has two points, so from one to the next it is hardly ever further than some cells.
TEST(Order, buckets_are_walked_there_and_back) {
  const PointSet points = uniform(2, 20000, 1);
  const std::vector<Index> rows = ordered_rows(Order::bucket, points.view(), axes_of(points));
  const double cell = 1 / std::floor(std::sqrt(10000.0));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto a = points.view()[rows[i - 1]];
    const auto b = points.view()[rows[i]];
    ASSERT_LT(std::hypot(a[0] - b[0], a[1] - b[1]), 16 * cell) << i;
  }
}

// 4 x 4 x 4 cells with two points each: rows and layers are joined end to end.
TEST(Order, buckets_touch_the_one_before_in_space_too) {
  PointSet points{"cells", 3, {}, {}};
  for (int i = 0; i < 128; ++i) {
    for (const int x : {i / 2 % 4, i / 8 % 4, i / 32}) points.coordinates.push_back(x);
  }
  const std::vector<Index> rows = ordered_rows(Order::bucket, points.view(), axes_of(points));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto a = points.view()[rows[i - 1]];
    const auto b = points.view()[rows[i]];
    EXPECT_LE(std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]), 1.0) << i;
  }
}

// At any time the points so far are spread evenly: of the first 4^k no more than a few share one of 4^k boxes.
TEST(Order, quaternary_order_fills_boxes_evenly) {
  const PointSet points = uniform(2, 20000, 1);
  const std::vector<Index> rows = ordered_rows(Order::quaternary, points.view(), axes_of(points));
  for (const std::size_t side : {4U, 8U, 16U}) {
    std::vector<int> in_box(side * side);
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto p = points.view()[rows[i]];
      const auto box = [&](double x) {
        return std::min(static_cast<std::size_t>(x * static_cast<double>(side)), side - 1);
      };
      ++in_box[box(p[0]) * side + box(p[1])];
    }
    EXPECT_LE(*std::ranges::max_element(in_box), 4) << side;
  }
}

TEST(Order, an_unknown_name_is_refused_naming_those_that_exist) { EXPECT_THROW(order_named("magic"), InputError); }

}  // namespace
}  // namespace delone
