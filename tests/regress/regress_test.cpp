// One input for every bug that was ever found, as small as it gets.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/mesh/export.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"
#include "support/float_modes.hpp"

namespace delone {
namespace {

using namespace test;

// The hash sorted points, and the check looked for their axes, while the caller's mode took denormals for zeros.
TEST(Regress, points_that_differ_by_denormals_are_told_apart_when_the_caller_flushes_them) {
  if (!can_flush_denormals()) GTEST_SKIP() << "no such mode on this machine";
  const PointSet points{"denormal triangle", 2, {0, 0, 5e-324, 0, 0, 5e-324}, {}};
  const AnyTriangulation t = built(points);
  const std::uint64_t hash = canonical_hash(t);
  const FlushedDenormals flushed(Flush::both);
  EXPECT_EQ(canonical_hash(t), hash);
  EXPECT_EQ(fails_check(t, points), "");
}

// A denormal weight was taken for none.
TEST(Regress, a_denormal_weight_is_refused_without_weights_whatever_the_mode) {
  AnyTriangulation t = built(PointSet{"triangle", 2, {0, 0, 1, 0, 0, 1}, {}});
  const FlushedDenormals flushed(Flush::both);
  EXPECT_THROW(insert(t, std::vector{0.25, 0.25}, 5e-324), InputError);
}

// Any other rounding mode was reported as fused multiplication or excess precision, too.
TEST(Regress, a_rounding_mode_is_one_problem) {
  const Rounding rounding(FE_DOWNWARD);
  EXPECT_EQ(arithmetic_problems().size(), 1U);
}

// The middle of two numbers side by side is one of them; sites were thought to lie as far from it on either side.
TEST(Regress, few_points_seen_from_a_rounded_middle) {
  constexpr double kHeight = 0x1p-80;
  constexpr double kLeft = 1 + 0x1p-52, kRight = 1 + 0x1p-51;
  const PointSet points{
      "side by side",
      2,
      {kRight, -5 * kHeight, kRight, 4 * kHeight, kLeft, 2.75 * kHeight, kLeft, -3 * kHeight, kRight, 5 * kHeight},
      {}};
  const AnyTriangulation t = built(points);
  EXPECT_EQ(fails_check(t, points), "");
  EXPECT_EQ(canonical_hash(t), canonical_hash(build(points.view(), {.method = Method::cavity})));
}

}  // namespace
}  // namespace delone
