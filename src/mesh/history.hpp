// The history of a triangulation: every cell that ever was, and which cells took its place. A point is located by going
// from cells that contain it to cells that contain it, from the first to one of today.
// Source: [ES96] 7 (the history dag), [GKS92] 3, [Slides] III.
//
// Departure: in place of far points with huge coordinates there is the one ghost vertex, at infinity in all directions
// from a point o that never moves, within the first cell. A ghost cell on facet F is what lies beyond F in the cone
// from o through F; so all cells, ghosts included, divide space at all times, and those that a flip makes divide the
// region of those that it removes. The point o is infinitely near site 0, moved a little towards site 1, less towards
// site 2, and so on: the sign of a determinant with o in it is that of the first of those with site 0, 1, ..., K in its
// place that is not zero.
//
// Where sites are not in general position a flip may make a cell without volume, which lives until a later flip of the
// same insertion. Such a cell may seem to contain a point that its successors do not: then the search goes back.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/grown.hpp"
#include "delone/base/buffer.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

template <int K>
class History {
  static constexpr std::size_t kCorners = K + 1;

 public:
  using Cell = std::array<VertexId, kCorners>;

  struct Node {
    Cell vertices;
    Index first;  ///< of its successors, which follow each other; of a cell of today the CellId
    Index count;  ///< of its successors, 0 for a cell of today

    bool is_leaf() const { return count == 0; }
    CellId cell() const { return CellId{first}; }
  };

  std::size_t size() const { return nodes_.size(); }
  const Node& operator[](Index node) const { return nodes_[node]; }
  /// The node of a cell of today.
  Index node_of(CellId c) const { return node_of_[raw(c)]; }

  /// Notes a cell that has come. Its successors will be named by `succeed`.
  void add(CellId c, const Cell& vertices) {
    grown(node_of_, raw(c)) = next_id(nodes_.size());
    nodes_.push_back({vertices, raw(c), 0});
  }
  /// The `count` nodes from `first` on took the place of `node`.
  void succeed(Index node, Index first, Index count) {
    nodes_[node].first = first;
    nodes_[node].count = count;
  }

  /// The sign of the orientation of `points` with o in slot i; 0 when that facet and o do not span space, wherever in
  /// the first cell o lies.
  static int side_of_origin(Kernel<K>& kernel, typename Kernel<K>::Points points, int i) {
    for (Index v = 0; v <= K; ++v) {
      points[static_cast<std::size_t>(i)] = kernel.at(VertexId{v});
      if (const int sign = kernel.orient(points); sign != 0) return sign;
    }
    return 0;
  }

  /// Whether the closed region of a cell contains q.
  static bool contains(Kernel<K>& kernel, const Cell& cell, const double* q) {
    const auto ghost = std::ranges::find(cell, kGhost);
    if (ghost == cell.end()) return kernel.separating_slot(cell, q, -1) < 0;
    typename Kernel<K>::Points points;
    for (std::size_t i = 0; i < kCorners; ++i) points[i] = cell[i] == kGhost ? q : kernel.at(cell[i]);
    if (kernel.orient(points) < 0) return false;
    for (std::size_t i = 0; i < kCorners; ++i) {
      if (cell[i] != kGhost && side_of_origin(kernel, points, static_cast<int>(i)) < 0) return false;
    }
    return true;
  }

  /// A leaf whose closed region contains q, or the first node on the way to it where `stop` says so.
  /// @param roots  how many nodes, from 0 on, were there at first
  /// @param steps  grows by the number of nodes that contain q and were gone through
  template <class Stop>
  Index locate(Kernel<K>& kernel, const double* q, Index roots, std::uint64_t& steps, const Stop& stop) {
    ++epoch_;
    visited_.reserve(nodes_.capacity());
    visited_.resize(nodes_.size(), 0);
    open_.clear();
    push(0, roots);
    for (;;) {
      DELONE_ASSERT(!open_.empty(), "I6 the cells of any time cover space");
      const Index n = open_[open_.size() - 1];
      open_.resize(open_.size() - 1);
      if (visited_[n] == epoch_ || !contains(kernel, nodes_[n].vertices, q)) continue;
      visited_[n] = epoch_;
      ++steps;
      if (nodes_[n].is_leaf() || stop(nodes_[n].vertices)) return n;
      push(nodes_[n].first, nodes_[n].count);
    }
  }

 private:
  void push(Index first, Index count) {
    for (Index i = count; i-- > 0;) open_.push_back(first + i);
  }

  Buffer<Node> nodes_;
  Buffer<Index> node_of_;  // per cell slot
  Buffer<Index> open_;
  Buffer<Index> visited_;  // per node the last search that came to it
  Index epoch_ = 0;
};

}  // namespace delone
