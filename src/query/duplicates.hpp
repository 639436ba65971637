// The rows that repeat a vertex: the one place of queries that knows how a mesh keeps its duplicates.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "delone/mesh/triangulation.hpp"

namespace delone::query_detail {

/// Cost: O(d log d) for d duplicates, once.
class DuplicateRows {
 public:
  explicit DuplicateRows(const Mesh& mesh) {
    for (const auto& [site, vertex] : mesh.duplicates) pairs_.emplace_back(vertex, mesh.sites.row(site));
    std::ranges::sort(pairs_);
  }
  /// Calls take(row) for each row that repeats v, ascending.
  template <class Take>
  void for_each(VertexId v, Take take) const {
    if (pairs_.empty()) return;
    auto at = std::ranges::lower_bound(pairs_, v, {}, [](const auto& pair) { return pair.first; });
    for (; at != pairs_.end() && at->first == v; ++at) take(at->second);
  }

 private:
  std::vector<std::pair<VertexId, Index>> pairs_;
};

}  // namespace delone::query_detail
