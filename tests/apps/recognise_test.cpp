#include "delone/apps/recognise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/geometry/affine.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using Point = std::array<double, 2>;
using test::Random;
using test::unit_random;

PlanarComplex voronoi(const std::vector<Point>& sites) { return planar_complex(Diagram(build(PointsView(sites)))); }

std::vector<Point> grid(int columns, int rows, Point origin, Point a, Point b) {
  std::vector<Point> sites;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i)
      sites.push_back({origin[0] + i * a[0] + j * b[0], origin[1] + i * a[1] + j * b[1]});
  }
  return sites;
}

std::vector<Point> random_sites(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> sites(n);
  for (Point& site : sites) site = {unit_random(random), unit_random(random)};
  return sites;
}

double size_of(const PlanarComplex& complex) {
  double size = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto [low, high] = std::ranges::minmax(complex.vertices, {}, [j](const Point& p) { return p[j]; });
    size = std::max(size, high[j] - low[j]);
  }
  return size;
}

void expect_near(const std::vector<Point>& found, const std::vector<Point>& sites, double error) {
  ASSERT_EQ(found.size(), sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_NEAR(found[i][0], sites[i][0], error) << i;
    EXPECT_NEAR(found[i][1], sites[i][1], error) << i;
  }
}

/// That of all sites those of a cell are nearest to its vertices, and to places far out on its rays.
void expect_diagram(const PlanarComplex& complex, const std::vector<Point>& sites, double error) {
  ASSERT_EQ(sites.size(), complex.cells.size());
  const auto expect_nearest = [&](std::size_t c, const Point& x, double far) {
    const auto distance = [&](const Point& site) { return std::hypot(site[0] - x[0], site[1] - x[1]); };
    EXPECT_LE(distance(sites[c]), distance(*std::ranges::min_element(sites, {}, distance)) + far * error) << c;
  };
  const double size = 1 + size_of(complex);
  for (std::size_t c = 0; c < sites.size(); ++c) {
    const std::vector<Index>& loop = complex.cells[c];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index from = loop[i], to = loop[(i + 1) % loop.size()];
      const Index vertex = std::min(from, to), direction = std::max(from, to);  // of a ray
      if (from < complex.vertices.size()) expect_nearest(c, complex.vertices[from], 1);
      if (vertex >= complex.vertices.size() || direction < complex.vertices.size()) continue;
      const Point &v = complex.vertices[vertex], &d = complex.directions[direction - complex.vertices.size()];
      const double times = 100 * size / std::hypot(d[0], d[1]);
      expect_nearest(c, {v[0] + times * d[0], v[1] + times * d[1]}, 100);
    }
  }
}

TEST(Recognise, sites_of_a_skew_lattice_come_back_exactly) {
  for (const double scale : {1.0, 0x1p-400, 0x1p400}) {
    for (const double far : {0.0, 0x1p30}) {
      const std::vector<Point> sites = grid(7, 6, {far * scale, -far * scale}, {4 * scale, 0}, {2 * scale, 4 * scale});
      const Recognition found = recognise(voronoi(sites));
      EXPECT_TRUE(found.is_voronoi) << found.reason;
      EXPECT_EQ(found.freedom, 0);
      EXPECT_EQ(found.residual, 0.0);
      EXPECT_EQ(found.sites, sites);
    }
  }
}

TEST(Recognise, a_square_lattice_has_as_many_choices_as_a_square_has_points) {
  const std::vector<Point> sites = grid(5, 4, {1, 2}, {1, 0}, {0, 1});
  const PlanarComplex complex = voronoi(sites);
  for (const double tolerance : {0.0, 1e-12}) {
    const Recognition found = recognise(complex, tolerance);
    ASSERT_TRUE(found.is_voronoi) << found.reason;
    EXPECT_EQ(found.freedom, 2);
    expect_diagram(complex, found.sites, 1e-12);
  }
}

TEST(Recognise, sites_come_back_from_rounded_vertices) {
  for (const std::size_t n : {3, 4, 5, 8, 20, 100, 400}) {
    const std::vector<Point> sites = random_sites(n, n);
    const PlanarComplex complex = voronoi(sites);
    const Recognition found = recognise(complex, 1e-10);
    ASSERT_TRUE(found.is_voronoi) << n << ": " << found.reason;
    EXPECT_LT(found.residual, 1e-12);
    if (n == 3) continue;
    EXPECT_EQ(found.freedom, 0);
    expect_near(found.sites, sites, 1e-10 * size_of(complex));
  }
}

TEST(Recognise, of_points_of_a_lattice_some_sites_are_found_whatever_the_degrees_of_vertices) {
  std::array<int, 3> with_freedom{};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const test::PointSet points = test::lattice(2, 3 + seed % 12, 5, seed);
    std::set<Point> distinct;
    for (std::size_t row = 0; row < points.size(); ++row)
      distinct.insert({points.view()[row][0], points.view()[row][1]});
    const std::vector<Point> sites(distinct.begin(), distinct.end());
    if (affine_dimension(PointsView(sites)) < 2) continue;
    const PlanarComplex complex = voronoi(sites);
    const Recognition found = recognise(complex, 1e-9);
    ASSERT_TRUE(found.is_voronoi) << seed << ": " << found.reason;
    ++with_freedom[static_cast<std::size_t>(found.freedom)];
    if (found.freedom == 0) expect_near(found.sites, sites, 1e-9);
    expect_diagram(complex, found.sites, 1e-9);
  }
  EXPECT_GT(*std::ranges::min_element(with_freedom), 0);
}

TEST(Recognise, rounded_vertices_are_no_exact_diagram) {
  const Recognition found = recognise(voronoi(random_sites(50, 1)));
  EXPECT_FALSE(found.is_voronoi);
  EXPECT_NE(found.reason.find("is on no bisector"), std::string::npos) << found.reason;
  EXPECT_TRUE(found.sites.empty());
}

TEST(Recognise, three_rays_have_a_line_of_choices) {
  const PlanarComplex complex{{{3, 1}}, {{1, 0}, {-1, 2}, {-1, -1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
  for (const double tolerance : {0.0, 1e-12}) {
    const Recognition found = recognise(complex, tolerance);
    ASSERT_TRUE(found.is_voronoi) << found.reason;
    EXPECT_EQ(found.freedom, 1);
    expect_diagram(complex, found.sites, 1e-12);
  }
}

TEST(Recognise, four_rays_need_opposite_angles_that_sum_to_half_a_turn) {
  PlanarComplex complex{{{0, 0}}, {{1, 0}, {1, 2}, {-1, 1}, {-1, -1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}};
  EXPECT_FALSE(recognise(complex).is_voronoi);
  EXPECT_FALSE(recognise(complex, 1e-3).is_voronoi);  // in the vertex all sites would suit
  complex.directions[3] = {-1, -3};                   // (1 + 2i)(-1 - 3i) / (-1 + i) is a negative number
  for (const double tolerance : {0.0, 1e-12}) {
    const Recognition found = recognise(complex, tolerance);
    ASSERT_TRUE(found.is_voronoi) << found.reason;
    EXPECT_EQ(found.freedom, 2);
    expect_diagram(complex, found.sites, 1e-12);
  }
}

// Around a vertex of even degree that suits no sites they would all have to lie in it.
TEST(Recognise, sites_do_not_fall_together_in_a_vertex) {
  Random random(4);
  for (int trial = 0; trial < 3000; ++trial) {
    PlanarComplex complex{
        {{unit_random(random), unit_random(random)}}, {}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}};
    for (int i = 0; i < 4; ++i) {
      const double angle = i * std::numbers::pi / 2 + unit_random(random);
      complex.directions.push_back({std::cos(angle), std::sin(angle)});
    }
    EXPECT_FALSE(recognise(complex, 1e-9).is_voronoi) << trial;
  }
}

/// Parallel lines through the points (x, 0), the cells from left to right.
PlanarComplex lines(const std::vector<double>& x, Point up) {
  PlanarComplex complex{{}, {up, {-up[0], -up[1]}}, {}};
  const auto n = static_cast<Index>(x.size());
  for (const double at : x) complex.vertices.push_back({at, 0});
  complex.cells.push_back({n + 1, 0, n});
  for (Index i = 0; i + 1 < n; ++i) complex.cells.push_back({n, i, n + 1, i + 1});
  complex.cells.push_back({n, n - 1, n + 1});
  return complex;
}

TEST(Recognise, parallel_lines_belong_to_sites_on_a_line_across_when_their_distances_allow_it) {
  for (const double tolerance : {0.0, 1e-12}) {
    for (const std::vector<double>& x : {std::vector<double>{3}, {0, 1}, {0, 1, 2, 3}, {0, 2, 5, 7, 10}}) {
      const Recognition found = recognise(lines(x, {1, 4}), tolerance);
      ASSERT_TRUE(found.is_voronoi) << found.reason;
      EXPECT_EQ(found.freedom, 2);
      for (std::size_t i = 0; i < x.size(); ++i) {  // both as far from the line, on a line across
        const Point &a = found.sites[i], &b = found.sites[i + 1];
        EXPECT_NEAR(b[0] - a[0], -4 * (b[1] - a[1]), 1e-12);
        EXPECT_NEAR(4 * ((a[0] + b[0]) / 2 - x[i]), (a[1] + b[1]) / 2, 1e-12);
        EXPECT_LT(4 * (a[0] - x[i]) - a[1], 0);
      }
    }
    const Recognition none = recognise(lines({0, 1, 4, 5}, {1, 4}), tolerance);
    EXPECT_FALSE(none.is_voronoi);
    EXPECT_NE(none.reason.find("no choice of sites lies within the cells"), std::string::npos) << none.reason;
  }
}

TEST(Recognise, a_moved_vertex_is_noticed) {
  const std::vector<Point> lattice = grid(6, 6, {0, 0}, {4, 0}, {2, 4});
  const std::vector<Point> random = random_sites(100, 2);
  for (const auto& [sites, tolerance] : {std::pair(lattice, 0.0), std::pair(random, 1e-9)}) {
    const PlanarComplex complex = voronoi(sites);
    ASSERT_TRUE(recognise(complex, tolerance).is_voronoi);
    for (std::size_t v = 0; v < complex.vertices.size(); v += 7) {
      PlanarComplex moved = complex;
      moved.vertices[v][0] += 1e-7 * size_of(complex);
      const Recognition found = recognise(moved, tolerance);
      EXPECT_FALSE(found.is_voronoi) << v;
      EXPECT_NE(found.reason.find("is on no bisector"), std::string::npos) << found.reason;
    }
  }
}

/// Layers of height 1 between two half-planes, each cut at the given places from left to right.
PlanarComplex wall(const std::vector<std::set<double>>& cuts) {
  PlanarComplex complex{{}, {{-1, 0}, {1, 0}}, {}};
  std::vector<std::vector<Index>> line(cuts.size() + 1);  // the vertices of each, from left to right
  for (std::size_t j = 0; j < line.size(); ++j) {
    std::set<double> places = j < cuts.size() ? cuts[j] : std::set<double>{};
    if (j > 0) places.insert(cuts[j - 1].begin(), cuts[j - 1].end());
    for (const double x : places) {
      line[j].push_back(static_cast<Index>(complex.vertices.size()));
      complex.vertices.push_back({x, static_cast<double>(j)});
    }
  }
  const auto left = static_cast<Index>(complex.vertices.size());
  const Index right = left + 1;
  const auto between = [&](std::size_t j, double low, double high) {
    std::vector<Index> part;
    std::ranges::copy_if(line[j], std::back_inserter(part),
                         [&](Index v) { return complex.vertices[v][0] >= low && complex.vertices[v][0] <= high; });
    return part;
  };
  for (std::size_t j = 0; j < cuts.size(); ++j) {
    double low = -HUGE_VAL;
    std::vector<double> ends(cuts[j].begin(), cuts[j].end());
    ends.push_back(HUGE_VAL);
    for (const double high : ends) {
      std::vector<Index> brick = between(j, low, high), top = between(j + 1, low, high);
      if (high == HUGE_VAL) brick.push_back(right);
      brick.insert(brick.end(), top.rbegin(), top.rend());
      if (low == -HUGE_VAL) brick.push_back(left);
      complex.cells.push_back(std::move(brick));
      low = high;
    }
  }
  std::vector<Index> ground{right}, sky{left};
  ground.insert(ground.end(), line.front().rbegin(), line.front().rend());
  sky.insert(sky.end(), line.back().begin(), line.back().end());
  ground.push_back(left);
  sky.push_back(right);
  complex.cells.push_back(std::move(ground));
  complex.cells.push_back(std::move(sky));
  return complex;
}

TEST(Recognise, a_brick_wall_is_none) {
  for (const double tolerance : {0.0, 1e-9}) {
    for (const auto& cuts : {std::vector<std::set<double>>{{0, 2, 4}, {1, 3, 5}, {0, 2, 4}}, {{0, 1}}}) {
      const Recognition found = recognise(wall(cuts), tolerance);
      EXPECT_FALSE(found.is_voronoi);
      EXPECT_NE(found.reason, "");
    }
  }
}

// Of (0, 0), (8, 0), (8, 4), (0, 8): the bisectors are those of sites, but each lies opposite its cell.
TEST(Recognise, of_a_furthest_diagram_sites_would_lie_outside_of_their_cells) {
  const PlanarComplex complex{
      {{4, 4}, {2, 2}}, {{1, 0}, {0, 1}, {-1, 0}, {-1, -2}}, {{0, 2, 3}, {0, 3, 4, 1}, {1, 4, 5}, {1, 5, 2, 0}}};
  for (const double tolerance : {0.0, 1e-12}) {
    const Recognition found = recognise(complex, tolerance);
    EXPECT_FALSE(found.is_voronoi);
    EXPECT_EQ(found.freedom, 0);
    EXPECT_LT(found.residual, 1e-15);  // they suit all edges
    EXPECT_NE(found.reason.find("no choice of sites lies within the cells"), std::string::npos) << found.reason;
  }
}

TEST(Recognise, a_power_diagram_is_rarely_one) {
  const test::PointSet points = test::with_random_weights(test::uniform(2, 30, 3), 3);
  const Recognition found = recognise(planar_complex(Diagram(build(points.view()))), 1e-9);
  EXPECT_FALSE(found.is_voronoi);
  EXPECT_GT(found.residual, 1e-9);
}

TEST(PlanarComplex, is_made_of_diagrams_of_points_that_span_the_plane) {
  const std::vector<double> numbers{0, 0, 1, 1, 2, 2};
  EXPECT_THROW(planar_complex(Diagram(build(PointsView(numbers, 2)))), InputError);
  EXPECT_THROW(planar_complex(Diagram(build(test::uniform(3, 9, 1).view()))), InputError);
}

/// The message of the refusal.
std::string refusal(const PlanarComplex& complex, double tolerance = 0) {
  try {
    recognise(complex, tolerance);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Recognise, refuses_what_does_not_divide_the_plane) {
  const PlanarComplex good = voronoi(grid(4, 4, {0, 0}, {4, 0}, {2, 4}));
  const auto cell = std::ranges::find_if(good.cells, [&](const auto& loop) {
    return std::ranges::all_of(loop, [&](Index place) { return place < good.vertices.size(); });
  });
  const auto inner = static_cast<std::size_t>(cell - good.cells.begin());
  const std::string name = "cell " + std::to_string(inner);
  for (const double tolerance : {0.0, 1e-9}) {
    PlanarComplex bad = good;
    bad.cells.erase(bad.cells.begin() + static_cast<std::ptrdiff_t>(inner));
    EXPECT_NE(refusal(bad, tolerance).find("is in 1 cells, not in two"), std::string::npos) << refusal(bad, tolerance);
    bad = good;
    bad.cells.push_back(bad.cells[inner]);
    EXPECT_NE(refusal(bad, tolerance).find("is in 3 cells, not in two"), std::string::npos) << refusal(bad, tolerance);
    bad = good;
    std::ranges::reverse(bad.cells[inner]);
    EXPECT_NE(refusal(bad, tolerance).find(name), std::string::npos) << refusal(bad, tolerance);
    bad = good;
    bad.cells[inner].push_back(99999);
    EXPECT_EQ(refusal(bad, tolerance), name + ": there is no place 99999");
    bad = good;
    bad.cells[inner].resize(2);
    EXPECT_EQ(refusal(bad, tolerance), name + " is no loop: it has less than 3 places");
    bad = good;  // a corner far inside of the cell
    const Index place = bad.cells[inner][0];
    const Point &p = good.vertices[bad.cells[inner][2]], &q = good.vertices[bad.cells[inner][3]];
    bad.vertices[place] = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
    EXPECT_NE(refusal(bad, tolerance).find("is not convex"), std::string::npos) << refusal(bad, tolerance);
    bad = good;
    bad.vertices[3][1] = std::nan("");
    EXPECT_EQ(refusal(bad, tolerance), "vertex 3 is not finite");
    bad = good;
    bad.directions[2] = {0, 0};
    EXPECT_EQ(refusal(bad, tolerance), "direction 2 leads nowhere");
    bad = good;
    bad.vertices.push_back({0, 0});
    bad.directions.clear();
    EXPECT_NE(refusal(bad, tolerance), "none");
    EXPECT_EQ(refusal({}, tolerance), "no cells: they must cover the plane");
  }
  EXPECT_EQ(refusal(good), "none");
  EXPECT_EQ(refusal(good, -1), "the tolerance must be from 0 to 0.1");
  EXPECT_EQ(refusal(good, std::nan("")), "the tolerance must be from 0 to 0.1");
}

TEST(Recognise, refuses_planes_that_lie_upon_each_other) {
  PlanarComplex two = lines({0, 2}, {0, 1});
  const PlanarComplex other = lines({1, 3}, {0, 1});
  for (auto loop : other.cells) {  // places 0, 1 become 4, 5; directions 2, 3 become 8, 9 of vertices 0 to 5
    for (Index& place : loop) place += 10;
    two.cells.push_back(loop);
  }
  const auto renamed = [](Index place) {
    const std::map<Index, Index> names{{2, 4}, {3, 5}, {10, 2}, {11, 3}, {12, 6}, {13, 7}};
    return names.contains(place) ? names.at(place) : place;
  };
  for (auto& loop : two.cells) std::ranges::transform(loop, loop.begin(), renamed);
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  two.directions.insert(two.directions.end(), other.directions.begin(), other.directions.end());
  EXPECT_EQ(refusal(two), "cell 3 has no connection with cell 0 through edges");
  // Six sectors of a third of a turn each: twice around.
  const PlanarComplex twice{{{0, 0}},
                            {{1, 0}, {-1, 2}, {-1, -2}, {1, 0}, {-1, 2}, {-1, -2}},
                            {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}}};
  EXPECT_EQ(refusal(twice), "the cells at vertex 0 do not surround it exactly once");
}

TEST(Recognise, refuses_strips_turned_inside_out_and_edges_within_the_rounding) {
  PlanarComplex strips = lines({0, 1, 2}, {0, 1});
  std::swap(strips.vertices[0], strips.vertices[1]);
  EXPECT_NE(refusal(strips).find("cell 1 is not convex"), std::string::npos) << refusal(strips);
  EXPECT_NE(refusal(strips, 1e-9).find("cell 1 is not convex"), std::string::npos);
  const PlanarComplex lattice = voronoi(grid(4, 4, {0, 0}, {4, 0}, {2, 4}));
  EXPECT_NE(refusal(lattice, 0.09).find("is not longer than the tolerance"), std::string::npos);
}

}  // namespace
}  // namespace delone
