// Signs, and which stage decides them.
#include "delone/geometry/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "delone/geometry/exact_predicates.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using test::PointSet;
using test::Random;

constexpr double kTiniest = std::numeric_limits<double>::denorm_min();

enum class Decided { filter, adaptive, exact, symbolic };

std::ostream& operator<<(std::ostream& out, Decided stage) {
  constexpr std::array<const char*, 4> kNames{"filter", "adaptive", "exact", "symbolic"};
  return out << kNames[static_cast<std::size_t>(stage)];
}

template <int K>
Sites sites_of(const std::vector<double>& coordinates, const std::vector<double>& weights = {}, int dimension = K) {
  Flat flat{K, {}};
  for (int axis = 0; axis < K; ++axis) flat.axes[static_cast<std::size_t>(axis)] = axis;
  Sites sites(dimension, !weights.empty(), flat);
  const PointsView points(coordinates, dimension, weights);
  sites.reserve_more(points.size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    sites.append(points[row], points.weight(row), static_cast<Index>(row));
  }
  return sites;
}

template <int K>
typename Kernel<K>::Cell first_cell() {
  typename Kernel<K>::Cell cell;
  for (std::size_t i = 0; i < cell.size(); ++i) cell[i] = VertexId{static_cast<Index>(i)};
  return cell;
}

/// Orientation of the K + 1 points, and the stage that decides it.
template <int K>
void expect_orient(const std::vector<double>& points, int sign, Decided stage) {
  const Sites sites = sites_of<K>(points);
  Kernel<K> kernel(sites);
  EXPECT_EQ(kernel.orient(first_cell<K>()), sign);
  std::array<const double*, K + 1> pointers;
  for (std::size_t i = 0; i < pointers.size(); ++i) pointers[i] = sites.at(VertexId{static_cast<Index>(i)});
  const SlowSign slow = slow_orient<K>(pointers);
  EXPECT_EQ(slow.sign, sign);
  const bool filtered = kernel.filtered_orient(first_cell<K>()) != Kernel<K>::kUnsure;
  EXPECT_EQ(filtered ? Decided::filter : (slow.stage == Stage::adaptive ? Decided::adaptive : Decided::exact), stage);
  EXPECT_EQ(kernel.stats().orient_filter, filtered ? 1U : 0U);
}

/// Whether the last point conflicts with the positive cell of the K + 1 points before it, and the deciding stage.
template <int K>
void expect_conflict(const std::vector<double>& points, bool conflict, Decided stage,
                     const std::vector<double>& weights = {}, int dimension = K) {
  const Sites sites = sites_of<K>(points, weights, dimension);
  Kernel<K> kernel(sites);
  ASSERT_EQ(kernel.orient(first_cell<K>()), 1) << "the cell of the test is not positive";
  EXPECT_EQ(kernel.conflict(first_cell<K>(), VertexId{K + 1}), conflict);
  const PredicateStats& stats = kernel.stats();
  const std::array<std::uint64_t, 4> counts{stats.conflict_filter, stats.conflict_adaptive, stats.conflict_exact,
                                            stats.conflict_symbolic};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_EQ(counts[i], i == static_cast<std::size_t>(stage) ? 1U : 0U) << static_cast<Decided>(i);
  }
}

TEST(Orient, plain_turns_are_decided_by_the_filter) {
  expect_orient<1>({0, 1}, 1, Decided::filter);
  expect_orient<1>({0, -kTiniest}, -1, Decided::filter);
  expect_orient<2>({0, 0, 1, 0, 0.5, 1e-30}, 1, Decided::filter);
  expect_orient<2>({0, 0, 1, 0, 0.5, -1e-30}, -1, Decided::filter);
  expect_orient<3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0.3, 0.3, 1e-9}, 1, Decided::filter);
  expect_orient<4>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 1, Decided::filter);
}

TEST(Orient, collinear_and_coplanar_points_of_a_fine_grid_are_decided_by_short_integers) {
  const double a = 0x1p31 + 1, b = 0x1p30 + 3, c = 0x1p29 + 7;
  expect_orient<2>({0, 0, a, b, 2 * a, 2 * b}, 0, Decided::adaptive);
  expect_orient<2>({0, 0, a, b, 2 * a, 2 * b + 0x1p-21}, 1, Decided::adaptive);
  expect_orient<2>({0.25, 0.5, 0.25 + a, 0.5 + b, 0.25 + 2 * a, 0.5 + 2 * b}, 0, Decided::adaptive);
  expect_orient<3>({0, 0, 0, a, 5, b, 3, c, a, a + 3, c + 5, a + b}, 0, Decided::adaptive);
}

TEST(Orient, coarse_lattices_end_fast) {
  const auto expect_zero = [](const Sites& sites) {
    Kernel<2> kernel(sites);
    EXPECT_EQ(kernel.orient(first_cell<2>()), 0);
  };
  expect_zero(sites_of<2>({0, 0, 3, 1, 6, 2}));
  expect_zero(sites_of<2>({0, 0, 0x1p54, 0x1p54, 0x1p53, 0x1p53}));
  expect_zero(sites_of<2>({1e6, 1e6, 1e6 + 0.25, 1e6 + 0.5, 1e6 + 0.5, 1e6 + 1}));
}

TEST(Orient, what_a_double_cannot_tell_is_decided_by_the_last_bit) {
  // (0.1, 0.1), (0.2, 0.2), (0.3, y): 0.3 is not exactly three tenths, but x == y keeps the points collinear.
  expect_orient<2>({0.1, 0.1, 0.2, 0.2, 0.3, 0.3}, 0, Decided::adaptive);
  expect_orient<2>({0.1, 0.1, 0.2, 0.2, 0.3, std::nextafter(0.3, 1.0)}, 1, Decided::adaptive);
  expect_orient<2>({0.1, 0.1, 0.2, 0.2, 0.3, std::nextafter(0.3, 0.0)}, -1, Decided::adaptive);
}

TEST(Orient, far_exponents_are_decided_by_integers_of_any_size) {
  expect_orient<2>({0, 0, 1e300, 1e300, -1e300, -1e300}, 0, Decided::adaptive);  // over 2^944 they are short
  expect_orient<2>({0, kTiniest, 1e300, 1e300, -1e300, -1e300}, -1, Decided::exact);
  expect_orient<2>({0, -kTiniest, 1e300, 1e300, -1e300, -1e300}, 1, Decided::exact);
  expect_orient<2>({-0x1.8p1023, 0, 0x1.8p1023, 0, 0, kTiniest}, 1, Decided::exact);
  expect_orient<2>({0, 0, kTiniest, 0, 0, kTiniest}, 1, Decided::adaptive);
  expect_orient<3>({0, 0, 0, kTiniest, 0, 0, 0, kTiniest, 0, 0, 0, kTiniest}, 1, Decided::adaptive);
  expect_orient<3>({0, 0, 0, 1e200, 0, 0, 0, 1e200, 0, 1, 1, 1e-300}, 1, Decided::exact);
}

TEST(Conflict, plain_points_are_decided_by_the_filter) {
  expect_conflict<1>({0, 1, 0.5}, true, Decided::filter);
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 0.4, 0.4}, true, Decided::filter);
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 2, 2}, false, Decided::filter);
  expect_conflict<3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3, 0.3, 0.3}, true, Decided::filter);
  expect_conflict<4>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.2, 0.2, 0.2, 0.2}, true,
                     Decided::filter);
}

TEST(Conflict, a_lattice_ends_in_short_integers_and_the_tie_rule) {
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 1, 1}, true, Decided::symbolic);   // the cell lacks nothing but (0, 0) does it
  expect_conflict<2>({0, 0, 1, 0, 1, 1, 0, 1}, false, Decided::symbolic);  // coned from (0, 0) already
  expect_conflict<2>({1, 0, 1, 1, 0, 1, 0, 0}, true, Decided::symbolic);   // the smallest of all comes
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 1, 1 - 0x1p-52}, true, Decided::adaptive);
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 1, 1 + 0x1p-52}, false, Decided::adaptive);
}

TEST(Conflict, points_close_to_a_sphere_are_decided_by_double_doubles) {
  // Random points of a circle, rounded: off by an ulp or so, which neither doubles nor 128-bit integers can tell.
  Random random(1);
  std::uint64_t decided = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> points;
    for (int i = 0; i < 4; ++i) {
      const double angle =
          2 * std::numbers::pi * (i < 3 ? i / 3.0 + 0.3 * test::unit_random(random) : test::unit_random(random));
      points.insert(points.end(), {std::cos(angle), std::sin(angle)});
    }
    const Sites sites = sites_of<2>(points);
    Kernel<2> kernel(sites);
    kernel.conflict(first_cell<2>(), VertexId{3});
    decided += kernel.stats().conflict_adaptive;
    EXPECT_EQ(kernel.stats().conflict_filter, 0U);
  }
  EXPECT_GT(decided, 190U);
}

TEST(Conflict, far_exponents_are_decided_by_integers_of_any_size) {
  expect_conflict<2>({0, 0, 1e300, 0, 0, 1e300, 1e300, 1e300}, true, Decided::symbolic);
  expect_conflict<2>({0, 0, 1e300, 0, 0, 1e300, 1e300, std::nextafter(1e300, 0.0)}, true, Decided::exact);
  // The circle through (-1, 0), (1, 0) and (t, 1) has its centre at (0, t^2 / 2).
  expect_conflict<2>({-1, 0, 1, 0, kTiniest, 1, 0, 1}, true, Decided::exact);
  expect_conflict<2>({-1, 0, 1, 0, kTiniest, 1, 0, -1}, false, Decided::exact);
  expect_conflict<2>({-1, 0, 1, 0, 0, 1, kTiniest, -1}, false, Decided::exact);
  expect_conflict<2>({0, 0, kTiniest, 0, 0, kTiniest, 2 * kTiniest, 2 * kTiniest}, false, Decided::adaptive);
}

TEST(Conflict, weights_move_the_heights) {
  // The power circle of the unit triangle with equal weights; the centre's height is 0.5 below its plane.
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 0.5, 0.5}, true, Decided::filter, {1, 1, 1, 1});
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 0.5, 0.5}, true, Decided::filter, {1, 1, 1, 0.75});
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 0.5, 0.5}, false, Decided::symbolic, {1, 1, 1, 0.5});
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 0.5, 0.5}, false, Decided::adaptive, {1, 1, 1, 0.5 - 0x1p-54});
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 0.5, 0.5}, true, Decided::adaptive, {1, 1, 1, 0.5 + 0x1p-53});
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 9, 9}, true, Decided::filter, {0, 0, 0, 1e10});
  expect_conflict<2>({0, 0, 1, 0, 0, 1, 0.5, 0.5}, false, Decided::exact, {0, 0, 0, -1.7e308});
}

TEST(Conflict, coordinates_beside_the_flat_are_seen_by_heights) {
  // A vertical line: orientation on x alone, heights from both coordinates.
  expect_conflict<1>({0, 0, 2, 2, 1, 1}, true, Decided::filter, {}, 2);
  expect_conflict<1>({0, 0, 2, 2, 4, 4}, false, Decided::filter, {}, 2);
}

/// Points near a line through `origin`: multiples of one direction, then off by a few ulps.
std::vector<double> near_collinear(Random& random) {
  const double dx = test::unit_random(random);
  const double dy = test::unit_random(random);
  std::vector<double> points;
  for (int i = 0; i < 3; ++i) {
    const double t = std::ldexp(test::unit_random(random), static_cast<int>(random() % 5));
    points.insert(points.end(), {12 + t * dx, 12 + t * dy});
  }
  return points;
}

TEST(Orient, is_antisymmetric_on_two_hundred_thousand_triples_close_to_lines) {
  Random random(2);
  std::uint64_t unsure = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    const Sites sites = sites_of<2>(near_collinear(random));
    Kernel<2> kernel(sites);
    const VertexId a{0}, b{1}, c{2};
    const int sign = kernel.orient({a, b, c});
    ASSERT_EQ(kernel.orient({b, c, a}), sign);
    ASSERT_EQ(kernel.orient({c, a, b}), sign);
    ASSERT_EQ(kernel.orient({b, a, c}), -sign);
    ASSERT_EQ(kernel.orient({a, c, b}), -sign);
    unsure += kernel.stats().orient_exact > 0 ? 1 : 0;
  }
  EXPECT_GT(unsure, 10000U);  // the triples are as close as they should be
}

// --- The filter never contradicts integers. ---

/// Near-degenerate numbers: a coarse lattice, missed by the last bits or by some bits, at some scale, off the origin.
std::vector<double> near_lattice(Random& random, std::size_t count, int exponent) {
  const double offset = random() % 2 == 0 ? 0.0 : 1000.0;
  const int miss = 20 + static_cast<int>(random() % 34);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    double x = offset + static_cast<double>(random() % 3);
    if (random() % 2 == 0) x += std::ldexp(test::unit_random(random) - 0.5, -miss);
    numbers.push_back(std::ldexp(x, exponent));
  }
  return numbers;
}

int scale(Random& random) {  // where partial products get close to the ends of the range, too
  constexpr std::array<int, 9> kScales{0, 0, 0, 60, 88, -60, -100, -160, -200};
  return kScales[random() % kScales.size()];
}

template <int K>
void expect_filter_agrees(int trials) {
  Random random(K);
  std::uint64_t certain = 0;
  std::uint64_t unsure = 0;
  std::uint64_t kept_unsure = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const int exponent = scale(random);
    const bool weighted = trial % 3 == 0;
    const auto coordinates = near_lattice(random, (K + 2) * K, exponent);
    const auto weights = weighted ? near_lattice(random, K + 2, 2 * exponent) : std::vector<double>();
    const Sites sites = sites_of<K>(coordinates, weights);
    const Kernel<K> kernel(sites);
    auto cell = first_cell<K>();
    const int orient = kernel.exact_orient(cell);
    if (const int sign = kernel.filtered_orient(cell); sign != Kernel<K>::kUnsure) {
      ASSERT_EQ(sign, orient);
    }
    if (orient == 0) continue;
    if constexpr (K >= 1) {
      if (orient < 0) std::swap(cell[0], cell[1]);
    }
    const VertexId q{K + 1};
    const int truth = kernel.slow_conflict_sign(cell, q).sign;
    const int sign = kernel.filtered_conflict(cell, q);
    ++(sign == Kernel<K>::kUnsure ? unsure : certain);
    ASSERT_TRUE(sign == Kernel<K>::kUnsure || sign == truth) << trial;
    const int kept = kernel.filtered_conflict(kernel.hyperplane(cell), q);
    ASSERT_TRUE(kept == Kernel<K>::kUnsure || kept == truth) << trial;
    kept_unsure += kept == Kernel<K>::kUnsure ? 1 : 0;
  }
  EXPECT_GT(certain, static_cast<std::uint64_t>(trials / 20));
  EXPECT_GT(unsure, static_cast<std::uint64_t>(trials / 20));
  EXPECT_LT(kept_unsure, static_cast<std::uint64_t>(trials - trials / 20));  // it is of use
}

/// Of two cells on one facet and a point that destroys the first: the hyperplane of the new cell there, as seen by one
/// point more.
template <int K>
void expect_new_hyperplane_agrees(int trials) {
  Random random(K);
  int certain = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const bool weighted = trial % 3 == 0;
    const int exponent = scale(random) / 4;
    const auto coordinates = near_lattice(random, (K + 4) * K, exponent);
    const auto weights = weighted ? near_lattice(random, K + 4, 2 * exponent) : std::vector<double>();
    const Sites sites = sites_of<K>(coordinates, weights);
    const Kernel<K> kernel(sites);
    auto inside = first_cell<K>();
    const int orient = kernel.exact_orient(inside);
    if (orient == 0) continue;
    if (orient < 0) std::swap(inside[0], inside[1]);
    const VertexId q{K + 2};
    const VertexId seen{K + 3};
    auto outside = inside;
    auto fresh = inside;
    outside[K] = trial % 4 == 0 ? kGhost : VertexId{K + 1};
    std::swap(outside[0], outside[1]);
    fresh[K] = q;
    if (outside[K] != kGhost && kernel.exact_orient(outside) <= 0) continue;
    if (kernel.exact_orient(fresh) <= 0 || kernel.slow_conflict_sign(inside, q).sign <= 0) continue;
    if (outside[K] != kGhost && kernel.slow_conflict_sign(outside, q).sign >= 0) continue;
    const auto in = kernel.hyperplane(inside);
    const auto out = kernel.hyperplane(outside);
    const auto plane = kernel.hyperplane(in, kernel.sight(in, q), out, kernel.sight(out, q), q);
    const int sign = kernel.filtered_conflict(plane, seen);
    ASSERT_TRUE(sign == Kernel<K>::kUnsure || sign == kernel.slow_conflict_sign(fresh, seen).sign) << trial;
    certain += sign == Kernel<K>::kUnsure ? 0 : 1;
  }
  EXPECT_GT(certain, trials / 1000);
}

TEST(Filter, agrees_with_integers_from_the_hyperplanes_of_neighbours) {
  expect_new_hyperplane_agrees<4>(40000);
  expect_new_hyperplane_agrees<5>(40000);
  expect_new_hyperplane_agrees<6>(40000);
}

/// The filters' signs of the last point against the cell of those before it, where they are certain.
template <int K>
void expect_no_contradiction(const Sites& sites) {
  const Kernel<K> kernel(sites);
  auto cell = first_cell<K>();
  const int orient = kernel.exact_orient(cell);
  if (orient == 0) return;
  if (orient < 0) std::swap(cell[0], cell[1]);
  const VertexId q{K + 1};
  const int truth = kernel.slow_conflict_sign(cell, q).sign;
  for (const int sign : {kernel.filtered_conflict(cell, q), kernel.conflict_sign_by_permanent(cell, q),
                         kernel.filtered_conflict(kernel.hyperplane(cell), q)}) {
    ASSERT_TRUE(sign == Kernel<K>::kUnsure || sign == truth);
  }
}

TEST(Filter, never_contradicts_integers_where_heights_are_large_and_differences_tiny) {
  Random random(11);
  const double tiny = 0x1p-182;
  for (int trial = 0; trial < 3000; ++trial) {
    // In 4D on the flat where the last coordinate is 2^279 times the first; in 3D with weights close to a plane.
    std::vector<double> in_flat, in_space, weights;
    for (int i = 0; i < 5; ++i) {
      const double x = tiny * test::unit_random(random);
      const double y = tiny * test::unit_random(random);
      const double z = tiny * test::unit_random(random);
      in_flat.insert(in_flat.end(), {x, y, z, x * 0x1p279});
      in_space.insert(in_space.end(), {x, y, z});
      weights.push_back((x + 2 * y - z) * 0x1p382);
    }
    expect_no_contradiction<3>(sites_of<3>(in_flat, {}, 4));
    expect_no_contradiction<3>(sites_of<3>(in_space, weights));
    in_flat.resize(16);
    expect_no_contradiction<2>(sites_of<2>(in_flat, {}, 4));
  }
}

/// Two rows whose products underflow, the others as large as filters take.
template <int K>
void expect_no_contradiction_of_unlike_rows(int trials) {
  Random random(K);
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> points;
    for (int i = 0; i < K + 1; ++i) {
      const double scale = i < 3 ? 0x1p-535 : 0x1p96;
      for (int j = 0; j < K; ++j) points.push_back(scale * (static_cast<double>(random() % 7) - 3.0));
    }
    points.insert(points.end(), K, 0.0);
    expect_no_contradiction<K>(sites_of<K>(points));
  }
}

TEST(Filter, never_contradicts_integers_where_minors_underflow) {
  const double t = 0x1p-358;
  const double b = 0x1p97;
  std::vector<double> points(10 * 8, 0.0);
  points[0] = t, points[1] = -t;
  points[9] = t, points[10] = -t;
  points[16] = points[17] = 0.625 * t, points[18] = -1.375 * t;
  for (std::size_t i = 3; i < 8; ++i) points[8 * i + i] = b;
  points[8 * 8 + 3] = 2 * b;
  expect_no_contradiction<8>(sites_of<8>(points));
  expect_no_contradiction_of_unlike_rows<4>(500);
  expect_no_contradiction_of_unlike_rows<6>(300);
  expect_no_contradiction_of_unlike_rows<7>(300);
  expect_no_contradiction_of_unlike_rows<8>(100);
}

TEST(Filter, never_contradicts_integers_on_points_that_just_miss_a_lattice) {
  expect_filter_agrees<1>(30000);
  expect_filter_agrees<2>(100000);
  expect_filter_agrees<3>(50000);
  expect_filter_agrees<4>(20000);
  expect_filter_agrees<5>(5000);
  expect_filter_agrees<6>(2000);
}

/// A simplex and, as closely as doubles tell, a point of one of its facets.
template <int K>
std::vector<double> near_facet(Random& random) {
  std::vector<double> numbers;
  for (int i = 0; i < (K + 1) * K; ++i) numbers.push_back(test::unit_random(random));
  std::array<double, K + 1> share;
  for (double& s : share) s = test::unit_random(random);
  share[random() % share.size()] = 0.0;
  const double sum = std::accumulate(share.begin(), share.end(), 0.0);
  for (std::size_t j = 0; j < K; ++j) {
    double x = 0.0;
    for (std::size_t i = 0; i <= K; ++i) x += share[i] / sum * numbers[i * K + j];
    numbers.push_back(x);
  }
  return numbers;
}

/// By exact numbers, of points that just miss the facets of a cell, or lie on them.
/// @param numbers  makes those of its corners, then of the point
template <int K, class F>
void expect_separating_facets(int trials, const F& numbers) {
  Random random(100 + K);
  int beyond = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Sites sites = sites_of<K>(numbers(random));
    Kernel<K> kernel(sites);
    auto cell = first_cell<K>();
    const int orient = kernel.exact_orient(cell);
    if (orient == 0) continue;
    if (orient < 0) std::swap(cell[0], cell[1]);
    const VertexId q{K + 1};
    std::array<int, K + 1> side;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      auto replaced = cell;
      replaced[i] = q;
      side[i] = kernel.exact_orient(replaced);
    }
    const bool inside = std::ranges::all_of(side, [](int s) { return s >= 0; });
    const int slot = kernel.separating_slot(cell, kernel.at(q), -1);
    ASSERT_EQ(slot < 0, inside) << trial;
    if (inside) continue;
    ++beyond;
    ASSERT_LT(side[static_cast<std::size_t>(slot)], 0) << trial;
  }
  EXPECT_GT(beyond, trials / 10);
  EXPECT_LT(beyond, trials - trials / 50);
}

template <int K>
void expect_separating_facets(int trials) {
  expect_separating_facets<K>(trials, [](Random& r) { return near_lattice(r, (K + 2) * K, scale(r)); });
  if (K > 1) expect_separating_facets<K>(trials, near_facet<K>);  // a point of a line is a facet
}

TEST(Kernel, a_separating_facet_is_found_exactly_when_the_point_is_outside) {
  expect_separating_facets<1>(5000);
  expect_separating_facets<2>(50000);
  expect_separating_facets<3>(50000);
  expect_separating_facets<4>(5000);
}

/// Random edges of cells that no other site is in conflict with: of all other sites, on whichever side, the innermost
/// is the inner one whose cell none of the inner ones is in conflict with. @return how many edges there were
std::size_t expect_innermost(const std::vector<double>& coordinates, const std::vector<double>& weights,
                             int dimension) {
  const Sites sites = sites_of<2>(coordinates, weights, dimension);
  Kernel<2> kernel(sites);
  const auto n = static_cast<Index>(sites.size());
  std::size_t edges = 0;
  for (Index i = 0; i < n * n * n; ++i) {
    const Kernel<2>::Cell beyond{VertexId{i % n}, VertexId{i / n % n}, VertexId{i / n / n}};
    const auto [b, a, c] = beyond;
    if (a == b || a == c || b == c || kernel.orient(beyond) <= 0) continue;
    std::vector<VertexId> others;
    for (Index j = 0; j < n; ++j) {
      const VertexId v{j};
      if (v != a && v != b && v != c) others.push_back(v);
    }
    if (std::ranges::any_of(others, [&](VertexId v) { return kernel.conflict(beyond, v); })) continue;
    std::vector<VertexId> inner = others;
    std::erase_if(inner, [&](VertexId v) { return kernel.orient({a, v, b}) <= 0; });
    if (inner.empty()) continue;
    ++edges;
    const VertexId found = others[kernel.innermost(a, b, others)];
    EXPECT_NE(std::ranges::find(inner, found), inner.end()) << "an outer one";
    for (const VertexId v : inner) {
      EXPECT_TRUE(v == found || !kernel.conflict({a, found, b}, v));
    }
  }
  return edges;
}

TEST(Kernel, the_innermost_corner_needs_no_orientation) {
  Random random(31);
  std::size_t edges = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const int dimension = trial % 5 == 4 ? 3 : 2;
    const double scale = trial % 7 == 0 ? 0x1p400 : (trial % 7 == 1 ? 0x1p-500 : 1.0);
    const double noise = trial % 3 == 0 ? 0x1p-52 : 0.0;
    std::vector<std::array<int, 2>> places;
    while (places.size() < 9) {
      const std::array<int, 2> place{static_cast<int>(random() % 4), static_cast<int>(random() % 4)};
      if (std::ranges::find(places, place) == places.end()) places.push_back(place);
    }
    std::vector<double> coordinates;
    std::vector<double> weights;
    for (const auto& place : places) {
      for (const int x : place) coordinates.push_back(scale * (x + noise * static_cast<double>(random() % 3)));
      if (dimension == 3) coordinates.push_back(coordinates.back());  // in a flat
      if (trial % 2 == 1) weights.push_back(scale * scale * static_cast<double>(random() % 3));
    }
    SCOPED_TRACE(trial);
    edges += expect_innermost(coordinates, weights, dimension);
  }
  EXPECT_GT(edges, 5000U);
}

TEST(Kernel, lexicographic_order_is_that_of_coordinates) {
  const Sites sites = sites_of<2>({0, 1, 0, 2, 1, 0, 0, 1, -0.0, 1});
  const Kernel<2> kernel(sites);
  EXPECT_TRUE(kernel.before(VertexId{0}, VertexId{1}));
  EXPECT_TRUE(kernel.before(VertexId{1}, VertexId{2}));
  EXPECT_FALSE(kernel.before(VertexId{2}, VertexId{0}));
  EXPECT_TRUE(kernel.same_place(VertexId{0}, VertexId{3}));
  EXPECT_TRUE(kernel.same_place(VertexId{0}, VertexId{4}));  // the two zeros are one place
}

}  // namespace
}  // namespace delone
