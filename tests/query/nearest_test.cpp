#include "delone/query/nearest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/integer.hpp"
#include "query/queries.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;
using exact::BigInt;

BigInt integer(double x, int unit) { return exact::to_integer<BigInt>(exact::decompose(x), unit); }

/// Rows that are results (vertices and their duplicates) by exact distance from one query, then by row.
class BruteForce {
 public:
  BruteForce(const AnyTriangulation& t, const PointSet& points, std::span<const double> q) {
    for (const auto& numbers : {std::span<const double>(points.coordinates), q}) {
      for (const double x : numbers) exact::lower_unit(unit_, exact::decompose(x));
    }
    for (const double w : points.weights) exact::lower_unit(unit_, exact::decompose(w), 2);
    for (Index row = 0; row < points.size(); ++row) {
      if (t.status(row).status == Status::hidden) continue;
      BigInt power = -integer(points.view().weight(row), 2 * unit_);
      for (std::size_t j = 0; j < q.size(); ++j) {
        const BigInt d = integer(points.view()[row][j], unit_) - integer(q[j], unit_);
        power += d * d;
      }
      ranked_.emplace_back(power, row);
    }
    std::ranges::sort(ranked_);
  }

  std::vector<Index> nearest(std::size_t k) const {
    std::vector<Index> rows;
    for (const auto& pair : ranked_) {
      if (rows.size() < k) rows.push_back(pair.second);
    }
    return rows;
  }
  std::vector<Index> within(double radius) const {
    const int unit = std::min(unit_, exact::decompose(radius).exponent);
    const BigInt r = integer(radius, unit);
    std::vector<Index> rows;
    for (const auto& [power, row] : ranked_) {
      if (power << (2 * (unit_ - unit)) <= r * r) rows.push_back(row);
    }
    return rows;
  }

 private:
  int unit_ = 0;
  std::vector<std::pair<BigInt, Index>> ranked_;
};

std::vector<Index> rows_of(const std::vector<Neighbour>& neighbours) {
  std::vector<Index> rows;
  for (const Neighbour& n : neighbours) rows.push_back(n.row);
  return rows;
}

void expect_brute_force_agrees(const PointSet& points, std::uint64_t seed) {
  const AnyTriangulation t = built(points);
  const PointSet queries = queries_around(points, seed);
  Random random(seed);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto q = queries.view()[i];
    const BruteForce truth(t, points, q);
    const auto one = truth.nearest(1);
    const Neighbour found = nearest(t, q);
    ASSERT_EQ(found.row, one.empty() ? kNone : one[0]) << points << "\nquery " << i << " of " << queries;
    ASSERT_EQ(nearest(t, q, any_live_cell(t, random)), found) << points;
    const std::size_t k = random() % 8 == 0 ? points.size() + 3 : random() % 6;
    ASSERT_EQ(rows_of(nearest(t, q, k)), truth.nearest(k)) << points << "\nquery " << i << " of " << queries;
    const double distance = std::sqrt(std::max(found.squared_distance, 0.0));
    const double radius = std::isfinite(distance) ? distance * static_cast<double>(random() % 4) : 1e300;
    if (!std::isfinite(radius)) continue;
    ASSERT_EQ(rows_of(within(t, q, radius)), truth.within(radius)) << points << "\nquery " << i << " of " << queries;
  }
}

TEST(Nearest, agrees_with_exact_brute_force_on_every_family) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    const std::size_t n = dimension <= 3 ? 14 : 7;
    for (const PointSet& points : families(dimension, n, 11)) expect_brute_force_agrees(points, 5);
  }
}

TEST(Nearest, few_points_or_none) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (std::size_t n = 0; n <= 4; ++n) {
      expect_brute_force_agrees(lattice(dimension, n, 2, n), 3);
      expect_brute_force_agrees(with_random_weights(lattice(dimension, n, 2, n), 4), 3);
    }
  }
  const AnyTriangulation none(2);
  const std::vector<double> q{1, 2};
  EXPECT_EQ(nearest(none, q), Neighbour{});
  EXPECT_EQ(nearest(none, q, std::size_t{3}).size(), 0U);
  EXPECT_EQ(within(none, q, 1.0).size(), 0U);
  const PointsView queries(q, 2);
  EXPECT_EQ(nearest(none, queries), std::vector<Neighbour>(1));
  EXPECT_EQ(nearest(none, queries, std::size_t{3}).offsets, (std::vector<std::size_t>{0, 0}));
}

TEST(Nearest, of_equally_near_vertices_the_lowest_row_is_the_answer) {
  // Sixteen points of one circle, and its centre as the query; and all corners of a cube.
  PointSet circle{"circle", 2, {}};
  for (const auto& [x, y] : {std::pair{0, 65}, {16, 63}, {25, 60}, {33, 56}, {39, 52}, {52, 39}, {56, 33}, {60, 25}}) {
    for (const int turn : {0, 1}) {
      circle.coordinates.insert(circle.coordinates.end(), {double(turn == 0 ? x : -y), double(turn == 0 ? y : x)});
    }
  }
  const AnyTriangulation t = built(circle);
  const std::vector<double> centre{0, 0};
  EXPECT_EQ(nearest(t, centre), (Neighbour{0, 65.0 * 65.0}));
  std::vector<Index> all(circle.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
  EXPECT_EQ(rows_of(nearest(t, centre, std::size_t{100})), all);
  EXPECT_EQ(rows_of(within(t, centre, 65.0)), all);
  EXPECT_TRUE(within(t, centre, std::nextafter(65.0, 0.0)).empty());
}

TEST(Nearest, duplicates_are_rows_of_their_own_and_hidden_rows_are_none) {
  PointSet points{"two places", 2, {0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0}};
  const std::vector<double> q{0.25, 0};
  EXPECT_EQ(rows_of(nearest(built(points), q, std::size_t{5})), (std::vector<Index>{0, 2, 5, 1, 4}));
  EXPECT_EQ(rows_of(within(built(points), q, 0.75)), (std::vector<Index>{0, 2, 5, 1, 4}));
  points.weights = {0, 0, 1, 0, 0, 1};  // rows 0, 1, 4 are hidden or beaten by the heavy ones at the origin
  const AnyTriangulation t = built(points);
  for (const Neighbour& n : nearest(t, q, std::size_t{9})) EXPECT_NE(t.status(n.row).status, Status::hidden);
  EXPECT_EQ(nearest(t, q).row, 2U);
}

TEST(Nearest, distances_are_close_to_the_exact_ones) {
  const PointSet points = uniform(3, 50, 1);
  const AnyTriangulation t = built(points);
  for (const Neighbour& n : nearest(t, std::vector<double>{0.5, 0.25, 0.125}, points.size())) {
    const auto p = points.view()[n.row];
    const double d = std::hypot(p[0] - 0.5, p[1] - 0.25, p[2] - 0.125);
    EXPECT_NEAR(n.squared_distance, d * d, 1e-15);
  }
}

NeighbourLists one_by_one(const AnyTriangulation& t, PointsView queries, std::size_t k, std::optional<double> radius) {
  NeighbourLists lists;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    for (const Neighbour& n : radius ? within(t, queries[i], *radius) : nearest(t, queries[i], k)) {
      lists.rows.push_back(n.row);
      lists.squared_distances.push_back(n.squared_distance);
    }
    lists.offsets.push_back(lists.rows.size());
  }
  return lists;
}

void expect_equal(const NeighbourLists& a, const NeighbourLists& b) {
  EXPECT_EQ(a.offsets, b.offsets);
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.squared_distances, b.squared_distances);
}

TEST(NearestInBatches, equal_single_calls_for_any_number_of_threads) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const PointSet& points : families(dimension, 16, 7)) {
      const AnyTriangulation t = built(points);
      const PointSet queries = rows(queries_around(points, 9), 0, 20);
      std::vector<Neighbour> singles;
      for (std::size_t i = 0; i < queries.size(); ++i) singles.push_back(nearest(t, queries.view()[i]));
      ASSERT_EQ(nearest(t, queries.view()), singles) << points;
      ASSERT_EQ(nearest(t, queries.view(), {.threads = 3}), singles) << points;
      expect_equal(nearest(t, queries.view(), 5), one_by_one(t, queries.view(), 5, {}));
      expect_equal(within(t, queries.view(), 1.5), one_by_one(t, queries.view(), 0, 1.5));
    }
  }
}

TEST(NearestInBatches, many_queries_are_shared_among_threads) {
  for (const int dimension : {2, 3}) {
    const PointSet points = uniform(dimension, 3000, 3);
    const AnyTriangulation t = built(points);
    const PointSet queries = uniform(dimension, 20000, 4);
    const auto one = nearest(t, queries.view());
    EXPECT_EQ(nearest(t, queries.view(), {.threads = 4}), one);
    expect_equal(nearest(t, queries.view(), 6, {.threads = 4}), nearest(t, queries.view(), 6));
    expect_equal(within(t, queries.view(), 0.03, {.threads = 4}), within(t, queries.view(), 0.03));
    for (std::size_t i = 0; i < queries.size(); i += 97) EXPECT_EQ(one[i], nearest(t, queries.view()[i]));
  }
}

TEST(NearestInBatches, progress_is_told_and_may_cancel) {
  const AnyTriangulation t = built(uniform(2, 100, 3));
  const PointSet queries = uniform(2, 20000, 4);
  std::vector<double> told;
  nearest(t, queries.view(), {.threads = 2, .progress = [&](double done) {
                                told.push_back(done);
                                return true;
                              }});
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_LE(told.empty() ? 1.0 : told.back(), 1.0);
  EXPECT_THROW(nearest(t, queries.view(), {.progress = [](double) { return false; }}), Cancelled);
}

template <class Call>
void expect_refused(const Call& call, const std::string& words) {
  try {
    call();
    FAIL() << "not refused: " << words;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Nearest, bad_queries_are_refused_before_any_work) {
  const AnyTriangulation t = built(uniform(2, 10, 1));
  const std::vector<double> short_one{1};
  const std::vector<double> nan{1, std::nan("")};
  const std::vector<double> good{1, 2};
  const std::vector<double> later{1, 2, 3, std::numeric_limits<double>::infinity()};
  expect_refused([&] { nearest(t, short_one); }, "a point of 1 coordinates: expected 2");
  expect_refused([&] { nearest(t, nan, std::size_t{2}); }, "column 1: coordinate is not finite");
  expect_refused([&] { within(t, good, -1.0); }, "radius -1");
  expect_refused([&] { within(t, PointsView(good, 2), std::nan("")); }, "radius");
  expect_refused([&] { nearest(t, PointsView(later, 2)); }, "row 1, column 1: coordinate is not finite");
  expect_refused([&] { nearest(t, PointsView(good, 1), 3); }, "queries of 1 coordinates: expected 2");
}

TEST(Nearest, vertices_with_very_many_neighbours_do_not_fill_the_memory) {
  // On the moment curve in 4D every two points are neighbours.
  PointSet points{"moment curve", 4, {}};
  for (int i = 0; i < 60; ++i) {
    const double x = i - 30;
    points.coordinates.insert(points.coordinates.end(), {x, x * x, x * x * x, x * x * x * x});
  }
  expect_brute_force_agrees(points, 1);
}

}  // namespace
}  // namespace delone
