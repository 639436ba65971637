#include "delone/lab/order_k.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "delone/apps/order_k.hpp"
#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/lab/scope.hpp"
#include "lab/experiments.hpp"

namespace delone::lab {
namespace {

std::vector<double> points_of(const std::string& kind, std::size_t n, std::uint64_t seed) {
  return io::generate(kind, n, 2, seed).coordinates;
}

TEST(OrderKLab, pairs_are_those_that_one_finds_in_the_cells) {
  for (const char* kind : {"uniform", "circle", "lattice", "gks-figure1"}) {
    const std::vector<double> x = points_of(kind, 36, 2);
    const std::vector<OrderCounts> counts = count_orders(PointsView(x, 2), 12);
    ASSERT_EQ(counts.size(), 12U);
    std::set<std::pair<Index, Index>> pairs;
    for (const OrderCounts& c : counts) {
      const OrderK diagram = order_k_voronoi(PointsView(x, 2), c.k);
      for (std::size_t cell = 0; cell < diagram.size(); ++cell) {
        for (const Index a : diagram.subset(cell)) {
          for (const Index b : diagram.subset(cell)) {
            if (a < b) pairs.emplace(a, b);
          }
        }
      }
      EXPECT_EQ(c.pairs, pairs.size()) << kind << " " << c.k;
      EXPECT_EQ(c.cells, diagram.size());
    }
  }
}

// Lemma 4.3 by lemma 2.5: symmetric scopes are counted from scratch in lab/scope.
TEST(OrderKLab, pairs_have_small_symmetric_scopes) {
  const std::size_t n = 40;
  const std::vector<double> x = points_of("uniform", n, 3);
  const PointsView points(x, 2);
  const Scopes scopes = count_scopes(points);
  std::size_t up_to = 0;  // edges of symmetric scope up to k - 2
  for (const OrderCounts& c : count_orders(points, 20)) {
    if (c.k > 1) up_to += scopes.edge_count[static_cast<std::size_t>(c.k) - 2];
    EXPECT_LE(c.pairs, up_to) << c.k;
    EXPECT_LE(static_cast<double>(c.pairs), pairs_bound(n, c.k)) << c.k;
    for_orders(points, 1, c.k, [&](const OrderK& diagram) {
      for (const Bisector& b : diagram.borders) {
        if (b.near < b.far && diagram.k < c.k) {
          EXPECT_LE(scopes.of_edge[edge_number(b.near, b.far)] + 2, static_cast<std::size_t>(c.k));
        }
      }
    });
  }
}

TEST(OrderKLab, order_2_has_the_Delaunay_edges) {
  const std::vector<double> x = points_of("uniform", 200, 1);
  const AnyTriangulation t = build(PointsView(x, 2));
  const std::vector<OrderCounts> counts = count_orders(PointsView(x, 2), 2);
  const std::size_t edges = t.vertex_count() + t.cell_count() - 1;
  EXPECT_EQ(counts[0].borders, edges);
  EXPECT_EQ(counts[0].vertices, t.cell_count());
  EXPECT_EQ(counts[0].unbounded, t.hull_facet_count());
  EXPECT_EQ(counts[1].cells, edges);
  EXPECT_EQ(counts[1].pairs, edges);
}

TEST(OrderKLab, cells_of_points_in_general_position_are_as_many_as_Lee_says) {
  for (const char* kind : {"uniform", "circle"}) {
    const std::vector<double> x = points_of(kind, 150, 5);
    std::size_t lower_unbounded = 0;
    for (const OrderCounts& c : count_orders(PointsView(x, 2), 15)) {
      EXPECT_EQ(static_cast<double>(c.cells), cells_by_lee(150, c.k, lower_unbounded)) << kind << " " << c.k;
      lower_unbounded += c.unbounded;
    }
  }
}

TEST(OrderKLab, rows_add_up_what_is_counted_order_by_order) {
  PairsOptions options;
  options.kinds = {"uniform", "lattice"};
  options.n = 50;
  options.orders = {1, 3, 4};
  options.runs = 1;
  const PairsResult result = run_pairs(options);
  ASSERT_EQ(result.rows.size(), 6U);
  ASSERT_EQ(result.first.size(), 4U);
  double so_far = 0;
  auto row = result.rows.begin();
  for (const OrderCounts& c : result.first) {
    so_far += static_cast<double>(c.cells);
    if (c.k == 2) continue;
    EXPECT_EQ(row->k, c.k);
    EXPECT_EQ(row->cells.mean, static_cast<double>(c.cells));
    EXPECT_EQ(row->cells_so_far.mean, so_far);
    EXPECT_EQ((row++)->pairs.mean, static_cast<double>(c.pairs));
  }
}

TEST(OrderKLab, few_points_are_refused_and_callers_may_stop) {
  EXPECT_THROW(order_k_experiment().run({.n = 24}), InputError);
  EXPECT_THROW(order_k_experiment().run({.n = 25, .runs = 1, .progress = [](double) { return false; }}), Cancelled);
  EXPECT_EQ(order_k_experiment().run({.n = 25, .runs = 1}).tables.size(), 2U);
}

}  // namespace
}  // namespace delone::lab
