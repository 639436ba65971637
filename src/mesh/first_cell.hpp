// From simplex to simplex, each lower than the last: how a cell of the triangulation is found before there is any.
// Source: the dual simplex method, as [Sei86] uses linear programming.
//
// Everything is seen from a point o within the simplex of sites 0 to K, in no hyperplane that sites span: infinitely
// near site 0, moved a little towards site 1, less towards site 2, ... (mesh/history.hpp). A site q in conflict with a
// simplex takes the place of one of its vertices, the one for which the new simplex, too, is positive and lies around
// o: with its K + 2 lifted points the other simplices around o are above. So the height of the hyperplane at o sinks
// with every exchange, no simplex comes again, and where none is in conflict a cell is found.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "delone/base/assert.hpp"
#include "delone/geometry/kernel.hpp"
#include "mesh/history.hpp"
#include "mesh/site_tree.hpp"

namespace delone {

/// Whether a site is in conflict with a finite, positively oriented cell, of which the plane is kept.
template <int K>
[[gnu::always_inline]] inline bool in_conflict(const SiteTree<K>& tree, Kernel<K>& kernel, const Plane<K>& plane,
                                               const typename Kernel<K>::Cell& cell, VertexId v) {
  const int sign = tree.clearance(plane, v).sign();
  if (sign == 0) [[unlikely]]
    return kernel.conflict(cell, v);
  kernel.count_filtered(1);
  return sign < 0;
}

/// A query of the tree: a site in conflict with a finite, positively oriented cell.
template <int K>
struct ConflictQuery {
  using Cell = typename Kernel<K>::Cell;

  ConflictQuery(const SiteTree<K>& in, Kernel<K>& by, const Cell& with)
      : tree(in), kernel(by), cell(with), plane(in.plane(with)) {}

  double rank(std::size_t box) const {
    const auto clearance = tree.clearance(plane, box);
    return clearance.is_certain() ? SiteTree<K>::kNever : tree.limited(clearance.least);
  }
  bool visit(VertexId v) {
    if (std::ranges::find(cell, v) != cell.end()) return false;
    if (!in_conflict(tree, kernel, plane, cell, v)) return false;
    found = v;
    return true;
  }

  const SiteTree<K>& tree;
  Kernel<K>& kernel;
  const Cell& cell;
  Plane<K> plane;
  VertexId found = kGhost;
};

/// The slot that site q takes in a positive simplex around o so that it stays one. With a slot that is `fixed`, not -1,
/// o may lie beyond the facet opposite to it, and -1 is the answer when only its vertex could give way to q.
template <int K>
int slot_for(Kernel<K>& kernel, const typename Kernel<K>::Cell& cell, VertexId q, int fixed) {
  for (int j = 0; j <= K; ++j) {
    if (j == fixed) continue;
    auto points = kernel.at(cell);
    points[static_cast<std::size_t>(j)] = kernel.at(q);
    bool around = kernel.orient(points) > 0;
    for (int i = 0; i <= K && around; ++i) {
      if (i != j && i != fixed) around = History<K>::side_of_origin(kernel, points, i) > 0;
    }
    if (around) return j;
  }
  return -1;
}

/// Exchanges vertices of positive simplices around o until no site is in conflict. Sites that were in conflict before
/// are tried first: they often are again, and where doubles do not tell the tree what to pass over, this saves most of
/// the looking around.
template <int K>
class Sinker {
  using Cell = typename Kernel<K>::Cell;
  static constexpr std::size_t kRecent = 16;

 public:
  Sinker(const SiteTree<K>& tree, Kernel<K>& kernel) : tree_(tree), kernel_(kernel) { recent_.fill(kGhost); }

  /// @param fixed  a slot whose vertex stays, or -1
  /// @return       false when it would have to give way
  bool sink(Cell& cell, int fixed) {
    for (;;) {
      ConflictQuery<K> query(tree_, kernel_, cell);
      if (!find_recent(query) && !tree_.search(query)) return true;
      remember(query.found);
      const int j = slot_for(kernel_, cell, query.found, fixed);
      if (j < 0) return false;
      cell[static_cast<std::size_t>(j)] = query.found;
    }
  }

  /// The cell that contains o.
  Cell first_cell() {
    Cell cell;
    for (std::size_t i = 0; i < cell.size(); ++i) cell[i] = VertexId{static_cast<Index>(i)};
    if (kernel_.orient(cell) < 0) std::swap(cell[0], cell[1]);
    [[maybe_unused]] const bool found = sink(cell, -1);
    DELONE_ASSERT(found, "o lies in one of the simplices that q makes");
    return cell;
  }

 private:
  bool find_recent(ConflictQuery<K>& query) const {
    return std::ranges::any_of(recent_, [&](VertexId v) { return v != kGhost && query.visit(v); });
  }
  /// Brings a site to the front.
  void remember(VertexId v) {
    const auto known = std::ranges::find(recent_, v);
    const auto place = known == recent_.end() ? recent_.end() - 1 : known;
    *place = v;
    std::rotate(recent_.begin(), place, place + 1);
  }

  const SiteTree<K>& tree_;
  Kernel<K>& kernel_;
  std::array<VertexId, kRecent> recent_;
};

}  // namespace delone
