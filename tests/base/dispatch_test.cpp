#include "delone/base/dispatch.hpp"

#include <gtest/gtest.h>

namespace delone {
namespace {

TEST(Dispatch, every_dimension_reaches_its_own_instantiation) {
  for (int k = 0; k <= kMaxDimension; ++k) {
    EXPECT_EQ(with_dimension(k, [](auto dimension) { return static_cast<int>(sizeof(char[dimension + 1])) - 1; }), k);
  }
  EXPECT_EQ(with_dimension<3>(5, [](auto dimension) { return static_cast<int>(dimension); }), 5);
}

}  // namespace
}  // namespace delone
