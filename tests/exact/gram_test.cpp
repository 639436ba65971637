#include "exact/gram.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/families.hpp"

namespace delone::exact {
namespace {

std::vector<Integers> random_edges(std::size_t count, std::size_t dimension, test::Random& random) {
  std::vector<Integers> edges(count, Integers(dimension));
  for (Integers& edge : edges) {
    for (BigInt& x : edge) x = static_cast<int>(random() % 41) - 20;
  }
  return edges;
}

TEST(Gram, the_solution_meets_every_equation) {
  test::Random random(1);
  for (std::size_t n = 0; n <= 8; ++n) {
    for (int trial = 0; trial < 20; ++trial) {
      const std::vector<Integers> edges = random_edges(n, 8, random);
      Integers b(n);
      for (BigInt& x : b) x = static_cast<int>(random() % 41) - 20;
      const auto [m, determinant] = solve_gram(edges, b);
      ASSERT_GT(determinant, 0);
      for (std::size_t i = 0; i < n; ++i) {
        BigInt sum = 0;
        for (std::size_t j = 0; j < n; ++j) sum += dot(edges[i], edges[j]) * m[j];
        EXPECT_EQ(sum, b[i] * determinant);
      }
    }
  }
}

TEST(Gram, edges_that_depend_on_each_other_have_determinant_0) {
  test::Random random(2);
  for (std::size_t n = 1; n <= 8; ++n) {
    std::vector<Integers> edges = random_edges(n, 8, random);
    Integers sum(8);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      for (std::size_t j = 0; j < 8; ++j) sum[j] += static_cast<int>(i + 1) * edges[i][j];
    }
    edges.back() = sum;  // for n = 1 it is 0
    EXPECT_EQ(solve_gram(edges, Integers(n)).second, 0);
  }
}

}  // namespace
}  // namespace delone::exact
