#include "delone/lab/scope.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "delone/base/errors.hpp"
#include "delone/build/insert.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "delone/io/generate.hpp"
#include "lab/experiments.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

double a(std::size_t k) { return 2 / ((static_cast<double>(k) + 1) * (static_cast<double>(k) + 2)); }
double b(std::size_t k) { return 2 * a(k) / (static_cast<double>(k) + 3); }

std::size_t choose2(std::size_t n) { return n < 2 ? 0 : n * (n - 1) / 2; }
std::size_t choose3(std::size_t n) { return n < 3 ? 0 : n * (n - 1) * (n - 2) / 6; }

/// ln C(n, r).
double log_choose(std::size_t n, std::size_t r) {
  const auto log_factorial = [](std::size_t k) { return std::lgamma(static_cast<double>(k) + 1); };
  return log_factorial(n) - log_factorial(r) - log_factorial(n - r);
}

/// The least of what samples of r sites give, r C(n,r) / C(n-others-corners, r-corners) times `cells`, and `all`.
double sampling_bound(std::size_t n, std::size_t others, std::size_t corners, double cells, double all) {
  double least = all;
  for (std::size_t r = corners; r + others <= n; ++r) {
    const double ratio = std::exp(log_choose(n, r) - log_choose(n - others - corners, r - corners));
    least = std::min(least, cells * static_cast<double>(r) * ratio);
  }
  return least;
}

/// Which sites lie where, as sets: bit m for site m.
class Sides {
 public:
  explicit Sides(PointsView points) : points_(points), left_(choose2(points.size())), inside_(choose3(points.size())) {
    for (std::size_t j = 1; j < points.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) left_[edge_number(i, j)] = left_of(i, j);
    }
    for (std::size_t k = 2; k < points.size(); ++k) {
      for (std::size_t j = 1; j < k; ++j) {
        for (std::size_t i = 0; i < j; ++i) inside_[triangle_number(i, j, k)] = inside_of(i, j, k);
      }
    }
  }

  /// Left of the line from i to j, i < j.
  std::uint64_t left(std::size_t i, std::size_t j) const { return left_[edge_number(i, j)]; }
  /// Inside the circle through three sites.
  std::uint64_t inside(std::size_t i, std::size_t j, std::size_t k) const {
    std::array<std::size_t, 3> v{i, j, k};
    std::ranges::sort(v);
    return inside_[triangle_number(v[0], v[1], v[2])];
  }

 private:
  const double* at(std::size_t i) const { return points_[i].data(); }

  std::uint64_t left_of(std::size_t i, std::size_t j) const {
    std::uint64_t set = 0;
    for (std::size_t m = 0; m < points_.size(); ++m) {
      if (m == i || m == j) continue;
      const int sign = slow_orient<2>({at(i), at(j), at(m)}).sign;
      if (sign == 0) throw InputError("lab scope: three of the points lie on a line");
      if (sign > 0) set |= std::uint64_t{1} << m;
    }
    return set;
  }

  std::uint64_t inside_of(std::size_t i, std::size_t j, std::size_t k) const {
    if ((left(i, j) >> k & 1) == 0) std::swap(i, j);
    SiteRefs<2, 4> sites{};
    sites.leading = {at(i), at(j), at(k), nullptr};
    std::uint64_t set = 0;
    for (std::size_t m = 0; m < points_.size(); ++m) {
      if (m == i || m == j || m == k) continue;
      sites.leading[3] = at(m);
      const int sign = slow_conflict<2>(sites).sign;
      if (sign == 0) throw InputError("lab scope: four of the points lie on a circle");
      if (sign > 0) set |= std::uint64_t{1} << m;
    }
    return set;
  }

  PointsView points_;
  std::vector<std::uint64_t> left_, inside_;
};

std::size_t size_of(std::uint64_t set) { return static_cast<std::size_t>(std::popcount(set)); }

void measure_edge(Scopes& scopes, const Sides& sides, std::size_t i, std::size_t j) {
  const std::uint64_t left = sides.left(i, j);
  double probability = a(size_of(left));
  std::size_t width = 0;
  for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
    const std::uint64_t inside = sides.inside(i, j, static_cast<std::size_t>(std::countr_zero(rest)));
    probability += b(size_of(inside));
    if (size_of(inside & ~left) > size_of(inside & left)) ++width;
  }
  scopes.of_edge[edge_number(i, j)] = width;
  scopes.edge_probability[edge_number(i, j)] = probability;
  ++scopes.edge_count[width];
}

/// Notes what appears while the sites of one run are inserted.
class Appearances {
 public:
  explicit Appearances(const Scopes& scopes)
      : scopes_(&scopes), triangle_(scopes.of_triangle.size()), edge_(scopes.of_edge.size()) {}

  void run(PointsView points, std::span<const Index> order) {
    triangle_.assign(triangle_.size(), false);
    edge_.assign(edge_.size(), false);
    AnyTriangulation t(2);
    for (const Index row : order) {
      insert(t, points[row], 0.0, {.on_edit = [&](const Edit& e) { see(t, e, order); }});
    }
  }

  /// How many there were of each scope.
  std::vector<double> triangles() const { return by_scope(triangle_, scopes_->of_triangle, scopes_->triangle_count); }
  std::vector<double> edges() const { return by_scope(edge_, scopes_->of_edge, scopes_->edge_count); }

 private:
  void see(const AnyTriangulation& t, const Edit& e, std::span<const Index> order) {
    if (t.affine_dimension() < 2) return;  // the edge of the first two sites is one of the first triangle, too
    if (!e.rebuilt) {
      for (const CellId c : e.created) see(t, c, order);
      return;
    }
    for (std::size_t slot = 0; slot < t.complex().slot_count(); ++slot) {
      const CellId c{static_cast<Index>(slot)};
      if (t.complex().is_live(c)) see(t, c, order);
    }
  }

  void see(const AnyTriangulation& t, CellId c, std::span<const Index> order) {
    std::array<std::size_t, 3> v{};
    for (int i = 0; i < 3; ++i) {
      const VertexId vertex = t.complex().vertex(c, i);
      if (vertex == kGhost) return;
      v[static_cast<std::size_t>(i)] = order[t.row(vertex)];
    }
    std::ranges::sort(v);
    triangle_[triangle_number(v[0], v[1], v[2])] = true;
    for (const auto& [i, j] : {std::array{v[0], v[1]}, std::array{v[0], v[2]}, std::array{v[1], v[2]}})
      edge_[edge_number(i, j)] = true;
  }

  static std::vector<double> by_scope(const std::vector<bool>& seen, const std::vector<std::size_t>& scope,
                                      const std::vector<std::size_t>& count) {
    std::vector<double> numbers(count.size());
    for (std::size_t i = 0; i < seen.size(); ++i) numbers[scope[i]] += seen[i] ? 1 : 0;
    return numbers;
  }

  const Scopes* scopes_;
  std::vector<bool> triangle_, edge_;
};

/// The numbers of one kind over all runs.
class Tally {
 public:
  explicit Tally(const std::vector<std::size_t>& count) : count_(&count), shares_(count.size()) {}

  void add(const std::vector<double>& numbers) {
    double sum = 0;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      sum += numbers[k];
      shares_[k].push_back((*count_)[k] == 0 ? 0 : numbers[k] / static_cast<double>((*count_)[k]));
    }
    totals_.push_back(sum);
  }
  Estimate total() const { return estimate(totals_); }
  std::vector<Estimate> shares() const {
    std::vector<Estimate> estimates;
    for (const auto& values : shares_) estimates.push_back(estimate(values));
    return estimates;
  }

 private:
  const std::vector<std::size_t>* count_;
  std::vector<double> totals_;
  std::vector<std::vector<double>> shares_;
};

}  // namespace

double triangle_probability(std::size_t scope) { return 1.5 * b(scope); }
double edge_probability_most(std::size_t symmetric_scope) { return 2 * a(symmetric_scope) - a(2 * symmetric_scope); }
double edge_probability_least(std::size_t symmetric_scope) { return a(2 * symmetric_scope); }

double expected_triangles(std::span<const std::size_t> counts) {
  double sum = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) sum += triangle_probability(k) * static_cast<double>(counts[k]);
  return sum;
}

double triangles_up_to_scope_bound(std::size_t n, std::size_t k) {
  return sampling_bound(n, k, 3, 2, static_cast<double>(choose3(n)));
}
double edges_up_to_scope_bound(std::size_t n, std::size_t k) {
  return sampling_bound(n, 2 * k, 2, 3, static_cast<double>(choose2(n)));
}

std::size_t triangle_number(std::size_t a, std::size_t b, std::size_t c) { return choose3(c) + choose2(b) + a; }
std::size_t edge_number(std::size_t a, std::size_t b) { return choose2(b) + a; }

Scopes count_scopes(PointsView points) {
  const std::size_t n = points.size();
  if (points.dimension() != 2 || n < 3 || n > kMostScopeSites)
    throw InputError("lab scope: scopes are counted for 3 to 64 points in the plane");
  const Sides sides(points);
  Scopes scopes{n,
                std::vector<std::size_t>(choose3(n)),
                std::vector<std::size_t>(choose2(n)),
                std::vector<double>(choose2(n)),
                std::vector<std::size_t>(n - 2),
                std::vector<std::size_t>(n / 2)};
  for (std::size_t j = 1; j < n; ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      measure_edge(scopes, sides, i, j);
      for (std::size_t k = j + 1; k < n; ++k) {
        const std::size_t scope = size_of(sides.inside(i, j, k));
        scopes.of_triangle[triangle_number(i, j, k)] = scope;
        ++scopes.triangle_count[scope];
      }
    }
  }
  return scopes;
}

ScopeSimulation simulate_scopes(PointsView points, const Scopes& scopes, int runs, std::uint64_t seed,
                                const Progress& progress) {
  Appearances appearances(scopes);
  Tally triangles(scopes.triangle_count), edges(scopes.edge_count);
  Work work(progress, runs);
  for (int run = 0; run < runs; ++run) {
    constexpr std::array<int, 2> kAxes{0, 1};
    appearances.run(points, ordered_rows(Order::random, points, kAxes, run_seed(seed, run)));
    triangles.add(appearances.triangles());
    edges.add(appearances.edges());
    work.done(1);
  }
  return {triangles.total(), edges.total(), triangles.shares(), edges.shares()};
}

namespace {

constexpr std::size_t kUsualSize = 24;
constexpr int kUsualRuns = 2000;

LabTable triangle_table(const Scopes& scopes, const ScopeSimulation& simulation) {
  LabTable table;
  table.title = "Triangles by scope";
  table.columns = {"scope k", "||T_k||", "up to k", "bound 2.2", "probability", "measured share", "spread"};
  std::size_t sum = 0;
  for (std::size_t k = 0; k < scopes.triangle_count.size(); ++k) {
    sum += scopes.triangle_count[k];
    const Estimate& share = simulation.triangle_share[k];
    table.rows.push_back({static_cast<double>(k), static_cast<double>(scopes.triangle_count[k]),
                          static_cast<double>(sum), triangles_up_to_scope_bound(scopes.n, k), triangle_probability(k),
                          share.mean, share.deviation});
  }
  table.note = "Probability: 6/((k+1)(k+2)(k+3)), lemma 2.1. Bound 2.2: that of its proof, with the best sample size.";
  return table;
}

/// Mean over the edges of each symmetric scope of their exact probabilities, NaN where there are none.
std::vector<double> mean_edge_probability(const Scopes& scopes) {
  std::vector<double> mean(scopes.edge_count.size());
  for (std::size_t e = 0; e < scopes.of_edge.size(); ++e) mean[scopes.of_edge[e]] += scopes.edge_probability[e];
  for (std::size_t w = 0; w < mean.size(); ++w) mean[w] /= static_cast<double>(scopes.edge_count[w]);
  return mean;
}

LabTable edge_table(const Scopes& scopes, const ScopeSimulation& simulation) {
  LabTable table;
  table.title = "Edges by symmetric scope";
  table.columns = {"scope w",     "||E_w||", "up to w",   "bound 2.5",      "at least",
                   "probability", "at most", "bound 2.4", "measured share", "spread"};
  const std::vector<double> mean = mean_edge_probability(scopes);
  std::size_t sum = 0;
  for (std::size_t w = 0; w < mean.size(); ++w) {
    sum += scopes.edge_count[w];
    const Estimate& share = simulation.edge_share[w];
    table.rows.push_back({static_cast<double>(w), static_cast<double>(scopes.edge_count[w]), static_cast<double>(sum),
                          edges_up_to_scope_bound(scopes.n, w), edge_probability_least(w), mean[w],
                          edge_probability_most(w), 2 * a(w), share.mean, share.deviation});
  }
  table.note =
      "Probability: the mean over these edges of the sum over the path of figure 3. Bound 2.4: 4/((w+1)(w+2)).\n"
      "At least and at most: the remark after lemma 2.4, and its proof.";
  return table;
}

double expected_edges(const Scopes& scopes) {
  double sum = 0;
  for (const double p : scopes.edge_probability) sum += p;
  return sum;
}

LabTable total_table(const Scopes& scopes, const ScopeSimulation& simulation, int runs) {
  LabTable table;
  table.title = "How many ever appear";
  table.columns = {"", "expected", "measured", "spread", "error of the mean"};
  const auto add = [&](const char* name, double expected, const Estimate& e) {
    table.rows.push_back({name, expected, e.mean, e.deviation, e.deviation / std::sqrt(static_cast<double>(runs))});
  };
  add("triangles", expected_triangles(scopes.triangle_count), simulation.triangles);
  add("edges", expected_edges(scopes), simulation.edges);
  return table;
}

std::vector<Panel> scope_panels(const Scopes& scopes, const ScopeSimulation& simulation) {
  Panel triangles{"triangles", {"scope k + 1", true}, {"probability", true}, {{"measured", {}}, {"exact", {}, true}}};
  for (std::size_t k = 0; k < scopes.triangle_count.size(); ++k) {
    const double x = static_cast<double>(k) + 1;
    triangles.series[0].points.push_back({x, simulation.triangle_share[k].mean});
    triangles.series[1].points.push_back({x, triangle_probability(k)});
  }
  Panel edges{"edges", {"symmetric scope w + 1", true}, {"probability", true}, {}};
  edges.series = {{"measured", {}},
                  {"exact", {}, true},
                  {"at most (lemma 2.4)", {}, true},
                  {"at least (remark after it)", {}, true}};
  const std::vector<double> mean = mean_edge_probability(scopes);
  for (std::size_t w = 0; w < mean.size(); ++w) {
    if (scopes.edge_count[w] == 0) continue;
    const double x = static_cast<double>(w) + 1;
    const std::array<double, 4> y{simulation.edge_share[w].mean, mean[w], edge_probability_most(w),
                                  edge_probability_least(w)};
    for (std::size_t i = 0; i < y.size(); ++i) edges.series[i].points.push_back({x, y[i]});
  }
  return {std::move(triangles), std::move(edges)};
}

std::size_t scope_size(const LabOptions& options) {
  const std::size_t n = options.n == 0 ? kUsualSize : options.n;
  if (n < 3 || n > kMostScopeSites)
    throw InputError("lab scope: scopes are counted for 3 to 64 points, not " + std::to_string(n));
  return n;
}

LabReport run_scope(const LabOptions& options) {
  const std::size_t n = scope_size(options);
  const int runs = options.runs == 0 ? kUsualRuns : options.runs;
  const io::Generated made = io::generate("uniform", n, 2, options.seed);
  const PointsView points(made.coordinates, 2);
  const Scopes scopes = count_scopes(points);
  const ScopeSimulation simulation = simulate_scopes(points, scopes, runs, options.seed, options.progress);
  LabReport report;
  report.heading =
      "[GKS92] lemmas 2.1 and 2.4: a triangle with k sites inside its circle is Delaunay at some time of a random\n"
      "insertion with probability 6/((k+1)(k+2)(k+3)), an edge of symmetric scope w with at most 4/((w+1)(w+2)).";
  report.tables = {total_table(scopes, simulation, runs), triangle_table(scopes, simulation),
                   edge_table(scopes, simulation)};
  report.chart_title = "Probability ever to be Delaunay";
  report.panels = scope_panels(scopes, simulation);
  return report;
}

}  // namespace

Experiment scope_experiment() {
  return {"scope", "How likely triangles and edges are ever to be Delaunay, by scope [GKS92] 2.1, 2.2",
          [](const LabOptions& options) {
            const auto n = static_cast<double>(scope_size(options));
            const int runs = options.runs == 0 ? kUsualRuns : options.runs;
            return 1e-7 * n * n * n * n + (1e-5 * n + 1e-8 * n * n * n) * runs;
          },
          run_scope};
}

}  // namespace delone::lab
