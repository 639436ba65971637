#include "mesh/chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace delone {

std::optional<int> chain_axis(const Sites& sites, std::size_t begin, std::size_t end) {
  std::array<const double*, 8> x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = sites.at(VertexId{static_cast<Index>(begin + (end - begin - 1) * i / (x.size() - 1))});
  }
  std::array<std::pair<const double*, const double*>, 2> ends;
  std::array<double, 2> length;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [least, most] = std::ranges::minmax_element(x, {}, [&](const double* p) { return p[axis]; });
    ends[axis] = {*least, *most};
    length[axis] = (*most)[axis] - (*least)[axis];
  }
  const std::size_t axis = length[0] >= length[1] ? 0 : 1;
  const double* const from = ends[axis].first;
  const double* const to = ends[axis].second;
  // In units of the length along the axis: 0 to 1 along it, at most 1 across it.
  const double slope = (to[1 - axis] - from[1 - axis]) / length[axis];
  const double most = (1.0 + slope * slope) / 32.0;
  const bool close = std::ranges::all_of(x, [&](const double* p) {
    const double along = (p[axis] - from[axis]) / length[axis];
    const double across = (p[1 - axis] - from[1 - axis]) / length[axis];
    return std::abs(across - slope * along) <= most;
  });
  return close ? std::optional(static_cast<int>(axis)) : std::nullopt;
}

bool ChainSorter::sort(const Sites& sites, int axis, std::vector<VertexId>& chain) {
  const auto along = [&](VertexId v) { return sites.at(v)[axis]; };
  if (spread(chain, along)) {
    for (auto next = chain.begin() + 1; next != chain.end(); ++next) {
      const VertexId v = *next;
      auto to = next;
      for (; to != chain.begin() && along(*(to - 1)) > along(v); --to) *to = *(to - 1);
      *to = v;
    }
  } else {
    std::ranges::sort(chain, {}, along);
  }
  return std::ranges::adjacent_find(chain, {}, along) == chain.end();
}

/// Puts each site about where it belongs, as a division tells. False, and nothing is done, when many would go to one
/// place.
template <class F>
bool ChainSorter::spread(std::vector<VertexId>& chain, const F& along) {
  constexpr Index kMany = 16;
  double least = along(chain.front());
  double most = least;
  for (const VertexId v : chain) {
    least = std::min(least, along(v));
    most = std::max(most, along(v));
  }
  const double scale = static_cast<double>(chain.size() - 1) / (most - least);
  if (!(scale > 0.0 && std::isfinite(scale))) return false;
  const auto place = [&](VertexId v) { return static_cast<std::size_t>((along(v) - least) * scale); };
  next_.assign(chain.size() + 1, 0);
  Index fullest = 0;
  for (const VertexId v : chain) fullest = std::max(fullest, ++next_[place(v) + 1]);
  if (fullest > kMany) return false;
  std::inclusive_scan(next_.begin(), next_.end(), next_.begin());
  spread_.resize(chain.size());
  for (const VertexId v : chain) spread_[next_[place(v)]++] = v;
  chain.swap(spread_);
  return true;
}

}  // namespace delone
