#include "delone/order/brio.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <thread>
#include <utility>

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
  explicit KeyedRows(std::size_t rows)
      : row_bits_(static_cast<int>(std::bit_width(rows))), words_(rows), scratch_(rows) {
    for (std::size_t i = 0; i < rows; ++i) words_[i] = i;
  }

  std::size_t size() const { return words_.size(); }
  int key_bits() const { return 64 - row_bits_; }
  Index row(std::size_t i) const { return static_cast<Index>(words_[i] & ((std::uint64_t{1} << row_bits_) - 1)); }
  std::uint64_t key(std::size_t i) const { return words_[i] >> row_bits_; }
  void set_key(std::size_t i, std::uint64_t key) { words_[i] = key << row_bits_ | row(i); }

  /// Sorts [begin, end) by the low `bits` bits of the key, which is all of it, 11 at a time, least significant first.
  void sort(std::size_t begin, std::size_t end, int bits) {
    constexpr std::size_t kFew = 512;
    if (end - begin < kFew) return std::sort(words_.begin() + begin, words_.begin() + end);
    constexpr int kDigit = 11;
    constexpr std::uint64_t kMask = (1U << kDigit) - 1;
    std::span<std::uint64_t> from = std::span(words_.data(), words_.size()).subspan(begin, end - begin);
    std::span<std::uint64_t> to = std::span(scratch_.data(), scratch_.size()).subspan(begin, end - begin);
    for (int shift = row_bits_; shift < row_bits_ + bits; shift += kDigit) {
      std::array<std::size_t, kMask + 1> start{};
      for (const std::uint64_t word : from) ++start[word >> shift & kMask];
      std::size_t sum = 0;
      for (std::size_t& s : start) sum += std::exchange(s, sum);
      for (const std::uint64_t word : from) to[start[word >> shift & kMask]++] = word;
      std::swap(from, to);
    }
    if (from.data() != words_.data() + begin) std::ranges::copy(from, to.begin());
  }

 private:
  int row_bits_;
  Buffer<std::uint64_t> words_, scratch_;
};

/// The cube that holds some rows; halved numbers, so that no extent overflows.
template <int K>
struct Cube {
  std::array<double, K> low;
  double extent = 0.0;

  Cube(PointsView points, std::span<const int> axes, const KeyedRows& rows, std::size_t begin, std::size_t end) {
    std::array<double, K> high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<const double> point = points[rows.row(i)];
      for (std::size_t j = 0; j < K; ++j) {
        const double x = point[static_cast<std::size_t>(axes[j])] * 0.5;
        low[j] = std::min(low[j], x);
        high[j] = std::max(high[j], x);
      }
    }
    for (std::size_t j = 0; j < K; ++j) extent = std::max(extent, high[j] - low[j]);
  }

  std::uint64_t distance(std::span<const double> point, std::span<const int> axes, int bits) const {
    std::array<std::uint32_t, K> cell;
    const auto cells = static_cast<double>(std::uint64_t{1} << bits);
    for (std::size_t j = 0; j < K; ++j) {
      const double share = (point[static_cast<std::size_t>(axes[j])] * 0.5 - low[j]) / extent;  // 0 to 1
      cell[j] = static_cast<std::uint32_t>(std::min(share * cells, cells - 1.0));
    }
    return HilbertCurve<K>::distance(cell, bits);
  }
};

/// Calls work(begin, end) for parts of a range, each on a thread of its own when the range is long.
template <class Work>
void for_chunks(std::size_t begin, std::size_t end, int threads, Work work) {
  constexpr std::size_t kLong = 1 << 16;
  const std::size_t chunks =
      std::clamp<std::size_t>((end - begin) / kLong, 1, static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::jthread> helpers;
  helpers.reserve(chunks - 1);
  for (std::size_t c = 1; c < chunks; ++c) {
    helpers.emplace_back(work, begin + (end - begin) * c / chunks, begin + (end - begin) * (c + 1) / chunks);
  }
  work(begin, begin + (end - begin) / chunks);
}

template <int K>
void sort_along_curve(PointsView points, std::span<const int> axes, KeyedRows& rows, int rounds, int threads) {
  constexpr std::size_t kCrowd = 3;  // up to this many points in one grid cell may stay as they are
  struct Job {
    std::size_t begin, end;
    int rounds;
  };
  std::vector<Job> jobs{{0, rows.size(), rounds}};
  while (!jobs.empty()) {
    const Job job = jobs.back();
    jobs.pop_back();
    const Cube<K> cube(points, axes, rows, job.begin, job.end);
    if (!(cube.extent > 0.0)) continue;
    const int round_bits = static_cast<int>(std::bit_width(static_cast<unsigned>(job.rounds)));
    const int bits = std::clamp((rows.key_bits() - round_bits) / K, 1, 31);
    DELONE_ASSERT(bits * K + round_bits <= rows.key_bits(), "a key fits beside its row");
    for_chunks(job.begin, job.end, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index row = rows.row(i);
        const int early = job.rounds == 0 ? 0 : std::min(job.rounds, std::countr_zero(mix(row)) / 3);
        const std::uint64_t distance = cube.distance(points[row], axes, bits);
        rows.set_key(i, static_cast<std::uint64_t>(job.rounds - early) << (bits * K) | distance);
      }
    });
    rows.sort(job.begin, job.end, bits * K + round_bits);
    for (std::size_t begin = job.begin, end; begin < job.end; begin = end) {
      for (end = begin + 1; end < job.end && rows.key(end) == rows.key(begin);) ++end;
      if (end - begin > kCrowd && end - begin < job.end - job.begin) jobs.push_back({begin, end, 0});
    }
  }
}

std::vector<Index> order_in_rounds(PointsView points, std::span<const int> axes, int rounds, int threads) {
  KeyedRows rows(points.size());
  if (!axes.empty()) {
    with_dimension<1>(static_cast<int>(axes.size()),
                      [&](auto dimension) { sort_along_curve<dimension>(points, axes, rows, rounds, threads); });
  }
  std::vector<Index> order(rows.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = rows.row(i);
  return order;
}

}  // namespace

std::vector<Index> brio_order(PointsView points, std::span<const int> axes, int threads) {
  const std::size_t few = axes.size() <= 3 ? 4096 : 64;  // above 3D one star costs as much as many walks
  int rounds = 0;
  for (std::size_t n = points.size(); n > few; n /= 8) ++rounds;
  return order_in_rounds(points, axes, rounds, threads);
}

std::vector<Index> curve_order(PointsView points, std::span<const int> axes, int threads) {
  return order_in_rounds(points, axes, 0, threads);
}

}  // namespace delone
