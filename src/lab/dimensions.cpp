#include "delone/lab/dimensions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/mesh/export.hpp"
#include "lab/experiments.hpp"

namespace delone::lab {
namespace {

using std::numbers::pi;

/// Of the ball of radius 1.
double unit_volume(int d) { return std::pow(pi, d / 2.0) / std::tgamma(d / 2.0 + 1); }

/// One site in the origin, n - 1 evenly in the ball of radius 1 about it.
io::Generated ball(std::size_t n, int dimension, std::uint64_t seed) {
  const auto d = static_cast<std::size_t>(dimension);
  io::Generated points{.dimension = dimension, .coordinates = std::vector<double>(d, 0.0)};
  // Of the cube around the ball this share is in it; a little more is taken until there are enough.
  const double share = unit_volume(dimension) / std::pow(2, dimension);
  for (std::size_t part = 0; points.coordinates.size() < n * d; ++part) {
    const auto count = static_cast<std::size_t>(1.2 * static_cast<double>(n) / share) + 10;
    const io::Generated cube = io::generate("uniform", count, dimension, seed + 1000000 * part);
    for (std::size_t row = 0; row < count && points.coordinates.size() < n * d; ++row) {
      std::vector<double> x(d);
      double square = 0;
      for (std::size_t axis = 0; axis < d; ++axis) {
        x[axis] = 2 * cube.coordinates[row * d + axis] - 1;
        square += x[axis] * x[axis];
      }
      if (square <= 1) points.coordinates.insert(points.coordinates.end(), x.begin(), x.end());
    }
  }
  return points;
}

/// Cells and neighbours of every site.
struct Stars {
  std::vector<std::size_t> cells, neighbours;
};

Stars stars_of(const CellTable& table, std::size_t n) {
  const auto corners = static_cast<std::size_t>(table.corners);
  Stars stars{std::vector<std::size_t>(n, 0), std::vector<std::size_t>(n, 0)};
  for (const Index row : table.vertices) ++stars.cells[row];
  std::vector<std::size_t> end(n);
  std::partial_sum(stars.cells.begin(), stars.cells.end(), end.begin());
  std::vector<std::size_t> next(n), cells(table.vertices.size());
  for (std::size_t v = 0; v < n; ++v) next[v] = end[v] - stars.cells[v];
  for (std::size_t place = 0; place < table.vertices.size(); ++place)
    cells[next[table.vertices[place]]++] = place / corners;
  std::vector<std::size_t> seen_by(n, n);
  for (std::size_t v = 0; v < n; ++v) {
    seen_by[v] = v;
    for (std::size_t i = end[v] - stars.cells[v]; i < end[v]; ++i) {
      for (const Index w : table[cells[i]]) {
        if (seen_by[w] == v) continue;
        seen_by[w] = v;
        ++stars.neighbours[v];
      }
    }
  }
  return stars;
}

double mean(const std::vector<std::size_t>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The values of some runs.
struct Runs {
  std::vector<double> in_cube, in_ball, degree, inner, inner_cells, inner_degree;
};

void add_run(Runs& runs, int d, std::size_t n, std::uint64_t seed) {
  const double corners = d + 1;
  const io::Generated cube = io::generate("uniform", n, d, seed);
  const auto cells_in_cube = static_cast<double>(build(PointsView(cube.coordinates, d)).cell_count());
  runs.in_cube.push_back(cells_in_cube / static_cast<double>(n));

  const io::Generated made = ball(n, d, seed);
  const PointsView points(made.coordinates, d);
  const Stars stars = stars_of(cells(build(points), false), n);
  runs.in_ball.push_back(mean(stars.cells) / corners);
  runs.degree.push_back(mean(stars.neighbours));
  const double depth = 2 * std::pow(12 / static_cast<double>(n), 1.0 / d);
  std::vector<std::size_t> inner_cells, inner_degrees;
  for (std::size_t row = 0; row < n; ++row) {
    const auto x = points[row];
    const double from_centre = std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
    if (row > 0 && from_centre > 1 - depth) continue;
    inner_cells.push_back(stars.cells[row]);
    inner_degrees.push_back(stars.neighbours[row]);
  }
  runs.inner.push_back(static_cast<double>(inner_cells.size()));
  runs.inner_cells.push_back(mean(inner_cells) / corners);
  runs.inner_degree.push_back(mean(inner_degrees));
}

/// What a run is likely to take, in units of cells.
double work(int d, std::size_t n) { return poisson_cells(d) * static_cast<double>(n) * d; }

}  // namespace

double poisson_cells(int d) {
  const double square = d * d;
  const double logarithm = (d + 1) * std::log(2) + (d - 1) / 2.0 * std::log(pi) - std::log(square * (d + 1)) +
                           std::lgamma((square + 1) / 2) - std::lgamma(square / 2) +
                           d * (std::lgamma(d / 2.0 + 1) - std::lgamma((d + 1) / 2.0));
  return std::exp(logarithm);
}

double estimated_cells(int d) {
  return std::exp(0.25) * std::sqrt(2 / pi) / (d * (d + 1)) * std::pow(2 * pi * d, d / 2.0);
}

double poisson_degree(int d) {
  switch (d) {
    case 1:
      return 2;
    case 2:
      return 6;
    case 3:
      return 2 * (1 + poisson_cells(3));
    case 4:
      return 6 + poisson_cells(4);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

std::vector<DimensionCount> run_dimensions(const DimensionOptions& options) {
  double all = 0, done = 0;
  for (const auto& [d, sizes, runs] : options.sizes) {
    for (const std::size_t n : sizes) all += runs * work(d, n);
  }
  std::vector<DimensionCount> counts;
  for (const auto& [d, sizes, run_count] : options.sizes) {
    for (const std::size_t n : sizes) {
      Runs runs;
      for (int run = 0; run < run_count; ++run) {
        add_run(runs, d, n, options.seed + static_cast<std::uint64_t>(run));
        done += work(d, n);
        if (options.progress && !options.progress(done / all)) throw Cancelled();
      }
      counts.push_back({.dimension = d,
                        .n = n,
                        .cells_in_cube = estimate(runs.in_cube),
                        .cells_in_ball = estimate(runs.in_ball),
                        .degree = estimate(runs.degree),
                        .inner = estimate(runs.inner).mean,
                        .inner_cells = estimate(runs.inner_cells),
                        .inner_degree = estimate(runs.inner_degree)});
    }
  }
  return counts;
}

namespace {

constexpr std::size_t kMost = 64000;
constexpr int kHighest = 6;

/// n sites in the plane, in higher dimensions fewer, since they have more cells.
DimensionOptions how(const LabOptions& options) {
  const std::size_t most = options.n == 0 ? kMost : options.n;
  constexpr std::array<std::size_t, 7> kShare{1, 1, 1, 2, 8, 32, 64};
  DimensionOptions result{.sizes = {}, .seed = options.seed, .progress = options.progress};
  for (int d = 2; d <= kHighest; ++d) {
    DimensionSizes sizes{d, {}, options.runs != 0 ? options.runs : 6};
    for (std::size_t n = std::max<std::size_t>(most / kShare[static_cast<std::size_t>(d)], 40); n >= 40; n /= 4) {
      sizes.sizes.push_back(n);
      if (sizes.sizes.size() == 4) break;
    }
    std::ranges::reverse(sizes.sizes);
    result.sizes.push_back(sizes);
  }
  return result;
}

LabTable cells_table(const std::vector<DimensionCount>& counts) {
  LabTable table{.title = "Cells by site",
                 .columns = {"d", "n", "in a cube", "+-", "in a ball", "+-", "inner sites", "at these", "+-",
                             "Poisson c_d", "estimate"},
                 .rows = {},
                 .note = "The estimate is meant for d > 5. Means of some runs, and their standard deviations."};
  for (const DimensionCount& c : counts) {
    table.rows.push_back({static_cast<double>(c.dimension), static_cast<double>(c.n), c.cells_in_cube.mean,
                          c.cells_in_cube.deviation, c.cells_in_ball.mean, c.cells_in_ball.deviation, c.inner,
                          c.inner_cells.mean, c.inner_cells.deviation, poisson_cells(c.dimension),
                          estimated_cells(c.dimension)});
  }
  return table;
}

LabTable degree_table(const std::vector<DimensionCount>& counts) {
  LabTable table{
      .title = "Neighbours of a site",
      .columns = {"d", "n", "in a ball", "+-", "inner sites", "at these", "+-", "Poisson"},
      .rows = {},
      .note = "[For92] 2.3 gives 6 and 15.54; for d = 4 they follow from c_d. Beyond, cells do not decide it."};
  for (const DimensionCount& c : counts) {
    table.rows.push_back({static_cast<double>(c.dimension), static_cast<double>(c.n), c.degree.mean, c.degree.deviation,
                          c.inner, c.inner_degree.mean, c.inner_degree.deviation, poisson_degree(c.dimension)});
  }
  return table;
}

Panel approach(const std::vector<DimensionCount>& counts) {
  Panel panel{"Cells by site in a ball, by c_d", {"sites", true}, {"share of c_d", false, 0, 1.1}, {}};
  for (int d = 2; d <= kHighest; ++d) {
    Series line{fmt::format("d = {}", d), {}};
    for (const DimensionCount& c : counts) {
      if (c.dimension == d) line.points.push_back({static_cast<double>(c.n), c.cells_in_ball.mean / poisson_cells(d)});
    }
    panel.series.push_back(line);
  }
  const auto [least, most] = std::ranges::minmax(counts, {}, [](const DimensionCount& c) { return c.n; });
  panel.series.push_back(
      {"Poisson process", {{static_cast<double>(least.n), 1.0}, {static_cast<double>(most.n), 1.0}}, true});
  return panel;
}

Panel by_dimension(const std::vector<DimensionCount>& counts, const char* title, Estimate DimensionCount::*inner,
                   Estimate DimensionCount::*all, double (*law)(int)) {
  Panel panel{title, {"dimension", false, 1.5, kHighest + 0.5}, {"by site", true}, {}};
  Series at_inner{"inner sites", {}}, at_all{"all sites in the ball", {}}, exact{"Poisson process", {}, true};
  for (int d = 2; d <= kHighest; ++d) {
    const DimensionCount* last = nullptr;
    for (const DimensionCount& c : counts) last = c.dimension == d ? &c : last;
    at_inner.points.push_back({static_cast<double>(d), (last->*inner).mean});
    at_all.points.push_back({static_cast<double>(d), (last->*all).mean});
    exact.points.push_back({static_cast<double>(d), law(d)});
  }
  panel.series = {at_inner, at_all, exact};
  return panel;
}

LabReport report(const LabOptions& options) {
  if (options.n != 0 && options.n < 1000) throw InputError("lab dimensions: at least 1000 sites in the plane");
  const std::vector<DimensionCount> counts = run_dimensions(how(options));
  LabReport report;
  report.heading =
      "[For92] 2.3: a site of a Poisson process has 6 neighbours in the plane and 15.54 in space, in the mean\n"
      "(Meijering), and n sites evenly in a ball have c_d n cells (Dwyer), which is conjectured for a cube, too. "
      "Sites\n"
      "near the border have fewer, and in high dimensions most sites are near the border.";
  report.tables = {cells_table(counts), degree_table(counts)};
  report.chart_title = "Cells and neighbours of a random site";
  report.panels = {approach(counts),
                   by_dimension(counts, "Cells by site", &DimensionCount::inner_cells, &DimensionCount::cells_in_ball,
                                poisson_cells),
                   by_dimension(counts, "Neighbours of a site", &DimensionCount::inner_degree, &DimensionCount::degree,
                                poisson_degree)};
  return report;
}

}  // namespace

Experiment dimensions_experiment() {
  return {.name = "dimensions",
          .text = "Neighbours and cells of a random site, in dimensions 2 to 6",
          .seconds =
              [](const LabOptions& options) {
                double all = 0;
                for (const auto& [d, sizes, runs] : how(options).sizes) {
                  for (const std::size_t n : sizes) all += runs * work(d, n);
                }
                return 6e-7 * all;
              },
          .run = report};
}

}  // namespace delone::lab
