#include "delone/order/brio.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "delone/base/dispatch.hpp"
#include "delone/base/random.hpp"
#include "delone/order/hilbert.hpp"

namespace delone {
namespace {

struct Keyed {
  std::uint64_t key;
  Index row;
};

/// Sorts by the low `bits` bits of the key, 11 at a time, least significant first.
void radix_sort(std::span<Keyed> items, std::span<Keyed> scratch, int bits) {
  constexpr int kDigit = 11;
  constexpr std::uint64_t kMask = (1U << kDigit) - 1;
  std::span<Keyed> from = items;
  std::span<Keyed> to = scratch.first(items.size());
  for (int shift = 0; shift < bits; shift += kDigit) {
    std::array<std::size_t, kMask + 1> start{};
    for (const Keyed& item : from) ++start[item.key >> shift & kMask];
    std::size_t sum = 0;
    for (std::size_t& s : start) sum += std::exchange(s, sum);
    for (const Keyed& item : from) to[start[item.key >> shift & kMask]++] = item;
    std::swap(from, to);
  }
  if (from.data() != items.data()) std::ranges::copy(from, items.begin());
}

/// The cube that holds some rows; halved numbers, so that no extent overflows.
template <int K>
struct Cube {
  std::array<double, K> low;
  double extent = 0.0;

  template <class Rows>
  Cube(PointsView points, std::span<const int> axes, const Rows& rows) {
    std::array<double, K> high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const auto& item : rows) {
      for (std::size_t j = 0; j < K; ++j) {
        const double x = points[item.row][static_cast<std::size_t>(axes[j])] * 0.5;
        low[j] = std::min(low[j], x);
        high[j] = std::max(high[j], x);
      }
    }
    for (std::size_t j = 0; j < K; ++j) extent = std::max(extent, high[j] - low[j]);
  }

  std::uint64_t distance(std::span<const double> point, std::span<const int> axes, int bits) const {
    std::array<std::uint32_t, K> cell;
    const double cells = std::ldexp(1.0, bits);
    for (std::size_t j = 0; j < K; ++j) {
      const double share = (point[static_cast<std::size_t>(axes[j])] * 0.5 - low[j]) / extent;  // 0 to 1
      cell[j] = static_cast<std::uint32_t>(std::min(share * cells, cells - 1.0));
    }
    return HilbertCurve<K>::distance(cell, bits);
  }
};

template <int K>
void sort_along_curve(PointsView points, std::span<const int> axes, std::vector<Keyed>& items, int rounds) {
  constexpr std::size_t kCrowd = 24;  // fewer points than this in one grid cell may stay as they are
  struct Job {
    std::size_t begin, end;
    int rounds;
  };
  std::vector<Keyed> scratch(items.size());
  std::vector<Job> jobs{{0, items.size(), rounds}};
  while (!jobs.empty()) {
    const Job job = jobs.back();
    jobs.pop_back();
    const std::span<Keyed> part = std::span(items).subspan(job.begin, job.end - job.begin);
    const Cube<K> cube(points, axes, part);
    if (!(cube.extent > 0.0)) continue;
    const int wanted = static_cast<int>(std::bit_width(part.size())) + 6;
    const int bits = std::clamp((wanted + K - 1) / K, 1, std::min(31, 56 / K));
    for (Keyed& item : part) {
      const auto round = job.rounds == 0 ? 0 : job.rounds - std::min(job.rounds, std::countr_zero(mix(item.row)) / 3);
      item.key = static_cast<std::uint64_t>(round) << (bits * K) | cube.distance(points[item.row], axes, bits);
    }
    radix_sort(part, scratch, bits * K + std::bit_width(static_cast<unsigned>(job.rounds)));
    for (std::size_t begin = 0, end; begin < part.size(); begin = end) {
      for (end = begin + 1; end < part.size() && part[end].key == part[begin].key;) ++end;
      if (end - begin > kCrowd && end - begin < part.size()) {
        jobs.push_back({job.begin + begin, job.begin + end, 0});
      }
    }
  }
}

}  // namespace

std::vector<Index> brio_order(PointsView points, std::span<const int> axes) {
  std::vector<Keyed> items(points.size());
  for (std::size_t i = 0; i < items.size(); ++i) items[i] = {0, static_cast<Index>(i)};
  int rounds = 0;
  for (std::size_t n = points.size(); n > 4096; n /= 8) ++rounds;
  if (!axes.empty())
    with_dimension<1>(static_cast<int>(axes.size()),
                      [&](auto dimension) { sort_along_curve<dimension>(points, axes, items, rounds); });
  std::vector<Index> order(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].row;
  return order;
}

}  // namespace delone
