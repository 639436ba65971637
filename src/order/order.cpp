#include "delone/order/order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "delone/base/errors.hpp"
#include "delone/base/random.hpp"
#include "delone/order/brio.hpp"

namespace delone {
namespace {

constexpr std::array<OrderInfo, 8> kOrders{{
    {Order::automatic, "automatic", "the usual one of the method"},
    {Order::brio, "brio", "rounds of growing size, each along Hilbert's curve"},
    {Order::hilbert, "hilbert", "along Hilbert's curve"},
    {Order::random, "random", "any order, each as likely; see --seed"},
    {Order::lexicographic, "lexicographic", "by the first coordinate, then the second, ..."},
    {Order::input, "input", "as the rows come"},
    {Order::bucket, "bucket", "through the cells of a grid, row after row, there and back"},
    {Order::quaternary, "quaternary", "through the boxes of a 2^D-ary tree, level by level"},
}};

void shuffle(std::vector<Index>& rows, std::uint64_t seed) {
  for (std::size_t i = rows.size(); i > 1; --i) std::swap(rows[i - 1], rows[mix(mix(seed) + i) % i]);
}

std::vector<Index> listed(const Buffer<Index>& rows) { return {rows.begin(), rows.end()}; }

/// Where the row of a grid that a point lies in is walked backwards, so that every cell touches the one before.
std::vector<Index> bucket_order(PointsView points, std::span<const int> axes, std::vector<Index> rows) {
  constexpr double kPointsPerCell = 2.0;
  if (rows.empty() || axes.empty()) return rows;
  std::vector<double> low(axes.size(), std::numeric_limits<double>::infinity());
  std::vector<double> high(axes.size(), -std::numeric_limits<double>::infinity());
  for (const Index row : rows) {
    for (std::size_t j = 0; j < axes.size(); ++j) {
      const double x = points[row][static_cast<std::size_t>(axes[j])];
      low[j] = std::min(low[j], x);
      high[j] = std::max(high[j], x);
    }
  }
  const double per_axis =
      std::pow(static_cast<double>(rows.size()) / kPointsPerCell, 1.0 / static_cast<double>(axes.size()));
  const double cells = std::max(1.0, std::floor(per_axis + 1e-9));  // a root that is whole may come out a little less
  std::vector<std::uint64_t> key(points.size());
  for (const Index row : rows) {
    bool backwards = false;
    for (std::size_t j = axes.size(); j-- > 0;) {
      const double x = points[row][static_cast<std::size_t>(axes[j])];
      const double extent = 0.5 * high[j] - 0.5 * low[j];  // halves: the difference may be too large for a double
      const double share = extent > 0.0 ? (0.5 * x - 0.5 * low[j]) / extent : 0.0;
      auto cell = static_cast<std::uint64_t>(std::min(share * cells, cells - 1.0));
      if (backwards) cell = static_cast<std::uint64_t>(cells) - 1 - cell;
      key[row] = key[row] * static_cast<std::uint64_t>(cells) + cell;
      backwards = key[row] % 2 == 1;
    }
  }
  std::ranges::stable_sort(rows, {}, [&](Index row) { return key[row]; });
  return rows;
}

/// Along the curve a box's first point stands for it. It has stood for all boxes around that begin with it, so its
/// level is the depth of the cut before it, of which there are D to a level (but not within a cell of the finest grid).
std::vector<Index> quaternary_order(PointsView points, std::span<const int> axes, int threads) {
  const CurveCuts cuts = curve_cuts(points, axes, threads);
  if (cuts.order.size() < 2) return listed(cuts.order);
  const std::uint16_t root = *std::min_element(cuts.cut.begin() + 1, cuts.cut.end());
  std::vector<std::size_t> places(cuts.order.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::ranges::stable_sort(places.begin() + 1, places.end(), {},
                           [&](std::size_t i) { return (cuts.cut[i] - root) / static_cast<int>(axes.size()); });
  std::vector<Index> rows(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) rows[i] = cuts.order[places[i]];
  return rows;
}

}  // namespace

std::span<const OrderInfo> orders() { return kOrders; }

Order order_named(const std::string& name) {
  std::string names;
  for (const OrderInfo& order : kOrders) {
    if (name == order.name) return order.order;
    names += (names.empty() ? "" : ", ") + std::string(order.name);
  }
  throw InputError("there is no order '" + name + "': there are " + names);
}

std::vector<Index> ordered_rows(Order order, PointsView points, std::span<const int> axes, std::uint64_t seed,
                                int threads) {
  std::vector<Index> rows(points.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  switch (order) {
    case Order::automatic:
    case Order::brio:
      return listed(brio_order(points, axes, threads));
    case Order::hilbert:
      return listed(curve_order(points, axes, threads));
    case Order::random:
      shuffle(rows, seed);
      return rows;
    case Order::lexicographic:
      std::ranges::sort(rows,
                        [&](Index a, Index b) { return std::ranges::lexicographical_compare(points[a], points[b]); });
      return rows;
    case Order::input:
      return rows;
    case Order::bucket:
      return bucket_order(points, axes, std::move(rows));
    case Order::quaternary:
      return quaternary_order(points, axes, threads);
  }
  return rows;
}

}  // namespace delone
