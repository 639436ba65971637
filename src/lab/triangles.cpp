#include "delone/lab/triangles.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "lab/experiments.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

/// The sum over r = 4 .. n of (whole - part / r).
double sum_over_insertions(std::size_t n, double whole, double part) {
  if (n < 3) return 0;
  return whole * static_cast<double>(n - 3) - part * (harmonic(n) - harmonic(3));
}

std::vector<std::string> kinds_of_the_plane() {
  std::vector<std::string> kinds;
  for (const std::string& kind : io::kinds()) {
    const io::KindInfo info = io::kind_info(kind);
    if (info.least_dimension <= 2 && info.most_dimension >= 2) kinds.push_back(kind);
  }
  return kinds;
}

struct Samples {
  std::size_t sites = 0;
  std::vector<double> by_flips, delaunay, edges;
};

/// Both methods see the same orders. The conflict graph fills the cavities that Method::cavity fills, but does not walk
/// to them, which takes long on curves.
Samples sample(PointsView points, const TrianglesOptions& options, Work& work) {
  Samples samples;
  for (int run = 0; run < options.runs; ++run) {
    const std::uint64_t seed = run_seed(options.seed, run);
    const Created flipped = count_created(points, Method::flip_loop, Order::random, seed);
    const Created stars = count_created(points, Method::conflict_graph, Order::random, seed);
    samples.sites = flipped.sites;
    samples.by_flips.push_back(flipped.triangles);
    samples.edges.push_back(flipped.edges);
    samples.delaunay.push_back(stars.triangles);
    work.done(static_cast<double>(points.size()));
  }
  return samples;
}

/// Lower and upper sites of [GKS92] figure 1 as io::generate makes them.
double lower(std::size_t n) { return static_cast<double>((n + 1) / 2); }
double upper(std::size_t n) { return static_cast<double>(n / 2); }

}  // namespace

double flipped_triangles_bound(std::size_t n) { return n < 3 ? 0 : 4 + sum_over_insertions(n, 9, 18); }
double delaunay_triangles_bound(std::size_t n) { return n < 3 ? 0 : 4 + sum_over_insertions(n, 6, 9); }
double created_edges_bound(std::size_t n) { return n < 3 ? 0 : 6 + sum_over_insertions(n, 6, 9); }

double figure_one_by_flips(std::size_t n) { return 4 + 3 * (lower(n) - 2) + (upper(n) - 1) * (2 * lower(n) + 1); }
double figure_one_delaunay(std::size_t n) { return 4 + 3 * (lower(n) - 2) + (upper(n) - 1) * (lower(n) + 2); }

Created count_created(PointsView points, Method method, Order order, std::uint64_t seed) {
  const AnyTriangulation t = build(points, {.method = method, .order = order, .seed = seed});
  // Statistics begin after the first triangle and its three ghosts.
  Created created{t.vertex_count(), 4 + static_cast<double>(t.statistics().cells_created), 0};
  if (t.statistics().flips > 0)
    created.edges = 6 + 2 * static_cast<double>(created.sites - 3) + static_cast<double>(t.statistics().flips);
  return created;
}

TrianglesResult run_triangles(const TrianglesOptions& options) {
  const std::vector<std::string> kinds = options.kinds.empty() ? kinds_of_the_plane() : options.kinds;
  double all = 0;
  for (const std::size_t n : options.sizes) all += static_cast<double>(n * kinds.size());
  for (const std::size_t n : options.figure_one_sizes) all += static_cast<double>(n);
  Work work(options.progress, all * options.runs);
  TrianglesResult result;
  for (const std::string& kind : kinds) {
    for (const std::size_t n : options.sizes) {
      const io::Generated made = io::generate(kind, n, 2, options.seed);
      const Samples s = sample(PointsView(made.coordinates, 2), options, work);
      result.rows.push_back({kind, s.sites, estimate(s.by_flips), estimate(s.delaunay), estimate(s.edges)});
    }
  }
  for (const std::size_t n : options.figure_one_sizes) {
    const io::Generated made = io::generate("gks-figure1", n);
    const PointsView points(made.coordinates, 2);
    const Samples s = sample(points, options, work);
    result.figure_one.push_back({n, count_created(points, Method::flip_loop, Order::input, 1).triangles,
                                 count_created(points, Method::cavity, Order::input, 1).triangles, estimate(s.by_flips),
                                 estimate(s.delaunay)});
  }
  return result;
}

namespace {

constexpr std::size_t kUsualSize = 10000;
constexpr std::size_t kUsualFigureOne = 2000;  // 2 million triangles from right to left
constexpr int kUsualRuns = 10;

TrianglesOptions triangles_options(const LabOptions& options) {
  const std::size_t n = options.n == 0 ? kUsualSize : options.n;
  if (n < 10) throw InputError("lab triangles: a bound on averages needs 10 points or more, not " + std::to_string(n));
  TrianglesOptions chosen;
  chosen.sizes = sizes_up_to(n, 100, 10);
  chosen.figure_one_sizes = sizes_up_to(std::min(n, kUsualFigureOne), 250, 2);
  chosen.runs = options.runs == 0 ? kUsualRuns : options.runs;
  chosen.seed = options.seed;
  chosen.progress = options.progress;
  return chosen;
}

LabTable created_table(const TrianglesResult& result) {
  LabTable table;
  table.title = "Ever created in random order, for each site";
  table.columns = {"points", "n",     "by flips", "spread", "bound", "Delaunay",
                   "spread", "bound", "edges",    "spread", "bound"};
  for (const TrianglesRow& row : result.rows) {
    const auto n = static_cast<double>(row.n);
    std::vector<Value> line{row.kind, n};
    const auto add = [&](const Estimate& e, double bound) {
      for (const double x : {e.mean, e.deviation, bound}) line.emplace_back(x / n);
    };
    add(row.by_flips, flipped_triangles_bound(row.n));
    add(row.delaunay, delaunay_triangles_bound(row.n));
    add(row.edges, created_edges_bound(row.n));
    table.rows.push_back(std::move(line));
  }
  table.note =
      "Triangles at the ghost vertex are counted. Edges follow from flips: three for the first flip of a site, one "
      "for\n"
      "each other. Bounds are on expectations: a mean over runs may be above by its own error, spread / sqrt(runs).\n"
      "Where the first three sites are collinear, the third is the first one off their line.";
  return table;
}

LabTable figure_one_table(const TrianglesResult& result) {
  LabTable table;
  table.title = "Triangles ever created on the sites of [GKS92] figure 1";
  table.columns = {"n",       "right to left, by flips", "formula", "Delaunay",
                   "formula", "random, by flips",        "spread",  "Delaunay",
                   "spread"};
  std::array<std::vector<std::array<double, 2>>, 4> curves;
  for (const FigureOneRow& row : result.figure_one) {
    const auto n = static_cast<double>(row.n);
    table.rows.push_back({n, row.by_flips, figure_one_by_flips(row.n), row.delaunay, figure_one_delaunay(row.n),
                          row.random_by_flips.mean, row.random_by_flips.deviation, row.random_delaunay.mean,
                          row.random_delaunay.deviation});
    const std::array<double, 4> y{row.by_flips, row.delaunay, row.random_by_flips.mean, row.random_delaunay.mean};
    for (std::size_t i = 0; i < y.size(); ++i) curves[i].push_back({n, y[i]});
  }
  const std::string none;
  table.rows.push_back({"exponent", exponent(curves[0]), none, exponent(curves[1]), none, exponent(curves[2]), none,
                        exponent(curves[3]), none});
  return table;
}

/// Six lines are told apart: a bound, three distributions, and figure 1 in both orders.
std::vector<Panel> triangles_panels(const TrianglesResult& result) {
  Panel flips{"by flips", {"sites", true}, {"triangles a site", false, 6, 9.5}, {{"bound for random order", {}, true}}};
  Panel delaunay{"Delaunay at some time",
                 {"sites", true},
                 {"triangles a site", false, 4.5, 6.5},
                 {{"bound for random order", {}, true}}};
  for (const TrianglesRow& row : result.rows) {
    if (row.kind != "uniform" && row.kind != "lattice" && row.kind != "circle" && row.kind != "gks-figure1") continue;
    const auto n = static_cast<double>(row.n);
    if (flips.series.size() == 1 || flips.series.back().name != row.kind) {
      flips.series.push_back({row.kind, {}});
      delaunay.series.push_back({row.kind, {}});
    }
    flips.series.back().points.push_back({n, row.by_flips.mean / n});
    delaunay.series.back().points.push_back({n, row.delaunay.mean / n});
    if (row.kind != "uniform") continue;
    flips.series[0].points.push_back({n, flipped_triangles_bound(row.n) / n});
    delaunay.series[0].points.push_back({n, delaunay_triangles_bound(row.n) / n});
  }
  Panel order{"figure 1, by flips", {"sites", true}, {"thousand triangles", true}, {}};
  order.series = {{"bound for random order", {}, true}, {"gks-figure1", {}}, {"gks-figure1 from right to left", {}}};
  for (const FigureOneRow& row : result.figure_one) {
    const auto n = static_cast<double>(row.n);
    order.series[0].points.push_back({n, flipped_triangles_bound(row.n) / 1000});
    order.series[1].points.push_back({n, row.random_by_flips.mean / 1000});
    order.series[2].points.push_back({n, row.by_flips / 1000});
  }
  return {std::move(flips), std::move(delaunay), std::move(order)};
}

}  // namespace

Experiment triangles_experiment() {
  return {"triangles", "Triangles and edges ever created by random insertion [Slides] lemma 2, [GKS92] 2.1",
          [](const LabOptions& options) {
            const TrianglesOptions chosen = triangles_options(options);
            double sites = 0;
            for (const std::size_t n : chosen.sizes) sites += static_cast<double>(n * kinds_of_the_plane().size());
            return 1 + 1.5e-5 * sites * chosen.runs;
          },
          [](const LabOptions& options) {
            const TrianglesResult result = run_triangles(triangles_options(options));
            LabReport report;
            report.heading =
                "[Slides] lemma 2: random incremental insertion creates at most 9n + 1 triangles, expected over all "
                "orders,\n"
                "whatever the sites; [GKS92] theorem 2.3: of those that are Delaunay at some time there are O(n). With "
                "one\n"
                "ghost vertex the bounds are 9n - 23 - 18 (H(n) - 11/6) and 6n - 14 - 9 (H(n) - 11/6).";
            report.tables = {created_table(result), figure_one_table(result)};
            report.chart_title = "Triangles ever created by inserting sites one by one";
            report.panels = triangles_panels(result);
            return report;
          }};
}

}  // namespace delone::lab
