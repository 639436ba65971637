// What the harness asks of another library: an index over points, and the nearest of a query.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "delone/geometry/points.hpp"

namespace delone::bench {

class QueryPeer {
 public:
  virtual ~QueryPeer() = default;
  /// The nearest rows of all queries, one after the other in their order, k of each.
  virtual void nearest(PointsView queries, std::size_t k, std::span<std::uint32_t> rows) const = 0;
};

/// A k-d tree of nanoflann over borrowed points of dimension 2 or 3, with 10 points a leaf.
std::unique_ptr<QueryPeer> nanoflann_index(PointsView points);
std::string nanoflann_version();

}  // namespace delone::bench
