#include "delone/geometry/perturb.hpp"

#include <gtest/gtest.h>

#include <array>

namespace delone {
namespace {

using Place = std::array<int, 2>;

/// The corners of the unit square in lexicographic order, and signs by hand.
struct Square {
  std::array<Place, 4> places{{{0, 0}, {0, 1}, {1, 0}, {1, 1}}};
  const Place& at(VertexId v) const { return places[raw(v)]; }
  bool conflict(std::array<Index, 3> cell, Index q) const {
    return perturbed_conflict<2>(
        {VertexId{cell[0]}, VertexId{cell[1]}, VertexId{cell[2]}}, VertexId{q},
        [&](VertexId a, VertexId b) { return at(a) < at(b); },
        [&](const std::array<VertexId, 3>& v) {
          const Place& a = at(v[0]);
          const Place& b = at(v[1]);
          const Place& c = at(v[2]);
          const int det = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
          return det > 0 ? 1 : (det < 0 ? -1 : 0);
        });
  }
};

TEST(Perturb, a_square_is_cut_from_its_smallest_corner) {
  const Square square;
  EXPECT_FALSE(square.conflict({0, 2, 3}, 1));
  EXPECT_FALSE(square.conflict({0, 3, 1}, 2));
  EXPECT_TRUE(square.conflict({0, 2, 1}, 3));
  EXPECT_TRUE(square.conflict({1, 2, 3}, 0));
}

TEST(Perturb, the_order_of_the_corners_does_not_matter) {
  const Square square;
  EXPECT_EQ(square.conflict({2, 1, 0}, 3), square.conflict({0, 2, 1}, 3));
  EXPECT_EQ(square.conflict({3, 0, 2}, 1), square.conflict({0, 2, 3}, 1));
}

TEST(Perturb, where_the_smallest_does_not_tell_the_next_one_does) {
  // A cell of the cube, and a corner in one plane with those opposite its smallest one: three of them and the corner
  // are a square, cut from its own smallest corner.
  const std::array<std::array<int, 3>, 5> places{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}}};
  const auto conflict = [&](const std::array<VertexId, 4>& cell, VertexId q) {
    return perturbed_conflict<3>(
        cell, q, [&](VertexId a, VertexId b) { return places[raw(a)] < places[raw(b)]; },
        [&](const std::array<VertexId, 4>& v) {
          std::array<std::array<int, 3>, 3> d;
          for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) d[i][j] = places[raw(v[i + 1])][j] - places[raw(v[0])][j];
          }
          const int det = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                          d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                          d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
          return det > 0 ? 1 : (det < 0 ? -1 : 0);
        });
  };
  const VertexId apex{0}, first{1}, a{2}, b{3}, last{4};
  EXPECT_TRUE(conflict({apex, first, a, b}, last));   // (a, b) is not the diagonal from the first corner
  EXPECT_FALSE(conflict({apex, first, a, last}, b));  // (first, last) is
  EXPECT_TRUE(conflict({apex, a, last, b}, first));
}

}  // namespace
}  // namespace delone
