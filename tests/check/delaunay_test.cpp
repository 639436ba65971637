#include "delone/check/delaunay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/brute_force.hpp"

namespace delone {
namespace {

using test::Truth;
using Cells = std::vector<std::vector<Index>>;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;

struct Points {
  std::string name;
  int dimension;
  std::vector<double> coordinates;
  std::vector<double> weights;

  PointsView view() const { return PointsView(coordinates, dimension, weights); }
  std::size_t size() const { return coordinates.size() / static_cast<std::size_t>(dimension); }
};

CellTable table(const Cells& cells) {
  CellTable result;
  if (!cells.empty()) result.corners = static_cast<int>(cells.front().size());
  for (const auto& cell : cells) result.vertices.insert(result.vertices.end(), cell.begin(), cell.end());
  return result;
}

CheckReport check_cells(const Points& points, const Cells& cells, bool canonical = false) {
  return check(points.view(), table(cells), {.canonical = canonical});
}

std::string first_line(const CheckReport& report) { return report.violations.empty() ? "" : report.violations.front(); }

// --- Families of small inputs, each hard in its own way. ---

using Random = std::mt19937_64;

double unit_random(Random& random) { return std::ldexp(static_cast<double>(random() >> 11), -53); }

template <class Value>
Points fill(std::string name, int dimension, std::size_t n, const Value& value) {
  Points points{std::move(name), dimension, {}, {}};
  for (std::size_t i = 0; i < n * static_cast<std::size_t>(dimension); ++i) points.coordinates.push_back(value(i));
  return points;
}

/// Each point a signed permutation of (1, 2, ..., D): all on one sphere.
Points cospherical(int dimension, std::size_t n, Random& random) {
  Points points{"cospherical", dimension, {}, {}};
  std::vector<double> p(static_cast<std::size_t>(dimension));
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = static_cast<double>(i + 1);
  for (std::size_t i = 0; i < n; ++i) {
    std::shuffle(p.begin(), p.end(), random);
    for (const double x : p) points.coordinates.push_back(random() % 2 == 0 ? x : -x);
  }
  return points;
}

/// On a line or, one dimension below D, on a hyperplane, tilted against all axes.
Points flat(int dimension, int rank, std::size_t n, Random& random) {
  Points points{"flat of rank " + std::to_string(rank), dimension, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> p(static_cast<std::size_t>(dimension), 0.0);
    for (int direction = 0; direction < rank; ++direction) {
      const auto step = static_cast<double>(random() % 4);
      for (int axis = 0; axis < dimension; ++axis) {
        p[static_cast<std::size_t>(axis)] +=
            step * static_cast<double>((axis + 1) * (direction + 2) % 5 + (axis == direction));
      }
    }
    points.coordinates.insert(points.coordinates.end(), p.begin(), p.end());
  }
  return points;
}

std::vector<Points> families(int dimension, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const auto pick = [&](std::initializer_list<double> values) { return *(values.begin() + random() % values.size()); };
  std::vector<Points> all{
      fill("random", dimension, n, [&](std::size_t) { return unit_random(random); }),
      fill("lattice", dimension, n, [&](std::size_t) { return static_cast<double>(random() % 3); }),
      fill("duplicates", dimension, n, [&](std::size_t) { return static_cast<double>(random() % 2); }),
      cospherical(dimension, n, random),
      flat(dimension, 1, n, random),
      flat(dimension, std::max(1, dimension - 1), n, random),
      fill("huge", dimension, n, [&](std::size_t) { return 1.7e308 * (unit_random(random) - 0.5); }),
      fill("tiny", dimension, n, [&](std::size_t) { return 1e-300 * unit_random(random); }),
      fill("denormal", dimension, n, [&](std::size_t) { return 5e-324 * static_cast<double>(random() % 50); }),
      fill("mixed", dimension, n,
           [&](std::size_t) {
             return pick({1e300, -1e300, 1.0, 1e-300, 5e-324, 0.0}) * static_cast<double>(random() % 3);
           }),
      fill("many bits", dimension, n,
           [&](std::size_t) {
             return pick({1.0, 0x1p-30, 0x1p-50}) * unit_random(random);
           }),
      fill("all equal", dimension, n, [&](std::size_t) { return 0.1; }),
  };
  return all;
}

/// The same points with equal, small integral, random and extreme weights.
std::vector<Points> weighted(const Points& points, std::uint64_t seed) {
  Random random(seed);
  std::vector<Points> all(4, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    all[0].weights.push_back(2.5);
    all[1].weights.push_back(static_cast<double>(random() % 3));
    all[2].weights.push_back(unit_random(random) - 0.5);
    all[3].weights.push_back(random() % 3 == 0 ? 1e-310 : (random() % 2 == 0 ? 1e300 : 0.0));
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].name += " with weights of kind " + std::to_string(i);
  return all;
}

std::size_t size_for(int dimension) { return static_cast<std::size_t>(dimension <= 3 ? 12 : 14 - dimension); }

/// Calls test(points, truth) for all families in dimensions 1 to 6.
template <class Test>
void for_all_inputs(const Test& test, int last_dimension = 6, std::uint64_t seeds = 2) {
  for (int dimension = 1; dimension <= last_dimension; ++dimension) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      for (const Points& plain : families(dimension, size_for(dimension), seed)) {
        std::vector<Points> inputs = weighted(plain, seed);
        inputs.push_back(plain);
        for (const Points& points : inputs) {
          SCOPED_TRACE(points.name + ", dimension " + std::to_string(dimension) + ", seed " + std::to_string(seed));
          test(points, test::brute_force(points.view()));
        }
      }
    }
  }
}

bool same_place(const Points& points, Index a, Index b) {
  return std::ranges::equal(points.view()[a], points.view()[b]);
}

// --- What is right passes. ---

TEST(CheckSlow, the_canonical_triangulation_passes_and_its_rows_are_counted) {
  for_all_inputs([](const Points& points, const Truth& truth) {
    const CheckReport report = check_cells(points, truth.cells, true);
    EXPECT_TRUE(report.passed()) << first_line(report);
    EXPECT_EQ(report.affine_dimension, truth.affine_dimension);
    EXPECT_EQ(report.cells, truth.cells.size());
    EXPECT_EQ(report.vertices, static_cast<std::size_t>(std::ranges::count(truth.status, 0)));
    EXPECT_EQ(report.duplicates, static_cast<std::size_t>(std::ranges::count(truth.status, 1)));
    EXPECT_EQ(report.hidden, static_cast<std::size_t>(std::ranges::count(truth.status, 2)));
  });
}

TEST(CheckSlow, ties_resolved_in_another_way_are_valid_but_not_canonical) {
  std::size_t different = 0;
  for_all_inputs(
      [&](const Points& points, const Truth& truth) {
        Points mirrored = points;  // turns the lexicographic order around, and nothing else
        for (double& x : mirrored.coordinates) x = -x;
        const Cells cells = test::brute_force(mirrored.view()).cells;
        EXPECT_TRUE(check_cells(points, cells).passed()) << first_line(check_cells(points, cells));
        EXPECT_EQ(check_cells(points, cells, true).passed(), cells == truth.cells);
        if (cells != truth.cells) ++different;
      },
      5, 1);
  EXPECT_GT(different, 10U);
}

TEST(Check, corners_and_cells_may_come_in_any_order) {
  Random random(7);
  const Points points = families(3, 12, 7).front();
  Cells cells = test::brute_force(points.view()).cells;
  for (auto& cell : cells) std::shuffle(cell.begin(), cell.end(), random);
  std::shuffle(cells.begin(), cells.end(), random);
  EXPECT_TRUE(check_cells(points, cells, true).passed());
}

TEST(Check, dimensions_seven_and_eight_are_checked) {
  for (const int dimension : {7, 8}) {
    const auto d = static_cast<std::size_t>(dimension);
    Random random(3);
    Points points = fill("random", dimension, d + 2, [&](std::size_t) { return unit_random(random); });
    const Cells cells = test::brute_force(points.view()).cells;
    EXPECT_TRUE(check_cells(points, cells, true).passed()) << first_line(check_cells(points, cells, true));
    EXPECT_FALSE(check_cells(points, {cells.begin() + 1, cells.end()}).passed());
  }
}

TEST(Check, hull_facets_are_counted) {
  const Points square{"square", 2, {0, 0, 1, 0, 0, 1, 1, 1}, {}};
  EXPECT_EQ(check_cells(square, {{0, 1, 3}, {0, 2, 3}}).hull_facets, 4U);
  const Points line{"line", 1, {0, 1, 2}, {}};
  EXPECT_EQ(check_cells(line, {{0, 1}, {1, 2}}).hull_facets, 2U);
}

TEST(Check, no_points_have_no_cells) {
  const CheckReport report = check(PointsView({}, 3), {});
  EXPECT_TRUE(report.passed());
  EXPECT_EQ(report.affine_dimension, -1);
  EXPECT_FALSE(check(PointsView({}, 3), table({{0}})).passed());
}

// --- What is wrong is caught. ---

TEST(CheckSlow, a_missing_cell_is_caught) {
  for_all_inputs(
      [](const Points& points, const Truth& truth) {
        for (std::size_t i = 0; i < truth.cells.size(); ++i) {
          Cells cells = truth.cells;
          cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(i));
          EXPECT_FALSE(check_cells(points, cells).passed()) << "without cell " << i;
        }
      },
      4, 1);
}

TEST(CheckSlow, a_cell_given_twice_is_caught) {
  for_all_inputs(
      [](const Points& points, const Truth& truth) {
        for (const auto& cell : truth.cells) {
          Cells cells = truth.cells;
          cells.push_back(cell);
          EXPECT_FALSE(check_cells(points, cells).passed());
        }
      },
      4, 1);
}

TEST(CheckSlow, a_replaced_vertex_is_caught) {
  for_all_inputs(
      [](const Points& points, const Truth& truth) {
        Random random(11);
        for (int attempt = 0; attempt < 20; ++attempt) {
          Cells cells = truth.cells;
          auto& cell = cells[random() % cells.size()];
          Index& corner = cell[random() % cell.size()];
          const auto other = static_cast<Index>(random() % points.size());
          if (same_place(points, corner, other)) continue;
          corner = other;
          EXPECT_FALSE(check_cells(points, cells).passed());
        }
      },
      4, 1);
}

TEST(CheckSlow, a_triangulation_of_other_weights_is_caught) {
  std::size_t different = 0;
  for_all_inputs(
      [&](const Points& points, const Truth&) {
        Points other = points;
        Random random(5);
        other.weights.clear();
        for (std::size_t i = 0; i < points.size(); ++i) other.weights.push_back(unit_random(random));
        const Cells cells = test::brute_force(other.view()).cells;
        const Cells truth = test::brute_force(points.view()).cells;
        EXPECT_EQ(check_cells(points, cells, true).passed(), cells == truth);
        if (cells != truth) ++different;
      },
      3, 1);
  EXPECT_GT(different, 20U);
}

TEST(Check, a_duplicate_that_stands_in_for_the_lowest_row_is_valid_but_not_canonical) {
  const Points points{"twins", 2, {0, 0, 1, 0, 0, 1, 0, 0}, {}};
  EXPECT_TRUE(check_cells(points, {{0, 1, 2}}, true).passed());
  EXPECT_TRUE(check_cells(points, {{1, 2, 3}}).passed());
  EXPECT_EQ(check_cells(points, {{1, 2, 3}}).duplicates, 1U);
  EXPECT_FALSE(check_cells(points, {{1, 2, 3}}, true).passed());
}

TEST(Check, the_wrong_diagonal_is_caught) {
  const Points kite{"kite", 2, {0, 0, 2, -1, 2, 1, 5, 0}, {}};
  EXPECT_TRUE(check_cells(kite, {{0, 1, 2}, {1, 2, 3}}).passed());
  const CheckReport report = check_cells(kite, {{0, 1, 3}, {0, 2, 3}});
  EXPECT_EQ(report.violation_count, 1U);
  EXPECT_EQ(first_line(report), "row 2 is inside the orthosphere of cell 0 (rows 0 1 3)");
}

TEST(Check, the_other_diagonal_of_a_square_is_valid_but_not_canonical) {
  const Points square{"square", 2, {0, 0, 1, 0, 0, 1, 1, 1}, {}};
  EXPECT_TRUE(check_cells(square, {{0, 1, 3}, {0, 2, 3}}, true).passed());
  EXPECT_TRUE(check_cells(square, {{0, 1, 2}, {1, 2, 3}}).passed());
  const CheckReport report = check_cells(square, {{0, 1, 2}, {1, 2, 3}}, true);
  EXPECT_EQ(first_line(report), "cell 0 (rows 0 1 2) is not canonical: in the tie with row 3 it must give way");
}

TEST(Check, a_flat_cell_is_caught) {
  const Points square{"square", 2, {0, 0, 1, 0, 2, 0, 1, 1}, {}};
  const CheckReport report = check_cells(square, {{0, 1, 3}, {1, 2, 3}, {0, 1, 2}});
  EXPECT_THAT(report.violations, Contains("cell 2 (rows 0 1 2) is flat"));
}

TEST(Check, a_cell_folded_over_its_neighbour_is_caught) {
  const Points points{"fold", 2, {0, 0, 4, 0, 1, 3, 2, 4}, {}};
  const CheckReport report = check_cells(points, {{0, 1, 2}, {0, 1, 3}});
  EXPECT_EQ(first_line(report), "cells 0 and 1 lie on the same side of their facet (rows 0 1)");
}

TEST(Check, three_cells_at_a_facet_are_caught) {
  const Points points{"fan", 2, {0, 0, 4, 0, 1, 3, 2, 4, 1, -3}, {}};
  const CheckReport report = check_cells(points, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  EXPECT_EQ(first_line(report), "facet (rows 0 1) is in 3 cells: 0 1 2");
}

/// A centre and five points of a circle, in order.
Points pentagon() {
  Points points{"pentagon", 2, {0, 0}, {}};
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / 5;
    points.coordinates.insert(points.coordinates.end(), {std::cos(angle), std::sin(angle)});
  }
  return points;
}

TEST(Check, a_fan_that_winds_around_twice_is_caught_by_the_ray) {
  Cells fan;
  for (Index i = 0; i < 5; ++i) fan.push_back({0, 1 + i, 1 + (i + 2) % 5});
  const CheckReport report = check_cells(pentagon(), fan);
  EXPECT_FALSE(report.passed());
  EXPECT_THAT(report.violations, Each(HasSubstr("winds around more than once")));
}

TEST(Check, cells_that_lie_over_a_whole_triangulation_are_caught) {
  Points twice = pentagon();
  const Points once = pentagon();
  twice.coordinates.insert(twice.coordinates.end(), once.coordinates.begin(), once.coordinates.begin() + 2);
  Cells cells;
  for (Index i = 0; i < 5; ++i) cells.push_back({0, 1 + i, 1 + (i + 1) % 5});
  EXPECT_TRUE(check_cells(twice, cells).passed()) << first_line(check_cells(twice, cells));
  for (Index i = 0; i < 5; ++i) cells.push_back({6, 1 + i, 1 + (i + 1) % 5});
  EXPECT_FALSE(check_cells(twice, cells).passed());
}

TEST(Check, a_cell_over_a_whole_triangulation_is_caught) {
  const Points line{"line", 1, {0, 1, 2, 3, 0.5, 2.5}, {}};
  EXPECT_FALSE(check_cells(line, {{0, 1}, {1, 2}, {2, 3}, {4, 5}}).passed());
  const Points star{"star", 2, {0, 3, 3, -2, -3, -2, 0, -3, 3, 2, -3, 2}, {}};
  EXPECT_THAT(check_cells(star, {{0, 1, 2}, {3, 4, 5}}).violations, Contains(HasSubstr("winds around more than once")));
}

TEST(Check, a_reflex_boundary_is_caught) {
  const Points points{"dart", 2, {0, 0, 4, 1, 1, 1, 1, 4}, {}};
  const CheckReport report = check_cells(points, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_THAT(report.violations, Contains(HasSubstr("the boundary is not convex")));
}

TEST(Check, a_hole_is_caught) {
  const Points points{"ring", 2, {0, 0, 9, 0, 0, 9, 2, 2, 4, 2, 2, 4}, {}};
  Cells cells = test::brute_force(points.view()).cells;
  ASSERT_THAT(cells, Contains(std::vector<Index>{3, 4, 5}));
  EXPECT_TRUE(check_cells(points, cells).passed());
  std::erase(cells, std::vector<Index>{3, 4, 5});
  EXPECT_THAT(check_cells(points, cells).violations, Contains(HasSubstr("the boundary is not convex")));
}

TEST(Check, a_missing_row_is_caught) {
  const Points points{"square", 2, {0, 0, 4, 0, 0, 4, 1, 1, 9, 9}, {}};
  EXPECT_THAT(check_cells(points, {{0, 1, 2}}).violations,
              Contains("row 3 is neither a vertex nor at the position of one"));
  Points weighty = points;
  weighty.weights.assign(5, 0.0);
  EXPECT_THAT(check_cells(weighty, {{0, 1, 2}}).violations, Contains("row 4 is outside of all cells"));
  EXPECT_THAT(check_cells(weighty, {{0, 1, 2}}).violations,
              Contains("row 3 is no vertex, but inside the orthosphere of cell 0 (rows 0 1 2) that contains it"));
}

TEST(Check, a_light_point_is_hidden_up_to_the_tie_and_not_beyond) {
  Points points{"triangle", 2, {0, 0, 4, 0, 0, 4, 1, 1}, {0, 0, 0, -7}};
  // The orthosphere of the triangle is centred at (2, 2), radius^2 8; (1, 1) has distance^2 2: its weight ties at -6.
  EXPECT_TRUE(check_cells(points, {{0, 1, 2}}, true).passed());
  EXPECT_EQ(check_cells(points, {{0, 1, 2}}).hidden, 1U);
  points.weights[3] = -6;
  EXPECT_TRUE(check_cells(points, {{0, 1, 2}}).passed());
  EXPECT_TRUE(check_cells(points, {{0, 1, 2}}, true).passed());  // (0, 0) is lowered more
  points.weights[3] = std::nextafter(-6.0, 0.0);
  EXPECT_FALSE(check_cells(points, {{0, 1, 2}}).passed());
}

TEST(Check, at_one_position_the_heaviest_must_live) {
  const Points points{"twins", 2, {0, 0, 4, 0, 0, 4, 0, 0}, {0, 0, 0, 1}};
  EXPECT_TRUE(check_cells(points, {{1, 2, 3}}, true).passed());
  EXPECT_EQ(check_cells(points, {{1, 2, 3}}).hidden, 1U);
  EXPECT_EQ(first_line(check_cells(points, {{0, 1, 2}})), "row 3 is heavier than the vertex at its position, row 0");
}

TEST(Check, malformed_tables_are_named_and_go_no_further) {
  const Points points{"square", 2, {0, 0, 1, 0, 0, 1, 1, 1}, {}};
  const auto complaint = [&](const CellTable& cells) { return first_line(check(points.view(), cells)); };
  EXPECT_EQ(complaint(table({{0, 1, 4}})), "cell 0 names row 4, but there are only 4 rows");
  EXPECT_EQ(complaint(table({{0, 1, 3}, {0, 2, 0}})), "cell 1 names row 0 twice");
  EXPECT_EQ(complaint(table({{0, 1}})), "cells have 2 corners, but points of affine dimension 2 have cells of 3");
  EXPECT_EQ(complaint(CellTable{3, {0, 1, 3, 0}, {}}), "the last cell is incomplete");
  EXPECT_EQ(complaint({}), "there are no cells");
}

TEST(Check, points_that_are_not_finite_are_refused) {
  const std::vector<double> points{0, 1, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(check(PointsView(points, 1), {}), InputError);
}

// --- Large inputs: chunks, threads and walks. ---

/// side x side points; canonical triangles: each square is cut from its lexicographically smallest corner.
Points grid(std::size_t side) {
  Points points{"grid", 2, {}, {}};
  for (std::size_t i = 0; i < side * side; ++i) {
    points.coordinates.push_back(static_cast<double>(i / side) / 8);
    points.coordinates.push_back(static_cast<double>(i % side) / 8);
  }
  return points;
}

Cells grid_cells(std::size_t side, std::size_t step = 1) {
  Cells cells;
  const auto row = [&](std::size_t x, std::size_t y) { return static_cast<Index>(x * side + y); };
  for (std::size_t x = 0; x + step < side; x += step) {
    for (std::size_t y = 0; y + step < side; y += step) {
      cells.push_back({row(x, y), row(x + step, y), row(x + step, y + step)});
      cells.push_back({row(x, y), row(x, y + step), row(x + step, y + step)});
    }
  }
  return cells;
}

TEST(Check, reports_do_not_depend_on_the_number_of_threads) {
  Cells cells = grid_cells(101);
  EXPECT_TRUE(check_cells(grid(101), cells, true).passed());
  for (std::size_t i = 0; i < cells.size(); i += 500) cells[i] = {cells[i][0], cells[i][1], cells[i + 1][1]};
  const CheckReport one = check(grid(101).view(), table(cells), {.threads = 1});
  EXPECT_GT(one.violation_count, one.violations.size());
  EXPECT_EQ(one.violations.size(), 10U);
  for (const int threads : {2, 3, 8}) {
    const CheckReport many = check(grid(101).view(), table(cells), {.threads = threads});
    EXPECT_EQ(many.violations, one.violations);
    EXPECT_EQ(many.violation_count, one.violation_count);
  }
}

TEST(Check, many_hidden_points_are_located_and_tested) {
  Points points = grid(101);  // only every fourth row and column lives
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool lives = i / 101 % 4 == 0 && i % 101 % 4 == 0;
    points.weights.push_back(lives ? 0.0 : -1.0);
  }
  const Cells cells = grid_cells(101, 4);
  const CheckReport report = check_cells(points, cells, true);
  EXPECT_TRUE(report.passed()) << first_line(report);
  EXPECT_EQ(report.hidden, points.size() - 26 * 26);
  points.weights[101 * 50 + 51] = 0.0;
  EXPECT_EQ(check_cells(points, cells).violation_count, 1U);
}

}  // namespace
}  // namespace delone
