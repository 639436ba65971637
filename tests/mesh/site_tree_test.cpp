#include "mesh/site_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "delone/base/dispatch.hpp"
#include "delone/geometry/affine.hpp"
#include "mesh/distinct.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// Counts the sites of the boxes that a plane does not rule out.
template <int K>
struct BelowPlane {
  const SiteTree<K>& tree;
  Plane<K> plane;
  std::vector<bool> seen;

  double rank(std::size_t box) const { return tree.clearance(plane, box).is_certain() ? SiteTree<K>::kNever : 0.0; }
  bool visit(VertexId v) {
    seen[raw(v)] = true;
    return false;
  }
};

/// What the tree is certain of must be so; a site below a plane is never passed over.
template <int K>
void expect_right(const PointSet& points) {
  const DistinctSites sites = distinct_sites(points.view(), Order::random, 1, 1);
  Kernel<K> kernel(sites.mesh.sites);
  const SiteTree<K> tree(sites.mesh.sites, sites.count);
  Random random(7);
  for (int round = 0; round < 15; ++round) {
    typename Kernel<K>::Cell cell;
    for (VertexId& v : cell) v = VertexId{static_cast<Index>(random() % sites.count)};
    const int orientation = kernel.orient(cell);
    if (orientation == 0) continue;
    if (orientation < 0) std::swap(cell[0], cell[1]);
    BelowPlane<K> query{tree, tree.plane(cell), std::vector<bool>(sites.count)};
    const Plane<K> wall = tree.wall(cell, 0);
    tree.search(query);
    for (std::size_t i = 0; i < sites.count; ++i) {
      const VertexId q{static_cast<Index>(i)};
      if (std::ranges::find(cell, q) != cell.end()) continue;
      const int sign = kernel.slow_conflict_sign(cell, q).sign;  // +1: below
      const int told = tree.clearance(query.plane, q).sign();
      ASSERT_TRUE(told == 0 || told == -sign) << points;
      ASSERT_TRUE(sign <= 0 || query.seen[i]) << points;
      auto moved = cell;
      moved[0] = q;
      const int side = tree.clearance(wall, q).sign();
      ASSERT_TRUE(side == 0 || side == kernel.orient(moved)) << points;
    }
  }
}

TEST(SiteTree, passes_over_nothing_that_lies_below_and_tells_no_wrong_sign) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    for (const PointSet& points : families(dimension, 40, 2)) {
      const int k = affine_dimension(points.view());
      if (k >= 1) with_dimension<1>(k, [&](auto constant) { expect_right<constant>(points); });
    }
  }
}

TEST(SiteTree, does_not_depend_on_the_unit_of_coordinates) {
  for (const double unit : {1e-300, 1e-30, 1e30, 1e300}) {
    PointSet points = uniform(3, 70, 4);
    for (double& x : points.coordinates) x *= unit;
    expect_right<3>(points);
    const DistinctSites sites = distinct_sites(points.view(), Order::random, 1, 1);
    const SiteTree<3> tree(sites.mesh.sites, sites.count);
    EXPECT_GT(tree.plane({VertexId{0}, VertexId{1}, VertexId{2}, VertexId{3}}).error, 0.0) << unit;
  }
}

}  // namespace
}  // namespace delone
