#include "delone/lab/dimensions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace delone::lab {
namespace {

TEST(Dimensions, constants_are_those_of_the_paper) {
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(poisson_cells(1), 1, 1e-12);
  EXPECT_NEAR(poisson_cells(2), 2, 1e-12);
  EXPECT_NEAR(poisson_cells(3), 24 * pi * pi / 35, 1e-12);
  EXPECT_NEAR(poisson_degree(2), 6, 0);
  EXPECT_NEAR(poisson_degree(3), 15.54, 0.005);  // [For92] 2.3
  for (const int d : {6, 7, 8, 9, 10}) EXPECT_NEAR(estimated_cells(d) / poisson_cells(d), 1, 0.01) << d;
  EXPECT_TRUE(std::isnan(poisson_degree(5)));
}

// [For92] 2.3.
TEST(Dimensions, inner_sites_have_the_cells_and_neighbours_of_a_poisson_process) {
  const auto counts = run_dimensions({.sizes = {{2, {4000}, 3}, {3, {4000}, 3}, {4, {2000}, 4}, {5, {400}, 12}}});
  for (const DimensionCount& c : counts) {
    const double tolerance = c.dimension < 4 ? 0.01 : c.dimension == 4 ? 0.05 : 0.15;
    EXPECT_NEAR(c.inner_cells.mean / poisson_cells(c.dimension), 1, tolerance) << c.dimension;
    if (c.dimension > 4) continue;
    EXPECT_NEAR(c.inner_degree.mean / poisson_degree(c.dimension), 1, tolerance) << c.dimension;
  }
}

TEST(Dimensions, the_border_costs_cells_the_fewer_the_more_sites_there_are) {
  for (const int d : {2, 3, 4}) {
    const auto counts = run_dimensions({.sizes = {{d, {100, 1600}, 3}}});
    EXPECT_LT(counts[0].cells_in_ball.mean, counts[1].cells_in_ball.mean);
    EXPECT_LT(counts[0].cells_in_cube.mean, counts[1].cells_in_cube.mean);
    EXPECT_LT(counts[1].cells_in_ball.mean, poisson_cells(d));
    EXPECT_LT(counts[1].cells_in_cube.mean, poisson_cells(d));
  }
}

// Euler: e = 3 v - 3 - h edges and 2 v - 2 - h triangles with h sites on the hull.
TEST(Dimensions, counts_of_the_plane_obey_euler) {
  const auto counts = run_dimensions({.sizes = {{2, {500}, 1}}});
  const double n = 500, triangles = counts[0].cells_in_ball.mean * n, edges = counts[0].degree.mean * n / 2;
  EXPECT_NEAR(edges - triangles, n - 1, 1e-6);
}

}  // namespace
}  // namespace delone::lab
