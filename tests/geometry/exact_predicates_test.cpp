#include "delone/geometry/exact_predicates.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "delone/exact/determinant.hpp"
#include "exact/integer.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using exact::BigInt;
using test::Random;

constexpr int kUnit = -1074;

BigInt integer(double x, int unit) { return exact::to_integer<BigInt>(exact::decompose(x), unit); }

template <int K>
int orient_by_big_integers(const std::vector<double>& x) {
  Matrix<K, BigInt> m;
  for (std::size_t i = 0; i < K; ++i) {
    for (std::size_t j = 0; j < K; ++j) m[i][j] = integer(x[(i + 1) * K + j], kUnit) - integer(x[j], kUnit);
  }
  return exact::sign(determinant<K>(m));
}

template <int K>
int conflict_by_big_integers(const std::vector<double>& x, const std::vector<double>& w) {
  Matrix<K + 1, BigInt> m;
  for (std::size_t i = 0; i <= K; ++i) {
    BigInt height = w.empty() ? BigInt(0) : BigInt(integer(w[K + 1], 2 * kUnit) - integer(w[i], 2 * kUnit));
    for (std::size_t j = 0; j < K; ++j) {
      m[i][j] = integer(x[i * K + j], kUnit) - integer(x[(K + 1) * K + j], kUnit);
      height += m[i][j] * m[i][j];
    }
    m[i][K] = height;
  }
  const int sign = exact::sign(determinant<K + 1>(m));
  return K % 2 == 0 ? sign : -sign;
}

/// From few bits to all, from the smallest exponents to the largest.
std::vector<double> any_numbers(Random& random, std::size_t count) {
  const int kind = static_cast<int>(random() % 6);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const auto small = static_cast<double>(random() % 5) - 2;
    const double fine = test::unit_random(random);
    const auto far = static_cast<int>(random() % 2000) - 1060;
    numbers.push_back(kind == 0   ? small
                      : kind == 1 ? std::ldexp(small, 1020)
                      : kind == 2 ? std::ldexp(small, -1074)
                      : kind == 3 ? small + std::ldexp(fine, -30)
                      : kind == 4 ? std::ldexp(std::floor(fine * 0x1p21), -10)  // the widest that 128 bits decide in 2D
                                  : std::ldexp(small, random() % 2 == 0 ? far : 0));
  }
  return numbers;
}

template <int K>
void expect_slow_stages_agree(int trials) {
  Random random(K);
  for (int trial = 0; trial < trials; ++trial) {
    const auto x = any_numbers(random, (K + 2) * K);
    const auto w = trial % 2 == 0 ? any_numbers(random, K + 2) : std::vector<double>();
    SiteRefs<K, K + 2> sites{};
    std::array<const double*, K + 1> points;
    for (std::size_t i = 0; i < K + 2; ++i) {
      sites.leading[i] = x.data() + i * K;
      sites.weights[i] = w.empty() ? 0.0 : w[i];
      if (i <= K) points[i] = sites.leading[i];
    }
    sites.weighted = !w.empty();
    ASSERT_EQ(slow_conflict<K>(sites).sign, conflict_by_big_integers<K>(x, w));
    ASSERT_EQ(slow_orient<K>(points).sign, orient_by_big_integers<K>(x));
  }
}

TEST(ExactPredicates, agree_with_big_integers_over_the_whole_range_of_doubles) {
  expect_slow_stages_agree<1>(3000);
  expect_slow_stages_agree<2>(3000);
  expect_slow_stages_agree<3>(1500);
  expect_slow_stages_agree<4>(500);
  expect_slow_stages_agree<5>(150);
  expect_slow_stages_agree<6>(50);
  expect_slow_stages_agree<7>(15);
  expect_slow_stages_agree<8>(8);
}

}  // namespace
}  // namespace delone
