#include "io/polygon.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace delone::io {
namespace {

using Point = std::array<double, 2>;

std::vector<Index> boundary(const std::vector<double>& coordinates) {
  std::vector<Index> rows(coordinates.size() / 2);
  std::iota(rows.begin(), rows.end(), Index{0});
  std::vector<Index> result;
  append_polygon(coordinates, rows, result);
  return result;
}

TEST(Turn, is_exact_for_every_double) {
  EXPECT_EQ(turn(Point{0, 0}, Point{1, 0}, Point{0.5, 1}), 1);
  EXPECT_EQ(turn(Point{0, 0}, Point{0.5, 1}, Point{1, 0}), -1);
  EXPECT_EQ(turn(Point{0, 0}, Point{3, 1}, Point{6, 2}), 0);
  EXPECT_EQ(turn(Point{0, 0}, Point{1e-300, 1e-300}, Point{1e300, std::nextafter(1e300, 2e300)}), 1);
  EXPECT_EQ(turn(Point{0x1p-1074, 0}, Point{0, 0x1p-1074}, Point{0x1p-1073, -0x1p-1074}), 0);
  EXPECT_EQ(turn(Point{-1.7e308, -1.7e308}, Point{0, 0}, Point{1.7e308, 1.7e308}), 0);
  EXPECT_EQ(turn(Point{0.1, 0.1}, Point{0.2, 0.2}, Point{0.3, std::nextafter(0.3, 1)}), 1);
}

TEST(Polygon, begins_at_the_smallest_point_and_goes_counter_clockwise) {
  EXPECT_EQ(boundary({1, 1, 0, 1, 1, 0, 0, 0}), (std::vector<Index>{3, 2, 0, 1}));
}

TEST(Polygon, keeps_points_within_edges_and_leaves_out_those_inside) {
  EXPECT_EQ(boundary({0, 0, 2, 0, 2, 2, 0, 2, 1, 1, 1, 0, 2, 1, 1, 2, 0, 1}),
            (std::vector<Index>{0, 5, 1, 6, 2, 7, 3, 8}));
}

TEST(Polygon, is_appended_to_what_is_there) {
  std::vector<Index> result{7, 8};
  const std::vector<double> coordinates{0, 0, 1, 0, 0, 1};
  append_polygon(coordinates, std::array<Index, 3>{0, 1, 2}, result);
  EXPECT_EQ(result, (std::vector<Index>{7, 8, 0, 1, 2}));
}

}  // namespace
}  // namespace delone::io
