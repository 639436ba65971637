#include "delone/order/brio.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <utility>

#include "base/chunks.hpp"
#include "delone/base/assert.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/base/random.hpp"
#include "delone/order/hilbert.hpp"

namespace delone {
namespace {

/// A key above, the row that it belongs to below: what is sorted is one word a point.
class KeyedRows {
 public:
  KeyedRows(std::size_t rows, int threads)
      : row_bits_(static_cast<int>(std::bit_width(rows))), words_(rows), scratch_(rows) {
    for_chunks(rows, threads, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) words_[i] = i;
    });
  }

  std::size_t size() const { return words_.size(); }
  /// Of a key, at most: so many that on a curve, too, few rows have the same, and as many as the sort takes no longer
  /// for.
  int key_bits() const { return std::min(64 - row_bits_, (2 * row_bits_ + 6 + kDigit - 1) / kDigit * kDigit); }
  Buffer<Index> in_order() const {
    Buffer<Index> order(size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = row(i);
    return order;
  }
  Index row(std::size_t i) const { return row_of(words_[i]); }
  std::uint64_t key(std::size_t i) const { return words_[i] >> row_bits_; }
  void set_key(std::size_t i, std::uint64_t key) { words_[i] = key << row_bits_ | row(i); }
  void set_row(std::size_t i, Index row) { words_[i] = key(i) << row_bits_ | row; }

  /// Sorts [begin, end) by place(row), and equal ones by their rows.
  void sort_by(std::size_t begin, std::size_t end, const auto& place) {
    std::ranges::sort(words_.begin() + begin, words_.begin() + end, {},
                      [&](std::uint64_t word) { return std::pair(place(row_of(word)), word); });
  }
  /// Sorts [begin, end) by the low `bits` bits of the key, which is all that they differ by, the least significant
  /// first.
  void sort(std::size_t begin, std::size_t end, int bits, int threads) {
    constexpr std::size_t kLeast = 48;
    constexpr std::size_t kShare = 1 << 16;  // of one thread, at least
    const std::size_t count = end - begin;
    if (count < kLeast) return std::sort(words_.begin() + begin, words_.begin() + end);
    const int digit_bits = count < 4096 ? 8 : kDigit;
    const int rounds = (bits + digit_bits - 1) / digit_bits;
    const int width = (bits + rounds - 1) / rounds;
    const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
    const std::size_t share = std::max(kShare, count / static_cast<std::size_t>(std::max(threads, 1)) + 1);
    int shift = row_bits_;
    std::vector<std::vector<std::size_t>> start((count + share - 1) / share, std::vector<std::size_t>(mask + 1));
    std::span<std::uint64_t> from = std::span(words_.data(), words_.size()).subspan(begin, count);
    std::span<std::uint64_t> to = std::span(scratch_.data(), scratch_.size()).subspan(begin, count);
    for (int round = 0; round < rounds; ++round, shift += width) {
      const auto digit = [shift, mask](std::uint64_t word) { return word >> shift & mask; };
      const auto count_digits = [&](std::size_t first, std::size_t last, std::size_t part) {
        std::ranges::fill(start[part], 0);
        for (std::size_t i = first; i < last; ++i) ++start[part][digit(from[i])];
      };
      const auto move_words = [&](std::size_t first, std::size_t last, std::size_t part) {
        for (std::size_t i = first; i < last; ++i) to[start[part][digit(from[i])]++] = from[i];
      };
      for_chunks(count, threads, count_digits, {}, share);
      std::size_t sum = 0;
      for (std::size_t d = 0; d <= mask; ++d) {
        for (auto& part : start) sum += std::exchange(part[d], sum);
      }
      for_chunks(count, threads, move_words, {}, share);
      std::swap(from, to);
    }
    if (from.data() != words_.data() + begin) std::ranges::copy(from, to.begin());
  }

 private:
  Index row_of(std::uint64_t word) const { return static_cast<Index>(word & ((std::uint64_t{1} << row_bits_) - 1)); }

  static constexpr int kDigit = 11;  // bits that are sorted at a time

  int row_bits_;
  Buffer<std::uint64_t> words_, scratch_;
};

/// The cube that holds some rows.
template <int K>
struct Cube {
  std::array<double, K> low;
  double extent = 0.0;
  double scale = 1.0;  // of all numbers here: a half where the extent would overflow

  Cube(PointsView points, std::span<const int> axes, const KeyedRows& rows, std::size_t first, std::size_t last,
       int threads) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::array<double, K> high;
    low.fill(kInfinity);
    high.fill(-kInfinity);
    std::mutex mutex;
    for_chunks(last - first, threads, [&](std::size_t begin, std::size_t end, std::size_t) {
      std::array<double, K> least, largest;
      least.fill(kInfinity);
      largest.fill(-kInfinity);
      for (std::size_t i = first + begin; i < first + end; ++i) {
        const std::span<const double> point = points[rows.row(i)];
        for (std::size_t j = 0; j < K; ++j) {
          const double x = point[static_cast<std::size_t>(axes[j])];
          least[j] = std::min(least[j], x);
          largest[j] = std::max(largest[j], x);
        }
      }
      const std::lock_guard lock(mutex);
      for (std::size_t j = 0; j < K; ++j) {
        low[j] = std::min(low[j], least[j]);
        high[j] = std::max(high[j], largest[j]);
      }
    });
    for (std::size_t j = 0; j < K; ++j) {
      if (high[j] - low[j] == std::numeric_limits<double>::infinity()) scale = 0.5;
    }
    for (std::size_t j = 0; j < K; ++j) {
      low[j] *= scale;
      extent = std::max(extent, high[j] * scale - low[j]);
    }
  }

  /// The grid cell of a point, with so many bits for each coordinate.
  typename HilbertCurve<K>::Place grid_cell(std::span<const double> point, std::span<const int> axes, int bits) const {
    typename HilbertCurve<K>::Place cell;
    const auto cells = static_cast<double>(std::uint64_t{1} << bits);
    for (std::size_t j = 0; j < K; ++j) {
      const double share = (point[static_cast<std::size_t>(axes[j])] * scale - low[j]) / extent;  // 0 to 1
      cell[j] = static_cast<std::uint32_t>(std::min(share * cells, cells - 1.0));
    }
    return cell;
  }
};

/// Rounds beyond the first.
int round_count(std::size_t points, std::size_t axes) {
  const std::size_t few = axes <= 3 ? 4096 : 64;  // above 3D one star costs as much as many walks
  int rounds = 0;
  for (; points > few; points /= 8) ++rounds;
  return rounds;
}

/// The round of a row, 0 to `rounds`: seven of eight are in the last, and so on.
int round_of(Index row, int rounds) {
  return rounds == 0 ? 0 : rounds - std::min(rounds, std::countr_zero(mix(row)) / 3);
}

constexpr int kWord = 64;  // more than a key has bits: cuts of one grid have so many depths

/// So few rows are parted by a balanced tree of three levels.
constexpr std::size_t kFew = 8;
constexpr int kLevels = 3;
static_assert(kLevels * kMaxDimension <= kWord);

/// Rows of one key.
struct Run {
  std::size_t begin, end;
};

/// Sorts up to kFew rows in lexicographic order. Cuts across a later axis are deeper than all across an earlier one.
/// @param depth  no cut is less deep  @param cuts  as below
void sort_few(PointsView points, std::span<const int> axes, KeyedRows& rows, const Run& run, int depth,
              std::span<std::uint16_t> cuts) {
  using Placed = std::pair<std::array<double, kMaxDimension>, Index>;
  std::array<Placed, kFew> room;
  const std::span<Placed> few = std::span(room).first(run.end - run.begin);
  for (std::size_t i = 0; i < few.size(); ++i) {
    auto& [place, row] = few[i];
    row = rows.row(run.begin + i);
    for (std::size_t j = 0; j < axes.size(); ++j) place[j] = points[row][static_cast<std::size_t>(axes[j])];
  }
  std::ranges::sort(few);
  for (std::size_t i = 0; i < few.size(); ++i) rows.set_row(run.begin + i, few[i].second);
  if (cuts.empty()) return;
  std::array<unsigned, kMaxDimension> steps{};
  for (std::size_t i = 1; i < few.size(); ++i) {
    const auto& low = few[i - 1].first;
    const auto axis = static_cast<std::size_t>(std::ranges::mismatch(low, few[i].first).in1 - low.begin());
    if (axis == kMaxDimension) continue;  // one place
    const int level = kLevels - 1 - std::countr_zero(++steps[axis]);
    cuts[run.begin + i] = static_cast<std::uint16_t>(depth + kLevels * static_cast<int>(axis) + level);
  }
}

/// The same of many runs, whose points are anywhere in memory.
void sort_runs(PointsView points, std::span<const int> axes, KeyedRows& rows, std::span<const Run> runs, int threads,
               int depth, std::span<std::uint16_t> cuts) {
  constexpr std::size_t kAhead = 8;
  for_chunks(runs.size(), threads, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kAhead < end) {
        const Run& later = runs[i + kAhead];
        for (std::size_t j = later.begin; j < later.end; ++j) __builtin_prefetch(points[rows.row(j)].data());
      }
      sort_few(points, axes, rows, runs[i], depth, cuts);
    }
  });
}

/// Sorts rows along the curve through the first K of the axes; those that these do not tell apart, along the next K.
/// @param cuts  empty, or where to write the depth of the cut before each row (see CurveCuts)
template <int K>
void sort_along_curve(PointsView points, std::span<const int> axes, KeyedRows& rows, int rounds, int threads,
                      std::span<std::uint16_t> cuts = {}) {
  constexpr std::size_t kTogether = 4;             // keys that are computed side by side
  const std::size_t crowd = cuts.empty() ? 3 : 1;  // up to this many points in one grid cell may stay as they are
  struct Job {
    std::size_t begin, end;
    int rounds;
    int grids;         // that its points were sorted on before
    std::size_t axis;  // the first of the K that are next
  };
  std::vector<Job> jobs{{0, rows.size(), rounds, 0, 0}};
  while (!jobs.empty()) {
    const Job job = jobs.back();
    jobs.pop_back();
    const std::span<const int> next_axes = axes.subspan(job.axis, K);
    const Cube<K> cube(points, next_axes, rows, job.begin, job.end, threads);
    if (!(cube.extent > 0.0)) {
      if (job.rounds > 0) rows.sort_by(job.begin, job.end, [&](Index row) { return round_of(row, job.rounds); });
      if (job.axis + K < axes.size()) jobs.push_back({job.begin, job.end, job.rounds, job.grids, job.axis + K});
      continue;
    }
    const int round_bits = static_cast<int>(std::bit_width(static_cast<unsigned>(job.rounds)));
    const int bits = std::clamp((rows.key_bits() - round_bits) / K, 1, 31);
    DELONE_ASSERT(bits * K + round_bits <= rows.key_bits(), "a key fits beside its row");
    for_chunks(job.end - job.begin, threads, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = job.begin + begin; i < job.begin + end; i += kTogether) {
        const std::size_t count = std::min(kTogether, job.begin + end - i);
        std::array<typename HilbertCurve<K>::Place, kTogether> cells{};
        for (std::size_t j = 0; j < count; ++j) cells[j] = cube.grid_cell(points[rows.row(i + j)], next_axes, bits);
        const auto distances = HilbertCurve<K>::distances(cells, bits);
        for (std::size_t j = 0; j < count; ++j) {
          const int round = round_of(rows.row(i + j), job.rounds);
          rows.set_key(i + j, static_cast<std::uint64_t>(round) << (bits * K) | distances[j]);
        }
      }
    });
    rows.sort(job.begin, job.end, bits * K + round_bits, threads);
    // Rows of one key belong to the chunk in which the first of them stands.
    std::vector<Run> runs;  // of a few rows
    std::mutex mutex;
    for_chunks(job.end - job.begin, threads, [&](std::size_t first, std::size_t last, std::size_t) {
      std::vector<Run> found;
      std::size_t begin = job.begin + first;
      while (begin > job.begin && begin < job.begin + last && rows.key(begin) == rows.key(begin - 1)) ++begin;
      for (std::size_t end; begin < job.begin + last; begin = end) {
        for (end = begin + 1; end < job.end && rows.key(end) == rows.key(begin);) ++end;
        if (end - begin > crowd && end - begin < job.end - job.begin) found.push_back({begin, end});
        if (cuts.empty() || begin == job.begin) continue;
        const int common = std::countl_zero(rows.key(begin) ^ rows.key(begin - 1));
        cuts[begin] = static_cast<std::uint16_t>(job.grids * kWord + common);
      }
      const std::lock_guard lock(mutex);
      for (const Run& run : found) {
        if (run.end - run.begin <= kFew) {
          runs.push_back(run);
        } else {
          jobs.push_back({run.begin, run.end, 0, job.grids + 1, job.axis});
        }
      }
    });
    sort_runs(points, axes.subspan(job.axis), rows, runs, threads, (job.grids + 1) * kWord, cuts);
  }
}

Buffer<Index> order_in_rounds(PointsView points, std::span<const int> axes, int rounds, int threads) {
  KeyedRows rows(points.size(), threads);
  if (!axes.empty()) {
    with_dimension<1>(static_cast<int>(axes.size()),
                      [&](auto dimension) { sort_along_curve<dimension>(points, axes, rows, rounds, threads); });
  }
  return rows.in_order();
}

template <int K>
CurveCuts cuts_along_curve(PointsView points, std::span<const int> axes, int threads) {
  KeyedRows rows(points.size(), threads);
  Buffer<std::uint16_t> cuts;
  cuts.resize(points.size(), CurveCuts::kSamePlace);
  sort_along_curve<K>(points, axes, rows, 0, threads, {cuts.data(), cuts.size()});
  return {rows.in_order(), std::move(cuts)};
}

}  // namespace

Buffer<Index> brio_order(PointsView points, std::span<const int> axes, int threads) {
  return order_in_rounds(points, axes, round_count(points.size(), axes.size()), threads);
}

std::vector<std::size_t> round_ends(std::span<const Index> order, int axes) {
  const int rounds = axes == 0 ? 0 : round_count(order.size(), static_cast<std::size_t>(axes));
  std::vector<std::size_t> ends;
  for (int round = 0; round < rounds; ++round) {
    const auto end = std::ranges::partition_point(order, [&](Index row) { return round_of(row, rounds) <= round; });
    ends.push_back(static_cast<std::size_t>(end - order.begin()));
  }
  ends.push_back(order.size());
  return ends;
}

Buffer<Index> curve_order(PointsView points, std::span<const int> axes, int threads) {
  return order_in_rounds(points, axes, 0, threads);
}

CurveCuts curve_cuts(PointsView points, std::span<const int> axes, int threads) {
  return with_dimension<1>(static_cast<int>(axes.size()),
                           [&](auto dimension) { return cuts_along_curve<dimension>(points, axes, threads); });
}

CurveCuts strip_cuts(PointsView points, std::span<const int> axes, int threads) {
  return cuts_along_curve<1>(points, axes, threads);
}

}  // namespace delone
