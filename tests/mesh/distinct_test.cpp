#include "mesh/distinct.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "delone/base/dispatch.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

TEST(Distinct, sites_have_places_of_their_own_and_the_first_span_space) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : families(dimension, 60, 2)) {
      if (affine_dimension(points.view()) < 1) continue;
      const DistinctSites sites = distinct_sites(points.view(), Order::random, 3, 1);
      const Sites& all = sites.mesh.sites;
      ASSERT_EQ(all.size(), points.size());
      std::set<std::vector<double>> places;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const VertexId v{static_cast<Index>(i)};
        const auto p = points.view()[all.row(v)];
        const bool is_new = places.emplace(p.begin(), p.end()).second;
        EXPECT_EQ(is_new, i < sites.count) << points;
      }
      with_dimension<1>(all.flat().dimension, [&](auto k) {
        std::array<const double*, k + 1> simplex;
        for (std::size_t i = 0; i <= k; ++i) simplex[i] = all.at(VertexId{static_cast<Index>(i)});
        EXPECT_NE(slow_orient<k>(simplex).sign, 0) << points;
      });
    }
  }
}

TEST(Distinct, of_several_at_one_place_the_heaviest_stands_there_and_of_these_the_lowest_row) {
  const std::vector<double> x{5, 0, 5, 5, 9};
  const std::vector<double> weights{1, 0, 2, 2, 0};
  const DistinctSites sites = distinct_sites(PointsView(x, 1, weights), Order::input, 1, 1);
  EXPECT_EQ(sites.count, 3U);
  std::set<Index> rows;
  for (Index i = 0; i < 3; ++i) rows.insert(sites.mesh.sites.row(VertexId{i}));
  EXPECT_EQ(rows, (std::set<Index>{1, 2, 4}));
  EXPECT_EQ(sites.mesh.duplicates.size(), 1U);  // row 3; row 0 is hidden
}

}  // namespace
}  // namespace delone
