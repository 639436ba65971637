#include "delone/mesh/walk.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delone/base/dispatch.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// Whether the closed cell contains q, or, for a ghost cell, whether q lies strictly beyond its facet.
template <int K>
bool holds(const ComplexView<K>& complex, Kernel<K>& kernel, CellId c, VertexId q) {
  const int ghost = complex.ghost_slot(c);
  for (int i = 0; i <= K; ++i) {
    if (ghost >= 0 && i != ghost) continue;
    auto v = complex.vertices(c);
    v[static_cast<std::size_t>(i)] = q;
    if (kernel.orient(v) < (ghost >= 0 ? 1 : 0)) return false;
  }
  return true;
}

/// Walks from every cell to every query, of which each is a site that is in no cell.
template <int K>
void expect_every_walk_to_arrive(AnyTriangulation& t, std::size_t first_query) {
  const ComplexView<K> complex(t.mesh().complex);
  Kernel<K> kernel(t.sites());
  for (std::size_t i = first_query; i < t.row_count(); ++i) {
    const VertexId q{static_cast<Index>(i)};
    const CellId exhaustive = exhaustive_locate(complex, kernel, kernel.at(q));
    ASSERT_TRUE(holds(complex, kernel, exhaustive, q));
    for (std::size_t s = 0; s < complex.slot_count(); ++s) {
      const CellId start{static_cast<Index>(s)};
      if (!complex.is_live(start)) continue;
      WalkStats stats;
      const CellId c = walk(complex, kernel, kernel.at(q), start, stats);
      ASSERT_TRUE(complex.is_live(c) && holds(complex, kernel, c, q));
      EXPECT_EQ(complex.is_ghost(c), complex.is_ghost(exhaustive));
      EXPECT_EQ(stats.fallbacks, 0U);
      EXPECT_LE(stats.steps, complex.slot_count());
    }
  }
}

TEST(Walk, arrives_from_every_cell_where_looking_at_every_cell_finds_the_point) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    const std::size_t n = dimension < 4 ? 30 : 15;
    for (const PointSet& points :
         {uniform(dimension, n, 1), lattice(dimension, n, 3, 2), cospherical(dimension, n, 3),
          circle_of_24_bits(dimension, n, 4), with_random_weights(lattice(dimension, n, 4, 5), 6)}) {
      AnyTriangulation t = built(points);
      if (t.affine_dimension() != dimension) continue;
      // Queries: inside, outside, at vertices, on facets and in line with them.
      PointSet queries = uniform(dimension, 8, 9);
      for (const PointSet& more : {lattice(dimension, 8, 5, 10), rows(points, 0, 4)}) {
        queries.coordinates.insert(queries.coordinates.end(), more.coordinates.begin(), more.coordinates.end());
      }
      Sites& sites = t.mesh().sites;
      for (std::size_t i = 0; i < queries.size(); ++i) {
        sites.reserve_more(1);
        sites.append(queries.view()[i], 0.0, static_cast<Index>(sites.size()));
      }
      with_dimension<1>(dimension, [&](auto k) { expect_every_walk_to_arrive<k>(t, points.size()); });
    }
  }
}

}  // namespace
}  // namespace delone
