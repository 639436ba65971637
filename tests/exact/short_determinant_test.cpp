#include "exact/short_determinant.hpp"

#include <gtest/gtest.h>

#include <random>

#include "delone/exact/determinant.hpp"

namespace delone::exact {
namespace {

using Random = std::mt19937_64;
constexpr std::int64_t kLargest = std::int64_t{1} << kShortBits;

/// Up to 2^bits in magnitude, often just that.
std::int64_t entry(Random& random, int bits) {
  const std::int64_t largest = std::int64_t{1} << bits;
  const std::int64_t magnitude = random() % 3 == 0 ? largest : static_cast<std::int64_t>(random()) & (largest - 1);
  return random() % 2 == 0 ? magnitude : -magnitude;
}

template <int N, class Table>
int slow_sign(const Table& m) {
  Matrix<N, BigInt> exact;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t j = 0; j < exact.size(); ++j) exact[i][j] = BigInt(m[i][j]);
  }
  return sign(determinant<N>(exact));
}

/// A matrix of the largest entries with all signs: its determinant is as large as they come.
template <int N>
ShortMatrix<N, N> largest(Random& random) {
  ShortMatrix<N, N> m;
  for (auto& row : m) {
    for (auto& x : row) x = random() % 2 == 0 ? kLargest : -kLargest;
  }
  return m;
}

template <int N>
void compare_with_integers_of_any_size(Random& random, int trials) {
  for (int trial = 0; trial < trials; ++trial) {
    ShortMatrix<N, N> square;
    ShortMatrix<N, N + 1> points;
    std::array<Int128, static_cast<std::size_t>(N) + 1> heights;
    Matrix<N + 1, Int128> lifted;
    for (auto& row : square) {
      for (auto& x : row) x = entry(random, kShortBits);
    }
    if (trial % 3 == 0) square = largest<N>(random);
    EXPECT_EQ(short_determinant_sign<N>(square), slow_sign<N>(square));
    for (std::size_t j = 0; j <= static_cast<std::size_t>(N); ++j) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
        points[i][j] = trial % 2 == 0 ? entry(random, kShortBits) : entry(random, 2);
        lifted[i][j] = points[i][j];
      }
      heights[j] = lifted[N][j] = static_cast<Int128>(entry(random, kShortBits)) * entry(random, kShortBits) * 16;
    }
    EXPECT_EQ(short_determinant_sign<N>(points, heights), slow_sign<N + 1>(lifted));
    if constexpr (N < 2) continue;
    square[0] = square[static_cast<std::size_t>(N - 1)];
    EXPECT_EQ(short_determinant_sign<N>(square), 0);
  }
}

TEST(ShortDeterminant, agrees_with_integers_of_any_size_up_to_its_largest_entries) {
  Random random(1);
  compare_with_integers_of_any_size<1>(random, 500);
  compare_with_integers_of_any_size<2>(random, 500);
  compare_with_integers_of_any_size<3>(random, 500);
  compare_with_integers_of_any_size<4>(random, 500);
  compare_with_integers_of_any_size<5>(random, 100);
  compare_with_integers_of_any_size<6>(random, 50);
  compare_with_integers_of_any_size<7>(random, 20);
  compare_with_integers_of_any_size<8>(random, 20);
}

}  // namespace
}  // namespace delone::exact
