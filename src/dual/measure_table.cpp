#include "dual/measure_table.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "base/huge_pages.hpp"
#include "delone/base/dispatch.hpp"

namespace delone::dual_detail {
namespace {

/// By neighbour. Most lists are short: there each entry is counted at all those that come after it, in loops of known
/// length.
void sort_entries(std::span<Index> neighbours, std::span<double> shared) {
  constexpr std::size_t kAtOnce = 8;
  constexpr std::size_t kShort = 6 * kAtOnce;
  const std::size_t n = neighbours.size();
  if (n > kShort) {
    std::vector<std::pair<Index, double>> sorted(n);
    for (std::size_t i = 0; i < n; ++i) sorted[i] = {neighbours[i], shared[i]};
    std::ranges::sort(sorted);
    for (std::size_t i = 0; i < n; ++i) std::tie(neighbours[i], shared[i]) = sorted[i];
    return;
  }
  std::array<Index, kShort> names{}, places;
  std::array<double, kShort> sizes;
  std::ranges::copy(neighbours, names.begin());
  std::ranges::copy(shared, sizes.begin());
  for (std::size_t begin = 0; begin < n; begin += kAtOnce) {
    std::fill_n(places.begin() + begin, kAtOnce, 0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = begin; j < begin + kAtOnce; ++j) places[j] += names[i] < names[j] ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    neighbours[places[i]] = names[i];
    shared[places[i]] = sizes[i];
  }
}

}  // namespace

/// A cell has at most one neighbour per edge at its site. Entries have their places by row.
MeasureTable::MeasureTable(const AnyTriangulation& t) : t_(t) {
  Buffer<Index> cells;  // per site
  cells.resize(t.sites().size(), 0);
  if (t.affine_dimension() > 0) with_dimension<1>(t.affine_dimension(), [&](auto k) { count_cells<k>(cells); });
  lines_.resize(t.sites().size());
  std::size_t room = 0;
  for (std::size_t row = 0; row < t.row_count(); ++row) {
    const auto r = static_cast<Index>(row);
    if (t.sites().is_removed(r)) continue;
    const VertexId v = t.sites().vertex(r);
    lines_[raw(v)] = {.begin = room};
    const std::size_t count = cells[raw(v)];
    room += t.affine_dimension() == 3 && count > 0 ? count / 2 + 2 : count;  // by Euler's formula
  }
  reserve_large(neighbours_, room);
  reserve_large(shared_, room);
  neighbours_.resize(room);
  shared_.resize(room);
}

template <int K>
void MeasureTable::count_cells(Buffer<Index>& cells) const {
  const ConstComplexView<K> complex(t_.complex());
  for (std::size_t i = 0; i < complex.slot_count(); ++i) {
    const CellId c{static_cast<Index>(i)};
    if (!complex.is_live(c)) continue;
    for (const VertexId v : complex.vertices(c)) {
      if (v != kGhost) ++cells[raw(v)];
    }
  }
}

void MeasureTable::put(const ClippedBlock& block, const CellMeasures& from) {
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [a, b] : block.doubtful) doubtful_.push_back({std::min(a, b), std::max(a, b)});
  }
  const auto d = static_cast<std::size_t>(from.dimension);
  for (std::size_t cell = 0; cell < from.size(); ++cell) {
    Line& line = lines_[raw(block.sites[cell])];
    line.volume = from.volume[cell];
    line.boundary = from.boundary[cell];
    line.second_moment = from.second_moment[cell];
    for (std::size_t axis = 0; axis < d; ++axis) line.centroid[axis] = from.centroid[cell * d + axis];
    line.count = static_cast<Index>(from.offsets[cell + 1] - from.offsets[cell]);
    DELONE_ASSERT(line.begin + line.count <= neighbours_.size(), "no more neighbours than edges at the site");
    const Entries to = entries(line);
    std::copy_n(from.neighbours.data() + from.offsets[cell], line.count, to.neighbours.data());
    std::copy_n(from.shared.data() + from.offsets[cell], line.count, to.shared.data());
  }
}

MeasureTable::Entries MeasureTable::entries(const Line& line) {
  return {{neighbours_.data() + line.begin, line.count}, {shared_.data() + line.begin, line.count}};
}

/// Where `row` says what it shares with `other`; nothing when it does not know of it. Its entries are sorted.
double* MeasureTable::shared_with(Index row, Index other) {
  const auto [neighbours, shared] = entries((*this)[t_.sites().vertex(row)]);
  const auto found = std::ranges::lower_bound(neighbours, other);
  if (found == neighbours.end() || *found != other) return nullptr;
  return &shared[static_cast<std::size_t>(found - neighbours.begin())];
}

/// What two cells share is what the lower row says. What only one of them knows of is the boundary of the region, which
/// ends where a bisector runs.
void MeasureTable::agree() {
  std::ranges::sort(doubtful_);  // blocks come in any order, and each pair twice
  doubtful_.erase(std::unique(doubtful_.begin(), doubtful_.end()), doubtful_.end());
  std::vector<bool> sorted(doubtful_.empty() ? 0 : t_.row_count());
  for (const auto& pair : doubtful_) {
    for (const Index row : pair) {
      if (sorted[row]) continue;
      const auto [neighbours, shared] = entries((*this)[t_.sites().vertex(row)]);
      sort_entries(neighbours, shared);
      sorted[row] = true;
    }
  }
  for (const auto& [low, high] : doubtful_) {
    double* const by_low = shared_with(low, high);
    double* const by_high = shared_with(high, low);
    if (by_low != nullptr && by_high != nullptr) {
      *by_high = *by_low;
    } else if (by_low != nullptr) {
      (*this)[t_.sites().vertex(low)].boundary += std::exchange(*by_low, 0.0);
    } else if (by_high != nullptr) {
      (*this)[t_.sites().vertex(high)].boundary += std::exchange(*by_high, 0.0);
    }
  }
}

CellMeasures MeasureTable::rows() {
  agree();
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  static constexpr Line kRemoved{.centroid = {kNowhere, kNowhere, kNowhere}};
  constexpr std::size_t kAhead = 16;
  const Sites& sites = t_.sites();
  const std::size_t rows = t_.row_count();
  const auto line_of = [&](std::size_t row) -> const Line& {
    const auto r = static_cast<Index>(row);
    return row >= rows || sites.is_removed(r) ? kRemoved : lines_[raw(sites.vertex(r))];
  };
  CellMeasures all;
  all.dimension = t_.dimension();
  for (auto* numbers : {&all.volume, &all.surface, &all.boundary, &all.second_moment}) reserve_large(*numbers, rows);
  const auto d = static_cast<std::size_t>(all.dimension);
  reserve_large(all.centroid, rows * d);
  reserve_large(all.offsets, rows + 1);
  std::size_t kept = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    __builtin_prefetch(&line_of(row + kAhead));
    __builtin_prefetch(&line_of(row + kAhead).centroid[2]);
    const Line& line = line_of(row);
    const auto [neighbours, shared] = entries(line);
    sort_entries(neighbours, shared);
    double surface = line.boundary;
    for (std::size_t i = 0; i < line.count; ++i) {
      surface += shared[i];
      neighbours_[kept] = neighbours[i];
      shared_[kept] = shared[i];
      kept += shared[i] > 0 ? 1 : 0;
    }
    all.volume.push_back(line.volume);
    all.surface.push_back(surface);
    all.boundary.push_back(line.boundary);
    all.second_moment.push_back(line.second_moment);
    for (std::size_t axis = 0; axis < d; ++axis) all.centroid.push_back(line.centroid[axis]);
    all.offsets.push_back(kept);
  }
  neighbours_.resize(kept);
  shared_.resize(kept);
  all.neighbours = std::move(neighbours_);
  all.shared = std::move(shared_);
  return all;
}

}  // namespace delone::dual_detail
