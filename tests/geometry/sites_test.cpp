#include "delone/geometry/sites.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

namespace delone {
namespace {

Sites plane_in_space() {  // the flat of axes 0 and 2: axis 1 is seen by heights only
  Sites sites(3, true, Flat{2, {0, 2}});
  sites.reserve_more(3);
  sites.append(std::vector<double>{1, 2, 3}, 0.5, 2);
  sites.append(std::vector<double>{4, 5, -6}, 0.25, 0);
  sites.append(std::vector<double>{1, 2, 3}, 0.125, 1);
  return sites;
}

TEST(Sites, coordinates_come_back_on_their_axes) {
  const Sites sites = plane_in_space();
  EXPECT_EQ(sites.leading()[2], 4.0);
  EXPECT_EQ(sites.leading()[3], -6.0);
  EXPECT_EQ(sites.others()[1], 5.0);
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(sites.coordinate(VertexId{0}, axis), axis + 1.0);
  EXPECT_EQ(sites.weight(VertexId{1}), 0.25);
  EXPECT_EQ(sites.range().magnitude, 6.0);
}

TEST(Sites, zeros_have_no_sign) {
  const std::vector<double> point{-0.0, 1, -0.0};
  const Index row = 0;
  for (const Flat& flat : {Flat{2, {1, 2}}, Flat{3, {0, 1, 2}}}) {
    Sites sites(3, true, flat);
    sites.append(point, -0.0, 0);
    sites.append(PointsView(point, 3, std::vector{-0.0}), std::span(&row, 1), 1, 1);
    for (const VertexId v : {VertexId{0}, VertexId{1}}) {
      for (const int axis : {0, 2}) EXPECT_FALSE(std::signbit(sites.coordinate(v, axis))) << axis;
      EXPECT_FALSE(std::signbit(sites.weight(v)));
    }
  }
}

TEST(Sites, rows_and_vertices_are_inverse) {
  Sites sites = plane_in_space();
  for (Index row = 0; row < 3; ++row) EXPECT_EQ(sites.row(sites.vertex(row)), row);
  EXPECT_EQ(sites.vertex(2), VertexId{0});
  EXPECT_TRUE(sites.same_place(VertexId{0}, VertexId{2}));
  EXPECT_FALSE(sites.same_place(VertexId{0}, VertexId{1}));
  sites.swap_rows(VertexId{0}, VertexId{2});
  EXPECT_EQ(sites.row(VertexId{0}), 1U);
  EXPECT_EQ(sites.row(VertexId{2}), 2U);
  for (Index row = 0; row < 3; ++row) EXPECT_EQ(sites.row(sites.vertex(row)), row);
}

TEST(Sites, the_last_one_can_be_taken_back) {
  Sites sites = plane_in_space();
  sites.reserve_more(1);
  sites.reserve_empty(1);
  sites.take_back(sites.put(std::vector<double>{7, 8, 9}, 1.0, 3));
  EXPECT_EQ(sites.present_count(), 3U);
  EXPECT_EQ(sites.row_count(), 3U);
  EXPECT_EQ(sites.coordinate(VertexId{2}, 1), 2.0);
  sites.append(std::vector<double>{-1, -2, -3}, 1.0, 3);
  EXPECT_EQ(sites.coordinate(sites.vertex(3), 2), -3.0);
}

TEST(Sites, a_new_point_takes_the_slot_of_a_removed_one_but_not_its_row) {
  Sites sites = plane_in_space();
  const VertexId v = sites.vertex(1);
  sites.reserve_empty(1);
  sites.remove(v);
  EXPECT_TRUE(sites.is_empty(v));
  EXPECT_TRUE(sites.is_removed(1));
  EXPECT_EQ(sites.present_count(), 2U);
  EXPECT_EQ(sites.row_count(), 3U);
  sites.reserve_more(1);
  EXPECT_EQ(sites.put(std::vector<double>{7, 8, 9}, 2.5, 3), v);
  EXPECT_EQ(sites.row(v), 3U);
  EXPECT_EQ(sites.weight(v), 2.5);
  EXPECT_EQ(sites.coordinate(v, 1), 8.0);
  EXPECT_TRUE(sites.is_removed(1));
}

}  // namespace
}  // namespace delone
