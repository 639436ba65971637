// The oracle of the other tests, tested by laws and by hand.
#include "support/brute_force.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "delone/exact/determinant.hpp"

namespace delone::test {
namespace {

using ::testing::ElementsAre;

/// D! times the volume of all cells; exact for small integers.
template <int D>
double volume(PointsView points, const Truth& truth) {
  double sum = 0;
  for (const auto& cell : truth.cells) {
    Matrix<D, double> m;
    for (std::size_t i = 0; i < D; ++i) {
      for (std::size_t j = 0; j < D; ++j) m[i][j] = points[cell[i + 1]][j] - points[cell[0]][j];
    }
    sum += std::abs(determinant<D>(m));
  }
  return sum;
}

/// All triangulations of one hull have its volume, whatever the weights.
template <int D>
void expect_equal_volumes() {
  std::mt19937_64 random(D);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<double> points, weights;
    for (int i = 0; i < 10 * D; ++i) points.push_back(static_cast<double>(random() % 5));
    for (int i = 0; i < 10; ++i) weights.push_back(static_cast<double>(random() % 9));
    const PointsView plain(points, D);
    const PointsView weighted(points, D, weights);
    const Truth truth = brute_force(plain);
    if (truth.affine_dimension < D) continue;
    EXPECT_EQ(volume<D>(plain, truth), volume<D>(weighted, brute_force(weighted)));
  }
}

TEST(BruteForce, the_volume_does_not_depend_on_the_weights) {
  expect_equal_volumes<1>();
  expect_equal_volumes<2>();
  expect_equal_volumes<3>();
  expect_equal_volumes<4>();
}

TEST(BruteForce, the_cube_is_coned_from_its_smallest_corner) {
  std::vector<double> cube;
  for (int i = 0; i < 8; ++i) {
    for (const int axis : {0, 1, 2}) cube.push_back(i >> axis & 1);
  }
  const Truth truth = brute_force(PointsView(cube, 3));
  EXPECT_EQ(truth.cells.size(), 6U);
  for (const auto& cell : truth.cells) EXPECT_EQ(cell.front(), 0U);
}

TEST(BruteForce, duplicates_and_hidden_rows_are_told_apart) {
  const std::vector<double> points{1, 0, 0, 4, 1, 4};
  const std::vector<double> weights{-9, 1, 2, 0, -9, 1};
  const Truth truth = brute_force(PointsView(points, 1, weights));
  EXPECT_THAT(truth.cells, ElementsAre(ElementsAre(2, 5)));
  EXPECT_THAT(truth.status, ElementsAre(2, 2, 0, 2, 2, 0));
  const Truth plain = brute_force(PointsView(points, 1));
  EXPECT_THAT(plain.cells, ElementsAre(ElementsAre(0, 1), ElementsAre(0, 3)));
  EXPECT_THAT(plain.status, ElementsAre(0, 0, 1, 0, 1, 1));
  EXPECT_THAT(plain.of, ElementsAre(0, 1, 1, 3, 0, 3));
}

TEST(BruteForce, few_points_have_their_own_dimension) {
  EXPECT_EQ(brute_force(PointsView({}, 3)).affine_dimension, -1);
  const std::vector<double> equal{1, 2, 1, 2};
  const Truth truth = brute_force(PointsView(equal, 2));
  EXPECT_EQ(truth.affine_dimension, 0);
  EXPECT_THAT(truth.cells, ElementsAre(ElementsAre(0)));
  EXPECT_THAT(truth.status, ElementsAre(0, 1));
}

}  // namespace
}  // namespace delone::test
