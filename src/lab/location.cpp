#include "delone/lab/location.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "delone/base/errors.hpp"
#include "delone/base/random.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "lab/experiments.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

using Point = std::array<double, 2>;
constexpr Point kX{0, 1}, kY{1, 1}, kP{0.5, 1 - 0x1p-40};  // P above the lines from Y to all bottom sites

std::vector<Point> bottom(std::size_t m) {
  std::vector<Point> points;
  for (std::size_t i = 1; i <= m; ++i) points.push_back({-static_cast<double>(i), 0});
  return points;
}

void shuffle(std::vector<Point>& points, std::uint64_t seed) {
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[mix(mix(seed) + i) % i]);
}

/// For the last of the points, inserted in order: what it adds to the steps of all before it. None when these are
/// collinear, or too few: then it is in the first triangle.
double traced_for_last(const std::vector<Point>& points, Method method) {
  const auto steps = [&](std::span<const Point> some) {
    const PointsView view(std::span(some.front().data(), 2 * some.size()), 2);
    return static_cast<double>(build(view, {.method = method, .order = Order::input}).statistics().history_steps);
  };
  const auto before = std::span(points).first(points.size() - 1);
  if (std::ranges::all_of(before, [](const Point& p) { return p[1] == 0; }) || before.size() < 3) return 0;
  return steps(points) - steps(before);
}

/// Those of [GKS92] that come before P in a random order, and P.
std::vector<Point> random_until_p(std::size_t n, std::uint64_t seed, bool ordered) {
  std::vector<Point> points = bottom(n - 3);
  points.insert(points.end(), {kX, kY, kP});
  shuffle(points, seed);
  if (ordered) {  // the three top sites change places among themselves
    std::array<Point, 3> rest{kP, kX, kY};
    std::size_t left = rest.size();
    for (Point& p : points) p = p[1] > 0 ? rest[--left] : p;
  }
  points.erase(std::ranges::find(points, kP) + 1, points.end());
  return points;
}

RandomBadSiteRow random_bad_site(std::size_t n, const LocationOptions& options, Work& work) {
  std::vector<double> any, ordered, before;
  for (int run = 0; run < options.bad_runs; ++run) {
    const std::uint64_t seed = run_seed(options.seed, run);
    any.push_back(traced_for_last(random_until_p(n, seed, false), Method::flip));
    const std::vector<Point> points = random_until_p(n, seed, true);
    ordered.push_back(traced_for_last(points, Method::flip));
    before.push_back(static_cast<double>(std::ranges::find(points, kX) - points.begin()) - 1);
    work.done(2 * static_cast<double>(n));
  }
  return {n, estimate(any), estimate(ordered), estimate(before).mean};
}

}  // namespace

double traced_bound(std::size_t r) {
  double bound = 1.75;
  for (std::size_t j = 4; j <= r; ++j) {
    const auto x = static_cast<double>(j);
    bound += 3 / x * (4 - 9 / (x + 1));
  }
  return bound;
}

double mean_traced_bound(std::size_t n) {
  double sum = 0, bound = traced_bound(3);
  for (std::size_t r = 3; r < n; ++r) {
    const auto x = static_cast<double>(r);
    if (r > 3) bound += 3 / x * (4 - 9 / (x + 1));
    sum += bound;
  }
  return sum / static_cast<double>(n);
}

double traced_for_bad_site(std::size_t m, Method method, std::uint64_t seed) {
  std::vector<Point> points = bottom(m);
  shuffle(points, seed);
  points.insert(points.begin(), kY);
  points.insert(points.end(), {kX, kP});
  return traced_for_last(points, method);
}

LocationResult run_location(const LocationOptions& options) {
  double all = 0;
  for (const std::size_t n : options.sizes)
    all += static_cast<double>(n * options.kinds.size()) * static_cast<double>(options.runs);
  for (const std::size_t n : options.bad_sizes) all += static_cast<double>(n) * (6 + 2.0 * options.bad_runs);
  Work work(options.progress, all);
  LocationResult result;
  for (const std::string& kind : options.kinds) {
    for (const std::size_t n : options.sizes) {
      const io::Generated made = io::generate(kind, n, 2, options.seed);
      std::vector<double> traced;
      for (int run = 0; run < options.runs; ++run) {
        const std::uint64_t seed = run_seed(options.seed, run);
        const AnyTriangulation t =
            build(PointsView(made.coordinates, 2), {.method = Method::flip, .order = Order::random, .seed = seed});
        traced.push_back(static_cast<double>(t.statistics().history_steps) / static_cast<double>(n));
        work.done(static_cast<double>(n));
      }
      result.rows.push_back({kind, n, estimate(traced)});
    }
  }
  for (const std::size_t n : options.bad_sizes) {
    const auto traced = [&](Method method) { return traced_for_bad_site(n, method, options.seed); };
    result.bad.push_back({n, traced(Method::flip), traced(Method::flip_loop), traced(Method::flip_legalize)});
    work.done(6 * static_cast<double>(n));
    result.random_bad.push_back(random_bad_site(n, options, work));
  }
  return result;
}

namespace {

constexpr std::size_t kUsualSize = 100000, kUsualBadSize = 10000;
constexpr int kUsualRuns = 5, kBadRunsPerRun = 20;

LocationOptions location_options(const LabOptions& options) {
  const std::size_t n = options.n == 0 ? kUsualSize : options.n;
  if (n < 10)
    throw InputError("lab location: a logarithm needs 10 points or more to be seen, not " + std::to_string(n));
  LocationOptions chosen;
  chosen.sizes = sizes_up_to(n, 100, 10);
  chosen.bad_sizes = sizes_up_to(std::min(n, kUsualBadSize), 100, 10);
  chosen.runs = options.runs == 0 ? kUsualRuns : options.runs;
  chosen.bad_runs = kBadRunsPerRun * chosen.runs;
  chosen.seed = options.seed;
  chosen.progress = options.progress;
  return chosen;
}

LabTable traced_table(const LocationResult& result, const LocationOptions& options) {
  LabTable table;
  table.title = "Triangles traced for a site, sites in random order";
  table.columns = {"points", "n", "traced", "spread", "bound", "traced / ln n", "c so far"};
  std::vector<std::array<double, 2>> curve;
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    const LocationRow& row = result.rows[i];
    if (i % options.sizes.size() == 0) curve.clear();
    const double logarithm = std::log(static_cast<double>(row.n));
    curve.push_back({logarithm, row.traced.mean});
    table.rows.push_back({row.kind, static_cast<double>(row.n), row.traced.mean, row.traced.deviation,
                          mean_traced_bound(row.n), row.traced.mean / logarithm, fitted_line(curve).slope});
  }
  table.note =
      "c: the slope of the line c ln n + d through the sizes so far. The bound, which grows as 12 ln n, counts "
      "triangles\n"
      "whose circle, not only whose region, contains the site.";
  return table;
}

LabTable bad_table(const LocationResult& result) {
  LabTable table;
  table.title = "Traced for the bad site P alone, after Y, m bottom sites and X";
  table.columns = {"m", "flip", "flip_loop", "flip_legalize", "flip / m"};
  for (const BadSiteRow& row : result.bad) {
    const auto m = static_cast<double>(row.m);
    table.rows.push_back({m, row.flip, row.flip_loop, row.flip_legalize, row.flip / m});
  }
  return table;
}

LabTable random_bad_table(const LocationResult& result) {
  LabTable table;
  table.title = "Traced for the bad site P alone, n sites in random order";
  table.columns = {"n",       "if Y, X, P come in this order",
                   "spread",  "bottom sites before X",
                   "(n-3)/2", "in any order",
                   "spread",  "(n-3)/12"};
  for (const RandomBadSiteRow& row : result.random_bad) {
    const auto n = static_cast<double>(row.n);
    table.rows.push_back({n, row.traced_if_ordered.mean, row.traced_if_ordered.deviation, row.before_x, (n - 3) / 2,
                          row.traced.mean, row.traced.deviation, (n - 3) / 12});
  }
  table.note =
      "Y, X, P is one of six orders as likely, and X is then the middle one: so (n-3)/12 is a bound from below.";
  return table;
}

std::vector<Panel> location_panels(const LocationResult& result) {
  Panel traced{"all sites", {"sites", true}, {"triangles traced a site"}, {{"bounds", {}, true}}};
  for (const LocationRow& row : result.rows) {
    if (row.kind != "uniform" && row.kind != "circle" && row.kind != "lattice") continue;
    if (traced.series.back().name != row.kind) traced.series.push_back({row.kind, {}});
    traced.series.back().points.push_back({static_cast<double>(row.n), row.traced.mean});
    if (row.kind == "uniform")
      traced.series[0].points.push_back({static_cast<double>(row.n), mean_traced_bound(row.n)});
  }
  Panel bad{"the bad site P", {"sites", true}, {"triangles traced for it", true}, {}};
  bad.series = {{"bounds", {}, true}, {"P, if Y, X, P come in this order", {}}, {"P, in any order", {}}};
  for (const RandomBadSiteRow& row : result.random_bad) {
    const auto n = static_cast<double>(row.n);
    bad.series[0].points.push_back({n, (n - 3) / 12});
    bad.series[1].points.push_back({n, row.traced_if_ordered.mean});
    bad.series[2].points.push_back({n, row.traced.mean});
  }
  return {std::move(traced), std::move(bad)};
}

}  // namespace

Experiment location_experiment() {
  return {
      "location", "Triangles of the history traced to find a site [GKS92] 3",
      [](const LabOptions& options) {
        const LocationOptions chosen = location_options(options);
        double sites = 0;
        for (const std::size_t n : chosen.sizes)
          sites += static_cast<double>(n * chosen.kinds.size()) * static_cast<double>(chosen.runs);
        for (const std::size_t n : chosen.bad_sizes) sites += 2 * static_cast<double>(n) * chosen.bad_runs;
        return 8e-6 * sites;
      },
      [](const LabOptions& options) {
        const LocationOptions chosen = location_options(options);
        const LocationResult result = run_location(chosen);
        LabReport report;
        report.heading =
            "[GKS92] theorem 3.1: O(n log n) triangles of the history are traced to find all n sites, expected over\n"
            "random orders; looking backward, at most 12 ln n a site. Remark: for one bad site P they may be linear.";
        report.tables = {traced_table(result, chosen), bad_table(result), random_bad_table(result)};
        report.chart_title = "Triangles traced in the history to find a site";
        report.panels = location_panels(result);
        return report;
      }};
}

}  // namespace delone::lab
