// Sites that lie along a line, as those of a piece of a curve do.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/sites.hpp"

namespace delone {

/// The leading axis along which sites [begin, end) of the plane lie, as far as eight of them tell: these stay as close
/// to a line as a thirty-second of its length.
std::optional<int> chain_axis(const Sites& sites, std::size_t begin, std::size_t end);

/// Sorts chains, in memory that it keeps.
class ChainSorter {
 public:
  /// Sorts sites along an axis. False when two are alike on it. Cost: O(n) if they are spread evenly.
  bool sort(const Sites& sites, int axis, std::vector<VertexId>& chain);

 private:
  template <class F>
  bool spread(std::vector<VertexId>& chain, const F& along);

  std::vector<VertexId> spread_;
  std::vector<Index> next_;  ///< per place the first site that goes there, then the next
};

}  // namespace delone
