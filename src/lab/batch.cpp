#include "delone/lab/batch.hpp"

#include <algorithm>
#include <array>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/io/generate.hpp"
#include "delone/locate/hierarchy.hpp"
#include "lab/experiments.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

/// What is there, and what is added.
struct Sites2 {
  std::vector<double> old_ones, new_ones;
};

Sites2 uniform_sites(std::size_t m, std::size_t n, std::uint64_t seed) {
  const io::Generated made = io::generate("uniform", m + n, 2, seed);
  const auto middle = made.coordinates.begin() + static_cast<std::ptrdiff_t>(2 * m);
  return {{made.coordinates.begin(), middle}, {middle, made.coordinates.end()}};
}

Sites2 worst_sites(std::size_t m, std::size_t n) {
  Sites2 sites;
  for (std::size_t i = 1; i < m; ++i) sites.old_ones.insert(sites.old_ones.end(), {-static_cast<double>(i), 0});
  for (std::size_t i = 1; i <= n; ++i) sites.new_ones.insert(sites.new_ones.end(), {static_cast<double>(i), 1});
  sites.old_ones.insert(sites.old_ones.end(), {static_cast<double>(n + 1), 1});
  return sites;
}

double count_added(const Sites2& sites, std::uint64_t seed) {
  AnyTriangulation t = build(PointsView(sites.old_ones, 2));
  const std::uint64_t before = t.statistics().cells_created;
  const PointsView added(sites.new_ones, 2);
  constexpr std::array<int, 2> kAxes{0, 1};
  Hierarchy locator;
  attach(locator, t);
  for (const Index row : ordered_rows(Order::random, added, kAxes, seed)) insert(t, added[row], 0.0, locator);
  return static_cast<double>(t.statistics().cells_created - before);
}

}  // namespace

double added_triangles_bound(std::size_t m, std::size_t n) {
  double sum = 0;
  for (std::size_t i = 1; i <= n; ++i) {
    const auto old_count = static_cast<double>(m), count = static_cast<double>(i);
    const double degrees = std::min(3 * old_count + 6 * count - 9, 2 * old_count + 8 * count - 14);
    sum += i < 3 ? old_count + count : std::min(degrees / count, old_count + count);
  }
  return sum;
}

double added_triangles_scale(std::size_t m, std::size_t n) {
  return static_cast<double>(m) * harmonic(n) + static_cast<double>(n);
}

double worst_case_expected(std::size_t m, std::size_t n) {
  return (static_cast<double>(m) - 3) * harmonic(n) + 4 * static_cast<double>(n);
}

std::vector<BatchRow> run_batch(const BatchOptions& options) {
  double all = 0;
  for (const std::size_t m : options.old_sizes) {
    if (m < 3) throw InputError("lab batch: the sites that are there must be 3 or more");
    for (const std::size_t n : options.new_sizes) all += added_triangles_scale(m, n) * options.runs;
  }
  Work work(options.progress, all);
  std::vector<BatchRow> rows;
  for (const std::size_t m : options.old_sizes) {
    for (const std::size_t n : options.new_sizes) {
      std::vector<double> uniform, worst;
      for (int run = 0; run < options.runs; ++run) {
        const std::uint64_t seed = run_seed(options.seed, run);
        uniform.push_back(count_added(uniform_sites(m, n, options.seed), seed));
        worst.push_back(count_added(worst_sites(m, n), seed));
        work.done(added_triangles_scale(m, n));
      }
      rows.push_back({m, n, estimate(uniform), estimate(worst)});
    }
  }
  return rows;
}

namespace {

constexpr std::size_t kUsualSize = 10000;
constexpr int kUsualRuns = 20;

BatchOptions batch_options(const LabOptions& options) {
  const std::size_t n = options.n == 0 ? kUsualSize : options.n;
  if (n < 10) throw InputError("lab batch: 10 points or more must be added, not " + std::to_string(n));
  BatchOptions chosen;
  chosen.old_sizes = sizes_up_to(n, 100, 10);
  chosen.new_sizes = sizes_up_to(n, 10, 10);
  chosen.runs = options.runs == 0 ? kUsualRuns : options.runs;
  chosen.seed = options.seed;
  chosen.progress = options.progress;
  return chosen;
}

LabTable batch_table(const std::vector<BatchRow>& rows) {
  LabTable table;
  table.title = "Triangles created by n new sites among m old ones";
  table.columns = {"m",          "n",      "bound",           "m H(n) + n",
                   "worst case", "spread", "(m-3) H(n) + 4n", "measured / this",
                   "uniform",    "spread", "uniform / n"};
  for (const BatchRow& row : rows) {
    const double expected = worst_case_expected(row.m, row.n);
    const auto n = static_cast<double>(row.n);
    table.rows.push_back({static_cast<double>(row.m), n, added_triangles_bound(row.m, row.n),
                          added_triangles_scale(row.m, row.n), row.worst.mean, row.worst.deviation, expected,
                          row.worst.mean / expected, row.uniform.mean, row.uniform.deviation, row.uniform.mean / n});
  }
  table.note =
      "Worst case: old sites on the negative x axis, but for one; new ones on the positive part of y = 1. The orders "
      "are\n"
      "the same for all m. Its spread is that of the number of new sites that are the leftmost so far: each of them\n"
      "meets all old ones.";
  return table;
}

/// One panel for each m.
std::vector<Panel> batch_panels(const std::vector<BatchRow>& rows) {
  std::vector<Panel> panels;
  std::size_t m = 0;
  for (const BatchRow& row : rows) {
    if (row.m != m) {
      m = row.m;
      panels.push_back({"added to " + std::to_string(m), {"sites added", true}, {"thousand triangles", true}, {}});
      panels.back().series = {{"bound", {}, true},
                              {"worst case", {}},
                              {"worst case expected: (m - 3) H(n) + 4n", {}, true},
                              {"uniform points", {}}};
    }
    const std::array<double, 4> y{added_triangles_bound(row.m, row.n), row.worst.mean,
                                  worst_case_expected(row.m, row.n), row.uniform.mean};
    for (std::size_t i = 0; i < y.size(); ++i)
      panels.back().series[i].points.push_back({static_cast<double>(row.n), y[i] / 1000});
  }
  return panels;
}

}  // namespace

Experiment batch_experiment() {
  return {
      "batch", "Triangles created by adding points to a triangulation [GKS92] 2.3",
      [](const LabOptions& options) {
        const BatchOptions chosen = batch_options(options);
        double cells = 0;
        for (const std::size_t m : chosen.old_sizes) {
          for (const std::size_t n : chosen.new_sizes)
            cells += added_triangles_bound(m, n) + 6 * static_cast<double>(m + n);
        }
        return 3e-7 * cells * chosen.runs;
      },
      [](const LabOptions& options) {
        const std::vector<BatchRow> rows = run_batch(batch_options(options));
        LabReport report;
        report.heading =
            "[GKS92] theorem 2.6: n sites, added in random order to the triangulation of m, are expected to create\n"
            "O(m log n + n) triangles, and there are sites for which they do. By looking backward: less than\n"
            "2m H(n) + 8n.";
        report.tables = {batch_table(rows)};
        report.chart_title = "Triangles created by adding sites to m old ones";
        report.panels = batch_panels(rows);
        return report;
      }};
}

}  // namespace delone::lab
