#include "delone/exact/four_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delone/exact/determinant.hpp"
#include "delone/exact/double_double.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using test::Random;
using Rows = std::array<std::array<double, 3>, 4>;

/// Small integers, whose determinants doubles hold without rounding.
Rows random_rows(Random& random) {
  Rows rows;
  for (auto& row : rows) {
    for (double& x : row) x = std::floor(200.0 * (test::unit_random(random) - 0.5));
  }
  return rows;
}

template <class P>
FourRows<P> four_rows_of(const Rows& m) {
  const auto column = [&](std::size_t row, std::size_t axis) { return P(Pair{m[row][axis], m[row + 1][axis]}); };
  return four_rows(column(0, 0), column(2, 0), column(0, 1), column(2, 1), column(0, 2), column(2, 2));
}

Matrix<4, double> lifted(const Rows& rows) {
  Matrix<4, double> m;
  for (std::size_t i = 0; i < 4; ++i) {
    m[i] = {rows[i][0], rows[i][1], rows[i][2], 0.0};
    for (std::size_t j = 0; j < 3; ++j) m[i][3] += m[i][j] * m[i][j];
  }
  return m;
}

Matrix<3, double> without(const Rows& rows, std::size_t row) {
  Matrix<3, double> m;
  for (std::size_t i = 0; i < 3; ++i) m[i] = rows[(row + 1 + i) % 4];
  return m;
}

TEST(FourRows, minors_and_squares_are_those_of_the_rows) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Rows rows = random_rows(random);
    const FourRows<Pair> four = four_rows_of<Pair>(rows);
    EXPECT_EQ(four.abc[0], determinant<3>(without(rows, 3)));
    EXPECT_EQ(four.abc[1], determinant<3>(without(rows, 0)));
    EXPECT_EQ(four.cda[0], determinant<3>(without(rows, 1)));
    EXPECT_EQ(four.cda[1], determinant<3>(without(rows, 2)));
    const Matrix<4, double> m = lifted(rows);
    EXPECT_EQ(four.ab_lifts[0], m[0][3]);
    EXPECT_EQ(four.ab_lifts[1], m[1][3]);
    EXPECT_EQ(four.cd_lifts[0], m[2][3]);
    EXPECT_EQ(four.cd_lifts[1], m[3][3]);
  }
}

TEST(FourRows, every_kind_of_pair_gives_the_lifted_determinant) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Rows rows = random_rows(random);
    const double expected = -determinant<4>(lifted(rows));
    const auto plain = four_rows_of<Pair>(rows);
    const Pair terms = lifted_terms(plain);
    EXPECT_EQ(terms[1] - terms[0], expected);
    const auto sized = four_rows_of<SizedPair>(rows);
    const SizedPair sizes = lifted_terms(sized);
    EXPECT_EQ(sizes.value[1] - sizes.value[0], expected);
    EXPECT_EQ(sizes.size[0] + sizes.size[1], absolute_permanent<4>(lifted(rows)));
    const auto wide = four_rows_of<DoubleDoubles<Pair>>(rows);
    const auto wide_terms = lifted_terms(wide);
    EXPECT_EQ((wide_terms[1] - wide_terms[0]).high(), expected);
  }
}

}  // namespace
}  // namespace delone
