#include "delone/lab/order_k.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "delone/apps/order_k.hpp"
#include "delone/base/errors.hpp"
#include "delone/io/generate.hpp"
#include "delone/lab/scope.hpp"
#include "lab/experiments.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;  // ascending

/// Those on two sides of a border, once each.
Pairs pairs_at_borders(const OrderK& diagram) {
  Pairs pairs;
  for (const Bisector& b : diagram.borders) {
    if (b.near < b.far) pairs.emplace_back(b.near, b.far);
  }
  std::ranges::sort(pairs);
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
  return pairs;
}

}  // namespace

double pairs_bound(std::size_t n, int k) {
  return k < 2 ? 0 : edges_up_to_scope_bound(n, static_cast<std::size_t>(k - 2));
}

double cells_by_lee(std::size_t n, int k, std::size_t lower_unbounded) {
  return (2.0 * k - 1) * static_cast<double>(n) - (1.0 * k * k - 1) - static_cast<double>(lower_unbounded);
}

std::vector<OrderCounts> count_orders(PointsView points, int most, const Progress& progress) {
  std::vector<OrderCounts> counts;
  Pairs pairs;
  const auto count = [&](const OrderK& diagram) {
    const auto unbounded = static_cast<std::size_t>(std::ranges::count(diagram.starts, kNone));
    counts.push_back(
        {diagram.k, diagram.size(), unbounded, diagram.borders.size() / 2, diagram.vertex_count(), pairs.size()});
    Pairs more;
    std::ranges::set_union(pairs, pairs_at_borders(diagram), std::back_inserter(more));
    pairs.swap(more);
  };
  for_orders(points, 1, most, count, {.progress = progress});
  return counts;
}

PairsResult run_pairs(const PairsOptions& options) {
  Work work(options.progress, static_cast<double>(options.kinds.size()) * options.runs);
  PairsResult result;
  for (const std::string& kind : options.kinds) {
    std::vector<std::array<std::vector<double>, 3>> values(options.orders.size());
    for (int run = 0; run < options.runs; ++run) {
      const io::Generated made = io::generate(kind, options.n, 2, run_seed(options.seed, run));
      const std::vector<OrderCounts> counts = count_orders(PointsView(made.coordinates, 2), options.orders.back());
      if (result.first.empty()) result.first = counts;
      double so_far = 0;
      auto value = values.begin();
      for (std::size_t i = 0; i < counts.size(); ++i) {
        so_far += static_cast<double>(counts[i].cells);
        if (counts[i].k != options.orders[static_cast<std::size_t>(value - values.begin())]) continue;
        (*value)[0].push_back(static_cast<double>(counts[i].cells));
        (*value)[1].push_back(so_far);
        (*value)[2].push_back(static_cast<double>(counts[i].pairs));
        ++value;
      }
      work.done(1);
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto& [cells, so_far, pairs] = values[i];
      result.rows.push_back({kind, options.n, options.orders[i], estimate(cells), estimate(so_far), estimate(pairs)});
    }
  }
  return result;
}

namespace {

constexpr std::size_t kUsualSize = 1000;
constexpr std::size_t kLeastSize = 25;
constexpr int kUsualRuns = 3;

PairsOptions pairs_options(const LabOptions& options) {
  PairsOptions chosen;
  chosen.n = options.n == 0 ? kUsualSize : options.n;
  if (chosen.n < kLeastSize)
    throw InputError("lab order-k: diagrams up to order 20 are looked at, of 25 points or more, not " +
                     std::to_string(chosen.n));
  chosen.runs = options.runs == 0 ? kUsualRuns : options.runs;
  chosen.seed = options.seed;
  chosen.progress = options.progress;
  return chosen;
}

LabTable pairs_table(const PairsResult& result) {
  LabTable table;
  table.title = "Cells, and pairs of sites that share one, for each site";
  table.columns = {"points", "k",    "cells of order k", "cells up to k", "/ k^2", "pairs up to k", "spread",
                   "/ k",    "bound"};
  for (const PairsRow& row : result.rows) {
    const auto n = static_cast<double>(row.n), k = static_cast<double>(row.k);
    const double cells = row.cells_so_far.mean / n, pairs = row.pairs.mean / n;
    table.rows.push_back({row.kind, k, row.cells.mean / n, cells, cells / (k * k), pairs, row.pairs.deviation / n,
                          pairs / k, pairs_bound(row.n, row.k) / n});
  }
  table.note =
      "Pairs up to k: those in a cell of an order up to k. Bound: that of the proof of lemma 2.5 for symmetric scopes "
      "up\n"
      "to k - 2, with the best sample size; never more than all pairs.";
  return table;
}

LabTable orders_table(const PairsResult& result, std::size_t n) {
  LabTable table;
  table.title = "The orders of one set of uniform points";
  table.columns = {"k", "cells", "by Lee", "unbounded", "borders", "vertices", "pairs up to k"};
  std::size_t lower_unbounded = 0;
  for (const OrderCounts& c : result.first) {
    std::vector<Value> row{static_cast<double>(c.k), static_cast<double>(c.cells),
                           cells_by_lee(n, c.k, lower_unbounded)};
    for (const std::size_t x : {c.unbounded, c.borders, c.vertices, c.pairs}) row.emplace_back(static_cast<double>(x));
    table.rows.push_back(std::move(row));
    lower_unbounded += c.unbounded;
  }
  table.note = "By Lee: (2k - 1) n - (k^2 - 1) less all unbounded cells of lower orders.";
  return table;
}

std::vector<Panel> pairs_panels(const PairsResult& result) {
  Panel cells{"cells up to order k", {"k", true}, {"for each site", true}, {{"n k^2", {}, true}}};
  Panel pairs{"pairs that share one", {"k", true}, {"for each site", true}, {{"bound of lemma 2.5", {}, true}}};
  for (const PairsRow& row : result.rows) {
    const auto n = static_cast<double>(row.n), k = static_cast<double>(row.k);
    if (cells.series.size() == 1 || cells.series.back().name != row.kind) {
      cells.series.push_back({row.kind, {}});
      pairs.series.push_back({row.kind, {}});
    }
    cells.series.back().points.push_back({k, row.cells_so_far.mean / n});
    if (row.k > 1) pairs.series.back().points.push_back({k, row.pairs.mean / n});
    if (row.kind != result.rows.front().kind) continue;
    cells.series[0].points.push_back({k, k * k});
    if (row.k > 1) pairs.series[0].points.push_back({k, pairs_bound(row.n, row.k) / n});
  }
  return {std::move(cells), std::move(pairs)};
}

}  // namespace

Experiment order_k_experiment() {
  return {"order-k", "Cells of orders up to 20, and pairs of sites that share one [GKS92] 4.2",
          [](const LabOptions& options) {
            const PairsOptions chosen = pairs_options(options);
            return 5e-4 * static_cast<double>(chosen.n * chosen.kinds.size()) * chosen.runs;
          },
          [](const LabOptions& options) {
            const PairsOptions chosen = pairs_options(options);
            const PairsResult result = run_pairs(chosen);
            LabReport report;
            report.heading =
                "[GKS92] lemma 4.3: the pairs of sites that share a cell of a Voronoi diagram of an order up to k are\n"
                "O(nk), while all these diagrams may have as many as n k^2 cells.";
            report.tables = {pairs_table(result), orders_table(result, chosen.n)};
            report.chart_title = "Cells of orders up to k, and pairs of sites that share one";
            report.panels = pairs_panels(result);
            return report;
          }};
}

}  // namespace delone::lab
