#include "mesh/wrap_few.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/geometry/affine.hpp"
#include "geometry/sixteen.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

std::optional<AnyTriangulation> wrapped(const PointSet& points) {
  std::optional<Mesh> mesh = wrap_few(points.view(), affine_hull(points.view()), {});
  if (!mesh) return std::nullopt;
  return AnyTriangulation(*std::move(mesh));
}

/// Whether the points are wrapped; what is built must be what insertion makes.
bool expect_inserted(const PointSet& points) {
  const std::optional<AnyTriangulation> t = wrapped(points);
  if (!t) return false;
  EXPECT_EQ(broken_invariant(*t), "") << points;
  EXPECT_EQ(description(*t), description(build(points.view(), {.method = Method::cavity}))) << points;
  return true;
}

bool can_wrap() {
#ifdef DELONE_SIXTEENS
  return sixteen::possible();
#else
  return false;
#endif
}

/// The same of points that are wrapped wherever the processor can.
void expect_wrapped(const PointSet& points) { EXPECT_EQ(expect_inserted(points), can_wrap()) << points; }

PointSet joined(PointSet points, const PointSet& more) {
  points.coordinates.insert(points.coordinates.end(), more.coordinates.begin(), more.coordinates.end());
  points.weights.insert(points.weights.end(), more.weights.begin(), more.weights.end());
  return points;
}

PointSet moved(PointSet points, double factor, double shift) {
  for (double& x : points.coordinates) x = x * factor + shift;
  return points;
}

/// The corners of the unit cube: on one sphere, and four on each side.
PointSet cube() {
  PointSet points{"cube", 3, {}, {}};
  for (unsigned i = 0; i < 8; ++i)
    points.coordinates.insert(points.coordinates.end(), {i % 2 * 1.0, i / 2 % 2 * 1.0, i / 4 * 1.0});
  return points;
}

TEST(WrapFew, agrees_with_insertion_on_every_family) {
  std::vector<std::size_t> counts(36);
  std::iota(counts.begin(), counts.end(), 4U);
  counts.insert(counts.end(), {100, 240});
  for (const std::size_t n : counts) {
    for (const PointSet& points : unweighted_families(2, n, n)) expect_inserted(points);
    for (const PointSet& points : families(3, n, n)) expect_inserted(points);
  }
}

TEST(WrapFew, usual_points_are_wrapped) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const PointSet points = uniform(3, 12 + seed % 229, seed);
    expect_wrapped(points);
    expect_wrapped(with_random_weights(points, seed));
  }
}

/// All but a few, since floats find the cells.
TEST(WrapFew, usual_points_of_the_plane_are_wrapped) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    count += expect_inserted(uniform(2, 4 + seed % 237, seed)) ? 1 : 0;
    count += expect_inserted(moved(uniform(2, 100, seed), 1e-3, 1e6)) ? 1 : 0;
  }
  EXPECT_GT(count, can_wrap() ? 590 : -1);
}

TEST(WrapFew, few_points_of_the_plane_with_ties) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    // One square, found late or soon, in the middle or as a part of the hull.
    const PointSet square{"square", 2, {0, 0, 0, 1, 1, 0, 1, 1}, {}};
    count += expect_inserted(joined(uniform(2, 60, seed), moved(square, 0.25, 0.375))) ? 1 : 0;
    count += expect_inserted(joined(uniform(2, 20, seed), square)) ? 1 : 0;
    count += expect_inserted(joined(square, uniform(2, 20, seed))) ? 1 : 0;
    // Collinear on the hull.
    PointSet sides = uniform(2, 40, seed);
    for (std::size_t i = 0; i < 10; ++i) sides.coordinates[2 * i + seed % 2] = i % 2 == 0 ? 0.0 : 1.0;
    count += expect_inserted(sides) ? 1 : 0;
  }
  EXPECT_GT(count, can_wrap() ? 250 : -1);
}

TEST(WrapFew, few_points_of_the_plane_with_near_ties) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const double error : {1e-4, 1e-6, 1e-7, 1e-8, 1e-12, 1e-15}) {
      PointSet points = uniform(2, 60, seed);
      const PointSet noise = uniform(2, 60, seed + 1);
      for (std::size_t i = 0; i < points.coordinates.size(); ++i) {
        points.coordinates[i] = std::floor(points.coordinates[i] * 16) / 16 + error * noise.coordinates[i];
      }
      expect_inserted(points);
      expect_inserted(moved(points, 1.0, -0.5));
      expect_inserted(joined(points, rows(points, 0, 1)));
    }
  }
}

TEST(WrapFew, clusters_strips_and_curves_in_the_plane) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const double size : {0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9}) {
      expect_inserted(joined(moved(uniform(2, 50, seed), size, 0.5), uniform(2, 50, seed + 1)));
      expect_inserted(moved(uniform(2, 50, seed), size, 100.0));
      PointSet strip = uniform(2, 100, seed);
      PointSet arc = strip;
      for (std::size_t i = 0; i < 100; ++i) strip.coordinates[2 * i] *= size;
      for (std::size_t i = 0; i < 100; ++i) arc.coordinates[2 * i + 1] = size * std::sin(3 * arc.coordinates[2 * i]);
      expect_inserted(strip);
      expect_inserted(arc);
    }
  }
}

/// Their middle, rounded, is one of them.
TEST(WrapFew, numbers_side_by_side) {
  constexpr double kNext = 1 + 0x1p-52;
  Random random(2);
  for (int i = 0; i < 3000; ++i) {
    PointSet points{"side by side", 2, {}, {}};
    const double odd = i % 2 == 0 ? 1.0 : kNext;
    for (int j = 0; j < 4 + i % 9; ++j) {
      const double x = random() % 2 == 0 ? odd : std::nextafter(odd, 2.0);
      const double y = std::ldexp(unit_random(random), -52 - i / 50);
      points.coordinates.insert(points.coordinates.end(), {i % 4 < 2 ? x : y, i % 4 < 2 ? y : x});
    }
    expect_inserted(points);
  }
}

TEST(WrapFew, others_are_not) {
  EXPECT_FALSE(wrapped(uniform(2, 241, 1)));
  EXPECT_FALSE(wrapped(uniform(2, 3, 1)));
  EXPECT_FALSE(wrapped(with_random_weights(uniform(2, 100, 1), 1)));
  EXPECT_FALSE(wrapped(cospherical(2, 48, 1)));
  EXPECT_FALSE(wrapped(flat(2, 1, 100, 1)));
  EXPECT_FALSE(wrapped(flat(3, 2, 100, 1)));

  EXPECT_FALSE(wrapped(uniform(3, 11, 1)));
  EXPECT_FALSE(wrapped(uniform(3, 241, 1)));
  EXPECT_FALSE(wrapped(uniform(4, 100, 1)));
  EXPECT_FALSE(wrapped(flat(4, 3, 100, 1)));
  EXPECT_FALSE(wrapped(cospherical(3, 48, 1)));
}

/// Sites that alternate between two curves: on each, neighbours in the order of `along`.
template <class First, class Second>
PointSet on_two_curves(const First& first, const Second& second) {
  PointSet points{"two curves", 3, {}, {}};
  const PointSet along = uniform(3, 100, 3);
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double* const u = &along.coordinates[3 * i];
    const std::array<double, 3> x = i % 2 == 0 ? first(u) : second(u);
    points.coordinates.insert(points.coordinates.end(), x.begin(), x.end());
  }
  return points;
}

TEST(WrapFew, it_is_given_up_where_cells_are_many) {
  const PointSet points = on_two_curves(
      [](const double* u) {
        return std::array{0.01 * u[0], 0.01 * u[1], 2 * u[2] - 1};
      },
      [](const double* u) {
        return std::array{std::cos(7 * u[0]), std::sin(7 * u[0]), 0.01 * u[1]};
      });
  EXPECT_FALSE(wrapped(points));
  EXPECT_GT(built(points).cell_count(), 800U);
}

TEST(WrapFew, it_is_given_up_where_exact_tests_are_many) {
  const PointSet points = on_two_curves(
      [](const double* u) {
        return std::array{u[0], 1e-3 * u[1], 1e-3 * u[2]};
      },
      [](const double* u) {
        return std::array{1e-3 * u[1], u[0], 1 + 1e-3 * u[2]};
      });
  EXPECT_FALSE(wrapped(points));
}

TEST(WrapFew, a_caller_may_cancel) {
  for (const int dimension : {2, 3}) {
    const PointSet points = uniform(dimension, 100, 1);
    EXPECT_THROW(build(points.view(), {.progress = [](double) { return false; }}), Cancelled);
  }
}

TEST(WrapFew, work_is_counted) {
  if (!can_wrap()) GTEST_SKIP() << "the processor cannot";
  const PointSet points = joined(cube(), uniform(3, 92, 1));
  const AnyTriangulation t = *wrapped(points);
  EXPECT_EQ(t.statistics().cells_created, t.cell_count() + t.hull_facet_count());
  EXPECT_EQ(t.statistics().predicates.conflict_filter, 100 * t.statistics().cells_created);
  EXPECT_GT(t.statistics().predicates.orient_exact + t.statistics().predicates.orient_filter, 0U);
}

TEST(WrapFew, work_is_counted_in_the_plane) {
  if (!can_wrap()) GTEST_SKIP() << "the processor cannot";
  const AnyTriangulation t = *wrapped(uniform(2, 100, 1));
  EXPECT_EQ(t.statistics().cells_created, 198U);
  EXPECT_EQ(t.statistics().predicates.conflict_filter, 297U);  // edges
}

/// All but a few are wrapped: not those whose first cell has a tie.
TEST(WrapFew, ties_among_others_are_broken_as_ever) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    count += expect_inserted(joined(cube(), uniform(3, 92, seed))) ? 1 : 0;
    count += expect_inserted(joined(uniform(3, 60, seed), moved(cube(), 0.25, 0.375))) ? 1 : 0;
  }
  EXPECT_GT(count, can_wrap() ? 180 : -1);
}

/// Floats cannot tell who is nearest; nor where the hull is flat. Seen from the centre of a ball its hyperplane is
/// level.
TEST(WrapFew, near_ties_are_told_by_exact_tests) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const double error : {1e-5, 1e-7, 1e-8, 1e-12, 1e-15}) {
      PointSet almost = moved(cube(), 0.5, 0.25);
      const PointSet noise = uniform(3, 8, seed);
      for (std::size_t i = 0; i < 24; ++i) almost.coordinates[i] += error * (noise.coordinates[i] - 0.5);
      const PointSet around = joined(almost, moved(uniform(3, 40, seed + 1), 3.0, -1.0));
      const PointSet within = joined(moved(uniform(3, 40, seed + 2), 0.4, 0.3), almost);
      for (const PointSet& points : {around, within}) {
        expect_inserted(points);
        expect_inserted(moved(points, 1.0, -0.5));
      }
    }
  }
}

TEST(WrapFew, units_do_not_matter) {
  for (const int dimension : {2, 3}) {
    const PointSet points = uniform(dimension, 60, 7);
    for (const double unit : {dimension == 2 ? 0x1p-990 : 0x1p-1000, 0x1p-300, 0x1p-30, 0x1p30, 0x1p300, 0x1p1000}) {
      expect_wrapped(moved(points, unit, 0.0));
    }
    expect_inserted(moved(points, 0x1p-1040, 0.0));
    expect_inserted(moved(points, 0x1p1023, 0.0));
    expect_wrapped(moved(moved(points, 2.0, -1.0), 1.9 * 0x1p1023, 0.0));
  }
}

TEST(WrapFew, clusters_and_points_far_from_the_origin) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const double size : {0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9}) {
      expect_inserted(joined(moved(uniform(3, 50, seed), size, 0.5), uniform(3, 50, seed + 1)));
      expect_inserted(moved(uniform(3, 50, seed), size, 100.0));
    }
  }
}

TEST(WrapFew, duplicates_are_told) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    PointSet points = uniform(3, 60, seed);
    points = joined(points, rows(points, 10, 40));
    points = joined(rows(points, 0, 20), points);
    expect_wrapped(points);
    expect_wrapped(permuted(points, [&] {
      Random random(seed);
      return random_permutation(points.size(), random);
    }()));
    // In floats these are alike.
    PointSet shifted = rows(points, 0, 1);
    shifted.coordinates[0] = std::nextafter(shifted.coordinates[0], 2.0);
    expect_inserted(joined(points, shifted));
  }
}

TEST(WrapFew, hidden_sites_are_in_no_cell) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    PointSet points = uniform(3, 100, seed);
    Random random(seed);
    for (std::size_t i = 0; i < points.size(); ++i) points.weights.push_back(0.1 * unit_random(random));
    expect_wrapped(points);
    // At one place with others.
    PointSet heavier = rows(points, 0, 3);
    for (double& w : heavier.weights) w += 0.25;
    expect_inserted(joined(points, heavier));
    for (const double factor : {1e9, 1e30, 1e250}) {
      PointSet heavy = points;
      for (double& w : heavy.weights) w *= factor;
      expect_inserted(heavy);
      heavy = points;
      heavy.weights[seed] *= factor;
      expect_inserted(heavy);
      heavy.weights[seed] *= -1.0;
      expect_inserted(heavy);
    }
  }
}

}  // namespace
}  // namespace delone
