// What all queries begin with: the point is checked and put as sites are, and its cell is found by a walk.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "delone/mesh/triangulation.hpp"
#include "delone/mesh/walk.hpp"

namespace delone::query_detail {

/// A point as sites keep theirs, leading coordinates first.
using Placed = std::array<double, kMaxDimension>;

/// @throws InputError unless the queries have the dimension of `t` and are finite
void require_queries(const AnyTriangulation& t, PointsView queries);
/// The same for one point. @throws InputError
PointsView require_query(const AnyTriangulation& t, std::span<const double> q);

/// The range of the sites and of all queries but the enormous ones, which would slow down the tests of all others.
NumberRange range_with(const Sites& sites, PointsView queries);

/// Walks, in a complex of dimension K >= 1. One thread each.
template <int K>
class CellFinder {
 public:
  /// @param range  from range_with
  CellFinder(const AnyTriangulation& t, const NumberRange& range)
      : sites_(&t.sites()), complex_(t.complex()), range_(range), kernel_(*sites_, range) {}

  const ConstComplexView<K>& complex() const { return complex_; }

  /// The closed cell that contains q, or a ghost cell whose facet q lies strictly beyond.
  CellId find(const Placed& q, CellId start) {
    if (start == kNoCell) start = cell_of_near_sample(q);
    DELONE_ASSERT(complex_.is_live(start), "a walk begins at a live cell");
    if (in_range(q)) [[likely]]
      return walk_with(kernel_, q, start);
    Kernel<K> own = kernel_for(q);
    return walk_with(own, q, start);
  }

  /// Calls f(kernel) with a kernel whose range holds q.
  template <class F>
  decltype(auto) with_kernel(const Placed& q, F f) {
    if (in_range(q)) return f(kernel_);
    Kernel<K> own = kernel_for(q);
    return f(own);
  }

 private:
  [[gnu::noinline]] CellId walk_with(Kernel<K>& kernel, const Placed& q, CellId start) const {
    WalkStats stats;
    return walk(complex_, kernel, q.data(), start, stats);
  }
  /// The queries that range_with has included.
  bool in_range(const Placed& q) const {
    double largest = 0.0;
    for (const double x : q) largest = std::max(largest, std::abs(x));
    return largest < filter::kLargest;
  }
  Kernel<K> kernel_for(const Placed& q) const {
    NumberRange range = range_;
    range.include(std::span(q).first(K));
    return Kernel<K>(*sites_, range);
  }

  /// Jump and walk: a sample of O(n^(1/(K+1))) vertices costs as much as the walk from the nearest of them. Sites
  /// follow a curve through space, so every so many of them are spread well.
  CellId cell_of_near_sample(const Placed& q) const {
    const std::size_t n = sites_->size();
    const double samples = kSamples * std::pow(static_cast<double>(n), 1.0 / (K + 1));
    const std::size_t step = std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(n) / samples));
    CellId best = complex_.incident_cell(kGhost);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; i += step) {
      const VertexId v{static_cast<Index>(i)};
      const double distance = kernel_.squared_distance(v, q.data());
      if (!(distance < least) || !complex_.has_vertex(v)) continue;
      least = distance;
      best = complex_.incident_cell(v);
    }
    return best;
  }

  static constexpr double kSamples = 1.5;

  const Sites* sites_;
  ConstComplexView<K> complex_;
  NumberRange range_;
  Kernel<K> kernel_;
};

}  // namespace delone::query_detail
