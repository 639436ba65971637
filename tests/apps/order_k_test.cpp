#include "delone/apps/order_k.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "delone/apps/furthest.hpp"
#include "delone/apps/hull.hpp"
#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/dual/clip.hpp"
#include "delone/dual/region.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "delone/geometry/voronoi_predicates.hpp"
#include "delone/mesh/export.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

std::vector<Index> sorted(std::span<const Index> rows) {
  std::vector<Index> copy(rows.begin(), rows.end());
  std::ranges::sort(copy);
  return copy;
}

bool has(std::span<const Index> ascending, Index row) { return std::ranges::binary_search(ascending, row); }

Point2 at(PointsView points, Index row) { return {points[row][0], points[row][1]}; }

/// The lowest row at each place.
std::vector<Index> distinct_rows(PointsView points) {
  std::map<Point2, Index> first;
  for (Index row = 0; row < points.size(); ++row) first.emplace(at(points, row), row);
  std::vector<Index> rows;
  for (const auto& [place, row] : first) rows.push_back(row);
  std::ranges::sort(rows);
  return rows;
}

// --- Few points with small integers: look around every place where lines of equal distance meet ---

using Set = std::uint32_t;  // bit r for row r

/// A border as its cell, near, far, and the cell beyond.
using Border = std::tuple<Set, Index, Index, Set>;

struct Pictures {
  std::map<int, std::set<Set>> cells;  // by order
  std::map<int, std::set<Border>> borders;
};

/// Every cell and every border comes close to such a place, or to the middle of two points if all are on one line. A
/// step from there in a given direction ranks the points by their distances, then by how far they are in it. Directions
/// along lines of equal distance show the borders; those a little beside them, all cells.
class Truth {
 public:
  explicit Truth(const PointSet& points) {
    for (const Index row : distinct_rows(points.view())) {
      const Point2 p = at(points.view(), row);
      sites_.push_back({row, static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1])});
    }
    for (const Line& a : lines()) {
      look_around(a.middle);
      for (const Line& b : lines()) look_around(meeting(a, b));
    }
    if (sites_.size() == 1) pictures_.cells[1] = {Set{1} << sites_[0].row};
  }

  const Pictures& pictures() const { return pictures_; }

 private:
  struct Site {
    Index row;
    std::int64_t x, y;
  };
  /// x / w, y / w
  struct Place {
    std::int64_t x, y, w;
  };
  /// ax + by = c
  struct Line {
    std::int64_t a, b, c;
    Place middle;
  };

  std::vector<Line> lines() const {
    std::vector<Line> all;
    for (const Site& p : sites_) {
      for (const Site& q : sites_) {
        if (p.row < q.row)
          all.push_back({2 * (q.x - p.x),
                         2 * (q.y - p.y),
                         q.x * q.x + q.y * q.y - p.x * p.x - p.y * p.y,
                         {p.x + q.x, p.y + q.y, 2}});
      }
    }
    return all;
  }

  static Place meeting(const Line& l, const Line& m) {
    const std::int64_t w = l.a * m.b - m.a * l.b, sign = w < 0 ? -1 : 1;
    return {sign * (l.c * m.b - m.c * l.b), sign * (l.a * m.c - m.a * l.c), sign * w};
  }

  void look_around(Place o) {
    if (o.w == 0) return;
    for (const Line& line : lines()) {
      for (const std::int64_t sign : {-1, 1}) {
        const std::int64_t x = -line.b * sign, y = line.a * sign;
        constexpr std::int64_t kMuch = 100'000;
        look(o, x, y);
        look(o, kMuch * x + line.a, kMuch * y + line.b);
        look(o, kMuch * x - line.a, kMuch * y - line.b);
      }
    }
  }

  void look(Place o, std::int64_t x, std::int64_t y) {
    std::vector<std::array<std::int64_t, 3>> ranked;  // squared distance, how far the other way, row
    for (const Site& p : sites_) {
      const std::int64_t dx = p.x * o.w - o.x, dy = p.y * o.w - o.y;
      ranked.push_back({dx * dx + dy * dy, -(p.x * x + p.y * y), static_cast<std::int64_t>(p.row)});
    }
    std::ranges::sort(ranked);
    Set nearest = 0;
    for (std::size_t k = 1; k <= ranked.size(); ++k) {
      const auto& [distance, way, row] = ranked[k - 1];
      nearest |= Set{1} << row;
      if (k == ranked.size() || distance != ranked[k][0] || way != ranked[k][1]) {
        pictures_.cells[static_cast<int>(k)].insert(nearest);
        continue;
      }
      const auto near = static_cast<Index>(row), far = static_cast<Index>(ranked[k][2]);
      const Set beyond = nearest ^ (Set{1} << near) ^ (Set{1} << far);
      pictures_.borders[static_cast<int>(k)].insert({nearest, near, far, beyond});
      pictures_.borders[static_cast<int>(k)].insert({beyond, far, near, nearest});
    }
  }

  std::vector<Site> sites_;
  Pictures pictures_;
};

Set set_of(std::span<const Index> rows) {
  Set set = 0;
  for (const Index row : rows) set |= Set{1} << row;
  return set;
}

Pictures pictures_of(const PointSet& points) {
  Pictures pictures;
  const int last = static_cast<int>(distinct_rows(points.view()).size());
  for_orders(points.view(), 1, last, [&](const OrderK& diagram) {
    for (std::size_t cell = 0; cell < diagram.size(); ++cell) {
      const Set set = set_of(diagram.subset(cell));
      EXPECT_TRUE(pictures.cells[diagram.k].insert(set).second) << "a cell comes twice";
      for (const Bisector& b : diagram.borders_of(cell)) {
        const Border border{set, b.near, b.far, set_of(diagram.subset(b.across))};
        EXPECT_TRUE(pictures.borders[diagram.k].insert(border).second) << "a border comes twice";
      }
    }
  });
  return pictures;
}

void expect_truth(const PointSet& points) {
  const Truth truth(points);
  const Pictures pictures = pictures_of(points);
  EXPECT_EQ(pictures.cells, truth.pictures().cells) << points;
  EXPECT_EQ(pictures.borders, truth.pictures().borders) << points;
}

PointSet integers(std::string name, const std::vector<std::array<int, 2>>& list) {
  PointSet points{std::move(name), 2, {}};
  for (const auto& [x, y] : list) points.coordinates.insert(points.coordinates.end(), {double(x), double(y)});
  return points;
}

/// Of the twelve integer points on a circle around the origin, and the origin.
PointSet on_a_circle(std::size_t n, std::uint64_t seed) {
  const PointSet all = integers("circle and centre", {{3, 4},
                                                      {-3, 4},
                                                      {3, -4},
                                                      {-3, -4},
                                                      {4, 3},
                                                      {-4, 3},
                                                      {4, -3},
                                                      {-4, -3},
                                                      {5, 0},
                                                      {-5, 0},
                                                      {0, 5},
                                                      {0, -5},
                                                      {0, 0}});
  Random random(seed);
  return rows(permuted(all, random_permutation(all.size(), random)), 0, n);
}

TEST(OrderK, small_lattices_are_what_one_sees_around_every_meeting) {
  for (const int side : {2, 3, 4, 9}) {
    for (std::size_t n = 1; n <= 7; ++n) {
      for (std::uint64_t seed = 0; seed < 3; ++seed) expect_truth(lattice(2, n, side, seed));
    }
  }
}

TEST(OrderK, cocircular_sites_are_what_one_sees_around_every_meeting) {
  for (std::size_t n = 3; n <= 7; ++n) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) expect_truth(on_a_circle(n, seed));
  }
  expect_truth(integers("square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  expect_truth(integers("square and its middle", {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}}));
  expect_truth(integers("circles around one centre", {{1, 0}, {-1, 0}, {0, 1}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}}));
}

TEST(OrderK, sites_on_lines_are_what_one_sees_around_every_meeting) {
  expect_truth(integers("a line", {{0, 0}, {3, 3}, {1, 1}, {7, 7}, {2, 2}, {3, 3}}));
  expect_truth(integers("an upright line", {{2, 5}, {2, 1}, {2, 9}, {2, 2}}));
  expect_truth(integers("all but one on a line", {{0, 0}, {1, 0}, {2, 0}, {5, 0}, {1, 3}}));
  expect_truth(integers("two lines", {{0, 0}, {1, 0}, {2, 0}, {0, 4}, {1, 4}, {2, 4}}));
  expect_truth(integers("trapezoids", {{-1, 0}, {1, 0}, {-3, 2}, {3, 2}, {-2, 7}, {2, 7}}));
  expect_truth(integers("within a hull edge", {{0, 0}, {4, 0}, {8, 0}, {4, 5}, {6, 0}, {4, 1}}));
}

// --- Any points: exact tests of every circle ---

int turn(PointsView points, Index a, Index b, Index c) {
  return slow_orient<2>({points[a].data(), points[b].data(), points[c].data()}).sign;
}

/// +1 for a row inside the circle through three that are not collinear, 0 on it, -1 outside.
int side(PointsView points, std::array<Index, 3> three, Index row) {
  if (turn(points, three[0], three[1], three[2]) < 0) std::swap(three[0], three[1]);
  SiteRefs<2, 4> sites{};
  for (std::size_t i = 0; i < 3; ++i) sites.leading[i] = points[three[i]].data();
  sites.leading[3] = points[row].data();
  return slow_conflict<2>(sites).sign;
}

/// The rows on a circle, and how many are inside.
using Circle = std::pair<std::vector<Index>, Index>;

Circle circle_through(PointsView points, const std::vector<Index>& distinct, const std::array<Index, 3>& three) {
  Circle circle;
  for (const Index row : distinct) {
    const int sign = side(points, three, row);
    if (sign == 0) circle.first.push_back(row);
    circle.second += sign > 0 ? 1 : 0;
  }
  return circle;
}

std::set<Circle> circles_of(const OrderK& diagram) {
  std::set<Circle> circles;
  for (std::size_t v = 0; v < diagram.vertex_count(); ++v)
    circles.insert({sorted(diagram.circle(v)), diagram.inside[v]});
  return circles;
}

void expect_sound_circles(const PointSet& points, const OrderK& diagram) {
  const std::vector<Index> distinct = distinct_rows(points.view());
  for (std::size_t v = 0; v < diagram.vertex_count(); ++v) {
    const auto on = diagram.circle(v);
    ASSERT_GE(on.size(), 3U);
    for (std::size_t i = 2; i < on.size(); ++i) EXPECT_GT(turn(points.view(), on[0], on[i - 1], on[i]), 0) << points;
    EXPECT_EQ(on[0], std::ranges::min(on));
    EXPECT_EQ(circle_through(points.view(), distinct, {on[0], on[1], on[2]}), Circle(sorted(on), diagram.inside[v]))
        << points;
  }
}

/// Beyond is a cell with one row changed, which has the same border.
void expect_sound_border(const OrderK& diagram, std::size_t cell, const Bisector& border) {
  const auto subset = diagram.subset(cell);
  EXPECT_TRUE(has(subset, border.near) && !has(subset, border.far));
  std::vector<Index> beyond = sorted(subset);
  std::erase(beyond, border.near);
  beyond.push_back(border.far);
  EXPECT_TRUE(std::ranges::equal(sorted(beyond), diagram.subset(border.across)));
  const auto is_same = [&](const Bisector& b) {
    return b.across == cell && b.near == border.far && b.far == border.near;
  };
  EXPECT_EQ(std::ranges::count_if(diagram.borders_of(border.across), is_same), 1);
}

/// Where two borders of a cell meet, counter-clockwise: on the circle there, the sites in the cell follow each other,
/// between those that the borders change.
void expect_sound_corner(const OrderK& diagram, Index vertex, const Bisector& in, const Bisector& out) {
  std::vector<Index> on(diagram.circle(vertex).begin(), diagram.circle(vertex).end());
  std::ranges::rotate(on, std::ranges::find(on, in.near));
  const std::size_t arc = static_cast<std::size_t>(diagram.k) - diagram.inside[vertex];
  ASSERT_TRUE(0 < arc && arc < on.size());
  EXPECT_EQ(on[0], in.near);
  EXPECT_EQ(on[arc - 1], out.near);
  EXPECT_EQ(on[arc], in.far);
  EXPECT_EQ(on.back(), out.far);
}

/// All that is promised of each cell, border and circle.
void expect_sound(const PointSet& points, const OrderK& diagram) {
  expect_sound_circles(points, diagram);
  Index vertices = 0;
  for (std::size_t cell = 0; cell < diagram.size(); ++cell) {
    const auto subset = diagram.subset(cell);
    EXPECT_EQ(std::ranges::adjacent_find(subset, std::greater_equal{}), subset.end());
    if (cell > 0) {
      EXPECT_TRUE(std::ranges::lexicographical_compare(diagram.subset(cell - 1), subset));
    }
    const auto borders = diagram.borders_of(cell);
    const auto starts = std::span(diagram.starts).subspan(diagram.offsets[cell], borders.size());
    for (std::size_t i = 0; i < borders.size(); ++i) {
      expect_sound_border(diagram, cell, borders[i]);
      const Bisector& before = borders[i > 0 ? i - 1 : borders.size() - 1];
      if (starts[i] != kNone) {
        expect_sound_corner(diagram, starts[i], before, borders[i]);
        EXPECT_LE(starts[i], vertices) << "numbers of vertices ascend";
        vertices = std::max(vertices, starts[i] + 1);
      }
    }
    if (borders.empty() || std::ranges::count(starts, kNone) == 2) continue;  // everything, or between parallel lines
    if (std::ranges::count(starts, kNone) == 1) {
      EXPECT_EQ(starts[0], kNone);
    } else {
      const auto name = [](const Bisector& b) { return std::pair(b.near, b.far); };
      EXPECT_EQ(std::ranges::min_element(borders, {}, name), borders.begin());
    }
  }
  EXPECT_EQ(vertices, diagram.vertex_count());
}

TEST(OrderK, every_family_is_sound_and_has_every_circle) {
  for (const std::size_t n : {1, 2, 3, 4, 6, 9}) {
    for (const PointSet& points : unweighted_families(2, n, n)) {
      const std::vector<Index> distinct = distinct_rows(points.view());
      std::set<Circle> circles;
      for (const Index a : distinct) {
        for (const Index b : distinct) {
          for (const Index c : distinct) {
            if (a < b && b < c && turn(points.view(), a, b, c) != 0)
              circles.insert(circle_through(points.view(), distinct, {a, b, c}));
          }
        }
      }
      for_orders(points.view(), 1, static_cast<int>(distinct.size()), [&](const OrderK& diagram) {
        expect_sound(points, diagram);
        std::set<Circle> here;
        for (const Circle& circle : circles) {
          const auto k = static_cast<std::size_t>(diagram.k);
          if (circle.second < k && k < circle.second + circle.first.size()) here.insert(circle);
        }
        EXPECT_EQ(circles_of(diagram), here) << diagram.k << "\n" << points;
      });
    }
  }
}

std::size_t unbounded_count(const OrderK& diagram) {
  return static_cast<std::size_t>(std::ranges::count(diagram.starts, kNone));
}

/// The centres, and infinity, are the corners of a map on the sphere whose faces are the cells.
void expect_map(const PointSet& points, const OrderK& diagram) {
  EXPECT_EQ(diagram.borders.size() % 2, 0U);
  EXPECT_EQ(diagram.vertex_count() + 1 + diagram.size(), diagram.borders.size() / 2 + 2) << diagram.k << "\n" << points;
}

TEST(OrderK, larger_sets_are_sound_maps) {
  for (const PointSet& points : unweighted_families(2, 45, 5)) {
    const int last = std::min(9, static_cast<int>(distinct_rows(points.view()).size()));
    const bool flat = affine_dimension(points.view()) < 2;
    for_orders(points.view(), 1, last, [&](const OrderK& diagram) {
      if (diagram.k % 4 == 1) expect_sound(points, diagram);
      if (!flat) expect_map(points, diagram);
    });
  }
}

// --- Laws ---

// What [Lee82] says of points in general position; and sets of k sites that a line parts from the others come in pairs
// with the n - k others.
TEST(OrderK, numbers_of_cells_are_those_of_Lee) {
  const std::size_t n = 40;
  const PointSet points = uniform(2, n, 7);
  std::vector<std::size_t> unbounded{0};
  std::size_t before = 0;  // unbounded cells of lower orders
  for_orders(points.view(), 1, static_cast<int>(n), [&](const OrderK& diagram) {
    const auto k = static_cast<std::size_t>(diagram.k);
    EXPECT_EQ(diagram.size() + before, (2 * k - 1) * n - (k * k - 1)) << k;
    unbounded.push_back(unbounded_count(diagram));
    before += unbounded.back();
  });
  for (std::size_t k = 1; k < n; ++k) EXPECT_EQ(unbounded[k], unbounded[n - k]) << k;
}

TEST(OrderK, the_nearest_sites_of_a_place_are_those_of_the_cell_around_it) {
  Random random(3);
  for (const PointSet& points : {uniform(2, 80, 1), lattice(2, 80, 12, 2), circle_of_24_bits(2, 50, 3)}) {
    const std::vector<Index> distinct = distinct_rows(points.view());
    double low = 1e300, high = -1e300;
    for (const double x : points.coordinates) low = std::min(low, x), high = std::max(high, x);
    for (const int k : {1, 2, 3, 8, 20}) {
      const OrderK diagram = order_k_voronoi(points.view(), k);
      for (int query = 0; query < 20; ++query) {
        const auto coordinate = [&] { return low + (high - low) * (2 * unit_random(random) - 0.5); };
        const Point2 q{coordinate(), coordinate()};
        std::vector<Index> nearest = distinct;
        std::ranges::sort(nearest,
                          [&](Index a, Index b) { return nearer(q, at(points.view(), a), at(points.view(), b)) > 0; });
        nearest.resize(static_cast<std::size_t>(k));
        std::ranges::sort(nearest);
        for (std::size_t cell = 0; cell < diagram.size(); ++cell) {
          const bool within = std::ranges::all_of(diagram.borders_of(cell), [&](const Bisector& b) {
            return nearer(q, at(points.view(), b.near), at(points.view(), b.far)) > 0;
          });
          EXPECT_EQ(within, std::ranges::equal(diagram.subset(cell), nearest)) << k << "\n" << points;
        }
      }
    }
  }
}

TEST(OrderK, order_1_is_dual_to_the_merged_Delaunay_cells) {
  for (const PointSet& points : unweighted_families(2, 50, 4)) {
    const AnyTriangulation t = build(points.view());
    const OrderK diagram = order_k_voronoi(points.view(), 1);
    EXPECT_EQ(diagram.subsets, distinct_rows(points.view())) << points;
    if (t.affine_dimension() < 2) continue;
    std::set<Circle> circles;
    const PolytopeTable polygons = merged_cells(t);
    for (std::size_t i = 0; i < polygons.size(); ++i) circles.insert({sorted(polygons[i]), 0});
    EXPECT_EQ(circles_of(diagram), circles) << points;
  }
}

TEST(OrderK, order_n_less_1_is_the_furthest_site_diagram) {
  for (const PointSet& points : unweighted_families(2, 24, 6)) {
    const std::vector<Index> distinct = distinct_rows(points.view());
    if (distinct.size() < 2) continue;
    const OrderK diagram = order_k_voronoi(points.view(), static_cast<int>(distinct.size()) - 1);
    std::vector<Index> furthest;
    for (std::size_t cell = 0; cell < diagram.size(); ++cell) {
      std::vector<Index> left_out;
      std::ranges::set_difference(distinct, diagram.subset(cell), std::back_inserter(left_out));
      furthest.push_back(left_out.at(0));
    }
    EXPECT_EQ(sorted(furthest), convex_hull(points.view()).corners) << points;
    if (affine_dimension(points.view()) < 2) continue;
    const CellTable triangles = furthest_delaunay(points.view()).cells;
    const std::set<Circle> circles = circles_of(diagram);
    std::size_t count = 0;
    for (const auto& [on, inside] : circles) count += on.size() - 2;
    EXPECT_EQ(triangles.size(), count) << points;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::vector<Index> corners = sorted(triangles[i]);
      EXPECT_EQ(
          std::ranges::count_if(circles, [&](const Circle& c) { return std::ranges::includes(c.first, corners); }), 1)
          << points;
    }
  }
}

TEST(OrderK, cells_cut_from_a_box_fill_it) {
  for (const PointSet& points : {uniform(2, 40, 2), lattice(2, 40, 7, 1), on_a_circle(13, 1),
                                 integers("a line", {{0, 0}, {3, 3}, {1, 1}, {7, 7}, {2, 2}, {9, 9}})}) {
    const auto [low, high] = std::ranges::minmax(points.coordinates);
    const double middle = (low + high) / 2, reach = 3 * (high - low);
    const std::array<double, 2> from{middle - reach, middle - reach}, to{middle + reach, middle + reach};
    for (const int k : {1, 2, 5}) {
      const OrderK diagram = order_k_voronoi(points.view(), k);
      const CellShapes shapes = cut_cells(points.view(), Region::box(from, to), diagram.offsets, diagram.borders);
      const std::vector<double> sites(2 * diagram.size());
      const std::vector<double> areas = measure_shapes(shapes, PointsView(sites, 2)).volume;
      EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 4 * reach * reach, 1e-12 * reach * reach) << points;
    }
  }
}

TEST(OrderK, order_n_is_one_cell) {
  for (const PointSet& points : unweighted_families(2, 12, 2)) {
    const std::vector<Index> distinct = distinct_rows(points.view());
    const OrderK diagram = order_k_voronoi(points.view(), static_cast<int>(distinct.size()));
    EXPECT_EQ(diagram.subsets, distinct) << points;
    EXPECT_EQ(diagram.size(), 1U);
    EXPECT_TRUE(diagram.borders.empty());
    EXPECT_EQ(diagram.vertex_count(), 0U);
  }
}

TEST(OrderK, powers_of_two_change_nothing) {
  const PointSet points = lattice(2, 70, 9, 3);
  const OrderK diagram = order_k_voronoi(points.view(), 6);
  for (const double scale : {0x1p-500, 0x1p-1060, 0x1p1000}) {
    PointSet scaled = points;
    for (double& x : scaled.coordinates) x *= scale;
    const OrderK same = order_k_voronoi(scaled.view(), 6);
    EXPECT_EQ(same.subsets, diagram.subsets);
    EXPECT_EQ(same.offsets, diagram.offsets);
    EXPECT_EQ(same.starts, diagram.starts);
    EXPECT_EQ(same.on, diagram.on);
  }
}

TEST(OrderK, rows_are_names_only) {
  const PointSet points = lattice(2, 60, 100, 8);
  Random random(1);
  const std::vector<std::size_t> names = random_permutation(points.size(), random);
  const PointSet renamed = permuted(points, names);
  const auto described = [](const OrderK& diagram, const auto& name) {
    std::set<std::tuple<std::vector<Index>, Index, Index>> borders;
    for (std::size_t cell = 0; cell < diagram.size(); ++cell) {
      std::vector<Index> subset;
      for (const Index row : diagram.subset(cell)) subset.push_back(name(row));
      for (const Bisector& b : diagram.borders_of(cell)) borders.insert({sorted(subset), name(b.near), name(b.far)});
    }
    return borders;
  };
  ASSERT_EQ(distinct_rows(points.view()).size(), points.size());
  for (const int k : {2, 7}) {
    EXPECT_EQ(described(order_k_voronoi(renamed.view(), k), [&](Index row) { return static_cast<Index>(names[row]); }),
              described(order_k_voronoi(points.view(), k), [](Index row) { return row; }));
  }
}

TEST(OrderK, orders_one_after_the_other_are_the_same_as_each_alone) {
  const PointSet points = lattice(2, 40, 5, 1);
  int k = 2;
  for_orders(points.view(), 2, 6, [&](const OrderK& diagram) {
    const OrderK alone = order_k_voronoi(points.view(), k);
    EXPECT_EQ(diagram.k, k++);
    EXPECT_EQ(diagram.subsets, alone.subsets);
    EXPECT_EQ(diagram.starts, alone.starts);
  });
  EXPECT_EQ(k, 7);
}

TEST(OrderK, orders_that_do_not_exist_are_refused) {
  const PointSet points = integers("three places", {{0, 0}, {1, 0}, {0, 1}, {1, 0}});
  EXPECT_NO_THROW(order_k_voronoi(points.view(), 3));
  EXPECT_THROW(order_k_voronoi(points.view(), 4), InputError);
  EXPECT_THROW(order_k_voronoi(points.view(), 0), InputError);
  EXPECT_THROW(for_orders(points.view(), 3, 2, [](const OrderK&) {}), InputError);
  EXPECT_THROW(order_k_voronoi(PointSet{"none", 2, {}}.view(), 1), InputError);
  EXPECT_THROW(order_k_voronoi(uniform(3, 9, 1).view(), 1), InputError);
  EXPECT_THROW(order_k_voronoi(with_random_weights(uniform(2, 9, 1), 1).view(), 1), InputError);
  EXPECT_THROW(order_k_voronoi(PointSet{"not a number", 2, {0, std::nan("")}}.view(), 1), InputError);
}

TEST(OrderK, callers_may_stop) {
  const PointSet points = uniform(2, 20, 1);
  EXPECT_THROW(order_k_voronoi(points.view(), 2, {.progress = [](double) { return false; }}), Cancelled);
}

}  // namespace
}  // namespace delone
