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
  int key_bits() const { return 64 - row_bits_; }
  std::vector<Index> in_order() const {
    std::vector<Index> order(size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = row(i);
    return order;
  }
  Index row(std::size_t i) const { return static_cast<Index>(words_[i] & ((std::uint64_t{1} << row_bits_) - 1)); }
  std::uint64_t key(std::size_t i) const { return words_[i] >> row_bits_; }
  void set_key(std::size_t i, std::uint64_t key) { words_[i] = key << row_bits_ | row(i); }

  /// Sorts [begin, end) by the low `bits` bits of the key, which is all that they differ by: first by as many of these
  /// as tell most of the words apart, then what is still alike by the others.
  void sort(std::size_t begin, std::size_t end, int bits, int threads) {
    constexpr std::size_t kFew = 512;
    if (end - begin < kFew) return std::sort(words_.begin() + begin, words_.begin() + end);
    const int first = std::min(bits, static_cast<int>(std::bit_width(end - begin)) + 2);
    const int shift = row_bits_ + bits - first;
    sort_by_bits(begin, end, shift, first, threads);
    if (first == bits) return;
    for (std::size_t alike = begin; begin < end; begin = alike) {
      while (alike < end && words_[alike] >> shift == words_[begin] >> shift) ++alike;
      if (alike - begin > 1) sort(begin, alike, bits - first, threads);
    }
  }

 private:
  /// The same by `bits` bits from `shift` on, at most 11 at a time, least significant first.
  void sort_by_bits(std::size_t begin, std::size_t end, int shift, int bits, int threads) {
    constexpr std::size_t kShare = 1 << 16;  // of one thread, at least
    constexpr int kDigit = 11;
    const int rounds = (bits + kDigit - 1) / kDigit;
    const int width = (bits + rounds - 1) / rounds;
    const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
    const std::size_t count = end - begin;
    const std::size_t share = std::max(kShare, count / static_cast<std::size_t>(std::max(threads, 1)) + 1);
    std::vector<std::array<std::size_t, 1 << kDigit>> start((count + share - 1) / share);
    std::span<std::uint64_t> from = std::span(words_.data(), words_.size()).subspan(begin, count);
    std::span<std::uint64_t> to = std::span(scratch_.data(), scratch_.size()).subspan(begin, count);
    for (int round = 0; round < rounds; ++round, shift += width) {
      const auto digit = [shift, mask](std::uint64_t word) { return word >> shift & mask; };
      const auto count_digits = [&](std::size_t first, std::size_t last, std::size_t part) {
        start[part].fill(0);
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

/// @param cuts  empty, or where to write the depth of the cut before each row (see CurveCuts)
template <int K>
void sort_along_curve(PointsView points, std::span<const int> axes, KeyedRows& rows, int rounds, int threads,
                      std::span<std::uint16_t> cuts = {}) {
  constexpr int kWord = 64;                        // more than a key has bits
  constexpr std::size_t kTogether = 4;             // keys that are computed side by side
  const std::size_t crowd = cuts.empty() ? 3 : 1;  // up to this many points in one grid cell may stay as they are
  struct Job {
    std::size_t begin, end;
    int rounds;
    int grids;  // that its points were sorted on before
  };
  std::vector<Job> jobs{{0, rows.size(), rounds, 0}};
  while (!jobs.empty()) {
    const Job job = jobs.back();
    jobs.pop_back();
    const Cube<K> cube(points, axes, rows, job.begin, job.end, threads);
    if (!(cube.extent > 0.0)) continue;
    const int round_bits = static_cast<int>(std::bit_width(static_cast<unsigned>(job.rounds)));
    const int bits = std::clamp((rows.key_bits() - round_bits) / K, 1, 31);
    DELONE_ASSERT(bits * K + round_bits <= rows.key_bits(), "a key fits beside its row");
    for_chunks(job.end - job.begin, threads, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = job.begin + begin; i < job.begin + end; i += kTogether) {
        const std::size_t count = std::min(kTogether, job.begin + end - i);
        std::array<typename HilbertCurve<K>::Place, kTogether> cells{};
        for (std::size_t j = 0; j < count; ++j) cells[j] = cube.grid_cell(points[rows.row(i + j)], axes, bits);
        const auto distances = HilbertCurve<K>::distances(cells, bits);
        for (std::size_t j = 0; j < count; ++j) {
          const int early = job.rounds == 0 ? 0 : std::min(job.rounds, std::countr_zero(mix(rows.row(i + j))) / 3);
          rows.set_key(i + j, static_cast<std::uint64_t>(job.rounds - early) << (bits * K) | distances[j]);
        }
      }
    });
    rows.sort(job.begin, job.end, bits * K + round_bits, threads);
    // Rows of one key belong to the chunk in which the first of them stands.
    std::mutex mutex;
    for_chunks(job.end - job.begin, threads, [&](std::size_t first, std::size_t last, std::size_t) {
      std::size_t begin = job.begin + first;
      while (begin > job.begin && begin < job.begin + last && rows.key(begin) == rows.key(begin - 1)) ++begin;
      for (std::size_t end; begin < job.begin + last; begin = end) {
        for (end = begin + 1; end < job.end && rows.key(end) == rows.key(begin);) ++end;
        if (end - begin > crowd && end - begin < job.end - job.begin) {
          const std::lock_guard lock(mutex);
          jobs.push_back({begin, end, 0, job.grids + 1});
        }
        if (cuts.empty() || begin == job.begin) continue;
        const int common = std::countl_zero(rows.key(begin) ^ rows.key(begin - 1));
        cuts[begin] = static_cast<std::uint16_t>(job.grids * kWord + common);
      }
    });
  }
}

std::vector<Index> order_in_rounds(PointsView points, std::span<const int> axes, int rounds, int threads) {
  KeyedRows rows(points.size(), threads);
  if (!axes.empty()) {
    with_dimension<1>(static_cast<int>(axes.size()),
                      [&](auto dimension) { sort_along_curve<dimension>(points, axes, rows, rounds, threads); });
  }
  return rows.in_order();
}

/// The place nearest to the middle of rows [begin, end), which are sorted on this axis, where its coordinate grows;
/// `begin` when it does not.
std::size_t nearest_step(PointsView points, std::span<const Index> order, std::size_t begin, std::size_t end,
                         int axis) {
  const auto grows_at = [&](std::size_t i) {
    return points[order[i - 1]][static_cast<std::size_t>(axis)] != points[order[i]][static_cast<std::size_t>(axis)];
  };
  const std::size_t middle = begin + (end - begin) / 2;
  for (std::size_t d = 0; d <= end - middle; ++d) {
    if (d < middle - begin && grows_at(middle - d)) return middle - d;
    if (d < end - middle && middle + d > begin && grows_at(middle + d)) return middle + d;
  }
  return begin;
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

CurveCuts curve_cuts(PointsView points, std::span<const int> axes, int threads) {
  KeyedRows rows(points.size(), threads);
  Buffer<std::uint16_t> cuts;
  cuts.resize(points.size(), CurveCuts::kSamePlace);
  with_dimension<1>(static_cast<int>(axes.size()), [&](auto dimension) {
    sort_along_curve<dimension>(points, axes, rows, 0, threads, {cuts.data(), cuts.size()});
  });
  return {rows.in_order(), std::move(cuts)};
}

CurveCuts vertical_cuts(PointsView points, std::span<const int> axes) {
  CurveCuts cuts;
  cuts.order.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) cuts.order[i] = static_cast<Index>(i);
  const auto place = [&](Index row) {
    return std::array{points[row][static_cast<std::size_t>(axes[0])], points[row][static_cast<std::size_t>(axes[1])]};
  };
  std::ranges::sort(cuts.order, {}, place);
  cuts.cut.resize(points.size(), CurveCuts::kSamePlace);
  struct Part {
    std::size_t begin, end;
    std::uint16_t depth;
  };
  std::vector<Part> parts{{0, points.size(), 0}};
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    std::size_t at = part.begin;
    for (std::size_t axis = 0; axis < 2 && at == part.begin && part.end - part.begin > 1; ++axis) {
      at = nearest_step(points, cuts.order, part.begin, part.end, axes[axis]);
    }
    if (at == part.begin) continue;  // one place
    cuts.cut[at] = part.depth;
    const auto deeper = static_cast<std::uint16_t>(part.depth + 1);
    parts.push_back({part.begin, at, deeper});
    parts.push_back({at, part.end, deeper});
  }
  return cuts;
}

}  // namespace delone
