#include "delone/mesh/duplicates.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace delone {
namespace {

std::vector<Index> rows_at(const Duplicates& duplicates, VertexId vertex) {
  std::vector<Index> rows;
  for (const auto& [v, row] : duplicates.at(vertex)) rows.push_back(row);
  return rows;
}

constexpr VertexId kVertex{2}, kOther{4}, kSite{7}, kSecond{9};

TEST(Duplicates, wait_at_their_vertex_by_ascending_row) {
  Duplicates duplicates;
  duplicates.add(kSite, kVertex, 30);
  duplicates.add(kSecond, kVertex, 20);
  EXPECT_EQ(rows_at(duplicates, kVertex), (std::vector<Index>{20, 30}));
  EXPECT_TRUE(rows_at(duplicates, kOther).empty());
  EXPECT_EQ(duplicates.vertex_of(kSite), kVertex);
  EXPECT_EQ(duplicates.vertex_of(kVertex), kGhost);
  EXPECT_EQ(duplicates.vertex_of(VertexId{1000}), kGhost);
}

TEST(Duplicates, can_be_taken_out_and_put_back) {
  Duplicates duplicates;
  duplicates.add(kSite, kVertex, 30);
  auto node = duplicates.take(kSite, 30);
  EXPECT_TRUE(duplicates.empty());
  EXPECT_EQ(duplicates.vertex_of(kSite), kGhost);
  duplicates.put_back(std::move(node), kSite);
  EXPECT_EQ(rows_at(duplicates, kVertex), (std::vector<Index>{30}));
  EXPECT_EQ(duplicates.vertex_of(kSite), kVertex);
}

TEST(Duplicates, follow_their_vertex_and_the_names_of_rows) {
  Duplicates duplicates;
  duplicates.add(kSite, kVertex, 1);
  duplicates.change({kVertex, 1}, kSite, {kOther, 2});
  EXPECT_EQ(duplicates.vertex_of(kSite), kOther);
  duplicates.rename_rows(std::vector<Index>{10, 20, 30});
  EXPECT_EQ(rows_at(duplicates, kOther), (std::vector<Index>{30}));
}

}  // namespace
}  // namespace delone
