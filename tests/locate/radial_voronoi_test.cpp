#include "delone/locate/radial_voronoi.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "delone/base/errors.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"
#include "support/float_modes.hpp"

namespace delone {
namespace {

using namespace test;
using BigInt = boost::multiprecision::cpp_int;

constexpr double kLargest = std::numeric_limits<double>::max();

// ---------------------------------------------------------------------------------------------------------------------
// Against brute force

/// Sites and queries as integers over one power of two; the nearest row by comparing all squared distances.
class BruteForce {
 public:
  BruteForce(const std::vector<double>& sites, const std::vector<double>& queries) {
    for (const auto* list : {&sites, &queries}) {
      for (const double x : *list) unit_ = std::min(unit_, exponent(x));
    }
    for (const double x : sites) sites_.push_back(integer(x));
    for (const double x : queries) queries_.push_back(integer(x));
  }

  Index nearest(std::size_t query) const {
    Index best = kNone;
    BigInt least;
    for (std::size_t row = 0; 2 * row < sites_.size(); ++row) {
      const BigInt x = sites_[2 * row] - queries_[2 * query];
      const BigInt y = sites_[2 * row + 1] - queries_[2 * query + 1];
      BigInt square = x * x + y * y;
      if (best != kNone && square >= least) continue;
      best = static_cast<Index>(row);
      least = std::move(square);
    }
    return best;
  }

 private:
  static int exponent(double x) {
    int e = 0;
    std::frexp(x, &e);
    return e - 53;
  }
  BigInt integer(double x) const {
    int e = 0;
    const double fraction = std::frexp(x, &e);
    return BigInt(static_cast<std::int64_t>(std::ldexp(fraction, 53))) << (e - 53 - unit_);
  }

  int unit_ = -53;
  std::vector<BigInt> sites_, queries_;
};

/// Random points, sites, midpoints of two sites, centres of three, coordinates taken from different sites, neighbours
/// of all these in the last bit, and points far away.
std::vector<double> hard_queries(const PointSet& points, std::size_t count, Random& random) {
  std::vector<double> queries;
  const auto x = [&](std::size_t axis) {
    return points.size() == 0 ? unit_random(random) : points.coordinates[2 * (random() % points.size()) + axis];
  };
  const auto between = [&](double a, double b) {
    const double share = random() % 2 == 0 ? 0.5 : unit_random(random);
    return a * share + b * (1 - share);
  };
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 2> q{x(0), x(1)};
    switch (random() % 7) {
      case 0:
        q = {between(x(0), x(0)), between(x(1), x(1))};
        break;
      case 1:
      case 2: {  // between two sites
        const std::size_t n = std::max<std::size_t>(points.size(), 1);
        const std::size_t a = random() % n;
        const std::size_t b = random() % n;
        for (std::size_t axis = 0; axis < 2 && points.size() != 0; ++axis) {
          q[axis] = 0.5 * points.coordinates[2 * a + axis] + 0.5 * points.coordinates[2 * b + axis];
        }
        break;
      }
      case 3:
        q[0] = std::nextafter(q[0], random() % 2 == 0 ? kLargest : -kLargest);
        break;
      case 4:
        q[random() % 2] = (unit_random(random) - 0.5) * kLargest;
        break;
      default:
        break;
    }
    queries.insert(queries.end(), q.begin(), q.end());
  }
  return queries;
}

void expect_nearest_as_by_brute_force(const PointSet& points, const std::vector<double>& queries, std::uint64_t seed) {
  const RadialVoronoi diagram(built(points), seed);
  const BruteForce truth(points.coordinates, queries);
  for (std::size_t i = 0; 2 * i < queries.size(); ++i) {
    const std::span q(queries.data() + 2 * i, 2);
    ASSERT_EQ(diagram.nearest(q), truth.nearest(i)) << q[0] << ' ' << q[1] << ", seed " << seed << ", " << points;
  }
}

TEST(RadialVoronoi, finds_the_nearest_site_in_every_family) {
  Random random(1);
  for (const std::size_t n : {1U, 2U, 3U, 4U, 5U, 9U, 30U}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      for (const PointSet& points : unweighted_families(2, n, seed + 10 * n)) {
        expect_nearest_as_by_brute_force(points, hard_queries(points, 30, random), seed);
      }
    }
  }
}

TEST(RadialVoronoi, finds_the_nearest_site_among_hundreds) {
  Random random(2);
  for (const PointSet& points :
       {uniform(2, 400, 1), lattice(2, 600, 20, 2), circle_of_24_bits(2, 300, 3), cospherical(2, 8, 4)}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      expect_nearest_as_by_brute_force(points, hard_queries(points, 300, random), seed);
    }
  }
}

TEST(RadialVoronoi, takes_the_lowest_row_where_many_sites_are_as_near) {
  // 12 integer points of a circle of radius 5, their centre far inside an empty circle, some of them twice.
  const std::vector<std::array<double, 2>> circle{{3, 4},  {-3, 4}, {5, 0},  {0, -5},  {-5, 0}, {4, 3},
                                                  {4, -3}, {0, 5},  {-4, 3}, {-4, -3}, {3, -4}, {-3, -4}};
  Random random(3);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    PointSet points{"circle of radius 5", 2, {}, {}};
    for (const std::size_t i : random_permutation(circle.size(), random)) {
      for (std::uint64_t copy = 0; copy <= random() % 2; ++copy) {
        points.coordinates.insert(points.coordinates.end(), circle[i].begin(), circle[i].end());
      }
    }
    const RadialVoronoi diagram(built(points), seed);
    EXPECT_EQ(diagram.nearest(std::array{0.0, 0.0}), 0U) << seed;
    expect_nearest_as_by_brute_force(points, {0, 0, 1, 2, 3.5, 3.5, 7, 7, 0, 9, 9, 0, 0x1p-1000, 0, 3, 4}, seed);
  }
}

TEST(RadialVoronoi, finds_every_site_itself_and_a_duplicate_by_its_lowest_row) {
  for (const PointSet& points : unweighted_families(2, 60, 4)) {
    const AnyTriangulation t = built(points);
    const RadialVoronoi diagram(t, 9);
    EXPECT_EQ(diagram.site_count(), t.vertex_count());
    for (std::size_t row = 0; row < points.size(); ++row) {
      EXPECT_EQ(diagram.nearest(points.view()[row]), t.status(static_cast<Index>(row)).of) << points;
    }
  }
}

TEST(RadialVoronoi, no_answer_depends_on_the_seed) {
  const PointSet points = lattice(2, 300, 12, 6);
  const AnyTriangulation t = built(points);
  const RadialVoronoi first(t, 0);
  const RadialVoronoi same(t, 0);
  const RadialVoronoi other(t, 1);
  EXPECT_EQ(first.triangle_count(), same.triangle_count());
  EXPECT_NE(first.triangle_count(), other.triangle_count());
  Random random(7);
  const std::vector<double> queries = hard_queries(points, 300, random);
  for (std::size_t i = 0; i < queries.size(); i += 2) {
    const std::span q(queries.data() + i, 2);
    EXPECT_EQ(first.nearest(q), other.nearest(q));
  }
}

TEST(RadialVoronoi, does_not_depend_on_the_callers_rounding_and_denormals) {
  Random random(11);
  for (const PointSet& points : unweighted_families(2, 30, 12)) {
    const RadialVoronoi plain(built(points), 1);
    const std::vector<double> queries = hard_queries(points, 40, random);
    std::vector<Index> expected;
    for (std::size_t i = 0; i < queries.size(); i += 2) expected.push_back(plain.nearest({queries.data() + i, 2}));
    const AnyTriangulation t = built(points);
    const Rounding upward(FE_UPWARD);
    const FlushedDenormals flushed(Flush::both);
    const RadialVoronoi diagram(t, 1);
    for (std::size_t i = 0; i < queries.size(); i += 2) {
      ASSERT_EQ(diagram.nearest({queries.data() + i, 2}), expected[i / 2]) << points;
    }
  }
}

TEST(RadialVoronoi, outlives_the_triangulation_and_can_be_copied) {
  RadialVoronoi copy(AnyTriangulation(2), 0);
  {
    const RadialVoronoi diagram(built(lattice(2, 50, 100, 8)), 5);
    copy = diagram;
  }
  const PointSet points = lattice(2, 50, 100, 8);
  EXPECT_EQ(copy.nearest(points.view()[17]), 17U);
}

TEST(RadialVoronoi, without_sites_there_is_no_nearest) {
  const RadialVoronoi diagram((AnyTriangulation(2)));
  EXPECT_EQ(diagram.nearest(std::array{1.0, 2.0}), kNone);
  EXPECT_EQ(diagram.site_count(), 0U);
}

TEST(RadialVoronoi, refuses_weights_other_dimensions_and_queries_that_are_no_points) {
  EXPECT_THROW(RadialVoronoi(built(with_random_weights(uniform(2, 9, 1), 1))), InputError);
  EXPECT_THROW(RadialVoronoi(built(uniform(3, 9, 1))), InputError);
  EXPECT_THROW(RadialVoronoi(built(uniform(1, 9, 1))), InputError);
  const RadialVoronoi diagram(built(uniform(2, 9, 1)));
  EXPECT_THROW(diagram.nearest(std::array{0.0}), InputError);
  EXPECT_THROW(diagram.nearest(std::array{0.0, 0.0, 0.0}), InputError);
  EXPECT_THROW(diagram.nearest(std::array{0.0, std::nan("")}), InputError);
  EXPECT_THROW(diagram.nearest(std::array{HUGE_VAL, 0.0}), InputError);
}

// ---------------------------------------------------------------------------------------------------------------------
// The theorems, by counting

struct Means {
  double triangles, rays, comparisons, passed;
};

Means means(const RadialSteps& steps, double queries) {
  return {static_cast<double>(steps.triangles) / queries, static_cast<double>(steps.rays) / queries,
          static_cast<double>(steps.rays + steps.bisectors) / queries, static_cast<double>(steps.passed) / queries};
}

/// n sites on a line and one beside it: whoever inserts in the wrong order makes fans over and over.
PointSet line_and_arc(std::size_t n) {
  PointSet points{"line and arc", 2, {}, {}};
  for (std::size_t i = 0; i < n / 2; ++i) {
    const double x = static_cast<double>(i);
    points.coordinates.insert(points.coordinates.end(), {-1.0 - x, 0.0, x / static_cast<double>(n), 1.0 + 0x1p-40 * x});
  }
  return points;
}

/// [GKS92] theorem 5.2: every new edge of the Delaunay triangulation makes at most four triangles, and a new site has
/// less than six in expectation.
TEST(RadialVoronoi, keeps_on_the_average_at_most_24_triangles_a_site) {
  for (const PointSet& points :
       {uniform(2, 3000, 1), lattice(2, 3000, 60, 2), circle_of_24_bits(2, 3000, 3), line_and_arc(3000)}) {
    double triangles = 0;
    double sites = 0;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const RadialVoronoi diagram(built(points), seed);
      triangles += static_cast<double>(diagram.triangle_count());
      sites += static_cast<double>(diagram.site_count());
      EXPECT_LT(diagram.memory_bytes(), 400 * diagram.site_count() + 40000);
    }
    EXPECT_LT(triangles, 26 * sites) << points.name;
    EXPECT_GT(triangles, 8 * sites) << points.name;
  }
}

/// [GKS92] theorem 5.4: version r changes the triangle of a fixed query with probability at most 4 / r.
TEST(RadialVoronoi, queries_visit_few_triangles_and_compare_by_the_square_of_the_logarithm) {
  for (const std::size_t n : {1000U, 10000U, 100000U}) {
    const RadialVoronoi diagram(built(uniform(2, n, n)), n);
    const PointSet queries = uniform(2, 2000, 77);
    RadialSteps steps;
    for (std::size_t i = 0; i < queries.size(); ++i) diagram.nearest(queries.view()[i], steps);
    const Means mean = means(steps, static_cast<double>(queries.size()));
    const double log2 = std::log2(static_cast<double>(n));
    EXPECT_LT(mean.triangles, 4 * (std::log(n) + 1)) << n;
    EXPECT_GT(mean.triangles, std::log(n)) << n;
    EXPECT_LT(mean.comparisons, log2 * log2) << n;
  }
}

TEST(RadialVoronoi, sites_on_a_line_are_found_by_binary_search) {
  PointSet points{"line", 2, {}, {}};
  for (int i = 0; i < 5000; ++i) {
    points.coordinates.insert(points.coordinates.end(), {static_cast<double>(3 * i), static_cast<double>(4 * i)});
  }
  const RadialVoronoi diagram(built(points));
  Random random(5);
  RadialSteps steps;
  for (int i = 0; i < 100; ++i) {
    const auto at = static_cast<double>(random() % 4900);
    const auto off = static_cast<double>(random() % 3) * 1e6;
    EXPECT_EQ(diagram.nearest(std::array{3 * at + 4 * off, 4 * at - 3 * off}, steps), static_cast<Index>(at));
    EXPECT_EQ(diagram.nearest(std::array{3 * (at + 0.5), 4 * (at + 0.5)}), static_cast<Index>(at));
  }
  EXPECT_LE(steps.bisectors, 100U * 13U);
  EXPECT_EQ(diagram.triangle_count(), 0U);
}

/// n sites close to the unit circle, then its centre.
PointSet wheel(std::size_t n, double noise) {
  PointSet points{"wheel", 2, {}, {}};
  Random random(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    const double radius = 1.0 + noise * unit_random(random);
    points.coordinates.insert(points.coordinates.end(), {radius * std::cos(angle), radius * std::sin(angle)});
  }
  points.coordinates.insert(points.coordinates.end(), {0.0, 0.0});
  return points;
}

/// The mean cost of one query over random orders of insertion.
Means over_orders(const PointSet& points, const std::array<double, 2>& q, std::uint64_t orders) {
  const AnyTriangulation t = built(points);
  RadialSteps steps;
  for (std::uint64_t seed = 0; seed < orders; ++seed) {
    EXPECT_EQ(RadialVoronoi(t, seed).nearest(q, steps), t.row_count() - 1);
  }
  return means(steps, static_cast<double>(orders));
}

/// Why a destroyed triangle points to a bisector and not only to a plane. The triangle of s that holds q has the
/// Voronoi vertices (-6, -4) and (3, -4) before the newcomer takes the second one away. q stays in the region of s, but
/// seen from the newcomer it lies behind the base of the sector towards k.
TEST(RadialVoronoi, the_way_from_a_new_site_to_a_query_may_lead_through_a_third_region) {
  constexpr Index s = 0;
  constexpr Index k = 1;
  constexpr Index newcomer = 4;
  const PointSet points{"third region", 2, {0, 0, 0, -8, -12, -8, 8, -4, 4, -6}, {}};
  const std::array q{-3.0, -3.5};
  const std::array halfway{0.5, -4.75};
  const RadialVoronoi before(built(rows(points, 0, 4)));
  EXPECT_EQ(before.nearest(q), s);
  EXPECT_EQ(before.nearest(std::array{3.0, -4.0}), s);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const RadialVoronoi after(built(points), seed);
    EXPECT_EQ(after.nearest(q), s);
    EXPECT_EQ(after.nearest(std::array{3.0, -4.0}), newcomer);
    EXPECT_EQ(after.nearest(halfway), k);
  }
}

/// [GKS92] first remark after theorem 5.4, figure 6. Site j is a little nearer to the centre i than all others, so
/// before i comes the query p close to i lies in j's region, whatever its direction from i; here it is the opposite
/// one. The triangle that i destroys points to the sector of i on the bisector with j, and p is half the wheel away
/// from it.
TEST(RadialVoronoi, the_new_triangle_can_be_far_from_the_bisector_that_led_to_it) {
  for (const std::size_t n : {100U, 400U, 1600U}) {
    PointSet points = wheel(n, 0.0);
    points.coordinates[0] = 1.0 - 1e-3 / static_cast<double>(n);
    const Means mean = over_orders(points, {-1e-4 / static_cast<double>(n), 1e-12}, 40);
    const double log2 = std::log2(static_cast<double>(n));
    // j comes before i in half of the orders; then half the sectors of i lie between, of n / 3 of them in the mean.
    EXPECT_GT(mean.passed, static_cast<double>(n) / 12) << n;
    EXPECT_LT(mean.comparisons, log2 * log2) << n;
  }
}

/// [GKS92] second remark after theorem 5.4. Very close to the centre the nearest site of the wheel has nothing to do
/// with the direction of the query, and when the centre comes its sectors are many: walking through them one by one
/// does not amortize over the triangles visited, which remain few although all later sites change the centre's region.
TEST(RadialVoronoi, a_sequential_walk_through_sectors_would_not_amortize) {
  for (const std::size_t n : {100U, 400U, 1600U}) {
    const PointSet points = wheel(n, 1e-8);
    const AnyTriangulation t = built(points);
    ASSERT_EQ(t.star(t.vertex(static_cast<Index>(n))).size(), n);
    const Means mean = over_orders(points, {3e-13, -4e-13}, 40);
    const double size = static_cast<double>(n);
    EXPECT_GT(mean.passed, size / 16) << n;
    EXPECT_LT(mean.triangles, 4 * (std::log(size) + 1)) << n;
    EXPECT_GT(mean.passed / mean.triangles, size / 400) << n;  // grows without bound
    EXPECT_LT(mean.comparisons, std::log2(size) * std::log2(size)) << n;
  }
}

}  // namespace
}  // namespace delone
