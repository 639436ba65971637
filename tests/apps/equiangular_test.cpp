#include "delone/apps/equiangular.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <numeric>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/base/random.hpp"
#include "delone/build/build.hpp"
#include "delone/check/delaunay.hpp"
#include "delone/io/generate.hpp"
#include "delone/mesh/export.hpp"

namespace delone {
namespace {

using Points = std::vector<std::array<double, 2>>;
using Triangle = std::array<std::size_t, 3>;

/// An angle of a triangle with small integer corners, by its cotangent; larger angles are greater.
struct Angle {
  std::int64_t dot, cross;  // cross > 0
  std::strong_ordering operator<=>(const Angle& other) const {
    return static_cast<__int128>(other.dot) * cross <=> static_cast<__int128>(dot) * other.cross;
  }
  bool operator==(const Angle& other) const { return (*this <=> other) == 0; }
};

void add_angles(const Points& points, Triangle t, std::vector<Angle>& angles) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &p = points[t[i]], &q = points[t[(i + 1) % 3]], &r = points[t[(i + 2) % 3]];
    const auto difference = [](double a, double b) { return static_cast<std::int64_t>(a - b); };
    const std::int64_t ax = difference(q[0], p[0]), ay = difference(q[1], p[1]);
    const std::int64_t bx = difference(r[0], p[0]), by = difference(r[1], p[1]);
    angles.push_back({ax * bx + ay * by, std::abs(ax * by - ay * bx)});
  }
}

std::vector<Angle> sorted_angles(const Points& points, const CellTable& cells) {
  std::vector<Angle> angles;
  for (std::size_t c = 0; c < cells.size(); ++c) add_angles(points, {cells[c][0], cells[c][1], cells[c][2]}, angles);
  std::ranges::sort(angles);
  return angles;
}

/// All triangulations of the corners first .. last of a convex polygon, each as its triangles.
std::vector<std::vector<Triangle>> all_triangulations(std::size_t first, std::size_t last) {
  if (last - first < 2) return {{}};
  std::vector<std::vector<Triangle>> all;
  for (std::size_t apex = first + 1; apex < last; ++apex) {
    for (const auto& left : all_triangulations(first, apex)) {
      for (const auto& right : all_triangulations(apex, last)) {
        std::vector<Triangle> whole{{first, apex, last}};
        whole.insert(whole.end(), left.begin(), left.end());
        whole.insert(whole.end(), right.begin(), right.end());
        all.push_back(whole);
      }
    }
  }
  return all;
}

/// The integer points of the circle x^2 + y^2 = radius^2, counter-clockwise from (radius, 0).
Points circle(std::int64_t radius) {
  Points upper, lower;
  for (std::int64_t x = -radius; x <= radius; ++x) {
    for (std::int64_t y = 0; y <= radius; ++y) {
      if (x * x + y * y != radius * radius) continue;
      upper.push_back({static_cast<double>(x), static_cast<double>(y)});
      if (y > 0) lower.push_back({static_cast<double>(x), -static_cast<double>(y)});
    }
  }
  std::ranges::reverse(upper);
  upper.insert(upper.end(), lower.begin(), lower.end());
  return upper;
}

/// `count` corners of those of `all`, in their order; only of the first `among`.
Points some_of(const Points& all, std::size_t count, std::size_t among, std::uint64_t seed) {
  std::vector<std::size_t> rows(among);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  for (std::size_t i = among; i > 1; --i) std::swap(rows[i - 1], rows[mix(mix(seed) + i) % i]);
  rows.resize(count);
  std::ranges::sort(rows);
  Points points;
  for (const std::size_t row : rows) points.push_back(all[row]);
  return points;
}

TEST(Equiangular, cocircular_polygons_get_the_largest_sequence_of_angles) {
  const Points round = circle(325), regular = circle(5);  // 60 points; 12, with many equal arcs
  int polygons = 0;
  for (std::size_t count = 4; count <= 9; ++count) {
    for (std::uint64_t seed = 0; seed < (count < 8 ? 60 : 15); ++seed) {
      for (const Points& all : {round, regular}) {
        // A third of the polygons lie within a half circle, where one side spans more than half.
        const std::size_t among = seed % 3 == 0 ? std::max(count, all.size() / 2) : all.size();
        const Points points = some_of(all, count, among, seed + 1000 * count);
        std::vector<Angle> best;
        for (const auto& triangles : all_triangulations(0, count - 1)) {
          std::vector<Angle> angles;
          for (const Triangle& t : triangles) add_angles(points, t, angles);
          std::ranges::sort(angles);
          best = std::max(best, angles);
        }
        const AnyTriangulation t = build(points);
        ASSERT_EQ(sorted_angles(points, equiangular_cells(t)), best) << count << " corners, seed " << seed;
        ++polygons;
      }
    }
  }
  EXPECT_EQ(polygons, 2 * (4 * 60 + 2 * 15));
}

TEST(Equiangular, result_is_a_delaunay_triangulation_with_neighbours) {
  const io::Generated made = io::generate("uniform", 120, 2, 7, 4);  // many cocircular sites, and duplicates
  const PointsView points(made.coordinates, 2);
  const AnyTriangulation t = build(points);
  const CellTable table = equiangular_cells(t);
  EXPECT_TRUE(check(points, table).passed());
  EXPECT_NE(table.vertices, cells(t).vertices);
  ASSERT_EQ(table.neighbours.size(), table.vertices.size());
  std::size_t outside = 0;
  for (std::size_t place = 0; place < table.neighbours.size(); ++place) {
    if (table.neighbours[place] == kNone) {
      ++outside;
      continue;
    }
    const auto other = table[table.neighbours[place]];
    for (const std::size_t by : {std::size_t{1}, std::size_t{2}}) {
      EXPECT_NE(std::ranges::find(other, table.vertices[place / 3 * 3 + (place + by) % 3]), other.end());
    }
  }
  EXPECT_EQ(outside, t.hull_facet_count());
}

TEST(Equiangular, without_cocircular_sites_nothing_changes) {
  const io::Generated made = io::generate("uniform", 500);
  const AnyTriangulation t = build(PointsView(made.coordinates, 2));
  EXPECT_EQ(equiangular_cells(t).vertices, cells(t).vertices);
  EXPECT_EQ(equiangular_cells(t).neighbours, cells(t).neighbours);
}

TEST(Equiangular, choice_depends_on_the_points_alone) {
  Points points = circle(25);
  const auto drawn = [&] {
    const CellTable table = equiangular_cells(build(points), false);
    std::vector<std::array<std::array<double, 2>, 3>> triangles;
    for (std::size_t c = 0; c < table.size(); ++c) {
      std::array<std::array<double, 2>, 3> t{points[table[c][0]], points[table[c][1]], points[table[c][2]]};
      std::ranges::sort(t);
      triangles.push_back(t);
    }
    std::ranges::sort(triangles);
    return triangles;
  };
  const auto first = drawn();
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[mix(mix(seed) + i) % i]);
    EXPECT_EQ(drawn(), first);
  }
}

// Both diagonals of a square are equal.
TEST(Equiangular, squares_are_cut_as_usual) {
  const io::Generated made = io::generate("lattice", 90);
  const AnyTriangulation t = build(PointsView(made.coordinates, 2));
  EXPECT_EQ(equiangular_cells(t).vertices, cells(t).vertices);
  EXPECT_EQ(equiangular_cells(t).neighbours, cells(t).neighbours);
}

TEST(Equiangular, sites_on_a_line_have_their_edges) {
  const Points points{{0, 0}, {2, 2}, {1, 1}};
  const AnyTriangulation t = build(points);
  EXPECT_EQ(equiangular_cells(t).vertices, cells(t).vertices);
}

TEST(Equiangular, weights_and_other_dimensions_are_refused) {
  EXPECT_THROW(equiangular_cells(AnyTriangulation(3)), InputError);
  EXPECT_THROW(equiangular_cells(AnyTriangulation(2, true)), InputError);
}

}  // namespace
}  // namespace delone
