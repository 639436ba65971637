#include "delone/base/arithmetic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cfenv>

#include "support/float_modes.hpp"

namespace delone {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(Arithmetic, nothing_is_wrong_with_this_build) { EXPECT_THAT(arithmetic_problems(), IsEmpty()); }

TEST(Arithmetic, each_changed_rounding_mode_is_noticed) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const Rounding rounding(mode);
    EXPECT_THAT(arithmetic_problems(), ElementsAre(StartsWith("the rounding mode is not to nearest"))) << mode;
  }
}

TEST(Arithmetic, flushed_denormals_are_noticed) {
  if (!can_flush_denormals()) GTEST_SKIP() << "no such mode on this machine";
  for (const auto flush : {Flush::results, Flush::operands, Flush::both}) {
    const FlushedDenormals flushed(flush);
    EXPECT_THAT(arithmetic_problems(), ElementsAre(StartsWith("denormal numbers are flushed to zero")));
  }
}

TEST(ExactEnvironment, sets_all_right_and_restores_what_the_caller_had) {
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const Rounding rounding(mode);
    const FlushedDenormals flushed(Flush::both);
    {
      const ExactEnvironment outer;
      EXPECT_THAT(arithmetic_problems(), IsEmpty());
      { const ExactEnvironment inner; }
      EXPECT_THAT(arithmetic_problems(), IsEmpty());
    }
    EXPECT_EQ(std::fegetround(), mode);
    EXPECT_EQ(denormals_are_flushed(), can_flush_denormals());
  }
}

}  // namespace
}  // namespace delone
