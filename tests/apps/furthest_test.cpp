#include "delone/apps/furthest.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "delone/apps/hull.hpp"
#include "delone/base/errors.hpp"
#include "delone/check/delaunay.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

std::vector<Index> vertices_of(const FurthestDelaunay& furthest) {
  std::vector<Index> rows = furthest.cells.vertices;
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

void expect_furthest(const PointSet& points) {
  const FurthestDelaunay furthest = furthest_delaunay(points.view());
  const CheckReport report = check(points.view(), furthest.cells, {.canonical = true, .furthest = true});
  ASSERT_TRUE(report.passed()) << report.violations.front() << "\n" << points;
  EXPECT_EQ(furthest.hull_facets, report.hull_facets) << points;
  const std::vector<Index> vertices = vertices_of(furthest);
  for (std::size_t row = 0; row < points.size(); ++row) {
    EXPECT_EQ(furthest.status[row].status == Status::vertex,
              std::ranges::binary_search(vertices, static_cast<Index>(row)))
        << row << "\n"
        << points;
  }
}

TEST(Furthest, passes_the_exact_check_on_every_family) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const std::size_t n : {1, 2, 3, 4, 5, 7, 10, 16}) {
      for (const PointSet& points : unweighted_families(dimension, n, n)) expect_furthest(points);
    }
    for (const PointSet& points : unweighted_families(dimension, dimension < 4 ? 100 : 30, 2)) expect_furthest(points);
  }
}

// A point that is furthest from somewhere is extreme, and every extreme point is furthest from somewhere.
TEST(Furthest, vertices_are_the_corners_of_the_hull) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, dimension < 4 ? 50 : 20, 3)) {
      EXPECT_EQ(vertices_of(furthest_delaunay(points.view())), convex_hull(points.view()).corners) << points;
    }
  }
}

TEST(Furthest, of_a_kite_takes_the_other_diagonal) {
  const std::vector<double> kite{0, 0, 3, -1, 6, 0, 3, 1};
  EXPECT_EQ(furthest_delaunay(PointsView(kite, 2)).cells.vertices, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
}

TEST(Furthest, weights_are_refused) {
  const PointSet points = with_random_weights(uniform(2, 5, 1), 1);
  EXPECT_THROW(furthest_delaunay(points.view()), InputError);
  EXPECT_THROW(check(points.view(), {}, {.furthest = true}), InputError);
}

}  // namespace
}  // namespace delone
