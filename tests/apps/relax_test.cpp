#include "delone/apps/relax.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/brute_cells.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Region box(int dimension, double side) {
  const std::vector<double> low(static_cast<std::size_t>(dimension), 0.0);
  const std::vector<double> high(static_cast<std::size_t>(dimension), side);
  return Region::box(low, high);
}

Region angle_with_hole() {
  return Region::polygon({{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {{0.25, 0.25}, {0.75, 0.25}, {0.5, 0.75}}});
}

TEST(Relax, one_site_moves_to_the_centroid_and_stays) {
  const std::vector<double> site{7, 7};
  const Region angle = Region::polygon({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  const Relaxed relaxed = relax(PointsView(site, 2), angle, {.steps = 5, .tolerance = 1e-14});
  EXPECT_NEAR(relaxed.coordinates[0], 5.0 / 6, 1e-14);
  EXPECT_NEAR(relaxed.coordinates[1], 5.0 / 6, 1e-14);
  ASSERT_EQ(relaxed.moved.size(), 2U);
  EXPECT_NEAR(relaxed.moved[0], std::sqrt(2.0) * (7 - 5.0 / 6), 1e-13);
  ASSERT_EQ(relaxed.energy.size(), 2U);
  EXPECT_NEAR(relaxed.energy[1], relaxed.energy[0] - 3 * 2 * std::pow(7 - 5.0 / 6, 2), 1e-11);
}

TEST(Relax, two_sites_in_a_square_end_at_quarters) {
  const std::vector<double> sites{0.1, 0.5, 0.2, 0.5};
  const Relaxed relaxed = relax(PointsView(sites, 2), box(2, 1), {.steps = 200, .tolerance = 1e-13});
  EXPECT_LT(relaxed.moved.size(), 100U);
  EXPECT_LE(relaxed.moved.back(), 1e-13);
  const std::vector<double> quarters{0.25, 0.5, 0.75, 0.5};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(relaxed.coordinates[i], quarters[i], 1e-12);
  EXPECT_NEAR(relaxed.energy.back(), 1.0 / 12 + 1.0 / 48, 1e-12);
}

TEST(Relax, a_step_leads_to_the_centroids_of_brute_force_cells) {
  const Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const std::size_t n : {2, 3, 10, 50}) {
    const PointSet points = uniform(2, n, n);
    const Relaxed relaxed = relax(points.view(), box(2, 1));
    for (std::size_t i = 0; i < n; ++i) {
      const auto expected = centroid(brute_cell(points.view(), i, square));
      EXPECT_NEAR(relaxed.coordinates[2 * i], expected[0], 1e-12);
      EXPECT_NEAR(relaxed.coordinates[2 * i + 1], expected[1], 1e-12);
    }
  }
}

TEST(Relax, centers_of_a_grid_stay) {
  std::vector<double> grid;
  for (int i = 0; i < 64; ++i) grid.insert(grid.end(), {i % 4 + 0.5, i / 4 % 4 + 0.5, i / 16 + 0.5});
  const Relaxed relaxed = relax(PointsView(grid, 3), box(3, 4), {.steps = 3, .tolerance = 1e-14});
  EXPECT_EQ(relaxed.moved.size(), 1U);
  EXPECT_LE(relaxed.moved[0], 4e-14);
  EXPECT_NEAR(relaxed.energy[0], 64 * 0.25, 1e-12);
}

TEST(Relax, the_energy_never_rises) {
  for (const int dimension : {2, 3}) {
    std::vector<Region> regions{box(dimension, 3)};
    if (dimension == 2) regions.push_back(angle_with_hole());
    for (const Region& region : regions) {
      std::vector<PointSet> sets{uniform(dimension, 40, 1),    lattice(dimension, 40, 4, 2),
                                 lattice(dimension, 40, 2, 3), cospherical(dimension, 20, 4),
                                 flat(dimension, 1, 20, 5),    uniform(dimension, 1, 6)};
      for (const PointSet& points : sets) {
        const Relaxed relaxed = relax(points.view(), region, {.steps = 12});
        for (std::size_t step = 1; step < relaxed.energy.size(); ++step) {
          EXPECT_LE(relaxed.energy[step], relaxed.energy[step - 1] * (1 + 1e-12)) << step << "\n" << points;
        }
      }
    }
  }
}

TEST(Relax, sites_without_cells_stay_until_they_have_one) {
  const std::vector<double> sites{0.25, 0.5, 0.25, 0.5, 50, 50};
  const Relaxed once = relax(PointsView(sites, 2), box(2, 1));
  EXPECT_THAT(once.coordinates, ::testing::ElementsAre(0.5, 0.5, 0.25, 0.5, 50, 50));
  const Relaxed twice = relax(PointsView(sites, 2), box(2, 1), {.steps = 2});
  EXPECT_NEAR(twice.coordinates[2], 0.1875, 1e-15);
  EXPECT_EQ(twice.coordinates[4], 50);
}

TEST(Relax, no_steps_and_no_sites_are_legal) {
  const PointSet points = uniform(2, 5, 1);
  const Relaxed none = relax(points.view(), box(2, 1), {.steps = 0});
  EXPECT_EQ(none.coordinates, points.coordinates);
  EXPECT_TRUE(none.moved.empty() && none.energy.empty());
  EXPECT_TRUE(relax(PointsView({}, 2), box(2, 1)).coordinates.empty());
}

TEST(Relax, threads_change_nothing) {
  const PointSet points = uniform(2, 3000, 1);
  const Relaxed one = relax(points.view(), box(2, 1), {.steps = 2});
  const Relaxed three = relax(points.view(), box(2, 1), {.steps = 2, .threads = 3});
  EXPECT_EQ(one.coordinates, three.coordinates);
  EXPECT_EQ(one.energy, three.energy);
}

TEST(Relax, tells_of_progress_and_can_be_cancelled) {
  const PointSet points = uniform(2, 300, 1);
  std::vector<double> told;
  const auto tell = [&](double done) {
    told.push_back(done);
    return true;
  };
  const Relaxed relaxed = relax(points.view(), box(2, 1), {.steps = 4, .progress = tell});
  EXPECT_EQ(relaxed.coordinates, relax(points.view(), box(2, 1), {.steps = 4}).coordinates);
  ASSERT_GE(told.size(), 4U);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_GE(told.front(), 0);
  EXPECT_LE(told.back(), 1);
  EXPECT_GE(told.back(), 0.75);
  for (std::size_t calls = 1; calls <= told.size(); ++calls) {
    std::size_t left = calls;
    const auto stop = [&](double) { return --left > 0; };
    EXPECT_THROW(relax(points.view(), box(2, 1), {.steps = 4, .progress = stop}), Cancelled) << calls;
  }
}

TEST(Relax, refuses_bad_input) {
  const auto refuses = [](PointsView points, const RelaxOptions& options, const std::string& why) {
    EXPECT_THAT([&] { relax(points, box(2, 1), options); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  const std::vector<double> sites{0.1, 0.5, 0.2, std::numeric_limits<double>::quiet_NaN(), 0.3, 0.3};
  const std::vector<double> weights{1, 2};
  refuses(PointsView(sites, 2), {}, "row 1, column 1");
  refuses(PointsView(std::span(sites).first(3), 3), {}, "sites of dimension 3 in a region of dimension 2");
  refuses(PointsView(std::span(sites).first(2), 1), {}, "dimension 1");
  refuses(PointsView(weights, 2, std::span(weights).first(1)), {}, "no weights");
  refuses(PointsView(weights, 2), {.steps = -1}, "-1 steps");
  refuses(PointsView(weights, 2), {.tolerance = -1}, "tolerance");
  refuses(PointsView(weights, 2), {.tolerance = std::numeric_limits<double>::quiet_NaN()}, "tolerance");
}

}  // namespace
}  // namespace delone
