#include "delone/geometry/compare_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "exact/integer.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using exact::BigInt;
using test::Random;

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

BigInt integer(double x, int unit) { return exact::to_integer<BigInt>(exact::decompose(x), unit); }

/// Power over 2^-2148.
BigInt power(const double* p, double weight, const double* q, std::size_t dimension) {
  BigInt sum = -integer(weight, -2148);
  for (std::size_t j = 0; j < dimension; ++j) {
    const BigInt d = integer(p[j], -1074) - integer(q[j], -1074);
    sum += d * d;
  }
  return sum;
}

enum class Decided { filter, integral, adaptive, exact };

struct Decision {
  int sign;
  Decided by;
  bool operator==(const Decision&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Decision& d) {
  return out << "sign " << d.sign << " by stage " << static_cast<int>(d.by);
}

template <int K>
Decision decision(const Sites& sites, const std::vector<double>& q) {
  Distances<K> distances(sites);
  distances.measure_from(sites.placed(q));
  const VertexId a{0};
  const VertexId b{1};
  const Power pa = distances.power(a);
  const Power pb = distances.power(b);
  if (const int s = distances.filtered_compare(pa, pb); s != filter::kUnsure) return {s, Decided::filter};
  if (const int s = distances.integral_compare(pa, pb); s != filter::kUnsure) return {s, Decided::integral};
  const SlowSign slow = distances.slow_compare(a, b);
  return {slow.sign, slow.stage == Stage::adaptive ? Decided::adaptive : Decided::exact};
}

template <int K>
Sites two_sites(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weights = {}) {
  Flat flat{.dimension = K, .axes = {}};
  for (int axis = 0; axis < K; ++axis) flat.axes[static_cast<std::size_t>(axis)] = axis;
  Sites sites(static_cast<int>(a.size()), !weights.empty(), flat);
  sites.reserve_more(2);
  sites.append(a, weights.empty() ? 0.0 : weights[0], 0);
  sites.append(b, weights.empty() ? 0.0 : weights[1], 1);
  return sites;
}

template <int K>
Decision decision(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& q,
                  const std::vector<double>& weights = {}) {
  return decision<K>(two_sites<K>(a, b, weights), q);
}

TEST(CompareDistance, decides_at_the_expected_stage) {
  EXPECT_EQ(decision<2>({0, 0}, {3, 1}, {1, 0}), (Decision{-1, Decided::filter}));
  EXPECT_EQ(decision<2>({3, 1}, {0, 0}, {1, 0}), (Decision{1, Decided::filter}));
  // Integers, and numbers with few bits: ties are found in doubles.
  EXPECT_EQ(decision<2>({0, 0}, {2, 0}, {1, 7}), (Decision{0, Decided::integral}));
  EXPECT_EQ(decision<3>({5, 0, 0}, {3, 4, 0}, {0, 0, 0}), (Decision{0, Decided::integral}));
  // 0.1 has 53 bits, and its squares 106.
  EXPECT_EQ(decision<2>({0.1, 0.3}, {0.3, 0.1}, {0, 0}), (Decision{0, Decided::adaptive}));
  EXPECT_EQ(decision<2>({0x1p30, 1}, {0x1p30, 0}, {0, 0}), (Decision{1, Decided::adaptive}));
  // Exponents far apart, and what overflows or underflows.
  EXPECT_EQ(decision<2>({1, kSmallest}, {1, 0}, {0, 0}), (Decision{1, Decided::exact}));
  EXPECT_EQ(decision<2>({kLargest, 0}, {-kLargest, 1}, {kSmallest, 0}), (Decision{-1, Decided::exact}));
  EXPECT_EQ(decision<1>({kSmallest}, {0}, {0}), (Decision{1, Decided::adaptive}));
}

TEST(CompareDistance, weights_count_as_they_are) {
  EXPECT_EQ(decision<2>({0, 0}, {2, 0}, {0.5, 0}, {0, 2}), (Decision{0, Decided::integral}));
  EXPECT_EQ(decision<2>({0, 0}, {2, 0}, {0.5, 0}, {0, 3}), (Decision{1, Decided::filter}));
  EXPECT_EQ(decision<1>({0}, {0}, {7}, {kSmallest, 0}), (Decision{-1, Decided::exact}));
  EXPECT_EQ(decision<1>({0}, {0}, {7}, {kLargest, -kLargest}).sign, -1);
}

TEST(CompareDistance, in_a_flat_all_coordinates_count) {
  EXPECT_EQ(decision<1>({0, 0, 5}, {1, 0, 0}, {0, 0, 0}).sign, 1);
  EXPECT_EQ(decision<0>({3, 4}, {3, 4}, {0, 0}).sign, 0);
}

TEST(CompareDistance, a_radius_is_squared_without_rounding) {
  // 0.1 * 0.1 rounds up: a point at a distance of exactly 0.1 lies on the circle, its neighbours beside it.
  const double radius = 0.1;
  for (const auto& [x, sign] : {std::pair{radius, 0}, std::pair{std::nextafter(radius, 1.0), 1},
                                std::pair{std::nextafter(radius, 0.0), -1}, std::pair{0.0, -1}, std::pair{9.0, 1}}) {
    const Sites sites = two_sites<2>({x, 0}, {0, 0});
    Distances<2> distances(sites);
    distances.measure_from({});
    EXPECT_EQ(distances.compare_with_radius(VertexId{0}, distances.power(VertexId{0}), radius), sign) << x;
  }
  const Sites sites = two_sites<1>({kLargest}, {-1}, {0.0, 1.0});
  Distances<1> distances(sites);
  distances.measure_from({});
  EXPECT_EQ(distances.compare_with_radius(VertexId{0}, distances.power(VertexId{0}), kLargest), 0);
  EXPECT_EQ(distances.compare_with_radius(VertexId{1}, distances.power(VertexId{1}), 0.0), 0);
}

/// From few bits to all, from the smallest exponents to the largest.
double any_number(Random& random, int kind) {
  const auto small = static_cast<double>(random() % 5) - 2;
  const double fine = test::unit_random(random);
  const int far = static_cast<int>(random() % 2000) - 1060;
  return kind == 0   ? small
         : kind == 1 ? std::ldexp(small, 1020)
         : kind == 2 ? std::ldexp(small, -1074)
         : kind == 3 ? small + std::ldexp(fine, -30)
         : kind == 4 ? fine
                     : std::ldexp(small, random() % 2 == 0 ? far : 0);
}

template <int K>
void expect_big_integers_agree(std::size_t dimension, int trials) {
  Random random(K);
  for (int trial = 0; trial < trials; ++trial) {
    const int kind = static_cast<int>(random() % 6);
    const auto point = [&] {
      std::vector<double> x(dimension);
      for (double& c : x) c = any_number(random, kind);
      return x;
    };
    const auto a = point();
    const auto b = point();
    const auto q = point();
    std::vector<double> w(random() % 2 == 0 ? 2 : 0);
    for (double& x : w) x = any_number(random, kind);
    const double wa = w.empty() ? 0.0 : w[0];
    const double wb = w.empty() ? 0.0 : w[1];
    const BigInt pa = power(a.data(), wa, q.data(), dimension);
    const BigInt pb = power(b.data(), wb, q.data(), dimension);
    const Sites sites = two_sites<K>(a, b, w);
    Distances<K> distances(sites);
    distances.measure_from(sites.placed(q));
    ASSERT_EQ(distances.compare(VertexId{0}, VertexId{1}), exact::sign(BigInt(pa - pb))) << "kind " << kind;
    ASSERT_EQ(distances.slow_compare(VertexId{0}, VertexId{1}).sign, exact::sign(BigInt(pa - pb))) << "kind " << kind;
    const double radius = std::abs(any_number(random, kind));
    const BigInt r = integer(radius, -1074);
    ASSERT_EQ(distances.compare_with_radius(VertexId{0}, distances.power(VertexId{0}), radius),
              exact::sign(BigInt(pa - r * r)));
  }
}

TEST(CompareDistance, agrees_with_integers_of_any_size) {
  expect_big_integers_agree<0>(2, 300);
  expect_big_integers_agree<1>(1, 500);
  expect_big_integers_agree<2>(2, 500);
  expect_big_integers_agree<2>(5, 500);
  expect_big_integers_agree<3>(3, 500);
  expect_big_integers_agree<8>(8, 300);
}

}  // namespace
}  // namespace delone
