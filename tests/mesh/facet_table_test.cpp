#include "delone/mesh/facet_table.hpp"

#include <gtest/gtest.h>

#include <array>

namespace delone {
namespace {

std::array<VertexId, 4> cell(Index a, Index b, Index c, Index d) {
  return {VertexId{a}, VertexId{b}, VertexId{c}, VertexId{d}};
}

TEST(FacetTable, a_facet_has_one_name_however_its_cell_lists_the_vertices) {
  const auto key = FacetTable<3>::key(cell(9, 4, 7, 2), 1);
  EXPECT_EQ(key, (FacetTable<3>::Key{VertexId{2}, VertexId{7}, VertexId{9}}));
  EXPECT_EQ(key, FacetTable<3>::key(cell(5, 2, 9, 7), 0));
  EXPECT_NE(key, FacetTable<3>::key(cell(9, 4, 7, 2), 0));
}

TEST(FacetTable, keeps_every_value_while_it_grows) {
  constexpr Index kFacets = 1000;
  Buffer<Index> words;
  FacetTable<3> table(words, 4);
  const auto key = [](Index i) { return FacetTable<3>::key(cell(i, i + 1, i + 2, 0), 3); };
  for (Index i = 0; i < kFacets; ++i) {
    ASSERT_EQ(table[key(i)], kNone);
    table[key(i)] = i;
  }
  for (Index i = 0; i < kFacets; ++i) ASSERT_EQ(table[key(i)], i);
}

TEST(FacetTable, begins_empty_whatever_its_buffer_held) {
  Buffer<Index> words;
  FacetTable<1>(words, 4)[{VertexId{3}}] = 7;
  FacetTable<1> fresh(words, 4);
  EXPECT_EQ((fresh[{VertexId{3}}]), kNone);
}

}  // namespace
}  // namespace delone
