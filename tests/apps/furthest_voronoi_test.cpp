#include "delone/apps/furthest_voronoi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "delone/apps/hull.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/base/errors.hpp"
#include "delone/exact/determinant.hpp"
#include "delone/geometry/sites.hpp"
#include "exact/integer.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;
using Integer = exact::BigInt;
using Rational = boost::multiprecision::cpp_rational;
using Vector = std::vector<Integer>;

Rational power_of_two(int exponent) {
  return exponent < 0 ? Rational(1, Integer(1) << -exponent) : Rational(Integer(1) << exponent);
}
Integer dot(const Vector& a, const Vector& b) {
  Integer sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
  return sum;
}
Vector difference(Vector a, const Vector& b) {
  for (std::size_t j = 0; j < a.size(); ++j) a[j] -= b[j];
  return a;
}
Integer square(const Vector& a, const Vector& b) {
  const Vector d = difference(a, b);
  return dot(d, d);
}

int common_unit(const PointSet& points) {
  NumberRange range;
  range.include(points.coordinates);
  return range.unit;
}

/// Every row, divided by the common unit.
std::vector<Vector> integral(const PointSet& points) {
  const Rational scale = power_of_two(-common_unit(points));
  std::vector<Vector> all(points.size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (const double x : points.view()[row]) all[row].push_back(Integer(numerator(Rational(x) * scale)));
  }
  return all;
}

void for_every_family(int dimensions, std::size_t largest, const auto& test) {
  for (int dimension = 1; dimension <= dimensions; ++dimension) {
    for (const std::size_t n : {1, 2, 3, 5, 9, 20}) {
      if (n > largest) continue;
      for (const PointSet& points : unweighted_families(dimension, n, n)) test(points);
    }
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// The smallest ball

/// A centre over a common denominator, and the squared radius over the square of it.
struct Ball {
  Vector centre;
  Integer denominator, squared_radius;

  Integer squared_distance(const Vector& x) const {
    Vector scaled = x;
    for (Integer& coordinate : scaled) coordinate *= denominator;
    return square(scaled, centre);
  }
};

/// The ball about the one point of their flat that is as far from all rows, if it lies strictly inside of their
/// simplex: c = p_0 + sum w_i d_i with 2 d_i . (c - p_0) = |d_i|^2, by Cramer's rule.
template <int N>
std::optional<Ball> determined(const std::vector<Vector>& points, const std::vector<Index>& rows) {
  std::vector<Vector> d;
  for (std::size_t i = 1; i < rows.size(); ++i) d.push_back(difference(points[rows[i]], points[rows[0]]));
  Matrix<N, Integer> m;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) m[i][j] = 2 * dot(d[i], d[j]);
  }
  Ball ball{points[rows[0]], determinant<N>(m), 0};
  if (ball.denominator == 0) return {};
  for (Integer& x : ball.centre) x *= ball.denominator;
  Integer rest = ball.denominator;
  for (std::size_t i = 0; i < N; ++i) {
    Matrix<N, Integer> replaced = m;
    for (std::size_t j = 0; j < N; ++j) replaced[j][i] = dot(d[j], d[j]);
    const Integer weight = determinant<N>(replaced);
    if (weight <= 0) return {};
    rest -= weight;
    for (std::size_t j = 0; j < ball.centre.size(); ++j) ball.centre[j] += weight * d[i][j];
  }
  if (rest <= 0) return {};
  ball.squared_radius = ball.squared_distance(points[rows[0]]);
  return ball;
}

std::optional<Ball> determined(const std::vector<Vector>& points, const std::vector<Index>& rows) {
  return with_dimension(static_cast<int>(rows.size()) - 1,
                        [&](auto dimension) { return determined<dimension>(points, rows); });
}

bool is_nearest(double x, const Rational& truth) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (std::isinf(x)) return truth > std::numeric_limits<double>::max();
  for (const double other : {std::nextafter(x, infinity), std::nextafter(x, -infinity)}) {
    if (std::isfinite(other) && abs(Rational(other) - truth) < abs(Rational(x) - truth)) return false;
  }
  return true;
}

bool is_nearest_root(double x, const Rational& square) {
  const double largest = std::numeric_limits<double>::max();
  if (std::isinf(x)) return square > Rational(largest) * largest;
  const Rational up = x == largest ? Rational(x) : (Rational(x) + Rational(std::nextafter(x, HUGE_VAL))) / 2;
  const Rational down = (Rational(x) + Rational(std::nextafter(x, -HUGE_VAL))) / 2;
  return square <= up * up && (down < 0 || square >= down * down);
}

void expect_rounded(const EnclosingBall& ball, const Ball& truth, const PointSet& points) {
  const Rational unit = power_of_two(common_unit(points));
  for (std::size_t j = 0; j < truth.centre.size(); ++j) {
    EXPECT_TRUE(is_nearest(ball.centre[j], unit * Rational(truth.centre[j], truth.denominator))) << j << "\n" << points;
  }
  const Rational square = unit * unit * Rational(truth.squared_radius, truth.denominator * truth.denominator);
  EXPECT_TRUE(is_nearest(ball.squared_radius, square)) << points;
  EXPECT_TRUE(is_nearest_root(ball.radius, square)) << points;
}

void expect_smallest(const PointSet& points) {
  const EnclosingBall ball = smallest_enclosing_ball(points.view());
  const std::vector<Vector> all = integral(points);
  ASSERT_TRUE(std::ranges::is_sorted(ball.support)) << points;
  // A ball about a convex combination of points on its sphere is the smallest one that holds them.
  const std::optional<Ball> truth = determined(all, ball.support);
  ASSERT_TRUE(truth) << points;
  std::vector<Index> on_sphere;
  for (std::size_t row = 0; row < all.size(); ++row) {
    const Integer distance = truth->squared_distance(all[row]);
    ASSERT_LE(distance, truth->squared_radius) << row << "\n" << points;
    if (distance == truth->squared_radius) on_sphere.push_back(static_cast<Index>(row));
  }
  EXPECT_EQ(ball.on_sphere, on_sphere) << points;
  expect_rounded(ball, *truth, points);
}

TEST(SmallestBall, holds_all_and_its_support_proves_that_none_is_smaller) {
  for_every_family(4, 20, expect_smallest);
  for (const int dimension : {2, 3}) {
    for (const PointSet& points : unweighted_families(dimension, 100, 4)) expect_smallest(points);
  }
}

TEST(SmallestBall, works_up_to_dimension_8) {
  for (int dimension = 5; dimension <= 8; ++dimension) {
    expect_smallest(uniform(dimension, 60, 1));
    expect_smallest(lattice(dimension, 60, 3, 1));
    expect_smallest(cospherical(dimension, 30, 1));
    expect_smallest(flat(dimension, 3, 30, 1));
  }
}

TEST(SmallestBall, takes_more_rows_than_a_triangulation_could_have_in_that_dimension) {
  const PointSet points = uniform(8, 10000, 2);
  const EnclosingBall ball = smallest_enclosing_ball(points.view());
  double furthest = 0;
  for (std::size_t row = 0; row < points.size(); ++row) {
    double square = 0;
    for (std::size_t j = 0; j < 8; ++j) square += std::pow(points.view()[row][j] - ball.centre[j], 2);
    furthest = std::max(furthest, square);
  }
  EXPECT_NEAR(furthest, ball.squared_radius, 1e-14);
}

/// Calls f with every face of every cell.
template <class F>
void for_faces(const CellTable& cells, const F& f) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (unsigned set = 1; set < (1U << cells.corners); ++set) {
      std::vector<Index> face;
      for (std::size_t i = 0; i < cells[c].size(); ++i) {
        if ((set >> i & 1) != 0) face.push_back(cells[c][i]);
      }
      f(face);
    }
  }
}

// The squared distance of the furthest site is a convex function, so its minimum is the only place that its own sites
// surround: a face of the furthest triangulation with its circumcentre inside, and all other sites nearer.
TEST(SmallestBall, is_about_the_vertex_of_the_furthest_diagram_that_lies_in_the_dual_cell) {
  for_every_family(4, 9, [](const PointSet& points) {
    const std::vector<Vector> all = integral(points);
    const EnclosingBall ball = smallest_enclosing_ball(points.view());
    std::size_t found = 0;
    for_faces(furthest_delaunay(points.view()).cells, [&](const std::vector<Index>& face) {
      const std::optional<Ball> of_face = determined(all, face);
      const auto is_inside = [&](const Vector& x) { return of_face->squared_distance(x) <= of_face->squared_radius; };
      if (!of_face || !std::ranges::all_of(all, is_inside)) return;
      if (++found == 1) expect_rounded(ball, *of_face, points);
    });
    EXPECT_GT(found, 0U) << points;
  });
}

TEST(SmallestBall, does_not_depend_on_the_order_of_rows) {
  Random random(3);
  for (const PointSet& points : unweighted_families(3, 30, 8)) {
    const EnclosingBall ball = smallest_enclosing_ball(points.view());
    const std::vector<std::size_t> order = random_permutation(points.size(), random);
    const EnclosingBall other = smallest_enclosing_ball(permuted(points, order).view());
    EXPECT_EQ(other.centre, ball.centre) << points;
    EXPECT_EQ(other.radius, ball.radius) << points;
    std::vector<Index> on_sphere;
    for (const Index row : other.on_sphere) on_sphere.push_back(static_cast<Index>(order[row]));
    std::ranges::sort(on_sphere);
    EXPECT_EQ(on_sphere, ball.on_sphere) << points;
  }
}

TEST(SmallestBall, of_nothing_and_of_one_place) {
  const EnclosingBall none = smallest_enclosing_ball(PointsView(std::span<const double>(), 3));
  EXPECT_TRUE(none.centre.empty() && none.support.empty() && none.on_sphere.empty());
  const std::vector<double> same{4, -2, 4, -2, 4, -2};
  const EnclosingBall point = smallest_enclosing_ball(PointsView(same, 2));
  EXPECT_EQ(point.centre, (std::vector<double>{4, -2}));
  EXPECT_EQ(point.radius, 0.0);
  EXPECT_EQ(point.support, (std::vector<Index>{0}));
  EXPECT_EQ(point.on_sphere, (std::vector<Index>{0, 1, 2}));
}

TEST(SmallestBall, of_a_square_lists_all_corners_on_the_circle) {
  const std::vector<double> square{0, 0, 2, 0, 2, 2, 0, 2, 1, 1.5};
  const EnclosingBall ball = smallest_enclosing_ball(PointsView(square, 2));
  EXPECT_EQ(ball.centre, (std::vector<double>{1, 1}));
  EXPECT_EQ(ball.squared_radius, 2.0);
  EXPECT_EQ(ball.support.size(), 2U);
  EXPECT_EQ(ball.on_sphere, (std::vector<Index>{0, 1, 2, 3}));
}

// The diameter is (1 + 2^-53) times a root that is just above 1: just above the middle between two doubles.
TEST(SmallestBall, radius_is_rounded_once) {
  const std::vector<double> above{-0x1p-53, 0, 1, 0x1p-100};
  EXPECT_EQ(smallest_enclosing_ball(PointsView(above, 2)).radius, (1 + 0x1p-52) / 2);
  const std::vector<double> in_the_middle{-0x1p-53, 0, 1, 0};
  EXPECT_EQ(smallest_enclosing_ball(PointsView(in_the_middle, 2)).radius, 0.5);
}

TEST(SmallestBall, beyond_the_largest_double_has_an_infinite_radius_and_a_finite_centre) {
  const double most = std::numeric_limits<double>::max();
  const std::vector<double> ends{-most, -most, most, most};
  const EnclosingBall ball = smallest_enclosing_ball(PointsView(ends, 2));
  EXPECT_EQ(ball.centre, (std::vector<double>{0, 0}));
  EXPECT_EQ(ball.radius, HUGE_VAL);
  EXPECT_EQ(ball.support, (std::vector<Index>{0, 1}));
}

// ---------------------------------------------------------------------------------------------------------------------
// The farthest pair

void expect_farthest(const PointSet& points) {
  const std::vector<Vector> all = integral(points);
  Integer largest = -1;
  std::array<Index, 2> pair{kNone, kNone};
  for (Index a = 0; a < all.size(); ++a) {
    for (Index b = a + 1; b < all.size(); ++b) {
      Integer distance = square(all[a], all[b]);
      if (distance <= largest) continue;
      largest = std::move(distance);
      pair = {a, b};
    }
  }
  const FarthestPair found = farthest_pair(points.view());
  EXPECT_EQ((std::array{found.first, found.second}), pair) << points;
}

TEST(FarthestPair, is_that_of_trying_every_pair) {
  for_every_family(8, 20, expect_farthest);
  for (const PointSet& points : unweighted_families(2, 80, 6)) expect_farthest(points);
}

TEST(FarthestPair, turns_around_polygons_with_many_corners) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    expect_farthest(circle_of_24_bits(2, 120, seed));
    expect_farthest(circle_of_24_bits(3, 60, seed));
    PointSet oval = circle_of_24_bits(2, 90, seed);
    for (std::size_t i = 0; i < oval.coordinates.size(); i += 2) oval.coordinates[i] *= 1.25;
    expect_farthest(oval);
  }
  PointSet ties{"all integers on a circle", 2, {}};
  for (int x = -65; x <= 65; ++x) {
    for (int y = -65; y <= 65; ++y) {
      if (x * x + y * y == 65 * 65) ties.coordinates.insert(ties.coordinates.end(), {double(x), double(y)});
    }
  }
  ASSERT_EQ(ties.size(), 36U);
  expect_farthest(ties);
}

TEST(FarthestPair, need_not_be_an_edge_of_the_furthest_triangulation) {
  const std::vector<double> kite{-500, 0, 500, 0, -492, 100, -492, -100};
  const FarthestPair pair = farthest_pair(PointsView(kite, 2));
  EXPECT_EQ(pair.first, 0U);
  EXPECT_EQ(pair.second, 1U);
  EXPECT_EQ(furthest_delaunay(PointsView(kite, 2)).cells.vertices, (std::vector<Index>{0, 3, 2, 1, 2, 3}));
}

TEST(FarthestPair, of_less_than_two_rows_is_none) {
  for (const std::vector<double>& few : {std::vector<double>{}, std::vector<double>{1, 2}}) {
    const FarthestPair pair = farthest_pair(PointsView(few, 2));
    EXPECT_EQ(pair.first, kNone);
    EXPECT_EQ(pair.second, kNone);
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// The diagram

/// normal . x < offset
struct Inequality {
  Vector normal;
  Integer offset;
};

/// Whether some x meets all inequalities, by eliminating one variable after the other (Fourier and Motzkin).
bool can_be_met(std::vector<Inequality> system, std::size_t variables) {
  while (variables-- > 0) {
    std::vector<Inequality> next;
    for (const Inequality& a : system) {
      if (a.normal[variables] == 0) next.push_back(a);
      if (a.normal[variables] <= 0) continue;
      for (const Inequality& b : system) {
        if (b.normal[variables] >= 0) continue;
        Inequality sum{a.normal, a.offset * -b.normal[variables] + b.offset * a.normal[variables]};
        for (std::size_t j = 0; j < sum.normal.size(); ++j)
          sum.normal[j] = a.normal[j] * -b.normal[variables] + b.normal[j] * a.normal[variables];
        next.push_back(std::move(sum));
      }
    }
    system = std::move(next);
  }
  return std::ranges::all_of(system, [](const Inequality& i) { return i.offset > 0; });
}

/// |x - a|^2 > |x - c|^2 is 2 (a - c) . x < |a|^2 - |c|^2.
Inequality further(const Vector& a, const Vector& c) {
  Inequality result{difference(a, c), dot(a, a) - dot(c, c)};
  for (Integer& x : result.normal) x *= 2;
  return result;
}

/// Whether a and b are furthest away, as far as each other and strictly further than all other places, somewhere.
bool share_a_facet(const std::vector<Vector>& all, Index a, Index b) {
  Inequality plane = further(all[a], all[b]);  // with = in place of <
  std::size_t out = 0;
  while (plane.normal[out] == 0) ++out;
  if (plane.normal[out] < 0) plane = further(all[b], all[a]);
  std::vector<Inequality> system;
  for (const Vector& c : all) {
    if (c == all[a] || c == all[b]) continue;
    Inequality i = further(all[a], c);
    const Integer factor = i.normal[out];
    for (std::size_t j = 0; j < i.normal.size(); ++j)
      i.normal[j] = i.normal[j] * plane.normal[out] - factor * plane.normal[j];
    i.offset = i.offset * plane.normal[out] - factor * plane.offset;
    system.push_back(std::move(i));
  }
  return can_be_met(std::move(system), all[a].size());
}

TEST(FurthestDiagram, cells_meet_exactly_where_two_sites_alone_are_furthest) {
  for_every_family(3, 9, [](const PointSet& points) {
    const FurthestVoronoi diagram = furthest_voronoi(points.view());
    const std::vector<Vector> all = integral(points);
    EXPECT_EQ(diagram.rows, convex_hull(points.view()).corners) << points;
    ASSERT_EQ(diagram.offsets.size(), diagram.size() + 1);
    for (std::size_t i = 0; i < diagram.size(); ++i) {
      const Index owner = diagram.rows[i];
      std::vector<Index> neighbours, truth;
      for (std::size_t c = diagram.offsets[i]; c < diagram.offsets[i + 1]; ++c) {
        EXPECT_EQ(diagram.cuts[c].far, owner);
        EXPECT_EQ(diagram.cuts[c].near, diagram.cuts[c].across);
        neighbours.push_back(diagram.cuts[c].across);
      }
      for (const Index other : diagram.rows) {
        if (other != owner && share_a_facet(all, owner, other)) truth.push_back(other);
      }
      EXPECT_EQ(neighbours, truth) << owner << "\n" << points;
    }
  });
}

// Where all cuts of a cell hold, its owner is furthest: so the cuts are enough.
TEST(FurthestDiagram, the_cuts_of_a_cell_leave_the_places_from_which_its_owner_is_furthest) {
  Random random(5);
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 24, 7)) {
      const FurthestVoronoi diagram = furthest_voronoi(points.view());
      const std::vector<Vector> all = integral(points);
      for (int trial = 0; trial < 6; ++trial) {
        // Combinations of the points with weights that sum to one, some far outside.
        Vector place = all[random() % all.size()];
        for (int step = 0; step < 3; ++step) {
          const Vector way = difference(all[random() % all.size()], all[random() % all.size()]);
          const int times = static_cast<int>(random() % 5) - 2;
          for (std::size_t j = 0; j < place.size(); ++j) place[j] += times * way[j];
        }
        Integer largest = -1;
        for (const Vector& x : all) largest = std::max(largest, square(x, place));
        for (std::size_t i = 0; i < diagram.size(); ++i) {
          bool inside = true;
          for (std::size_t c = diagram.offsets[i]; c < diagram.offsets[i + 1]; ++c) {
            const Bisector& cut = diagram.cuts[c];
            inside = inside && square(place, all[cut.near]) <= square(place, all[cut.far]);
          }
          EXPECT_EQ(inside, square(place, all[diagram.rows[i]]) == largest) << diagram.rows[i] << "\n" << points;
        }
      }
    }
  }
}

TEST(FurthestDiagram, cut_cells_divides_a_region_among_the_sites_that_are_furthest) {
  for (const int dimension : {2, 3}) {
    const PointSet points = uniform(dimension, 200, 4);
    const FurthestVoronoi diagram = furthest_voronoi(points.view());
    const std::vector<double> low(points.view()[0].size(), -1.0), high(low.size(), 2.0);
    const CellShapes shapes = cut_cells(points.view(), Region::box(low, high), diagram.offsets, diagram.cuts);
    std::vector<double> owners;
    for (const Index row : diagram.rows)
      owners.insert(owners.end(), points.view()[row].begin(), points.view()[row].end());
    const CellMeasures measures = measure_shapes(shapes, PointsView(owners, dimension));
    double sum = 0;
    for (std::size_t c = 0; c < shapes.size(); ++c) {
      sum += measures.volume[c];
      if (shapes.empty(c)) continue;
      const double* centroid = measures.centroid.data() + c * low.size();
      const auto square = [&](std::size_t row) {
        double total = 0;
        for (std::size_t j = 0; j < low.size(); ++j) total += std::pow(points.view()[row][j] - centroid[j], 2);
        return total;
      };
      for (std::size_t row = 0; row < points.size(); ++row) EXPECT_LE(square(row), square(diagram.rows[c]) + 1e-9);
    }
    EXPECT_NEAR(sum, std::pow(3.0, dimension), 1e-12);
  }
}

TEST(FurthestDiagram, four_corners_of_a_square_meet_in_a_point_and_opposite_cells_in_nothing_more) {
  const std::vector<double> square{0, 0, 1, 0, 1, 1, 0, 1};
  const FurthestVoronoi diagram = furthest_voronoi(PointsView(square, 2));
  EXPECT_EQ(diagram.offsets, (std::vector<std::size_t>{0, 2, 4, 6, 8}));
  EXPECT_EQ(diagram.cuts[0].across, 1U);
  EXPECT_EQ(diagram.cuts[1].across, 3U);
}

TEST(FurthestDiagram, of_nothing_one_place_and_a_line) {
  EXPECT_EQ(furthest_voronoi(PointsView(std::span<const double>(), 2)).size(), 0U);
  const std::vector<double> same{1, 2, 1, 2};
  const FurthestVoronoi one = furthest_voronoi(PointsView(same, 2));
  EXPECT_EQ(one.rows, (std::vector<Index>{0}));
  EXPECT_EQ(one.offsets, (std::vector<std::size_t>{0, 0}));
  const std::vector<double> line{1, 1, 3, 3, 0, 0, 2, 2};
  const FurthestVoronoi two = furthest_voronoi(PointsView(line, 2));
  EXPECT_EQ(two.rows, (std::vector<Index>{1, 2}));
  EXPECT_EQ(two.offsets, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Furthest, points_with_weights_or_without_a_place_are_refused) {
  const PointSet weighted = with_random_weights(uniform(2, 5, 1), 1);
  EXPECT_THROW(furthest_voronoi(weighted.view()), InputError);
  EXPECT_THROW(farthest_pair(weighted.view()), InputError);
  EXPECT_THROW(smallest_enclosing_ball(weighted.view()), InputError);
  const std::vector<double> bad{0, 1, 2, std::nan("")};
  EXPECT_THROW(furthest_voronoi(PointsView(bad, 2)), InputError);
  EXPECT_THROW(farthest_pair(PointsView(bad, 2)), InputError);
  EXPECT_THROW(smallest_enclosing_ball(PointsView(bad, 2)), InputError);
}

}  // namespace
}  // namespace delone
