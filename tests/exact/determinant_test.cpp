#include "delone/exact/determinant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "support/families.hpp"

namespace delone {
namespace {

using test::Random;

template <int N>
Matrix<N, std::int64_t> random_matrix(Random& random) {
  Matrix<N, std::int64_t> m;
  for (auto& row : m) {
    for (auto& x : row) x = static_cast<std::int64_t>(random() % 9) - 4;
  }
  return m;
}

/// The definition: a sum over permutations.
template <int N>
std::int64_t by_definition(const Matrix<N, std::int64_t>& m, bool alternate) {
  std::array<std::size_t, static_cast<std::size_t>(N)> columns;
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  std::int64_t sum = 0;
  do {
    bool odd = false;
    std::int64_t product = 1;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) odd ^= columns[j] > columns[i];
      product *= alternate ? m[i][columns[i]] : std::abs(m[i][columns[i]]);
    }
    sum += odd && alternate ? -product : product;
  } while (std::ranges::next_permutation(columns).found);
  return sum;
}

template <int N>
void compare_with_the_definition(int trials) {
  Random random(N);
  for (int trial = 0; trial < trials; ++trial) {
    const auto m = random_matrix<N>(random);
    EXPECT_EQ(determinant<N>(m), by_definition<N>(m, true));
    Matrix<N, double> doubles;
    for (std::size_t i = 0; i < doubles.size(); ++i) std::ranges::copy(m[i], doubles[i].begin());
    EXPECT_EQ(absolute_permanent<N>(doubles), static_cast<double>(by_definition<N>(m, false)));
    EXPECT_EQ(determinant<N>(doubles), static_cast<double>(by_definition<N>(m, true)));
  }
}

TEST(Determinant, agrees_with_the_sum_over_permutations) {
  compare_with_the_definition<1>(50);
  compare_with_the_definition<2>(50);
  compare_with_the_definition<3>(50);
  compare_with_the_definition<4>(50);
  compare_with_the_definition<5>(20);
  compare_with_the_definition<6>(10);
  compare_with_the_definition<7>(3);
  compare_with_the_definition<8>(1);
}

TEST(Determinant, of_no_rows_is_one) { EXPECT_EQ(determinant<0>(Matrix<0, int>{}), 1); }

}  // namespace
}  // namespace delone
