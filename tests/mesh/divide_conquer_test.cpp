#include "mesh/divide_conquer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/export.hpp"
#include "delone/order/brio.hpp"
#include "mesh/plane_cuts.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// The same points by the incremental method, which takes weights, here all alike.
std::uint64_t incremental_hash(const PointSet& points) {
  return canonical_hash(build(PointsView(points.coordinates, 2, std::vector<double>(points.size(), 1.0))));
}

/// By divide and conquer, however few the points are.
AnyTriangulation divided(const PointSet& points) { return build(points.view(), {.method = Method::divide_conquer}); }

void expect_incremental(const PointSet& points) {
  const AnyTriangulation t = divided(points);
  EXPECT_EQ(broken_invariant(t), "") << points;
  EXPECT_EQ(canonical_hash(t), incremental_hash(points)) << points;
}

TEST(DivideConquer, agrees_with_the_incremental_method_on_every_family) {
  for (std::size_t n = 3; n < 60; ++n) {
    for (const PointSet& points : unweighted_families(2, n, n)) expect_incremental(points);
  }
  for (const PointSet& points : unweighted_families(2, 3000, 1)) expect_incremental(points);
}

/// Every way in which three or four sites may lie: three on a line with one beside it, on circles, one inside a
/// triangle.
TEST(DivideConquer, agrees_on_every_few_places_of_a_lattice) {
  for (unsigned chosen = 0; chosen < 1U << 16; ++chosen) {
    if (std::popcount(chosen) < 3 || std::popcount(chosen) > 4) continue;
    PointSet points{"few", 2, {}, {}};
    for (unsigned place = 0; place < 16; ++place) {
      if ((chosen >> place & 1) == 0) continue;
      points.coordinates.insert(points.coordinates.end(), {place % 4 * 1.0, place / 4 * 1.0});
    }
    expect_incremental(points);
  }
}

TEST(DivideConquer, three_sites_make_no_cell_in_vain) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const PointSet points = uniform(2, 3, seed);
    expect_incremental(points);
    EXPECT_EQ(divided(points).statistics().cells_created, 4U) << points;
  }
}

/// Among others, too: what is made of two threes far from each other is their cells, those between them, and two
/// ghosts.
TEST(DivideConquer, boxes_of_three_sites_are_found_among_others) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    PointSet points = uniform(2, 6, seed);
    for (std::size_t i = 0; i < 3; ++i) points.coordinates[2 * i + seed % 2] += 100.0;
    const AnyTriangulation t = divided(points);
    expect_incremental(points);
    EXPECT_EQ(t.statistics().cells_created, 4 + 4 + (t.cell_count() - 2) + 2) << points;
  }
}

TEST(DivideConquer, pieces_are_for_a_cache_and_of_chains_long) {
  EXPECT_EQ(piece_size(100000000, false), 1U << 13);
  EXPECT_EQ(piece_size(1000, true), 1U << 13);
  EXPECT_EQ(piece_size(3200000, true), 100000U);
  EXPECT_EQ(piece_size(100000000, true), 1U << 17);
}

TEST(DivideConquer, agrees_on_points_that_crowd_deeper_and_deeper) {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    PointSet points{"crowd", 2, {}, {}};
    for (int i = 0; i < 400; ++i) points.coordinates.push_back(std::ldexp(unit_random(random) - 0.5, -i * (round % 5)));
    expect_incremental(points);
  }
}

TEST(DivideConquer, agrees_on_two_lines_across_which_every_edge_of_a_part_goes) {
  PointSet points{"two lines", 2, {}, {}};
  for (int i = 0; i < 300; ++i) {
    points.coordinates.insert(points.coordinates.end(), {0.0, i * 1.0});
    points.coordinates.insert(points.coordinates.end(), {0.01, i + 0.5});
  }
  expect_incremental(points);
}

/// At random angles on an ellipse whose long axis is `axis`, or in a band of this width beside it.
PointSet around_ellipse(std::size_t n, std::size_t axis, double width) {
  PointSet points{"ellipse", 2, {}, {}};
  Random random(11);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * unit_random(random);
    std::array<double, 2> p;
    p[axis] = std::cos(angle) + width * unit_random(random);
    p[1 - axis] = 0.5 * std::sin(angle) + width * unit_random(random);
    points.coordinates.insert(points.coordinates.end(), p.begin(), p.end());
  }
  return points;
}

PointSet turned_ellipse(std::size_t n) {
  PointSet points = around_ellipse(n, 0, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    double& x = points.coordinates[2 * i];
    double& y = points.coordinates[2 * i + 1];
    std::tie(x, y) = std::pair(0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y);
  }
  return points;
}
PointSet ellipse_and_area(std::size_t n) {
  PointSet points = around_ellipse(n, 0, 0.0);
  Random random(12);
  for (std::size_t i = 0; i < n; i += 20) {
    points.coordinates[2 * i] = unit_random(random);
    points.coordinates[2 * i + 1] = 0.5 * unit_random(random);
  }
  return points;
}

TEST(DivideConquer, cells_do_not_depend_on_the_number_of_threads) {
  for (const PointSet& points : {uniform(2, 60000, 1), lattice(2, 60000, 250, 2), circle_of_24_bits(2, 40000, 3),
                                 around_ellipse(60000, 1, 0.0), ellipse_and_area(60000), turned_ellipse(60000)}) {
    const AnyTriangulation one = build(points.view(), {.threads = 1});
    const AnyTriangulation many = build(points.view(), {.threads = 3});
    ASSERT_EQ(one.complex().slot_count(), many.complex().slot_count());
    bool same = true;
    for (std::size_t s = 0; s < one.complex().slot_count(); ++s) {
      const CellId c{static_cast<Index>(s)};
      for (int i = 0; i < 3; ++i) {
        same &= one.complex().vertex(c, i) == many.complex().vertex(c, i);
        same &= one.complex().twin(c, i) == many.complex().twin(c, i);
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const VertexId v{static_cast<Index>(i)};
      same &= one.complex().incident_cell(v) == many.complex().incident_cell(v);
    }
    EXPECT_TRUE(same) << points.name;
    EXPECT_EQ(broken_invariant(many), "") << points.name;
    EXPECT_EQ(description(one), description(many)) << points.name;
  }
}

/// Of points that span the plane, one at a time along the boxes of their curve, or in chains.
AnyTriangulation divided(const PointSet& points, bool in_chains, std::size_t piece) {
  const AffineHull hull = affine_hull(points.view());
  const CurveCuts cuts = curve_cuts(points.view(), std::span(hull.flat.axes).first(2));
  Mesh mesh(Sites(2, false, hull.flat));
  mesh.sites.append(points.view(), cuts.order, 0, 1);
  divide_and_conquer(mesh, {cuts.cut.data(), cuts.cut.size()}, in_chains, 2, {}, piece);
  return AnyTriangulation(std::move(mesh));
}

/// Many merges side by side, and seams that leave vertices no cell of their own piece.
TEST(DivideConquer, small_pieces_lead_to_the_same) {
  for (const PointSet& points : unweighted_families(2, 2000, 4)) {
    if (affine_hull(points.view()).flat.dimension != 2) continue;
    for (const std::size_t piece : {1U, 3U, 50U}) {
      const AnyTriangulation t = divided(points, false, piece);
      EXPECT_EQ(broken_invariant(t), "") << points << ", " << piece;
      EXPECT_EQ(description(t), description(divided(points))) << points << ", " << piece;
    }
  }
}

TEST(DivideConquer, chains_lead_to_the_same) {
  for (const std::size_t n : {40U, 500U, 3000U}) {
    for (const PointSet& points : unweighted_families(2, n, 5)) {
      if (affine_hull(points.view()).flat.dimension != 2) continue;
      for (const std::size_t piece : {40U, 1000U}) {
        const AnyTriangulation t = divided(points, true, piece);
        EXPECT_EQ(broken_invariant(t), "") << points << ", " << piece;
        EXPECT_EQ(canonical_hash(t), incremental_hash(points)) << points << ", " << piece;
      }
    }
  }
}

/// That bend to either side, more and more or less and less, so that they are knit from either end; with steps, ties,
/// equal points, points beside them, and so far from the origin that most are cocircular or collinear by rounding; and
/// so large that no filter serves, or so small that squares vanish.
TEST(DivideConquer, every_kind_of_chain_is_knit_as_its_points_are) {
  Random random(17);
  int knit = 0;
  for (int round = 0; round < 400; ++round) {
    PointSet points{"chain " + std::to_string(round), 2, {}, {}};
    const double bend = (round % 2 == 0 ? 1.0 : -1.0) * std::ldexp(1.0, -(round % 7) * 4);
    const double slope = unit_random(random) - 0.5;
    const double far = round % 5 == 0 ? 0x1p40 : (round % 5 == 1 ? 0x1p20 : 0.0);
    const double scale = round % 11 == 0 ? 0x1p900 : (round % 11 == 1 ? 0x1p-600 : 1.0);
    const bool steps = round % 3 == 0;
    const std::size_t count = 33 + static_cast<std::size_t>(round) % 300;
    for (std::size_t i = 0; i < count; ++i) {
      double x = unit_random(random);
      if (steps) x = std::round(x * 100.0) / 100.0;
      double y = slope * x + bend * (round % 4 < 2 ? x * x * x : (1 - x) * (1 - x) * x) + far;
      if (i % 40 == 39) y += 0.02 * unit_random(random);
      if (round % 2 == 0) std::swap(x, y);
      points.coordinates.insert(points.coordinates.end(), {x * scale, y * scale});
    }
    if (affine_hull(points.view()).flat.dimension != 2) continue;
    const AnyTriangulation t = divided(points, true, 1000);
    EXPECT_EQ(broken_invariant(t), "") << points;
    EXPECT_EQ(canonical_hash(t), incremental_hash(points)) << points;
    knit += t.statistics().cells_created < divided(points, false, 1000).statistics().cells_created ? 1 : 0;
  }
  EXPECT_GT(knit, 200);
}

/// Boxes would make 20 cells a point, strips along the curve 26.
TEST(DivideConquer, points_on_a_curve_are_cut_into_strips_across_it) {
  constexpr std::size_t kCount = 20000;
  for (const std::size_t axis : {0U, 1U}) {
    const PointSet points = around_ellipse(kCount, axis, 0.0);
    expect_incremental(points);
    EXPECT_LT(divided(points).statistics().cells_created, 5 * kCount);
    PointSet lifted{"in space", 3, {}, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto p = points.view()[i];
      lifted.coordinates.insert(lifted.coordinates.end(), {7.0, p[0], p[1]});
    }
    EXPECT_LT(built(lifted).statistics().cells_created, 5 * kCount);
  }
}

/// By halves 20 cells a point.
TEST(DivideConquer, pieces_of_a_turned_curve_are_knit_as_chains) {
  constexpr std::size_t kCount = 20000;
  const PointSet points = turned_ellipse(kCount);
  expect_incremental(points);
  EXPECT_LT(divided(points).statistics().cells_created, 12 * kCount);
  PointSet tilted{"in space", 3, {}, {}};
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto p = points.view()[i];
    tilted.coordinates.insert(tilted.coordinates.end(), {p[0], p[1], 2.0 * p[0]});
  }
  const AnyTriangulation t = built(tilted);
  EXPECT_EQ(t.affine_dimension(), 2);
  EXPECT_LT(t.statistics().cells_created, 12 * kCount);
  EXPECT_EQ(canonical_hash(t), canonical_hash(build(tilted.view(), {.method = Method::cavity})));
  PointSet rounded = points;
  for (double& x : rounded.coordinates) x = std::round(x * 0x1p17) * 0x1p-17;
  expect_incremental(rounded);
  EXPECT_LT(divided(rounded).statistics().cells_created, 14 * kCount);
}

/// Where the triangulation is a fan a site makes a cell and two ghost cells; else no more than a few, where halves
/// would make 14; and where each step undoes the ones before (a thousand cells a point), another begins.
TEST(DivideConquer, chains_are_knit_from_the_end_that_all_see_unless_there_is_none) {
  constexpr std::size_t kCount = 8000;
  const auto cells_created = [&](auto curve) {
    PointSet points{"chain", 2, {}, {}};
    Random random(3);
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto [x, y] = curve(unit_random(random));
      points.coordinates.insert(points.coordinates.end(), {x, y});
    }
    return divided(points, true, kCount).statistics().cells_created;
  };
  EXPECT_EQ(cells_created([](double t) { return std::pair(t, t * t / 8); }), 3 * kCount - 4);
  EXPECT_EQ(cells_created([](double t) { return std::pair(-t * t / 8, 1 - t); }), 3 * kCount - 4);
  EXPECT_LT(cells_created([](double t) { return std::pair(std::exp(-10 * t), std::exp(-20 * t) / 16); }), 6 * kCount);
  EXPECT_LT(cells_created([](double t) { return std::pair(t, 0.1 * std::pow(2 * t - 1, 3)); }), 25 * kCount);
}

TEST(DivideConquer, chains_are_sought_where_there_are_some) {
  const auto in_chains = [](const PointSet& points) {
    return plane_cuts(points.view(), affine_hull(points.view()).flat, 1).in_chains;
  };
  EXPECT_TRUE(in_chains(ellipse_and_area(60000)));
  EXPECT_TRUE(in_chains(turned_ellipse(60000)));
  EXPECT_FALSE(in_chains(around_ellipse(60000, 1, 0.0)));
  EXPECT_FALSE(in_chains(uniform(2, 60000, 1)));
}

TEST(DivideConquer, points_around_a_curve_are_cut_into_boxes) {
  constexpr std::size_t kCount = 20000;
  for (const double width : {0.01, 0.1}) {
    const PointSet points = around_ellipse(kCount, 0, width);
    expect_incremental(points);
    EXPECT_LT(divided(points).statistics().cells_created, 10 * kCount);
  }
}

TEST(DivideConquer, boxes_and_strips_are_cut_when_they_are_asked_for) {
  constexpr std::size_t kCount = 20000;
  const PointSet points = around_ellipse(kCount, 0, 0.0);
  const auto cells_created = [&](Order order) {
    return build(points.view(), {.method = Method::divide_conquer, .order = order}).statistics().cells_created;
  };
  EXPECT_GT(cells_created(Order::hilbert), 15 * kCount);
  EXPECT_LT(cells_created(Order::lexicographic), 5 * kCount);
  EXPECT_LT(cells_created(Order::automatic), 5 * kCount);
}

TEST(DivideConquer, a_sample_may_span_less_than_all_points) {
  PointSet heap{"heap", 2, std::vector<double>(40000, 3.0), {}};
  heap.coordinates.insert(heap.coordinates.end(), {4.0, 3.0, 3.0, 5.0});
  EXPECT_EQ(divided(heap).cell_count(), 1U);
  EXPECT_EQ(divided(heap).vertex_count(), 3U);
  PointSet line{"line", 2, {7.0, -1.0}, {}};
  for (int i = 0; i < 20000; ++i) line.coordinates.insert(line.coordinates.end(), {i * 1.0, i * 2.0});
  EXPECT_EQ(divided(line).cell_count(), 19999U);
  expect_incremental(line);
}

TEST(DivideConquer, of_equal_points_the_first_row_is_the_vertex) {
  const AnyTriangulation t = divided({"twice", 2, {5, 5, 0, 0, 9, 0, 5, 5, 0, 9, 0, 0, 5, 5}, {}});
  EXPECT_EQ(t.vertex_count(), 4U);
  EXPECT_EQ(t.status(0), (RowStatus{Status::vertex, 0}));
  EXPECT_EQ(t.status(3), (RowStatus{Status::duplicate, 0}));
  EXPECT_EQ(t.status(5), (RowStatus{Status::duplicate, 1}));
  EXPECT_EQ(t.status(6), (RowStatus{Status::duplicate, 0}));
}

TEST(DivideConquer, two_cells_a_vertex_and_none_dead) {
  const AnyTriangulation t = divided(uniform(2, 5000, 1));
  EXPECT_EQ(t.complex().slot_count(), 2 * 5000U - 2);
  EXPECT_EQ(t.complex().live_count(), 2 * 5000U - 2);
  EXPECT_LT(t.statistics().cells_created, 9U * 5000U);
}

TEST(DivideConquer, a_caller_may_cancel) {
  const PointSet points = uniform(2, 50000, 1);
  EXPECT_THROW(build(points.view(), {.progress = [](double done) { return done < 0.5; }}), Cancelled);
}

}  // namespace
}  // namespace delone
