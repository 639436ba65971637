#include "delone/lab/triangles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "delone/base/errors.hpp"
#include "delone/io/generate.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

TEST(Triangles, bounds_stay_below_those_of_the_papers) {
  EXPECT_EQ(flipped_triangles_bound(3), 4);
  EXPECT_EQ(created_edges_bound(3), 6);
  for (const std::size_t n : {4U, 10U, 1000U}) {
    const auto sites = static_cast<double>(n);
    EXPECT_NEAR(flipped_triangles_bound(n), 9 * sites - 23 - 18 * (harmonic(n) - 11.0 / 6), 1e-9 * sites);
    EXPECT_NEAR(delaunay_triangles_bound(n), 6 * sites - 14 - 9 * (harmonic(n) - 11.0 / 6), 1e-9 * sites);
    EXPECT_LT(flipped_triangles_bound(n), 9 * sites + 1);
  }
}

// The bound is on the expectation over all orders: the mean over some is allowed three of its standard deviations.
TEST(Triangles, expected_numbers_stay_below_their_bounds_on_all_kinds_of_points) {
  TrianglesOptions options;
  options.sizes = {50, 500};
  options.figure_one_sizes = {};
  const TrianglesResult result = run_triangles(options);
  ASSERT_GE(result.rows.size(), 2U * 10);
  const double root = std::sqrt(static_cast<double>(options.runs));
  for (const TrianglesRow& row : result.rows) {
    EXPECT_LT(row.by_flips.mean - 3 * row.by_flips.deviation / root, flipped_triangles_bound(row.n)) << row.kind;
    EXPECT_LT(row.delaunay.mean - 3 * row.delaunay.deviation / root, delaunay_triangles_bound(row.n)) << row.kind;
    EXPECT_LT(row.edges.mean - 3 * row.edges.deviation / root, created_edges_bound(row.n)) << row.kind;
    EXPECT_GT(row.by_flips.mean, row.delaunay.mean) << row.kind;
  }
}

// [Slides] lemma 1: every edge is Delaunay when it comes, so it is one of the star of its site in the end.
TEST(Triangles, flips_make_the_edges_of_the_stars_and_no_others) {
  for (const char* kind : {"uniform", "lattice", "circle", "gks-figure1"}) {
    const io::Generated made = io::generate(kind, 300, 2, 5);
    const PointsView points(made.coordinates, 2);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Created flips = count_created(points, Method::flip_loop, Order::random, seed);
      const Created legalized = count_created(points, Method::flip_legalize, Order::random, seed);
      const Created stars = count_created(points, Method::cavity, Order::random, seed);
      const Created conflicts = count_created(points, Method::conflict_graph, Order::random, seed);
      EXPECT_EQ(conflicts.triangles, stars.triangles) << kind;
      EXPECT_EQ(flips.edges, stars.triangles + 2) << kind;
      EXPECT_EQ(flips.triangles, 2 * stars.triangles - 3 * static_cast<double>(flips.sites - 3) - 4) << kind;
      EXPECT_EQ(flips.triangles, legalized.triangles) << kind;
    }
  }
}

TEST(Triangles, from_right_to_left_they_grow_as_the_square) {
  TrianglesOptions options;
  options.sizes = {};
  options.figure_one_sizes = {40, 81, 160, 320};
  std::vector<std::array<double, 2>> in_order, random;
  for (const FigureOneRow& row : run_triangles(options).figure_one) {
    EXPECT_EQ(row.by_flips, figure_one_by_flips(row.n)) << row.n;
    EXPECT_EQ(row.delaunay, figure_one_delaunay(row.n)) << row.n;
    EXPECT_LT(row.random_by_flips.mean, flipped_triangles_bound(row.n)) << row.n;
    in_order.push_back({static_cast<double>(row.n), row.by_flips});
    random.push_back({static_cast<double>(row.n), row.random_by_flips.mean});
  }
  EXPECT_NEAR(exponent(in_order), 2, 0.1);
  EXPECT_NEAR(exponent(random), 1, 0.2);
}

TEST(Triangles, unknown_kinds_are_refused_and_a_caller_may_stop) {
  TrianglesOptions options;
  options.kinds = {"triangle"};
  EXPECT_THROW(run_triangles(options), InputError);
  options.kinds = {"uniform"};
  options.progress = [](double) { return false; };
  EXPECT_THROW(run_triangles(options), Cancelled);
}

}  // namespace
}  // namespace delone::lab
