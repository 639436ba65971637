// Numbers in groups, by union and find.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone {

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  /// The least number of the group of i.
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(Index a, Index b) { parent_[std::max(find(a), find(b))] = std::min(find(a), find(b)); }

 private:
  std::vector<Index> parent_;
};

}  // namespace delone
