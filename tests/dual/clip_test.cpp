#include "delone/dual/clip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "delone/build/build.hpp"
#include "delone/dual/voronoi.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

double sum(const std::vector<double>& numbers) { return std::accumulate(numbers.begin(), numbers.end(), 0.0); }

/// The bounding box of points, larger by a share of its longest side; a negative share cuts cells off everywhere.
Region box_around(PointsView points, double share) {
  const auto d = static_cast<std::size_t>(points.dimension());
  std::vector<double> low(d, INFINITY), high(d, -INFINITY);
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      low[axis] = std::min(low[axis], points[row][axis]);
      high[axis] = std::max(high[axis], points[row][axis]);
    }
  }
  double longest = 0;
  for (std::size_t axis = 0; axis < d; ++axis) longest = std::max(longest, high[axis] - low[axis]);
  for (std::size_t axis = 0; axis < d; ++axis) {
    const double margin = longest > 0 ? share * longest : 1;
    const double least = high[axis] - low[axis] + 2 * margin > 0.01 * longest ? margin : longest;
    low[axis] -= least;
    high[axis] += least;
  }
  return Region::box(low, high);
}

/// A region of the plane with a hole, an island in it and another part: a window of the box around points.
Region holes_in(PointsView points) {
  const Region box = box_around(points, 0.1);
  const auto at = [&](double x, double y) {
    return std::array{std::lerp(box.low()[0], box.high()[0], x), std::lerp(box.low()[1], box.high()[1], y)};
  };
  return Region::polygon({{at(0.03, 0.02), at(0.97, 0.1), at(0.71, 0.5), at(0.9, 0.9), at(0.5, 0.6), at(0.1, 0.95)},
                          {at(0.3, 0.3), at(0.5, 0.33), at(0.45, 0.55), at(0.21, 0.5)},
                          {at(0.35, 0.4), at(0.42, 0.41), at(0.4, 0.45)},
                          {at(0.93, 0.4), at(0.99, 0.6), at(0.91, 0.7)}});
}

Region octagon_in(PointsView points) {
  const Region box = box_around(points, 0.1);
  std::vector<HalfSpace> sides = box.sides();
  const double radius = (box.high()[0] - box.low()[0]) / 2 + (box.high()[1] - box.low()[1]) / 2;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const double middle = x * (box.low()[0] / 2 + box.high()[0] / 2) + y * (box.low()[1] / 2 + box.high()[1] / 2);
      sides.push_back(
          {{x, y, points.dimension() == 3 ? 0.25 : 0},
           middle + 0.7 * radius + (points.dimension() == 3 ? 0.25 * (box.low()[2] / 2 + box.high()[2] / 2) : 0)});
    }
  }
  return Region::half_spaces(points.dimension(), sides);
}

std::vector<Region> regions_for(PointsView points) {
  std::vector<Region> regions{box_around(points, 0.1), box_around(points, -0.2), octagon_in(points)};
  if (points.dimension() == 2) regions.push_back(holes_in(points));
  return regions;
}

/// Sets whose numbers are neither so large nor so small that areas are none.
bool measurable(const test::PointSet& points) {
  return std::ranges::all_of(points.coordinates,
                             [](double x) { return std::abs(x) < 1e60 && (x == 0 || std::abs(x) > 1e-60); });
}

void expect_consistent(const test::PointSet& points, const AnyTriangulation& t, const Region& region) {
  const CellMeasures cells = measure_cells(t, region);
  ASSERT_EQ(cells.size(), points.size());
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) longest = std::max(longest, region.high()[axis] - region.low()[axis]);
  // Sites may differ by as little as 1e-16 of the region: then borders are as ill-defined as that.
  const double rounding = 1e-7 * std::pow(longest, points.dimension - 1);
  EXPECT_NEAR(sum(cells.volume), region.measure(), 1e-12 * region.measure()) << points;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Index row = static_cast<Index>(i);
    EXPECT_GE(cells.volume[i], 0) << points << i;
    EXPECT_TRUE(cells.volume[i] == 0 || t.status(row).status == Status::vertex) << points << i;
    double shared = cells.boundary[i];
    for (std::size_t e = cells.offsets[i]; e < cells.offsets[i + 1]; ++e) {
      EXPECT_GT(cells.shared[e], 0);
      shared += cells.shared[e];
      const Index j = cells.neighbours[e];
      const auto begin = cells.neighbours.begin() + static_cast<std::ptrdiff_t>(cells.offsets[j]);
      const auto end = cells.neighbours.begin() + static_cast<std::ptrdiff_t>(cells.offsets[j + std::size_t{1}]);
      const auto back = std::lower_bound(begin, end, row);
      ASSERT_TRUE(back != end && *back == row) << points << i << " " << j;
      EXPECT_NEAR(cells.shared[static_cast<std::size_t>(back - cells.neighbours.begin())], cells.shared[e], rounding)
          << points;
    }
    EXPECT_NEAR(shared, cells.surface[i], rounding) << points << i;
  }
}

TEST(Cells, sum_to_the_region_and_share_their_borders) {
  for (const int d : {2, 3}) {
    for (const auto& points : test::families(d, 40, 5)) {
      if (!measurable(points)) continue;
      const AnyTriangulation t = test::built(points);
      for (const Region& region : regions_for(points.view())) expect_consistent(points, t, region);
    }
  }
}

/// Every cell as what the bisectors with all other sites leave.
CellMeasures by_all_bisectors(PointsView points, const Region& region) {
  std::vector<std::size_t> offsets{0};
  std::vector<Bisector> cuts;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i != j) cuts.push_back({static_cast<Index>(i), static_cast<Index>(j), static_cast<Index>(j)});
    }
    offsets.push_back(cuts.size());
  }
  return measure_shapes(cut_cells(points, region, offsets, cuts), points);
}

TEST(Cells, measure_as_what_all_bisectors_leave) {
  for (const int d : {2, 3}) {
    for (auto points : {test::uniform(d, 30, 8), test::with_random_weights(test::uniform(d, 30, 9), 1)}) {
      const AnyTriangulation t = test::built(points);
      for (const Region& region : regions_for(points.view())) {
        const CellMeasures fast = measure_cells(t, region);
        const CellMeasures slow = by_all_bisectors(points.view(), region);
        for (std::size_t i = 0; i < points.size(); ++i) {
          EXPECT_NEAR(fast.volume[i], slow.volume[i], 1e-13) << points;
          EXPECT_NEAR(fast.surface[i], slow.surface[i], 1e-12) << points;
          EXPECT_NEAR(fast.boundary[i], slow.boundary[i], 1e-12) << points;
          EXPECT_NEAR(fast.second_moment[i], slow.second_moment[i], 1e-13) << points;
          EXPECT_EQ(fast.offsets[i + 1] - fast.offsets[i], slow.offsets[i + 1] - slow.offsets[i]) << points << i;
        }
      }
    }
  }
}

/// What hyperplanes leave of a box around points, so many that they do not fit into a word of bits.
Region cut_by_many(PointsView points) {
  const Region box = box_around(points, 0.1);
  std::vector<HalfSpace> sides = box.sides();
  std::array<double, 3> middle{};
  double radius = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    middle[axis] = box.low()[axis] / 2 + box.high()[axis] / 2;
    radius = std::max(radius, box.high()[axis] / 2 - box.low()[axis] / 2);
  }
  for (int i = 0; i < 70; ++i) {
    const double turn = i * std::numbers::phi * 2 * std::numbers::pi;
    const double z = points.dimension() == 3 ? (i + 0.5) / 35 - 1 : 0;
    const double r = std::sqrt(1 - z * z);
    const std::array<double, 3> normal{r * std::cos(turn), r * std::sin(turn), z};
    sides.push_back({normal, std::inner_product(normal.begin(), normal.end(), middle.begin(), 0.9 * radius)});
  }
  return Region::half_spaces(points.dimension(), sides);
}

TEST(Cells, measure_as_their_shapes) {
  for (const int d : {2, 3}) {
    std::vector<test::PointSet> sets = test::families(d, 60, 11);
    sets.push_back(test::with_random_weights(test::uniform(d, 300, 12), 5));
    sets.push_back(test::uniform(d, 3000, 13));
    for (const auto& points : sets) {
      if (!measurable(points)) continue;
      const AnyTriangulation t = test::built(points);
      for (const Region& region : {box_around(points.view(), 0.1), box_around(points.view(), -0.2),
                                   octagon_in(points.view()), cut_by_many(points.view())}) {
        const CellMeasures cells = measure_cells(t, region);
        double longest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
          longest = std::max(longest, region.high()[axis] - region.low()[axis]);
        const double rounding = 1e-13 * std::pow(longest, d);
        for_cells(t, region, [&](const CellShapes& shapes, const CellMeasures& some) {
          for (std::size_t cell = 0; cell < some.size(); ++cell) {
            const std::size_t i = shapes.rows[cell];
            EXPECT_NEAR(cells.volume[i], some.volume[cell], rounding) << points << i;
            EXPECT_NEAR(cells.second_moment[i], some.second_moment[cell], rounding * longest * longest) << points << i;
            EXPECT_NEAR(cells.surface[i], some.surface[cell], 1e-7 * std::pow(longest, d - 1)) << points << i;
            EXPECT_NEAR(cells.boundary[i], some.boundary[cell], 1e-7 * std::pow(longest, d - 1)) << points << i;
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(d); ++axis) {
              const std::size_t at = static_cast<std::size_t>(d) * i + axis;
              const double off = cells.centroid[at] - some.centroid[static_cast<std::size_t>(d) * cell + axis];
              EXPECT_NEAR(cells.volume[i] * off, 0, rounding * longest) << points << i;
            }
          }
        });
      }
    }
  }
}

TEST(Cells, of_a_grid_are_squares_and_cubes_whatever_the_ties) {
  for (const int d : {2, 3}) {
    test::PointSet points{"grid", d, {}};
    for (int i = 0; i < (d == 2 ? 36 : 216); ++i) {
      for (int axis = 0, rest = i; axis < d; ++axis, rest /= 6) points.coordinates.push_back(rest % 6 + 1e6);
    }
    const AnyTriangulation t = test::built(points);
    const std::vector<double> low(static_cast<std::size_t>(d), 1e6 - 0.5), high(static_cast<std::size_t>(d), 1e6 + 5.5);
    const CellMeasures cells = measure_cells(t, Region::box(low, high));
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(cells.volume[i], 1, 1e-15);
      EXPECT_NEAR(cells.surface[i], 2 * d, 1e-15);
      EXPECT_NEAR(cells.second_moment[i], d / 12.0, 1e-15);
      const double neighbours = 2 * d - cells.boundary[i];
      EXPECT_EQ(static_cast<double>(cells.offsets[i + 1] - cells.offsets[i]), neighbours);
      for (int axis = 0; axis < d; ++axis) {
        const std::size_t at = i * static_cast<std::size_t>(d) + static_cast<std::size_t>(axis);
        EXPECT_EQ(cells.centroid[at], points.coordinates[at]);
      }
    }
  }
}

/// Whether x lies in the polygon of a cell, holes taken out.
bool holds(const CellShapes& shapes, std::size_t cell, double x, double y) {
  bool inside = false;
  for (std::size_t l = shapes.cells[cell]; l < shapes.cells[cell + 1]; ++l) {
    for (std::size_t i = shapes.loops[l]; i < shapes.loops[l + 1]; ++i) {
      const std::size_t j = i + 1 == shapes.loops[l + 1] ? shapes.loops[l] : i + 1;
      const double ax = shapes.corners[2 * i], ay = shapes.corners[2 * i + 1];
      const double bx = shapes.corners[2 * j], by = shapes.corners[2 * j + 1];
      if ((ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) inside = !inside;
    }
  }
  return inside;
}

TEST(Cells, the_nearest_site_owns_the_cell_of_a_random_place) {
  test::Random random(2);
  for (auto points :
       {test::uniform(2, 50, 8), test::with_random_weights(test::uniform(2, 50, 9), 1), test::lattice(2, 50, 5, 3)}) {
    const AnyTriangulation t = test::built(points);
    const Region region = holes_in(points.view());
    const CellShapes whole = clipped_cells(t, box_around(points.view(), 0.1));
    const CellShapes shapes = clipped_cells(t, region);
    CellShapes outline;  // the region as one cell
    for (const Ring& ring : region.rings()) {
      for (const auto& corner : ring) outline.corners.insert(outline.corners.end(), corner.begin(), corner.end());
      outline.loops.push_back(outline.corners.size() / 2);
    }
    outline.cells.push_back(outline.loops.size() - 1);
    for (int round = 0; round < 300; ++round) {
      const double x = std::lerp(region.low()[0], region.high()[0], test::unit_random(random));
      const double y = std::lerp(region.low()[1], region.high()[1], test::unit_random(random));
      double best = INFINITY;
      std::size_t owner = 0;
      for (std::size_t row = 0; row < points.size(); ++row) {
        const double power =
            std::pow(x - points.view()[row][0], 2) + std::pow(y - points.view()[row][1], 2) - points.view().weight(row);
        if (power < best) {
          best = power;
          owner = row;
        }
      }
      for (std::size_t row = 0; row < points.size(); ++row) {
        EXPECT_EQ(holds(whole, row, x, y), row == owner) << points << x << " " << y;
        EXPECT_EQ(holds(shapes, row, x, y), row == owner && holds(outline, 0, x, y)) << points << x << " " << y;
      }
    }
  }
}

TEST(Cells, contain_their_sites_when_weights_are_equal) {
  const test::PointSet points = test::uniform(2, 200, 3);
  const AnyTriangulation t = test::built(points);
  const CellShapes shapes = clipped_cells(t, box_around(points.view(), 0.05));
  for (std::size_t row = 0; row < points.size(); ++row)
    EXPECT_TRUE(holds(shapes, row, points.coordinates[2 * row], points.coordinates[2 * row + 1]));
}

TEST(Cells, have_the_mean_number_of_neighbours_of_random_points) {
  for (const auto& [d, expected, error] : {std::tuple{2, 6.0, 0.02}, {3, 15.54, 0.35}}) {
    const test::PointSet points = test::uniform(d, 20000, 3);
    const AnyTriangulation t = test::built(points);
    const CellMeasures cells = measure_cells(t, box_around(points.view(), 0), {.threads = 2});
    double inner = 0, neighbours = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (cells.boundary[i] > 0) continue;
      ++inner;
      neighbours += static_cast<double>(cells.offsets[i + 1] - cells.offsets[i]);
    }
    EXPECT_NEAR(neighbours / inner, expected, error);
  }
}

TEST(Cells, are_cut_into_pieces_by_a_region_that_is_not_convex) {
  const test::PointSet points{"pair", 2, {0, 0, 0, 10}};
  const AnyTriangulation t = test::built(points);
  // A comb that stands on the bisector y = 5: two teeth reach down.
  const Region comb = Region::polygon({{{-3, 6}, {-3, 3}, {-2, 3}, {-2, 5.5}, {2, 5.5}, {2, 3}, {3, 3}, {3, 6}}});
  const CellShapes shapes = clipped_cells(t, comb);
  EXPECT_EQ(shapes.cells, (std::vector<std::size_t>{0, 2, 3}));
  const CellMeasures cells = measure_cells(t, comb);
  EXPECT_EQ(cells.volume, (std::vector<double>{4, 4}));
  EXPECT_EQ(cells.shared, (std::vector<double>{2, 2}));
  EXPECT_EQ(cells.boundary, (std::vector<double>{10, 13}));
}

TEST(Cells, without_end_reach_over_sides_that_none_of_their_facets_does) {
  for (const double height : {1.0, 10.0, 100.0}) {
    test::PointSet points{"sharp", 3, {0, 0, height}};
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * std::numbers::pi * i / 3;
      points.coordinates.insert(points.coordinates.end(), {std::cos(angle), std::sin(angle), -height});
    }
    const std::vector<double> low{-1, -1, -1}, high{1, 1, 1};
    expect_consistent(points, test::built(points), Region::box(low, high));
  }
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const test::PointSet points = test::uniform(seed % 2 == 0 ? 3 : 2, 4 + seed % 3, seed);
    for (const Region& region : regions_for(points.view())) expect_consistent(points, test::built(points), region);
  }
}

TEST(Cells, whose_holes_touch_their_border_keep_them) {
  const Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const test::PointSet one{"one", 2, {1, 1}};
  EXPECT_DOUBLE_EQ(measure_cells(test::built(one), Region::polygon({square, {{4, 4}, {3, 2}, {2, 3}}})).volume[0],
                   14.5);
  const test::PointSet three{"three", 2, {-1, 0.1, 1, 0.1, 0, -50}};  // a bisector runs along the hole
  const Region region = Region::polygon({{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {{0, 1}, {0, 0}, {-1, 0}, {-1, 1}}});
  EXPECT_DOUBLE_EQ(sum(measure_cells(test::built(three), region).volume), 15);
}

TEST(Cells, that_end_where_the_region_does_have_no_neighbour_there) {
  for (const int d : {2, 3}) {
    test::PointSet points{"grid", d, {}};
    for (int i = 0; i < (d == 2 ? 36 : 216); ++i) {
      for (int axis = 0, rest = i; axis < d; ++axis, rest /= 6) points.coordinates.push_back(rest % 6);
    }
    const AnyTriangulation t = test::built(points);
    const std::vector<double> low(static_cast<std::size_t>(d), 0.5), high(static_cast<std::size_t>(d), 3.5);
    const Region box = Region::box(low, high);  // three sites a side, bisectors along all sides
    expect_consistent(points, t, box);
    const CellMeasures cells = measure_cells(t, box);
    EXPECT_NEAR(sum(cells.boundary), d == 2 ? 12 : 54, 1e-12);
    EXPECT_EQ(cells.neighbours.size(), d == 2 ? 24U : 108U);
    // Cells that reach over one side and end at another.
    const std::vector<double> cut{3.5, 3.3, 3.2};
    const Region part = Region::box(low, std::span(cut).first(static_cast<std::size_t>(d)));
    expect_consistent(points, t, part);
    EXPECT_EQ(measure_cells(t, part).neighbours.size(), d == 2 ? 24U : 108U);
  }
}

TEST(Cells, of_far_sites_sum_to_the_region) {
  for (const int d : {2, 3}) {
    for (const double far : {1e3, 1e6, 1e9}) {
      test::PointSet points = test::uniform(d, 200, 3);
      for (std::size_t i = 0; i < points.size(); ++i) {
        double squared = 0;
        for (int axis = 0; axis < d; ++axis) {
          double& x = points.coordinates[i * static_cast<std::size_t>(d) + static_cast<std::size_t>(axis)];
          x -= 0.5;
          squared += x * x;
        }
        for (int axis = 0; axis < d; ++axis)
          points.coordinates[i * static_cast<std::size_t>(d) + static_cast<std::size_t>(axis)] *=
              far / std::sqrt(squared);
      }
      const std::vector<double> low(static_cast<std::size_t>(d), -1.0), high(static_cast<std::size_t>(d), 1.0);
      const Region box = Region::box(low, high);
      EXPECT_NEAR(sum(measure_cells(test::built(points), box).volume) / box.measure(), 1, 1e-11) << d << " " << far;
      if (d == 3) continue;
      const Region notched = Region::polygon({{{-1, -1}, {1, -1}, {1, 1}, {0, 0.2}, {-1, 1}}});
      EXPECT_NEAR(sum(measure_cells(test::built(points), notched).volume) / notched.measure(), 1, 1e-11) << far;
    }
  }
}

TEST(Cells, keep_holes_after_their_pieces) {
  const test::PointSet points{"one", 2, {0, 0}};
  const AnyTriangulation t = test::built(points);
  const Ring left{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, right{{6, 0}, {10, 0}, {10, 4}, {6, 4}};
  const Ring hole{{7, 1}, {8, 1}, {8, 2}};
  const CellShapes shapes = clipped_cells(t, Region::polygon({hole, left, right}));
  ASSERT_EQ(shapes.cells, (std::vector<std::size_t>{0, 3}));
  std::vector<double> first_corners;
  for (std::size_t l = 0; l < 3; ++l) first_corners.push_back(shapes.corners[2 * shapes.loops[l]]);
  EXPECT_EQ(first_corners, (std::vector<double>{0, 6, 8}));
}

TEST(Cells, have_digits_in_every_unit) {
  for (const double unit : {1e-150, 1e-30, 1.0, 1e30, 1e150}) {
    test::PointSet points = test::uniform(2, 50, 3);
    for (double& x : points.coordinates) x *= unit;
    const AnyTriangulation t = test::built(points);
    const Region region = box_around(points.view(), 0.1);
    const CellMeasures cells = measure_cells(t, region);
    EXPECT_NEAR(sum(cells.volume) / region.measure(), 1, 1e-13) << unit;
    EXPECT_GT(cells.neighbours.size(), 200U);
  }
}

TEST(Cells, do_not_depend_on_threads) {
  for (const int d : {2, 3}) {
    for (const auto& points : {test::uniform(d, 20000, 3), test::lattice(d, 12000, d == 2 ? 110 : 23, 3)}) {
      const AnyTriangulation t = test::built(points);
      const Region region = box_around(points.view(), -0.05);
      const CellMeasures one = measure_cells(t, region);
      const CellMeasures three = measure_cells(t, region, {.threads = 3});
      EXPECT_EQ(one.volume, three.volume);
      EXPECT_EQ(one.surface, three.surface);
      EXPECT_EQ(one.boundary, three.boundary);
      EXPECT_EQ(one.centroid, three.centroid);
      EXPECT_EQ(one.second_moment, three.second_moment);
      EXPECT_EQ(one.neighbours, three.neighbours);
      EXPECT_EQ(one.shared, three.shared);
    }
  }
}

/// Two poles that share a facet with as many corners as there are sites on a circle between them.
TEST(Cells, share_a_facet_of_many_corners) {
  constexpr std::size_t kOnCircle = 20000;
  test::PointSet points{"poles", 3, {0, 0, 1, 0, 0, -1}};
  for (std::size_t i = 0; i < kOnCircle; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kOnCircle);
    points.coordinates.insert(points.coordinates.end(), {3 * std::cos(turn), 3 * std::sin(turn), 0});
  }
  for (const double x : {-9.0, 9.0}) {
    for (const double y : {-9.0, 9.0}) {
      for (const double z : {-9.0, 9.0}) points.coordinates.insert(points.coordinates.end(), {x, y, z});
    }
  }
  const AnyTriangulation t = test::built(points);
  const CellMeasures cells = measure_cells(t, box_around(points.view(), 0), {.threads = 2});
  EXPECT_NEAR(sum(cells.volume), 18.0 * 18 * 18, 1e-9);
  EXPECT_EQ(cells.neighbours[0], 1U);
  EXPECT_NEAR(cells.shared[0], std::numbers::pi * std::pow(4.0 / 3, 2), 1e-3);
}

TEST(Cells, tell_how_far_they_are_once) {
  for (const int d : {2, 3}) {
    const test::PointSet points = test::uniform(d, 20000, 3);
    double last = 0;
    const auto rises = [&](double done) {
      EXPECT_GE(done, last);
      EXPECT_LE(done, 1);
      last = done;
      return true;
    };
    measure_cells(test::built(points), box_around(points.view(), -0.05), {.progress = rises});
    EXPECT_GT(last, 0.8);
  }
}

TEST(Cells, in_blocks_are_the_same_and_threads_change_nothing) {
  const test::PointSet points = test::uniform(2, 10000, 3);
  const AnyTriangulation t = test::built(points);
  const Region region = holes_in(points.view());
  const CellMeasures all = measure_cells(t, region);
  const CellMeasures threaded = measure_cells(t, region, {.threads = 3});
  EXPECT_EQ(all.volume, threaded.volume);
  EXPECT_EQ(all.neighbours, threaded.neighbours);
  EXPECT_EQ(all.shared, threaded.shared);
  const CellShapes shapes = clipped_cells(t, region, {.threads = 3});
  EXPECT_EQ(measure_shapes(shapes, points.view()).neighbours, all.neighbours);
  std::vector<double> volume(points.size());
  std::size_t blocks = 0;
  for_cells(t, region,
            [&](const CellShapes& some, const CellMeasures& measures) {
              ++blocks;
              EXPECT_EQ(some.size(), measures.size());
              for (std::size_t cell = 0; cell < some.size(); ++cell) volume[some.rows[cell]] = measures.volume[cell];
            },
            {.threads = 2});
  EXPECT_GT(blocks, 1U);
  EXPECT_EQ(volume, all.volume);
}

TEST(Cells, vanish_with_removed_rows) {
  const test::PointSet points = test::uniform(2, 30, 3);
  AnyTriangulation t = test::built(points);
  const Region region = box_around(points.view(), 0.1);
  EXPECT_THAT(
      [&] {
        measure_cells(t, Region::box(std::vector<double>{0, 0, 0}, std::vector<double>{1, 1, 1}));
      },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("dimension 2 in a region of dimension 3")));
  EXPECT_THROW(measure_cells(t, region, {.progress = [](double) { return false; }}), Cancelled);
}

}  // namespace
}  // namespace delone
