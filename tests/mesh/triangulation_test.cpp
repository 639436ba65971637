#include "delone/mesh/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <thread>
#include <vector>

#include "delone/delone.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

TEST(Triangulation, gives_back_the_rows_as_they_were) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    for (const PointSet& points : families(dimension, 8, 1)) {
      const AnyTriangulation t = built(points);
      EXPECT_EQ(t.coordinates(), points.coordinates) << points.name;
      EXPECT_EQ(t.weights(), points.weights);
      const auto x = points.view()[3];
      EXPECT_EQ(t.point(3), std::vector<double>(x.begin(), x.end()));
      EXPECT_EQ(t.weight(3), points.view().weight(3));
      for (Index row = 0; row < points.size(); ++row) EXPECT_EQ(t.row(t.vertex(row)), row);
    }
  }
}

TEST(Triangulation, no_row_vanishes) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const PointSet& points : families(dimension, 12, 2)) {
      const AnyTriangulation t = built(points);
      std::size_t vertices = 0, duplicates = 0, hidden = 0;
      for (Index row = 0; row < points.size(); ++row) {
        const RowStatus status = t.status(row);
        vertices += status.status == Status::vertex ? 1 : 0;
        duplicates += status.status == Status::duplicate ? 1 : 0;
        hidden += status.status == Status::hidden ? 1 : 0;
        if (status.status != Status::duplicate) {
          EXPECT_EQ(status.of, row);
        }
        if (status.status == Status::duplicate) {
          EXPECT_EQ(t.status(status.of), (RowStatus{Status::vertex, status.of}));
          EXPECT_EQ(t.point(status.of), t.point(row));
          EXPECT_LT(status.of, row);
        }
      }
      EXPECT_EQ(vertices, t.vertex_count());
      EXPECT_EQ(duplicates, t.duplicate_count());
      EXPECT_EQ(hidden, t.hidden_count());
      if (points.weights.empty()) {
        EXPECT_EQ(hidden, 0U);
      }
    }
  }
}

TEST(Triangulation, the_star_of_a_vertex_is_all_of_its_cells) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    const AnyTriangulation t = built(lattice(dimension, 30, 3, 1));
    std::vector<VertexId> all{kGhost};
    for (Index row = 0; row < t.row_count(); ++row) all.push_back(t.vertex(row));
    for (const VertexId v : all) {
      std::set<Index> expected;
      for (std::size_t s = 0; s < t.complex().slot_count(); ++s) {
        const CellId c{static_cast<Index>(s)};
        for (int i = 0; t.complex().is_live(c) && i <= dimension; ++i) {
          if (t.complex().vertex(c, i) == v) expected.insert(raw(c));
        }
      }
      std::set<Index> star;
      for (const CellId c : t.star(v)) EXPECT_TRUE(star.insert(raw(c)).second);
      EXPECT_EQ(star, expected);
    }
  }
}

TEST(Triangulation, no_points_have_no_cells) {
  const AnyTriangulation t(3);
  EXPECT_EQ(t.affine_dimension(), -1);
  EXPECT_EQ(t.row_count() + t.vertex_count() + t.cell_count() + t.hull_facet_count(), 0U);
  EXPECT_EQ(t.duplicate_count() + t.hidden_count(), 0U);
  EXPECT_EQ(cells(t).size() + hull_facets(t).size() + merged_cells(t).size(), 0U);
}

TEST(Triangulation, another_dimension_than_the_type_is_refused) {
  EXPECT_THROW(Triangulation<3>(AnyTriangulation(2)), InputError);
  const Triangulation<2> t = triangulate<2>({{0, 0}, {2, 0}, {0, 2}, {2, 2}});
  EXPECT_EQ(t.cell_count(), 2U);
  EXPECT_EQ(t.point(2), (std::array<double, 2>{0, 2}));
  EXPECT_EQ(Triangulation<4>().dimension(), 4);
}

TEST(Triangulation, a_copy_is_independent) {
  const PointSet points = uniform(2, 30, 1);
  const AnyTriangulation t = built(points);
  AnyTriangulation copy = t;
  insert(copy, std::vector{0.5, 0.5});
  EXPECT_EQ(description(t), description(built(points)));
  EXPECT_EQ(copy.row_count(), 31U);
}

TEST(Triangulation, memory_stays_within_eighty_bytes_a_point_in_2d_and_three_hundred_in_3d) {
  constexpr std::size_t kWider = sizeof(Index) / sizeof(std::uint32_t);  // with 64-bit ids twice as much
  EXPECT_LT(built(uniform(2, 20000, 1)).memory_bytes() / 20000, kWider * 80 + 16);
  EXPECT_LT(built(uniform(3, 20000, 1)).memory_bytes() / 20000, kWider * 300 + 24);
}

TEST(Triangulation, many_threads_read_one_object) {
  const PointSet points = with_random_weights(lattice(3, 200, 5, 1), 2);
  const AnyTriangulation t = built(points);
  const std::string expected = description(t);
  const std::size_t degree = t.star(kGhost).size();
  std::vector<int> right(8, 0);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < right.size(); ++i) {
      threads.emplace_back([&, i] {
        for (int round = 0; round < 3; ++round) {
          right[i] += description(t) == expected && t.star(kGhost).size() == degree ? 1 : 0;
        }
      });
    }
  }
  EXPECT_EQ(std::ranges::count(right, 3), 8);
}

}  // namespace
}  // namespace delone
