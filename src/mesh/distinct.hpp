// A mesh without cells, for methods that want every site to stand at a place of its own: the others are set aside.
#pragma once

#include <cstddef>
#include <cstdint>

#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"
#include "delone/order/order.hpp"

namespace delone {

struct DistinctSites {
  Mesh mesh;
  /// Sites 0 to count - 1 have places of their own; of those that share one it is the heaviest, by the lowest row.
  /// Sites 0 to k span their flat, the rest follow in the order asked for. Sites from `count` on repeat one of these,
  /// or are hidden by it.
  std::size_t count;
};

/// Cost: that of the order, and of sorting the rows along a curve.
DistinctSites distinct_sites(PointsView points, Order order, std::uint64_t seed, int threads);

}  // namespace delone
