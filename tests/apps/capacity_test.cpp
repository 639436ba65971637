#include "delone/apps/capacity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "delone/build/build.hpp"
#include "delone/dual/clip.hpp"
#include "support/brute_cells.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const Ring kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Region unit_box(int dimension) {
  const std::vector<double> low(static_cast<std::size_t>(dimension), 0.0);
  const std::vector<double> high(static_cast<std::size_t>(dimension), 1.0);
  return Region::box(low, high);
}

Region angle_with_hole() {
  return Region::polygon({{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {{0.25, 0.25}, {0.75, 0.25}, {0.5, 0.75}}});
}

std::vector<double> random_capacities(std::size_t n, double sum, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> wanted(n);
  for (double& v : wanted) v = 0.05 + unit_random(random);
  const double scale = sum / std::reduce(wanted.begin(), wanted.end());
  for (double& v : wanted) v *= scale;
  return wanted;
}

/// The point set, stretched and moved.
PointSet placed(PointSet points, double scale, double shift) {
  for (double& x : points.coordinates) x = shift + scale * x;
  return points;
}

CellMeasures cells_of(const PointSet& points, const std::vector<double>& weights, const Region& region) {
  return measure_cells(build(PointsView(points.coordinates, points.dimension, weights)), region);
}

void expect_fit(const PointSet& points, const Region& region, const std::vector<double>& wanted) {
  const Capacities fit = fit_capacities(points.view(), region, wanted);
  EXPECT_TRUE(fit.converged) << fit.steps << " steps, error " << fit.error << "\n" << points;
  EXPECT_NEAR(std::reduce(fit.weights.begin(), fit.weights.end()), 0, 1e-9 * std::abs(fit.weights[0]) + 1e-12);
  EXPECT_EQ(fit.measures, cells_of(points, fit.weights, region).volume);
  const double mean = region.measure() / static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(fit.measures[i], wanted[i], 2e-9 * mean) << points;
}

TEST(Capacity, two_sites_share_a_square_where_they_should) {
  const std::vector<double> sites{0.25, 0.5, 0.75, 0.5};
  const Capacities fit = fit_capacities(PointsView(sites, 2), unit_box(2), std::vector{0.3, 0.7});
  EXPECT_TRUE(fit.converged);
  // The bisector is at (0.25 + 0.75) / 2 + (w0 - w1) / (2 * 0.5) = 0.3.
  EXPECT_NEAR(fit.weights[0], -0.1, 1e-12);
  EXPECT_NEAR(fit.weights[1], 0.1, 1e-12);
  EXPECT_NEAR(fit.measures[0], 0.3, 1e-12);
}

TEST(Capacity, a_single_site_takes_all) {
  const std::vector<double> site{-3, 12};
  const Capacities fit = fit_capacities(PointsView(site, 2), unit_box(2), std::vector{1.0});
  EXPECT_TRUE(fit.converged);
  EXPECT_EQ(fit.steps, 0);
  EXPECT_EQ(fit.weights, std::vector{0.0});
}

TEST(Capacity, equal_shares_of_a_grid_have_equal_weights) {
  std::vector<double> grid;
  for (int i = 0; i < 64; ++i) grid.insert(grid.end(), {(i % 4 + 0.5) / 4, (i / 4 % 4 + 0.5) / 4, (i / 16 + 0.5) / 4});
  const Capacities fit = fit_capacities(PointsView(grid, 3), unit_box(3), std::vector(64, 1.0 / 64));
  EXPECT_TRUE(fit.converged);
  EXPECT_EQ(fit.steps, 0);
  for (const double w : fit.weights) EXPECT_NEAR(w, 0, 1e-15);
}

TEST(Capacity, areas_that_were_measured_have_the_weights_they_were_measured_with) {
  const PointSet points = uniform(2, 60, 1);
  Random random(2);
  std::vector<double> weights(60);
  for (double& w : weights) w = 0.004 * unit_random(random);
  const double mean = std::reduce(weights.begin(), weights.end()) / 60;
  const std::vector<double> areas = cells_of(points, weights, unit_box(2)).volume;
  ASSERT_GT(*std::ranges::min_element(areas), 0);
  const Capacities fit = fit_capacities(points.view(), unit_box(2), areas, {.tolerance = 1e-12});
  EXPECT_TRUE(fit.converged);
  for (std::size_t i = 0; i < 60; ++i) EXPECT_NEAR(fit.weights[i], weights[i] - mean, 1e-10);
}

TEST(Capacity, fitted_cells_measured_by_brute_force_have_the_wanted_areas) {
  for (const std::size_t n : {3, 20, 100}) {
    const PointSet points = uniform(2, n, n);
    const std::vector<double> wanted = random_capacities(n, 1, n);
    const Capacities fit = fit_capacities(points.view(), unit_box(2), wanted);
    EXPECT_TRUE(fit.converged);
    const PointsView weighted(points.coordinates, 2, fit.weights);
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(area(brute_cell(weighted, i, kSquare)), wanted[i], 2e-9);
  }
}

TEST(Capacity, sites_may_lie_anywhere) {
  for (const int dimension : {2, 3}) {
    const std::vector<double> wanted = random_capacities(40, 1, 9);
    PointSet mixed = uniform(dimension, 40, 1);
    for (std::size_t i = 0; i < mixed.coordinates.size() / 2; ++i)
      mixed.coordinates[i] = 0.3 + 1e-5 * mixed.coordinates[i];
    for (const PointSet& points :
         {uniform(dimension, 40, 2), placed(uniform(dimension, 40, 3), 1, 10),
          placed(uniform(dimension, 40, 4), 1e-6, 0.9), placed(uniform(dimension, 40, 5), 20, -10), mixed}) {
      expect_fit(points, unit_box(dimension), wanted);
    }
  }
}

TEST(Capacity, degenerate_sites_are_served) {
  const auto lattice_of = [](int dimension, int side) {
    PointSet points{"lattice", dimension, {}, {}};
    for (int i = 0; i < std::pow(side, dimension); ++i) {
      for (int axis = 0, rest = i; axis < dimension; ++axis, rest /= side) points.coordinates.push_back(rest % side);
    }
    return points;
  };
  const PointSet line{"line", 2, {0, 0, 1, 2, 2, 4, 3, 6, 10, 20}, {}};
  const PointSet circle{"circle", 2, {1, 2, 2, 1, 2, -1, 1, -2, -1, -2, -2, -1, -2, 1, -1, 2}, {}};
  for (const PointSet& points : {lattice_of(2, 5), line, circle, lattice_of(3, 3), lattice_of(3, 2)}) {
    expect_fit(points, unit_box(points.dimension), random_capacities(points.size(), 1, 4));
  }
}

TEST(Capacity, capacities_of_very_different_size_are_served) {
  std::vector<double> wanted(50);
  for (std::size_t i = 0; i < 50; ++i) wanted[i] = std::pow(0.75, static_cast<double>(i));
  const double sum = std::reduce(wanted.begin(), wanted.end());
  for (double& v : wanted) v /= sum;
  expect_fit(uniform(2, 50, 1), unit_box(2), wanted);
}

TEST(Capacity, regions_of_other_shapes) {
  const Region simplex = Region::half_spaces(3, {{{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, 0}, {{1, 1, 1}, 1}});
  expect_fit(uniform(3, 30, 1), simplex, random_capacities(30, simplex.measure(), 1));
  const Region angle = angle_with_hole();
  for (const std::size_t n : {2, 5, 60}) {
    expect_fit(placed(uniform(2, n, 2), 3, 0), angle, random_capacities(n, angle.measure(), n));
    expect_fit(placed(uniform(2, n, 2), 1, -5), angle, random_capacities(n, angle.measure(), n));
  }
}

TEST(Capacity, pieces_that_are_full_for_themselves_are_served) {
  const Region pair = Region::polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{10, 0}, {12, 0}, {12, 1}, {10, 1}}});
  PointSet points = uniform(2, 20, 3);
  for (std::size_t i = 20; i < 40; i += 2) points.coordinates[i] = 10 + 2 * points.coordinates[i];
  std::vector<double> wanted = random_capacities(10, 1, 1);
  for (const double v : random_capacities(10, 2, 2)) wanted.push_back(v);
  expect_fit(points, pair, wanted);
}

TEST(Capacity, alternating_with_centroids_lowers_the_cost_of_transport) {
  PointSet points = placed(uniform(2, 30, 1), 3, 0);
  const Region region = angle_with_hole();
  const std::vector<double> wanted = random_capacities(30, region.measure(), 1);
  double last = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 6; ++round) {
    const Capacities fit = fit_capacities(points.view(), region, wanted);
    ASSERT_TRUE(fit.converged);
    const CellMeasures cells = cells_of(points, fit.weights, region);
    const double cost = std::reduce(cells.second_moment.begin(), cells.second_moment.end());
    EXPECT_LE(cost, last * (1 + 1e-8));
    last = cost;
    points.coordinates = cells.centroid;
  }
}

TEST(Capacity, the_cost_of_transport_is_that_of_no_other_weights) {
  // Kantorovich: for any weights, sum of w_i v_i + integral of the least power is at most the cost, and equal when fit.
  const PointSet points = uniform(3, 25, 1);
  const std::vector<double> wanted = random_capacities(25, 1, 1);
  const auto dual = [&](const std::vector<double>& weights) {
    const CellMeasures cells = cells_of(points, weights, unit_box(3));
    double sum = 0;
    for (std::size_t i = 0; i < 25; ++i) sum += cells.second_moment[i] + weights[i] * (wanted[i] - cells.volume[i]);
    return sum;
  };
  const Capacities fit = fit_capacities(points.view(), unit_box(3), wanted);
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    std::vector<double> other = fit.weights;
    for (double& w : other) w += 0.01 * (unit_random(random) - 0.5);
    EXPECT_LT(dual(other), dual(fit.weights));
  }
}

TEST(Capacity, too_few_steps_are_not_an_error) {
  const PointSet points = uniform(2, 100, 1);
  const std::vector<double> wanted = random_capacities(100, 1, 1);
  const Capacities none = fit_capacities(points.view(), unit_box(2), wanted, {.steps = 0});
  const Capacities one = fit_capacities(points.view(), unit_box(2), wanted, {.steps = 1});
  const Capacities all = fit_capacities(points.view(), unit_box(2), wanted);
  EXPECT_FALSE(none.converged || one.converged);
  EXPECT_EQ(one.steps, 1);
  EXPECT_LT(one.error, none.error);
  EXPECT_TRUE(all.converged);
  EXPECT_LE(all.steps, 10);
  EXPECT_EQ(one.measures, cells_of(points, one.weights, unit_box(2)).volume);
}

TEST(Capacity, a_tolerance_that_rounding_does_not_allow_ends) {
  const Capacities fit =
      fit_capacities(uniform(2, 50, 1).view(), unit_box(2), random_capacities(50, 1, 1), {.tolerance = 0});
  EXPECT_LE(fit.error, 1e-12);
  EXPECT_LT(fit.steps, 20);
}

TEST(Capacity, what_doubles_cannot_do_does_not_converge) {
  const std::vector<double> sites{0.5, 0.5, 0.5 + 0x1p-52, 0.5, 1e6, 0.5};
  const Capacities fit = fit_capacities(PointsView(sites, 2), unit_box(2), std::vector{0.3, 0.3, 0.4});
  EXPECT_FALSE(fit.converged);
  EXPECT_GT(fit.error, 1e-3);
}

TEST(Capacity, pieces_that_no_cell_connects_do_not_converge) {
  const Region pair = Region::polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{10, 0}, {11, 0}, {11, 1}, {10, 1}}});
  const std::vector<double> sites{0.5, 0.5, 10.5, 0.5};
  const Capacities fit = fit_capacities(PointsView(sites, 2), pair, std::vector{0.5, 1.5});
  EXPECT_FALSE(fit.converged);
  EXPECT_NEAR(fit.error, 0.5, 1e-12);
}

TEST(Capacity, scales_with_its_input) {
  const std::vector<double> low{0, 0};
  for (const double scale : {0x1p-60, 0x1p60}) {
    const Region square = Region::box(low, std::vector{scale, scale});
    PointSet points = uniform(2, 30, 1);
    std::vector<double> wanted = random_capacities(30, 1, 1);
    const Capacities one = fit_capacities(points.view(), unit_box(2), wanted);
    for (double& v : wanted) v *= scale * scale;
    const Capacities other = fit_capacities(placed(points, scale, 0).view(), square, wanted);
    EXPECT_TRUE(other.converged);
    for (std::size_t i = 0; i < 30; ++i) EXPECT_NEAR(other.weights[i] / (scale * scale), one.weights[i], 1e-9);
  }
}

TEST(Capacity, threads_change_nothing) {
  const PointSet points = uniform(2, 2000, 1);
  const std::vector<double> wanted = random_capacities(2000, 1, 1);
  EXPECT_EQ(fit_capacities(points.view(), unit_box(2), wanted, {.steps = 2}).weights,
            fit_capacities(points.view(), unit_box(2), wanted, {.steps = 2, .threads = 3}).weights);
}

TEST(Capacity, tells_of_progress_and_can_be_cancelled) {
  const PointSet points = uniform(2, 100, 1);
  const std::vector<double> wanted = random_capacities(100, 1, 1);
  std::vector<double> told;
  const auto tell = [&](double done) {
    told.push_back(done);
    return true;
  };
  fit_capacities(points.view(), unit_box(2), wanted, {.progress = tell});
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_EQ(told.front(), 0);
  EXPECT_GT(told.back(), 0.2);
  EXPECT_LE(told.back(), 1);
  for (std::size_t calls = 1; calls <= told.size(); ++calls) {
    std::size_t left = calls;
    const auto stop = [&](double) { return --left > 0; };
    EXPECT_THROW(fit_capacities(points.view(), unit_box(2), wanted, {.progress = stop}), Cancelled) << calls;
  }
}

TEST(Capacity, refuses_bad_input) {
  const auto refuses = [](PointsView sites, const std::vector<double>& wanted, const CapacityOptions& options,
                          const std::string& why) {
    EXPECT_THAT([&] { fit_capacities(sites, unit_box(2), wanted, options); },
                ThrowsMessage<InputError>(HasSubstr(why)));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> three{0.5, 0.5, 0.25, 0.5, -0.0, 0.5};
  const std::vector<double> equal{0.5, 0.0, 0.25, 0.5, 0.5, -0.0};
  const std::vector<double> bad{0.5, 0.5, 0.25, nan, 0, 0};
  const std::vector<double> huge{1e200, 0, 0, 0};
  const PointsView sites(three, 2);
  refuses(sites, {0.5, 0.5}, {}, "2 capacities for 3 sites");
  refuses(sites, {0.5, 0.5, 0}, {}, "row 2: capacity is not positive");
  refuses(sites, {0.5, -0.5, 1}, {}, "row 1: capacity is not positive");
  refuses(sites, {0.5, nan, 1}, {}, "row 1: capacity is not positive");
  refuses(sites, {0.5, 0.5, 0.25}, {}, "capacities sum to 1.25, but the region measures 1");
  refuses(sites, {0.5, 0.5, std::numeric_limits<double>::infinity()}, {}, "sum to inf");
  refuses(sites, {0.3, 0.3, 0.4 + 2e-6}, {}, "sum to 1.000002");
  refuses(PointsView({}, 2), {}, {}, "sum to 0");
  refuses(PointsView(equal, 2), {0.5, 0.25, 0.25}, {}, "rows 0 and 2 are one place");
  refuses(PointsView(bad, 2), {0.5, 0.25, 0.25}, {}, "row 1, column 1");
  refuses(PointsView(three, 2, std::span(three).first(3)), {0.5, 0.25, 0.25}, {}, "no weights");
  refuses(PointsView(three, 3), {0.5, 0.5}, {}, "dimension 3");
  refuses(PointsView(huge, 2), {0.5, 0.5}, {}, "weight is not finite");
  refuses(sites, {0.5, 0.25, 0.25}, {.tolerance = nan}, "tolerance");
  refuses(sites, {0.5, 0.25, 0.25}, {.steps = -1}, "-1 steps");
}

TEST(Capacity, shares_out_what_is_missing_in_proportion) {
  const std::vector<double> sites{0.25, 0.5, 0.75, 0.5};
  const Capacities fit = fit_capacities(PointsView(sites, 2), unit_box(2), std::vector{0.5, 0.5 + 5e-7});
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.measures[1] / fit.measures[0], 1 + 1e-6, 1e-9);
}

}  // namespace
}  // namespace delone
