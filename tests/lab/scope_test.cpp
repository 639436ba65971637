#include "delone/lab/scope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/mesh/export.hpp"
#include "lab/experiments.hpp"

namespace delone::lab {
namespace {

std::vector<double> points_of(std::size_t n, std::uint64_t seed) {
  return io::generate("uniform", n, 2, seed).coordinates;
}

std::size_t sum(const std::vector<std::size_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

// [GKS92] after lemma 2.5: the fourteen points of figure 2.
TEST(Scope, counts_of_the_paper_give_its_expected_number_of_triangles) {
  const std::vector<std::size_t> counts{17, 32, 42, 44, 47, 44, 40, 33, 28, 18, 12, 7};
  EXPECT_NEAR(expected_triangles(counts), 34.592, 0.001);
}

TEST(Scope, every_triangle_and_every_edge_has_one) {
  for (const std::size_t n : {3U, 4U, 11U, 24U, 40U}) {
    const std::vector<double> x = points_of(n, n);
    const Scopes scopes = count_scopes(PointsView(x, 2));
    EXPECT_EQ(sum(scopes.triangle_count), n * (n - 1) * (n - 2) / 6);
    EXPECT_EQ(sum(scopes.edge_count), n * (n - 1) / 2);
  }
}

TEST(Scope, zero_is_that_of_delaunay_triangles_and_edges) {
  const std::size_t n = 30;
  const std::vector<double> x = points_of(n, 3);
  const Scopes scopes = count_scopes(PointsView(x, 2));
  const AnyTriangulation t = build(PointsView(x, 2));
  std::set<std::size_t> triangles, edges;
  const CellTable table = cells(t);
  for (std::size_t c = 0; c < table.size(); ++c) {
    std::vector<std::size_t> v(table[c].begin(), table[c].end());
    std::ranges::sort(v);
    triangles.insert(triangle_number(v[0], v[1], v[2]));
    edges.insert({edge_number(v[0], v[1]), edge_number(v[0], v[2]), edge_number(v[1], v[2])});
  }
  for (std::size_t i = 0; i < scopes.of_triangle.size(); ++i)
    EXPECT_EQ(scopes.of_triangle[i] == 0, triangles.contains(i)) << i;
  for (std::size_t i = 0; i < scopes.of_edge.size(); ++i) EXPECT_EQ(scopes.of_edge[i] == 0, edges.contains(i)) << i;
}

TEST(Scope, probabilities_of_edges_lie_between_the_bounds_of_their_scopes) {
  const std::vector<double> x = points_of(24, 2);
  const Scopes scopes = count_scopes(PointsView(x, 2));
  for (std::size_t e = 0; e < scopes.of_edge.size(); ++e) {
    const std::size_t w = scopes.of_edge[e];
    const double width = static_cast<double>(w);
    EXPECT_LE(scopes.edge_probability[e], edge_probability_most(w) * (1 + 1e-12));
    EXPECT_GE(scopes.edge_probability[e], edge_probability_least(w) * (1 - 1e-12));
    EXPECT_LE(edge_probability_most(w), 4 / ((width + 1) * (width + 2)));
    if (w == 0) {
      EXPECT_NEAR(scopes.edge_probability[e], 1, 1e-12);
    }
  }
}

// The probability is found from the sites on the left; mirrored points have the others there.
TEST(Scope, mirror_images_have_the_same_scopes_and_probabilities) {
  std::vector<double> x = points_of(20, 4);
  const Scopes scopes = count_scopes(PointsView(x, 2));
  for (std::size_t i = 0; i < x.size(); i += 2) x[i] = -x[i];
  const Scopes mirrored = count_scopes(PointsView(x, 2));
  EXPECT_EQ(scopes.of_edge, mirrored.of_edge);
  for (std::size_t e = 0; e < scopes.of_edge.size(); ++e)
    EXPECT_NEAR(scopes.edge_probability[e], mirrored.edge_probability[e], 1e-12);
}

TEST(Scope, few_triangles_and_edges_have_small_ones) {
  for (const std::size_t n : {10U, 40U}) {
    const std::vector<double> x = points_of(n, 1);
    const Scopes scopes = count_scopes(PointsView(x, 2));
    double triangles = 0, edges = 0;
    for (std::size_t k = 0; k < scopes.triangle_count.size(); ++k)
      EXPECT_LE(triangles += static_cast<double>(scopes.triangle_count[k]), triangles_up_to_scope_bound(n, k));
    for (std::size_t w = 0; w < scopes.edge_count.size(); ++w)
      EXPECT_LE(edges += static_cast<double>(scopes.edge_count[w]), edges_up_to_scope_bound(n, w));
  }
}

TEST(Scope, shares_approach_probabilities) {
  const int runs = 1000;
  const std::vector<double> x = points_of(14, 1);
  const PointsView points(x, 2);
  const Scopes scopes = count_scopes(points);
  const ScopeSimulation simulation = simulate_scopes(points, scopes, runs, 1);
  const double root = std::sqrt(static_cast<double>(runs));
  const auto expect_close = [&](const Estimate& e, double expected) {
    EXPECT_NEAR(e.mean, expected, 4.5 * e.deviation / root + 1e-12);
  };
  expect_close(simulation.triangles, expected_triangles(scopes.triangle_count));
  expect_close(simulation.edges, std::accumulate(scopes.edge_probability.begin(), scopes.edge_probability.end(), 0.0));
  for (std::size_t k = 0; k < 7; ++k) expect_close(simulation.triangle_share[k], triangle_probability(k));
  std::vector<double> sums(scopes.edge_count.size());
  for (std::size_t e = 0; e < scopes.of_edge.size(); ++e) sums[scopes.of_edge[e]] += scopes.edge_probability[e];
  for (std::size_t w = 0; w < sums.size(); ++w) {
    if (scopes.edge_count[w] > 0)
      expect_close(simulation.edge_share[w], sums[w] / static_cast<double>(scopes.edge_count[w]));
  }
  EXPECT_EQ(simulation.triangle_share[0].mean, 1);  // the last triangles always appear
  EXPECT_EQ(simulation.edge_share[0].mean, 1);
}

TEST(Scope, points_must_be_few_and_in_general_position) {
  EXPECT_THROW(count_scopes(PointsView(points_of(65, 1), 2)), InputError);
  EXPECT_THROW(count_scopes(PointsView(points_of(2, 1), 2)), InputError);
  const std::vector<double> collinear{0, 0, 1, 1, 2, 2, 5, 0}, square{0, 0, 1, 0, 0, 1, 1, 1};
  EXPECT_THROW(count_scopes(PointsView(collinear, 2)), InputError);
  EXPECT_THROW(count_scopes(PointsView(square, 2)), InputError);
  EXPECT_THROW(scope_experiment().run({.n = 65}), InputError);
}

}  // namespace
}  // namespace delone::lab
