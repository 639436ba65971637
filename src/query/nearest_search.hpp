// The search for nearest vertices in a complex of dimension K: nearest.hpp says why it is right.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "delone/geometry/compare_distance.hpp"
#include "delone/query/nearest.hpp"
#include "query/cell_finder.hpp"
#include "query/neighbours.hpp"

namespace delone::query_detail {

/// All sites stand at one place: there is one vertex, and nothing to walk.
struct NoCellFinder {
  NoCellFinder(const AnyTriangulation& t, const NumberRange& /*range*/) : view(t.complex()) {}
  const ConstComplexView<0>& complex() const { return view; }
  CellId find(const Placed& /*q*/, CellId /*start*/) const {
    return view.cell(view.twin(view.incident_cell(kGhost), 0));
  }
  ConstComplexView<0> view;
};

/// One thread each. Every query starts where the one before has ended.
template <int K>
class NearestSearch {
 public:
  /// @param range  from range_with
  /// @param near   a live cell near the first query, or kNoCell
  /// @param kept   how many vertices' neighbours are kept: few for one query, many for queries along a curve
  NearestSearch(const AnyTriangulation& t, const NumberRange& range, CellId near, std::size_t kept)
      : sites_(&t.sites()),
        finder_(t, range),
        distances_(t.sites()),
        neighbours_(finder_.complex(), kept),
        near_(near) {}

  [[gnu::noinline]] Neighbour nearest(std::span<const double> q) {
    descend(q);
    if (!tied_) [[likely]]
      return {sites_->row(at_), power_.value};
    collect_tied();
    for (const VertexId v : tied_vertices_) {
      if (sites_->row(v) < sites_->row(at_)) at_ = v;
    }
    return {sites_->row(at_), distances_.power(at_).value};
  }

  /// The k nearest rows, in order; valid until the next call.
  std::span<const Neighbour> nearest(std::span<const double> q, std::size_t k, const Duplicates& duplicates) {
    found_.clear();
    if (k == 0) return found_;
    begin_spreading(q);
    const auto later = [this](const Candidate& a, const Candidate& b) { return before(b, a); };
    for (const VertexId v : tied_vertices_) push(v, distances_.power(v), duplicates);
    std::ranges::make_heap(candidates_, later);
    while (!candidates_.empty()) {
      std::ranges::pop_heap(candidates_, later);
      const Candidate next = candidates_.back();
      candidates_.pop_back();
      found_.push_back({next.row, next.power.value});
      if (found_.size() == k) break;
      if (next.row != sites_->row(next.vertex)) continue;  // a duplicate: its vertex is spread from
      for (const VertexId u : neighbours_(next.vertex)) {
        if (!seen_.insert(raw(u))) continue;
        const std::size_t first = candidates_.size();
        push(u, distances_.power(u), duplicates);
        for (std::size_t i = first; i < candidates_.size(); ++i) {
          std::push_heap(candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(i) + 1, later);
        }
      }
    }
    return found_;
  }

  /// All rows within the radius, in order; valid until the next call.
  std::span<const Neighbour> within(std::span<const double> q, double radius, const Duplicates& duplicates) {
    found_.clear();
    begin_spreading(q);
    const auto reach = [&](VertexId v) {
      const Power power = distances_.power(v);
      if (distances_.compare_with_radius(v, power, radius) <= 0) push(v, power, duplicates);
    };
    for (const VertexId v : tied_vertices_) reach(v);
    for (std::size_t next = 0; next < candidates_.size(); ++next) {
      const Candidate from = candidates_[next];
      if (from.row != sites_->row(from.vertex)) continue;
      for (const VertexId u : neighbours_(from.vertex)) {
        if (seen_.insert(raw(u))) reach(u);
      }
    }
    std::ranges::sort(candidates_, [this](const Candidate& a, const Candidate& b) { return before(a, b); });
    for (const Candidate& c : candidates_) found_.push_back({c.row, c.power.value});
    return found_;
  }

 private:
  using Finder = std::conditional_t<K == 0, NoCellFinder, CellFinder<K>>;

  struct Candidate {
    Power power;
    VertexId vertex;
    Index row;  // of the vertex, or of one of its duplicates
  };

  /// By distance, then by row.
  bool before(const Candidate& a, const Candidate& b) const {
    const int sign = a.vertex == b.vertex ? 0 : distances_.compare(a.vertex, a.power, b.vertex, b.power);
    return sign != 0 ? sign < 0 : a.row < b.row;
  }

  /// Goes down to a nearest vertex; tied_ when there is another.
  [[gnu::noinline]] void descend(std::span<const double> q) {
    const Placed placed = sites_->placed(q);
    distances_.measure_from(placed);
    bool walked = at_ == kGhost;
    if (walked) {
      begin_at(finder_.find(placed, near_));
    } else {
      power_ = distances_.power(at_);
    }
    for (;;) {
      // A walk costs less than the star of a vertex, and most often it ends at a cell of the nearest.
      if (!walked && !neighbours_.knows(at_)) {
        walked = true;
        begin_at(finder_.find(placed, finder_.complex().incident_cell(at_)));
      }
      if (!step_down()) return;
    }
  }

  /// To the nearest neighbour, if it is nearer.
  bool step_down() {
    VertexId best = at_;
    Power least = power_;
    tied_ = false;
    for (const VertexId u : neighbours_(at_)) {
      const Power power = distances_.power(u);
      if (power.value - power.error > least.value + least.error) continue;
      const int sign = distances_.compare(u, power, best, least);
      tied_ |= sign == 0;
      if (sign >= 0) continue;
      best = u;
      least = power;
    }
    power_ = least;
    return std::exchange(at_, best) != best;
  }

  /// At the nearest vertex of a cell, rounding errors aside: any is good to begin with.
  void begin_at(CellId c) {
    at_ = kGhost;
    for (const VertexId v : finder_.complex().vertices(c)) {
      if (v == kGhost) continue;
      const Power power = distances_.power(v);
      if (at_ != kGhost && !(power.value < power_.value)) continue;
      at_ = v;
      power_ = power;
    }
  }

  /// All vertices as near as at_, which are connected.
  [[gnu::noinline]] void collect_tied() {
    seen_.clear();
    seen_.insert(raw(at_));
    tied_vertices_.assign(1, at_);
    for (std::size_t next = 0; tied_ && next < tied_vertices_.size(); ++next) {
      for (const VertexId u : neighbours_(tied_vertices_[next])) {
        if (distances_.compare(u, distances_.power(u), at_, power_) != 0) continue;
        if (seen_.insert(raw(u))) tied_vertices_.push_back(u);
      }
    }
  }

  /// The nearest vertices, as seen and as seeds. All of them are: the others have a nearer neighbour, so that each is
  /// met before its turn, whatever its row; these have not.
  void begin_spreading(std::span<const double> q) {
    descend(q);
    collect_tied();
    candidates_.clear();
  }

  void push(VertexId v, Power power, const Duplicates& duplicates) {
    candidates_.push_back({power, v, sites_->row(v)});
    for (const auto& [vertex, row] : duplicates.at(v)) candidates_.push_back({power, v, row});
  }

  const Sites* sites_;
  Finder finder_;
  Distances<K> distances_;
  Neighbours<K> neighbours_;
  CellId near_;
  VertexId at_ = kGhost;  // where the descent has come, and its distance
  Power power_{};
  bool tied_ = false;
  IdSet seen_;
  std::vector<VertexId> tied_vertices_;
  std::vector<Candidate> candidates_;
  std::vector<Neighbour> found_;
};

}  // namespace delone::query_detail
