#include "delone/lab/spheres.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/order/order.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

using Curve = std::vector<std::array<double, 2>>;

std::vector<SpheresRow> small_runs() {
  SpheresOptions options;
  options.uniform_sizes = {60, 240, 960};
  options.zeta_sizes = {33, 65, 129, 257};
  options.runs = 20;
  options.zeta_runs = 40;
  return run_spheres(options);
}

TEST(Spheres, what_appears_is_the_sum_over_samples) {
  for (const SpheresRow& row : small_runs()) {
    if (!row.random) continue;
    // Both are means of the same expectation.
    const double root = std::sqrt(row.kind == "uniform" ? 20.0 : 40.0);
    const double error = (row.tetrahedra.deviation + row.samples.deviation) / root;
    EXPECT_NEAR(row.tetrahedra.mean, row.samples.mean, 3 * error) << row.kind << row.n;
  }
}

TEST(Spheres, uniform_points_make_linearly_many_and_those_with_zeta_a_square) {
  Curve uniform, in_order, random, at_most, last;
  for (const SpheresRow& row : small_runs()) {
    const auto n = static_cast<double>(row.n);
    EXPECT_LE(row.tetrahedra.mean, n * n) << row.kind << row.n;
    if (row.kind == "uniform") {
      uniform.push_back({n, row.tetrahedra.mean});
      EXPECT_LT(row.tetrahedra.mean, 27.08 * n);  // 4 * 24 pi^2 / 35 for each, without a boundary
    } else if (row.random) {
      random.push_back({n, row.tetrahedra.mean});
    } else {
      in_order.push_back({n, row.tetrahedra.mean});
      at_most.push_back({n, row.most.mean});
      last.push_back({n, row.last.mean});
      EXPECT_EQ(row.most.mean, zeta_before(row.n));
      EXPECT_EQ(row.last.mean, zeta_after(row.n));
      EXPECT_EQ(row.tetrahedra.mean, zeta_before(row.n) + zeta_after(row.n));
    }
  }
  EXPECT_LT(exponent(uniform), 1.3);  // the boundary matters less and less
  EXPECT_NEAR(exponent(in_order), 2, 0.1);
  EXPECT_NEAR(exponent(random), 2, 0.3);
  EXPECT_NEAR(exponent(at_most), 2, 0.1);
  EXPECT_NEAR(exponent(last), 1, 0.1);
}

// The builder counts the same ones, and those at the ghost vertex.
TEST(Spheres, counts_agree_with_those_of_the_builder) {
  const io::Generated made = io::generate("uniform", 200, 3, 4);
  const PointsView points(made.coordinates, 3);
  constexpr std::array<int, 3> kAxes{0, 1, 2};
  const Appeared a = count_appeared(points, ordered_rows(Order::input, points, kAxes));
  const AnyTriangulation t = build(points, {.method = Method::cavity, .order = Order::input});
  EXPECT_EQ(a.last, static_cast<double>(t.cell_count()));
  EXPECT_LT(a.tetrahedra, static_cast<double>(t.statistics().cells_created));
  EXPECT_GT(a.tetrahedra, 0.7 * static_cast<double>(t.statistics().cells_created));
}

}  // namespace
}  // namespace delone::lab
