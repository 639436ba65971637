#include "delone/mesh/hidden.hpp"

#include <gtest/gtest.h>

#include <set>

namespace delone {
namespace {

std::set<VertexId> sites_in(const HiddenSites& hidden, CellId c) {
  std::set<VertexId> sites;
  for (VertexId v = hidden.first(c); v != kGhost; v = hidden.next(v)) sites.insert(v);
  return sites;
}

constexpr CellId kCell{3}, kOther{5};
constexpr VertexId kA{0}, kB{4}, kC{8};

TEST(HiddenSites, are_listed_by_the_cell_that_holds_them) {
  HiddenSites hidden;
  EXPECT_FALSE(hidden.holds(kA));
  EXPECT_EQ(hidden.first(kCell), kGhost);
  hidden.reserve(9, 6);
  for (const VertexId v : {kA, kB, kC}) hidden.add(v, kCell);
  EXPECT_EQ(sites_in(hidden, kCell), (std::set<VertexId>{kA, kB, kC}));
  EXPECT_TRUE(sites_in(hidden, kOther).empty());
  EXPECT_EQ(hidden.cell(kB), kCell);
}

TEST(HiddenSites, leave_their_list_from_every_place_in_it) {
  for (const VertexId leaving : {kA, kB, kC}) {
    HiddenSites hidden;
    hidden.reserve(9, 6);
    for (const VertexId v : {kA, kB, kC}) hidden.add(v, kCell);
    hidden.remove(leaving);
    EXPECT_FALSE(hidden.holds(leaving));
    std::set<VertexId> rest{kA, kB, kC};
    rest.erase(leaving);
    EXPECT_EQ(sites_in(hidden, kCell), rest);
    hidden.add(leaving, kOther);
    EXPECT_EQ(sites_in(hidden, kOther), (std::set<VertexId>{leaving}));
    EXPECT_EQ(sites_in(hidden, kCell), rest);
  }
}

TEST(HiddenSites, keep_their_lists_while_room_is_made) {
  HiddenSites hidden;
  hidden.reserve(9, 6);
  hidden.add(kB, kCell);
  hidden.reserve(1000, 1000);
  EXPECT_EQ(sites_in(hidden, kCell), (std::set<VertexId>{kB}));
  EXPECT_EQ(hidden.first(CellId{999}), kGhost);
  EXPECT_FALSE(hidden.holds(VertexId{999}));
}

}  // namespace
}  // namespace delone
