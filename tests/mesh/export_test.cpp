#include "delone/mesh/export.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "delone/base/dispatch.hpp"
#include "delone/base/random.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;
using ::testing::ElementsAre;

/// Exact orientation of k + 1 rows on the axes of the flat.
int orientation(const AnyTriangulation& t, const std::vector<Index>& rows) {
  return with_dimension<1>(t.affine_dimension(), [&](auto k) {
    std::array<const double*, k + 1> points;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = t.sites().at(t.vertex(rows[i]));
    return slow_orient<k>(points).sign;
  });
}

TEST(Cells, are_in_the_documented_order) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 12, 1)) {
      const AnyTriangulation t = built(points);
      const CellTable table = cells(t);
      ASSERT_EQ(table.size(), t.cell_count());
      ASSERT_EQ(table.corners, t.affine_dimension() + 1);
      std::vector<std::vector<Index>> sorted;
      for (std::size_t c = 0; c < table.size(); ++c) {
        std::vector<Index> rows(table[c].begin(), table[c].end());
        ASSERT_TRUE(t.affine_dimension() == 0 || orientation(t, rows) == 1) << points;
        std::vector<Index> ascending = rows;
        std::ranges::sort(ascending);
        if (rows != ascending) std::swap(rows[rows.size() - 1], rows[rows.size() - 2]);
        EXPECT_EQ(rows, ascending);
        sorted.push_back(ascending);
      }
      EXPECT_TRUE(std::ranges::is_sorted(sorted));
    }
  }
}

TEST(Cells, neighbours_share_all_but_the_opposite_vertex_and_name_each_other) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 12, 2)) {
      const AnyTriangulation t = built(points);
      const CellTable table = cells(t);
      const auto corners = static_cast<std::size_t>(table.corners);
      std::size_t outside = 0;
      for (std::size_t c = 0; c < table.size(); ++c) {
        for (std::size_t i = 0; i < corners; ++i) {
          const Index d = table.neighbours[c * corners + i];
          if (d == kNone) {
            ++outside;
            continue;
          }
          std::set<Index> shared(table[c].begin(), table[c].end());
          shared.erase(table[c][i]);
          const auto back = std::find(table.neighbours.begin() + static_cast<std::ptrdiff_t>(d * corners),
                                      table.neighbours.begin() + static_cast<std::ptrdiff_t>((d + 1) * corners), c);
          const auto j = static_cast<std::size_t>(back - table.neighbours.begin()) - d * corners;
          ASSERT_LT(j, corners);
          for (std::size_t k = 0; k < corners; ++k) EXPECT_EQ(shared.contains(table[d][k]), k != j);
        }
      }
      EXPECT_TRUE(t.affine_dimension() == 0 || outside == t.hull_facet_count());
    }
  }
}

TEST(HullFacets, run_counter_clockwise_seen_from_outside) {
  const PointSet square{"square", 2, {0, 0, 1, 0, 1, 1, 0, 1}, {}};
  EXPECT_THAT(hull_facets(built(square)).vertices, ElementsAre(0, 1, 3, 0, 1, 2, 2, 3));
  const PointSet corner{"corner", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {}};
  EXPECT_THAT(hull_facets(built(corner)).vertices, ElementsAre(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3));
  const PointSet line{"line", 1, {3, 1, 2}, {}};
  EXPECT_THAT(hull_facets(built(line)).vertices, ElementsAre(0, 1));
}

TEST(HullFacets, have_every_point_on_their_inner_side) {
  for (int dimension = 2; dimension <= 5; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 12, 3)) {
      const AnyTriangulation t = built(points);
      const CellTable facets = hull_facets(t);
      EXPECT_EQ(facets.size(), t.hull_facet_count());
      if (t.affine_dimension() < 2) continue;
      for (std::size_t f = 0; f < facets.size(); ++f) {
        for (Index row = 0; row < points.size(); ++row) {
          // A point in front of the facet, then the facet: outward normal first, so the inner side is negative.
          std::vector<Index> simplex(facets[f].begin(), facets[f].end());
          simplex.push_back(row);
          const int side = orientation(t, simplex) * (t.affine_dimension() % 2 == 0 ? 1 : -1);
          ASSERT_GE(side, 0) << points << " facet " << f << " row " << row;
        }
      }
    }
  }
}

TEST(HullFacets, of_a_closed_surface_meet_in_pairs) {
  const CellTable facets = hull_facets(built(lattice(3, 60, 4, 1)));
  std::map<std::pair<Index, Index>, int> edges;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{facets[f][i], facets[f][(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST(MergedCells, of_a_lattice_are_its_cubes) {
  PointSet cubes{"cubes", 3, {}, {}};
  for (int i = 0; i < 27; ++i) {
    for (const int step : {9, 3, 1}) cubes.coordinates.push_back(i / step % 3);
  }
  const PolytopeTable merged = merged_cells(built(cubes));
  ASSERT_EQ(merged.size(), 8U);
  EXPECT_THAT(std::vector<Index>(merged[0].begin(), merged[0].end()), ElementsAre(0, 1, 3, 4, 9, 10, 12, 13));
  for (std::size_t c = 0; c < 8; ++c) EXPECT_EQ(merged[c].size(), 8U);
}

TEST(MergedCells, of_cospherical_points_are_one) {
  PointSet sphere{"octahedron", 3, {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1}, {}};
  EXPECT_EQ(built(sphere).cell_count(), 4U);
  ASSERT_EQ(merged_cells(built(sphere)).size(), 1U);
  EXPECT_THAT(merged_cells(built(sphere)).vertices, ElementsAre(0, 1, 2, 3, 4, 5));
}

/// The definition in the header, word for word.
std::uint64_t documented_hash(const AnyTriangulation& t) {
  std::vector<std::vector<double>> places;
  for (Index row = 0; row < t.row_count(); ++row) places.push_back(t.point(row));
  std::vector<std::vector<double>> distinct = places;
  std::ranges::sort(distinct);
  distinct.erase(std::ranges::unique(distinct).begin(), distinct.end());
  std::vector<std::vector<std::size_t>> numbered;
  for (const auto& cell : sorted_cells(t)) {
    numbered.emplace_back();
    for (const Index row : cell) {
      numbered.back().push_back(
          static_cast<std::size_t>(std::ranges::lower_bound(distinct, places[row]) - distinct.begin()));
    }
    std::ranges::sort(numbered.back());
  }
  std::ranges::sort(numbered);
  std::uint64_t hash = 0;
  const auto feed = [&](std::uint64_t word) { hash = mix(hash ^ word); };
  feed(static_cast<std::uint64_t>(t.dimension()));
  feed(static_cast<std::uint64_t>(std::int64_t{t.affine_dimension()}));
  feed(distinct.size());
  feed(numbered.size());
  for (const auto& cell : numbered) {
    for (const std::size_t number : cell) feed(number);
  }
  return hash;
}

TEST(CanonicalHash, is_as_documented) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : families(dimension, 10, 4)) {
      const AnyTriangulation t = built(points);
      EXPECT_EQ(canonical_hash(t), documented_hash(t)) << points;
    }
    EXPECT_EQ(canonical_hash(AnyTriangulation(dimension)), documented_hash(AnyTriangulation(dimension)));
  }
}

}  // namespace
}  // namespace delone
