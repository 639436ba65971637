#include "delone/base/ids.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace delone {
namespace {

TEST(Ids, are_types_that_do_not_mix) {
  EXPECT_FALSE((std::is_convertible_v<VertexId, CellId>));
  EXPECT_FALSE((std::is_convertible_v<CellId, FacetId>));
  EXPECT_FALSE((std::is_convertible_v<VertexId, Index>));
  EXPECT_EQ(raw(VertexId{7}), 7U);
}

TEST(Ids, the_ghost_is_beyond_every_row) {
  EXPECT_EQ(raw(kGhost), kNone);
  EXPECT_EQ(raw(kGhost) + Index{1}, Index{0});
}

}  // namespace
}  // namespace delone
