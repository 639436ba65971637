// Voronoi diagrams of order k in the plane: which k sites are nearest.
// Source: [Lee82] (order k + 1 from order k, the number of cells).
//
// The cell of a set S of k sites holds the places whose k nearest sites are those of S: it is convex. Cells are those
// with an interior, borders those with a length; so nothing here depends on how ties are broken. Of order 1 they are
// the Voronoi diagram, of order n - 1 the furthest-site diagram, of order n the whole plane. Of points at one place the
// lowest row counts, and no other one.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/base/progress.hpp"
#include "delone/dual/clip.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

/// Cells, their borders, and the vertices where borders end. cut_cells() gives the cells' shapes.
struct OrderK {
  int k = 1;
  std::vector<Index> subsets;           ///< size() x k rows, ascending; cells are sorted by them
  std::vector<std::size_t> offsets{0};  ///< cell i has borders offsets[i] to offsets[i + 1]
  /// Counter-clockwise: those of a bounded cell from the least (near, far) on, of an unbounded one from infinity to
  /// infinity. Beyond a border `far` takes the place of `near`, and the cell there is number `across`.
  std::vector<Bisector> borders;
  /// The vertex where each border begins, kNone at infinity. It ends where the next one of the cell begins; the last
  /// one where the first one does.
  std::vector<Index> starts;
  /// Vertex v is the centre of the circle through rows on[circles[v]] to on[circles[v + 1]], three or more,
  /// counter-clockwise from the least row on. Vertices are numbered as the borders begin at them.
  std::vector<std::size_t> circles{0};
  std::vector<Index> on;
  std::vector<Index> inside;  ///< how many sites lie inside of each circle: at least k + 1 less those on it, below k

  std::size_t size() const { return offsets.size() - 1; }
  std::size_t vertex_count() const { return inside.size(); }
  std::span<const Index> subset(std::size_t cell) const {
    const auto count = static_cast<std::size_t>(k);
    return std::span(subsets).subspan(cell * count, count);
  }
  std::span<const Bisector> borders_of(std::size_t cell) const {
    return std::span(borders).subspan(offsets[cell], offsets[cell + 1] - offsets[cell]);
  }
  std::span<const Index> circle(std::size_t vertex) const {
    return std::span(on).subspan(circles[vertex], circles[vertex + 1] - circles[vertex]);
  }
};

struct OrderKOptions {
  Progress progress = {};  ///< told of progress, may cancel
};

/// The diagram of order k.
/// @throws InputError unless the points are of the plane, finite, without weights, and stand at k places or more, k >=
/// 1;
///         Cancelled; std::bad_alloc
/// Exact. Cost: O(k^2 n) tests and O(k^3 n) numbers that are copied, while cells have few borders (one with h of them
/// may take h^2 tests); memory for a diagram and its sites inside, O(k^2 n).
OrderK order_k_voronoi(PointsView points, int k, const OrderKOptions& options = {});

/// The diagrams of orders `first` to `last`, one after the other, in the time of the last.
void for_orders(PointsView points, int first, int last, const std::function<void(OrderK)>& visit,
                const OrderKOptions& options = {});

}  // namespace delone
