// The sites in a tree of boxes, for searches of what lies below a hyperplane.
// Source: [FBF77]; [For92] 4.6 has buckets for the same purpose.
//
// The square of a point's distance from the centre of a cell's ball, less that of the radius and less its weight, is
// what the point lies above the cell's lifted hyperplane: normal . d + |d|^2 - w, where d leads to it from a corner of
// the cell. Least over a box it is a sum of least values per axis, so a ball, with weights or without, in space or in a
// flat, needs no centre and no radius, and nothing cancels that does not cancel in the test of a site. A box is passed
// over only when that least value is above a bound on its error, and a site's sign is known only when it is beyond
// such a bound; what that leaves open the kernel decides. So rounding may cost time, never a site: where a hyperplane
// is not known in doubles, because its cell is thin or numbers of very different sizes meet, every site is looked at.
//
// Coordinates are multiplied by a power of two that makes the largest about 1, so that their unit does not matter.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"
#include "delone/exact/determinant.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/geometry/sites.hpp"

namespace delone {

/// A hyperplane in lifted space: through a cell, or vertical through a facet. It passes through the lifted `origin`; a
/// site at d from there, of height l above it, lies normal . d + l above the hyperplane of a cell, and normal . d
/// inside a vertical one, in the tree's unit.
template <int K>
struct Plane {
  std::array<double, K> normal{};
  double error = 0.0;  ///< times the sum of |d_j|: bounds that of the normal; 0 when nothing is known
  VertexId origin{0};
  bool vertical = false;
};

template <int K>
class SiteTree {
  static constexpr std::size_t kCoordinates = K;
  static constexpr std::size_t kLeaf = 8;

 public:
  /// How far above a hyperplane something lies at least, up to an error.
  struct Clearance {
    double least, error;
    bool is_certain() const { return least > error; }
    /// The sign, if that is certain, or 0.
    int sign() const { return least > error ? 1 : (least < -error ? -1 : 0); }
  };
  /// The rank of a box that a search passes over.
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /// Of sites 0 to count - 1, which stay where they are.
  SiteTree(const Sites& sites, std::size_t count)
      : sites_(&sites),
        other_count_(static_cast<std::size_t>(sites.dimension()) - kCoordinates),
        scale_(filter::power_of_two(std::clamp(-std::ilogb(sites.range().magnitude), -1022, 1023))),
        order_(count) {
    std::size_t slots = 1;
    for (std::size_t size = count; size > kLeaf; size = (size + 1) / 2) slots = 2 * slots + 1;
    boxes_.resize(slots);
    others_.resize(2 * other_count_ * slots);
    Buffer<Entry> entries(count);
    for (std::size_t i = 0; i < count; ++i) {
      entries[i].site = VertexId{static_cast<Index>(i)};
      for (std::size_t j = 0; j < kCoordinates; ++j) entries[i].x[j] = x(entries[i].site, j);
    }
    make(0, {entries.data(), count});
    for (std::size_t i = 0; i < count; ++i) order_[i] = entries[i].site;
  }

  const Sites& sites() const { return *sites_; }
  /// All of them, near ones close to each other.
  std::span<const VertexId> in_order() const { return {order_.data(), order_.size()}; }

  /// Goes through the sites of all boxes that the query does not pass over, boxes of low rank first, until it has had
  /// enough.
  /// @param query  rank(box): kNever, or any other number; visit(site): true to end the search
  /// @return       whether `visit` ended it
  template <class Query>
  bool search(Query& query) const {
    return query.rank(0) != kNever && descend(0, {order_.data(), order_.size()}, query);
  }

  /// Through the lifted vertices of a cell.
  Plane<K> plane(const std::array<VertexId, K + 1>& cell) const;
  /// Vertical, through the facet opposite a slot of a cell.
  Plane<K> wall(const std::array<VertexId, K + 1>& cell, int slot) const;

  /// Of all points of a box.
  Clearance clearance(const Plane<K>& plane, std::size_t box) const;
  /// Of one site, which then lies between `least` - `error` and `least` + `error`.
  Clearance clearance(const Plane<K>& plane, VertexId v) const;

  /// Between a point and a box, squared and rounded, on the leading axes.
  double squared_distance(const std::array<double, K>& p, std::size_t box) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < kCoordinates; ++j) {
      const double d = std::max({0.0, boxes_[box].low[j] - p[j], p[j] - boxes_[box].high[j]});
      sum += d * d;
    }
    return limited(sum);
  }

  /// A rank, though the number may be infinite or none.
  static double limited(double rank) {
    return rank < std::numeric_limits<double>::max() ? rank : std::numeric_limits<double>::max();
  }

  /// A leading coordinate in the tree's unit.
  double x(VertexId v, std::size_t j) const { return scale_ * sites_->at(v)[j]; }

 private:
  struct Box {
    std::array<double, K> low, high;
    double heaviest;  ///< of the weights, as given
  };
  struct Entry {
    std::array<double, K> x;
    VertexId site;
  };

  double other(VertexId v, std::size_t j) const { return scale_ * sites_->others()[raw(v) * other_count_ + j]; }
  /// How much more than site q something of this weight weighs. Subtracted first: equal weights cancel whatever they
  /// are.
  double heavier(double weight, VertexId q) const { return scale_ * (scale_ * (weight - sites_->weight(q))); }

  /// What other coordinates and weights add to the height of v above q, and the sum of its parts' sizes.
  struct Lift {
    double value = 0.0;
    double size = 0.0;
  };
  Lift extra_lift(VertexId v, VertexId q) const {
    Lift lift;
    for (std::size_t j = 0; j < other_count_; ++j) {
      const double d = other(v, j) - other(q, j);
      lift.value += d * d;
    }
    lift.size = lift.value;
    if (sites_->weighted()) {
      const double w = heavier(sites_->weight(v), q);
      lift.value -= w;
      lift.size += std::abs(w);
    }
    return lift;
  }

  /// Halves the sites across the longest side of their box; child boxes of b are 2 b + 1 and 2 b + 2.
  void make(std::size_t box, std::span<Entry> entries) {
    enclose(box, entries);
    if (entries.size() <= kLeaf) return;
    const Box& b = boxes_[box];
    std::size_t axis = 0;
    for (std::size_t j = 1; j < kCoordinates; ++j) {
      if (b.high[j] - b.low[j] > b.high[axis] - b.low[axis]) axis = j;
    }
    const std::size_t half = entries.size() / 2;
    std::nth_element(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(half), entries.end(),
                     [axis](const Entry& a, const Entry& c) { return a.x[axis] < c.x[axis]; });
    make(2 * box + 1, entries.first(half));
    make(2 * box + 2, entries.subspan(half));
  }

  void enclose(std::size_t box, std::span<const Entry> entries) {
    Box b{entries[0].x, entries[0].x, sites_->weight(entries[0].site)};
    for (const Entry& e : entries) {
      for (std::size_t j = 0; j < kCoordinates; ++j) {
        b.low[j] = std::min(b.low[j], e.x[j]);
        b.high[j] = std::max(b.high[j], e.x[j]);
      }
      b.heaviest = std::max(b.heaviest, sites_->weight(e.site));
    }
    boxes_[box] = b;
    double* const low = others_.data() + 2 * other_count_ * box;
    double* const high = low + other_count_;
    for (std::size_t j = 0; j < other_count_; ++j) {
      low[j] = high[j] = other(entries[0].site, j);
      for (const Entry& e : entries) {
        low[j] = std::min(low[j], other(e.site, j));
        high[j] = std::max(high[j], other(e.site, j));
      }
    }
  }

  template <class Query>
  bool descend(std::size_t box, std::span<const VertexId> sites, Query& query) const {
    if (sites.size() <= kLeaf) {
      for (const VertexId v : sites) {
        if (query.visit(v)) return true;
      }
      return false;
    }
    const std::size_t half = sites.size() / 2;
    const std::array<std::span<const VertexId>, 2> halves{sites.first(half), sites.subspan(half)};
    const std::array<double, 2> ranks{query.rank(2 * box + 1), query.rank(2 * box + 2)};
    const std::size_t near = ranks[1] < ranks[0] ? 1 : 0;
    if (ranks[near] == kNever) return false;
    if (descend(2 * box + 1 + near, halves[near], query)) return true;
    // What was found there may have made the other half needless.
    const std::size_t far = 1 - near;
    if (ranks[far] == kNever || query.rank(2 * box + 1 + far) == kNever) return false;
    return descend(2 * box + 1 + far, halves[far], query);
  }

  const Sites* sites_;
  std::size_t other_count_;  // coordinates that only heights see
  double scale_;             // the tree's unit
  Buffer<VertexId> order_;   // the sites, those of a box in a row
  Buffer<Box> boxes_;
  Buffer<double> others_;  // per box the least and the largest of each
};

namespace detail {

/// Of K rows in K + 1 columns, all minors and bounds on their errors. An entry carries one rounding, those of the last
/// column at most K + 8 + 4; a minor then rounds K times in products and at most K (K + 1) / 2 times in sums, relative
/// to the permanent. What underflows is off by less than 2^-1074, times products of entries, of which only those of the
/// last column may be large: the last summand is far above that.
template <int K>
struct Minors {
  std::array<double, K + 1> value, error;

  /// @param rows, sizes  the entries, and what their roundings are relative to
  Minors(const std::array<std::array<double, K + 1>, K>& rows, const std::array<std::array<double, K + 1>, K>& sizes)
      : value(minors_without_column<K>(rows)) {
    constexpr double kBound = 1.01 * filter::kU * (0.5 * K * (K + 1) + K + K + kMaxDimension + 4);
    const auto permanents =
        minors<K, K + 1, false, double>([&](std::size_t i, std::size_t j) { return std::abs(sizes[i][j]); });
    double largest = 1.0;
    for (const auto& row : sizes) largest = std::max(largest, std::abs(row[K]));
    for (std::size_t j = 0; j <= K; ++j) {
      error[j] = kBound * permanents[((std::size_t{1} << (K + 1)) - 1) ^ (std::size_t{1} << j)] + 0x1p-900 * largest;
    }
  }
};

}  // namespace detail

// A minor n divided by the volume v is off by (error of n + |n / v| error of v) / (|v| - error of v); the product of a
// normal with d rounds K + 3 times more.
template <int K>
Plane<K> SiteTree<K>::plane(const std::array<VertexId, K + 1>& cell) const {
  std::array<std::array<double, K + 1>, K> rows;
  std::array<std::array<double, K + 1>, K> sizes;
  for (std::size_t i = 0; i < kCoordinates; ++i) {
    double square = 0.0;
    for (std::size_t j = 0; j < kCoordinates; ++j) {
      const double d = x(cell[i + 1], j) - x(cell[0], j);
      rows[i][j] = sizes[i][j] = d;
      square += d * d;
    }
    const Lift extra = extra_lift(cell[i + 1], cell[0]);
    rows[i][K] = square + extra.value;
    sizes[i][K] = square + extra.size;
  }
  const detail::Minors<K> minors(rows, sizes);
  const double volume = std::abs(minors.value[K]);
  const double volume_error = minors.error[K];
  Plane<K> plane;
  if (!(volume > 4.0 * volume_error)) return plane;
  for (std::size_t j = 0; j < kCoordinates; ++j) {
    const double n = ((kCoordinates - j) % 2 == 0 ? minors.value[j] : -minors.value[j]) / minors.value[K];
    const double error = (minors.error[j] + std::abs(n) * volume_error) / (volume - volume_error);
    plane.normal[j] = n;
    plane.error = std::max(plane.error, 1.01 * (error + (K + 4) * filter::kU * std::abs(n)));
  }
  plane.origin = cell[0];
  return plane;
}

template <int K>
Plane<K> SiteTree<K>::wall(const std::array<VertexId, K + 1>& cell, int slot) const {
  Plane<K> plane;
  plane.vertical = true;
  plane.origin = cell[slot == 0 ? 1 : 0];
  if constexpr (K == 1) {
    plane.normal[0] = 1.0;
    plane.error = 8 * filter::kU;
  } else {
    std::array<std::array<double, K>, K - 1> rows;
    std::size_t count = 0;
    for (const VertexId v : cell) {
      if (v == cell[static_cast<std::size_t>(slot)] || v == plane.origin) continue;
      for (std::size_t j = 0; j < kCoordinates; ++j) rows[count][j] = x(v, j) - x(plane.origin, j);
      ++count;
    }
    const detail::Minors<K - 1> minors(rows, rows);
    for (std::size_t j = 0; j < kCoordinates; ++j) {
      plane.normal[j] = j % 2 == 0 ? minors.value[j] : -minors.value[j];
      plane.error = std::max(plane.error, 1.01 * (minors.error[j] + (K + 4) * filter::kU * std::abs(plane.normal[j])));
    }
  }
  const int inside = clearance(plane, cell[static_cast<std::size_t>(slot)]).sign();
  if (inside == 0) return {};
  for (double& n : plane.normal) n *= inside;
  return plane;
}

// With m the largest |d| on an axis, a term d (n + d) rounds at most six times, relative to m (|n| + m), and then in at
// most 17 sums; where d is the clamped one, it is off by one rounding of m, which moves the term by that much at most.
// What underflows, in coordinates by their scale or in products, is covered by a little more than m, and by the last
// summand.
template <int K>
[[gnu::always_inline]] inline typename SiteTree<K>::Clearance SiteTree<K>::clearance(const Plane<K>& plane,
                                                                                     std::size_t box) const {
  constexpr double kRoundings = 32 * filter::kU;
  if (plane.error == 0.0) return {0.0, kNever};
  const Box& b = boxes_[box];
  double least = 0.0;
  double reach = 0.0;
  double size = 0.0;
  for (std::size_t j = 0; j < kCoordinates; ++j) {
    const double n = plane.normal[j];
    const double o = x(plane.origin, j);
    const double from = b.low[j] - o;
    const double to = b.high[j] - o;
    const double m = std::max(-from, to) + 0x1p-900;
    reach += m;
    if (plane.vertical) {
      least += n * (n > 0.0 ? from : to);
      size += m * std::abs(n);
    } else {
      const double d = std::min(std::max(-0.5 * n, from), to);
      least += d * (n + d);
      size += m * (std::abs(n) + m);
    }
  }
  if (!plane.vertical) {
    const double* const others = others_.data() + 2 * other_count_ * box;
    for (std::size_t j = 0; j < other_count_; ++j) {
      const double from = others[j] - other(plane.origin, j);
      const double to = others[other_count_ + j] - other(plane.origin, j);
      const double d = std::min(std::max(0.0, from), to);
      const double m = std::max(-from, to) + 0x1p-900;
      least += d * d;
      size += m * m;
    }
    if (sites_->weighted()) {
      const double w = heavier(b.heaviest, plane.origin);
      least -= w;
      size += std::abs(w);
    }
  }
  return {least, plane.error * reach + kRoundings * size + 0x1p-900};
}

template <int K>
[[gnu::always_inline]] inline typename SiteTree<K>::Clearance SiteTree<K>::clearance(const Plane<K>& plane,
                                                                                     VertexId v) const {
  constexpr double kRoundings = 32 * filter::kU;
  if (plane.error == 0.0) return {0.0, kNever};
  const Lift extra = plane.vertical ? Lift{} : extra_lift(v, plane.origin);
  double value = extra.value;
  double reach = 0x1p-900;
  double size = extra.size;
  for (std::size_t j = 0; j < kCoordinates; ++j) {
    const double n = plane.normal[j];
    const double d = x(v, j) - x(plane.origin, j);
    const double m = std::abs(d) + 0x1p-900;
    reach += m;
    value += d * (plane.vertical ? n : n + d);
    size += m * (plane.vertical ? std::abs(n) : std::abs(n) + m);
  }
  return {value, plane.error * reach + kRoundings * size + 0x1p-900};
}

}  // namespace delone
