#include "delone/lab/arithmetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace delone::lab {
namespace {

std::vector<StageCounts> small() {
  ArithmeticOptions options;
  options.n = 600;
  options.n_square = 60;
  return run_arithmetic(options);
}

const StageCounts& of(const std::vector<StageCounts>& all, const std::string& kind, int dimension, int bits) {
  return *std::ranges::find_if(
      all, [&](const StageCounts& c) { return c.kind == kind && c.dimension == dimension && c.rounded_to == bits; });
}

// [For92] 4.7.
TEST(Arithmetic, determinants_have_no_more_bits_than_their_degrees_allow) {
  for (const StageCounts& c : small()) {
    EXPECT_LE(c.orient_bits, orient_bits_bound(c.dimension, c.input_bits)) << c.kind;
    EXPECT_LE(c.conflict_bits, conflict_bits_bound(c.dimension, c.input_bits)) << c.kind;
    if (c.rounded_to != 0) {
      EXPECT_LE(c.input_bits, c.rounded_to) << c.kind;
    }
  }
}

// [Dev97] 5.3: "double precision computation is exact on degree 2 tests and almost never leads to precision problems on
// degree 4 predicates".
TEST(Arithmetic, twenty_four_bits_in_the_plane_are_nearly_all_filtered) {
  const std::vector<StageCounts> all = small();
  for (const StageCounts& c : all) {
    if (c.dimension != 2 || c.rounded_to != 24) continue;
    EXPECT_EQ(c.tests.orient_exact, 0U) << c.kind;
  }
  for (const char* kind : {"uniform", "gaussian", "clusters"}) {
    const StageCounts& c = of(all, kind, 2, 24);
    EXPECT_GT(static_cast<double>(c.tests.conflict_filter), 0.999 * static_cast<double>(c.conflicts())) << kind;
    EXPECT_EQ(c.tests.conflict_symbolic, 0U) << kind;
  }
}

TEST(Arithmetic, ties_are_symbolic_where_points_are_cospherical) {
  const std::vector<StageCounts> all = small();
  for (const int dimension : {2, 3}) {
    EXPECT_GT(of(all, "lattice", dimension, 0).tests.conflict_symbolic, 0U);
    EXPECT_EQ(of(all, "uniform", dimension, 0).tests.conflict_symbolic, 0U);
  }
}

TEST(Arithmetic, points_of_a_sphere_go_past_the_filter) {
  const std::vector<StageCounts> all = small();
  const StageCounts& c = of(all, "sphere", 3, 0);
  EXPECT_GT(c.tests.conflict_adaptive + c.tests.conflict_exact + c.tests.conflict_symbolic, 0U);
}

}  // namespace
}  // namespace delone::lab
