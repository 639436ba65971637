#include "delone/lab/flips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/mesh/export.hpp"
#include "lab/experiments.hpp"
#include "lab/plane.hpp"

namespace delone::lab {
namespace {

std::vector<std::array<Index, 3>> triangles_of(const AnyTriangulation& t) {
  const CellTable table = cells(t, false);
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t c = 0; c < table.size(); ++c) triangles.push_back({table[c][0], table[c][1], table[c][2]});
  return triangles;
}

double per_site(std::uint64_t count, std::size_t n) { return static_cast<double>(count) / static_cast<double>(n); }

}  // namespace

std::vector<FlipCounts> run_flip_counts(const FlipCountOptions& options) {
  std::vector<FlipCounts> counts;
  const auto all = static_cast<double>(options.distributions.size() * options.sizes.size()) * options.runs;
  double done = 0;
  for (const std::string& distribution : options.distributions) {
    for (const std::size_t n : options.sizes) {
      std::vector<double> lawson, incremental;
      for (int run = 0; run < options.runs; ++run) {
        const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(run);
        const io::Generated made = io::generate(distribution, n, 2, seed);
        const PointsView points(made.coordinates, 2);
        lawson.push_back(per_site(build(points, {.method = Method::lawson}).statistics().flips, n));
        const AnyTriangulation t = build(points, {.method = Method::flip_loop, .order = Order::random, .seed = seed});
        // The flip that puts a site into its triangle, for all but the first three, flips no edge.
        incremental.push_back(per_site(t.statistics().flips - (t.vertex_count() - 3), n));
        if (options.progress && !options.progress(++done / all)) throw Cancelled();
      }
      counts.push_back({distribution, n, estimate(lawson), estimate(incremental)});
    }
  }
  return counts;
}

double lawson_exponent(const std::vector<FlipCounts>& counts, const std::string& distribution) {
  double k = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const FlipCounts& c : counts) {
    if (c.distribution != distribution) continue;
    const double log_n = std::log(static_cast<double>(c.n));
    const double log_flips = std::log(c.lawson.mean) + log_n;
    k += 1;
    x += log_n;
    y += log_flips;
    xx += log_n * log_n;
    xy += log_n * log_flips;
  }
  return (k * xy - x * y) / (k * xx - x * x);
}

// The bend: y = 1 - e x^2 above and e x^2 below. The circle through three sites of a row has a radius of nearly
// 1 / (2 e) or more, so at a distance of up to 2 m it is off its tangent by less than about 4 e m^2. With e at most
// 1 / (64 m^2) that is 1/16, and the other row lies beyond, inside the circle. e is a power of two: coordinates are
// exact for m up to 2^20.
ForcedFlips run_forced_flips(std::size_t m, std::uint64_t seed) {
  if (m < 2 || m > (std::size_t{1} << 20)) throw InputError("two rows of 2 to 2^20 sites are needed");
  const auto round = static_cast<double>(std::bit_ceil(m));
  const double bend = 1 / (64 * round * round);
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 1; i <= m; ++i) {
    const auto x = static_cast<double>(i);
    points.push_back({-x, 1 - bend * x * x});
  }
  for (std::size_t i = 1; i <= m; ++i) {
    const auto x = static_cast<double>(i);
    points.push_back({x, bend * x * x});
  }
  const auto upper = [](std::size_t i) { return static_cast<Index>(i); };
  const auto lower = [m](std::size_t i) { return static_cast<Index>(m + i); };
  std::vector<Triangle> start;
  for (std::size_t i = 0; i + 1 < m; ++i) start.push_back({lower(i), lower(i + 1), upper(m - 1)});
  for (std::size_t i = 0; i + 1 < m; ++i) start.push_back({upper(i + 1), lower(m - 1), upper(i)});

  ForcedFlips result;
  result.n = 2 * m;
  const AnyTriangulation expected = build(points);
  result.convex = expected.hull_facet_count() == 2 * m;
  result.delaunay = true;
  const auto flips = [&](Discipline discipline) {
    Mesh mesh = closed_mesh(points, start);
    const std::uint64_t count = make_delaunay(mesh, discipline, seed);
    const bool same = canonical_hash(AnyTriangulation(std::move(mesh))) == canonical_hash(expected);
    result.delaunay = result.delaunay && same;
    return count;
  };
  result.queue = flips(Discipline::queue);
  result.stack = flips(Discipline::stack);
  result.random = flips(Discipline::random);
  // In a convex polygon each edge that is not at a corner v, but beyond a triangle at v, can be flipped to one that is:
  // so all edges come to v one by one, and from there go where they shall.
  const auto missing_at = [&](Index v, const std::vector<std::array<Index, 3>>& triangles) {
    const auto at_v = std::ranges::count_if(
        triangles, [v](const auto& t) { return std::ranges::find(t, v) != t.end(); });  // one less than the degree
    return 2 * m - 2 - static_cast<std::size_t>(at_v);
  };
  result.enough = missing_at(upper(m - 1), start) + missing_at(upper(m - 1), triangles_of(expected));
  return result;
}

bool StuckFlips::stuck() const {
  return least_degree > 3 && std::ranges::none_of(edges, [](const Edge& e) { return !e.regular && e.flippable; });
}

// Barycentric coordinates of the inner sites: (5, 2, 3)/10, (3, 5, 2)/10 and (2, 3, 5)/10, so that the inner triangle
// is turned a little. A weight of |p|^2 - h lifts p to h: the outer sites to 0, the inner ones to 1.
StuckFlips run_stuck_flips() {
  StuckFlips result;
  result.points = {{0, 0}, {80, 0}, {40, 70}, {28, 21}, {48, 14}, {44, 35}};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [x, y] = result.points[i];
    result.weights.push_back(x * x + y * y - (i < 3 ? 0 : 1));
  }
  result.triangles = {{3, 4, 5}};
  for (Index i = 0; i < 3; ++i) {
    const Index j = (i + 1) % 3;
    result.triangles.push_back({i, j, 3 + i});
    result.triangles.push_back({j, 3 + j, 3 + i});
  }
  const PointsView points(result.points, result.weights);
  Mesh mesh = closed_mesh(points, result.triangles);
  const ComplexView<2> complex(mesh.complex);
  Kernel<2> kernel(mesh.sites);
  std::array<std::size_t, 6> degree{};
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (complex.is_ghost(c)) continue;
    for (int i = 0; i < 3; ++i) {
      ++degree[raw(complex.vertex(c, i))];
      const FacetId f = complex.facet(c, i), across = complex.twin(f);
      if (across < f || complex.is_ghost(complex.cell(across))) continue;
      result.edges.push_back({.a = raw(complex.vertex(c, complex.turned(i, 1))),
                              .b = raw(complex.vertex(c, complex.turned(i, 2))),
                              .regular = !is_locally_non_regular(complex, kernel, f),
                              .flippable = is_flippable(complex, kernel, f)});
    }
  }
  result.least_degree = std::min({degree[3], degree[4], degree[5]});
  const AnyTriangulation flipped = build(points, {.method = Method::flip});
  result.by_insertion = triangles_of(flipped);
  result.hidden = flipped.hidden_count();
  result.by_cavities = triangles_of(build(points, {.method = Method::cavity}));
  return result;
}

namespace {

constexpr std::size_t kMost = 16000, kMostForced = 2048;

std::vector<std::size_t> doubled_up_to(std::size_t n) {
  std::vector<std::size_t> sizes;
  for (std::size_t size = n; size >= 100 && sizes.size() < 6; size /= 2) sizes.push_back(size);
  std::ranges::reverse(sizes);
  return sizes;
}

LabTable counts_table(const std::vector<FlipCounts>& counts) {
  LabTable table{
      .title = "Flips by site: Lawson's method, and sites inserted in random order (below 3)",
      .columns = {"points", "n", "Lawson", "deviation", "random order", "deviation", "expected below"},
      .rows = {},
      .note = "The random order's flips are edges alone: the mean degree of a new site, less than 6, less 3."};
  for (const FlipCounts& c : counts) {
    table.rows.push_back({c.distribution, static_cast<double>(c.n), c.lawson.mean, c.lawson.deviation,
                          c.incremental.mean, c.incremental.deviation, 3.0});
  }
  return table;
}

LabTable exponents_table(const std::vector<FlipCounts>& counts, const FlipCountOptions& options) {
  LabTable table{.title = "Lawson's method: all flips as c n^e",
                 .columns = {"points", "e", "flips at the largest n", "of n (n - 1) / 2"},
                 .rows = {},
                 .note = {}};
  for (const std::string& distribution : options.distributions) {
    const auto last = std::ranges::find_if(
        counts, [&](const FlipCounts& c) { return c.distribution == distribution && c.n == options.sizes.back(); });
    const auto n = static_cast<double>(last->n);
    table.rows.push_back({distribution, lawson_exponent(counts, distribution), std::round(last->lawson.mean * n),
                          last->lawson.mean / ((n - 1) / 2)});
  }
  return table;
}

LabTable forced_table(const std::vector<ForcedFlips>& all) {
  LabTable table{
      .title = "Two rows of sites that face each other: Delaunay flips, whatever their order",
      .columns = {"n", "queue", "stack", "random", "(n/2 - 1)^2", "by n^2", "enough, of any edges", "Delaunay"},
      .rows = {},
      .note = "With flips of any edge, by way of the fan of one corner, a number below 2 n would do."};
  for (const ForcedFlips& f : all) {
    const auto n = static_cast<double>(f.n);
    table.rows.push_back({n, static_cast<double>(f.queue), static_cast<double>(f.stack), static_cast<double>(f.random),
                          (n / 2 - 1) * (n / 2 - 1), static_cast<double>(f.queue) / (n * n),
                          static_cast<double>(f.enough), f.delaunay && f.convex ? "yes" : "no"});
  }
  return table;
}

LabTable stuck_table(const StuckFlips& s) {
  LabTable table{.title = "Six weighted sites, inner edges of the triangulation of [ES96] figure 5.1",
                 .columns = {"edge", "locally regular", "flippable"},
                 .rows = {},
                 .note = {}};
  for (const auto& e : s.edges) {
    table.rows.push_back({fmt::format("{}-{}", e.a, e.b), e.regular ? "yes" : "no", e.flippable ? "yes" : "no"});
  }
  table.note = fmt::format(
      "{}: no edge that should be flipped can be, no inner site has degree 3, yet the triangulation is not regular.\n"
      "The regular one, by flips as sites are inserted{}: {} triangle, {} sites hidden.",
      s.stuck() ? "Stuck" : "Not stuck", s.by_insertion == s.by_cavities ? " and by cavities" : " (NOT by cavities)",
      s.by_insertion.size(), s.hidden);
  return table;
}

void draw_triangles(Panel& panel, const std::string& name, const StuckFlips& s,
                    const std::vector<std::array<Index, 3>>& triangles, bool dashed) {
  for (const auto& [a, b, c] : triangles) {
    panel.series.push_back({name, {s.points[a], s.points[b], s.points[c], s.points[a]}, dashed});
  }
}

LabReport report(const LabOptions& options) {
  const std::size_t most = options.n == 0 ? kMost : options.n;
  if (most < 200) throw InputError("lab flips: sizes are doubled up to n, which is at least 200");
  FlipCountOptions how;
  how.sizes = doubled_up_to(most);
  how.runs = options.runs == 0 ? 3 : options.runs;
  how.seed = options.seed;
  how.progress = options.progress;
  const std::vector<FlipCounts> counts = run_flip_counts(how);
  std::vector<ForcedFlips> forced;
  for (std::size_t m = 16; 2 * m <= std::min(most, kMostForced); m *= 2) {
    forced.push_back(run_forced_flips(m, options.seed));
  }
  const StuckFlips stuck = run_stuck_flips();

  LabReport report;
  report.heading =
      "[For92] 4.2: flips lead from any triangulation of n sites to Delaunay's, at most n (n - 1) / 2 of them; some\n"
      "start in c n^2, whatever the order of the flips. [GKS92] 3: with sites inserted in random order it is O(n), "
      "less\n"
      "than 3 n. [ES96] 5: with weights, flips that follow no order can get stuck.";
  report.tables = {counts_table(counts), exponents_table(counts, how), forced_table(forced), stuck_table(stuck)};
  report.chart_title = "How many flips flipping takes";

  Panel by_site{"Flips by site", {"sites", true}, {"flips by site", true}, {}};
  for (const std::string distribution : {"uniform", "parabola"}) {
    Series line{"Lawson, " + distribution, {}};
    for (const FlipCounts& c : counts) {
      if (c.distribution == distribution) line.points.push_back({static_cast<double>(c.n), c.lawson.mean});
    }
    by_site.series.push_back(line);
  }
  Series incremental{"random order, uniform", {}}, bound{"bound", {}, true};
  for (const FlipCounts& c : counts) {
    if (c.distribution != how.distributions.front()) continue;
    incremental.points.push_back({static_cast<double>(c.n), c.incremental.mean});
    bound.points.push_back({static_cast<double>(c.n), 3.0});
  }
  by_site.series.push_back(incremental);
  by_site.series.push_back(bound);

  Panel rows{"Two rows of sites", {"sites", true}, {"flips", true}, {}};
  Series measured{"two rows: Delaunay flips, any order", {}}, law{"bound", {}, true},
      enough{"two rows: enough, of any edges", {}};
  for (const ForcedFlips& f : forced) {
    const auto n = static_cast<double>(f.n);
    measured.points.push_back({n, static_cast<double>(f.queue)});
    law.points.push_back({n, n * (n - 1) / 2});
    enough.points.push_back({n, static_cast<double>(f.enough)});
  }
  rows.series = {measured, law, enough};

  Panel six{"Six weighted sites: flips are stuck", {"", false, 0, 84}, {"", false, 0, 72}, {}};
  draw_triangles(six, "stuck triangulation", stuck, stuck.triangles, false);
  draw_triangles(six, "regular triangulation", stuck, stuck.by_insertion, true);
  report.panels = {by_site, rows, six};
  return report;
}

}  // namespace

Experiment flips_experiment() {
  return {.name = "flips",
          .text = "How many flips Lawson's method takes, at worst too, and where flips get stuck",
          .seconds =
              [](const LabOptions& options) {
                const auto n = static_cast<double>(options.n == 0 ? kMost : options.n);
                // The parabola takes nearly n^2 / 2 flips, at each size a quarter of those at the next.
                return 1 + (options.runs == 0 ? 3 : options.runs) * (2.5e-8 * n * n + 1e-4 * n);
              },
          .run = report};
}

}  // namespace delone::lab
