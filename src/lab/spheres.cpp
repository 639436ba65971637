#include "delone/lab/spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "delone/base/errors.hpp"
#include "delone/build/insert.hpp"
#include "delone/io/generate.hpp"
#include "delone/locate/locator.hpp"
#include "delone/order/order.hpp"
#include "lab/experiments.hpp"
#include "lab/growth.hpp"

namespace delone::lab {
namespace {

SpheresRow run_sites(const std::string& kind, bool random, std::size_t n, const SpheresOptions& options, Work& work) {
  const io::Generated made = io::generate(kind, n, 3, options.seed);
  const PointsView points(made.coordinates, 3);
  std::vector<double> tetrahedra, samples, most, last;
  const int runs = kind == "uniform" ? options.runs : random ? options.zeta_runs : 1;
  for (int run = 0; run < runs; ++run) {
    constexpr std::array<int, 3> kAxes{0, 1, 2};
    const Order order = random ? Order::random : Order::input;
    const Appeared a = count_appeared(points, ordered_rows(order, points, kAxes, run_seed(options.seed, run)));
    tetrahedra.push_back(a.tetrahedra);
    samples.push_back(a.samples);
    most.push_back(a.most);
    last.push_back(a.last);
    work.done(a.tetrahedra);
  }
  return {kind, random, n, estimate(tetrahedra), estimate(samples), estimate(most), estimate(last)};
}

/// Tetrahedra that a uniform point far from the boundary ends: 4 * 24 pi^2 / 35.
constexpr double kStar = 27.0709;
double square(std::size_t n) { return static_cast<double>(n) * static_cast<double>(n); }

double work_of(const SpheresOptions& options) {
  double tetrahedra = 0;
  for (const std::size_t n : options.uniform_sizes) tetrahedra += kStar * static_cast<double>(n) * options.runs;
  for (const std::size_t n : options.zeta_sizes) tetrahedra += square(n) * (0.25 + options.zeta_runs / 6.0);
  return tetrahedra;
}

}  // namespace

double zeta_before(std::size_t n) { return square(n - 3) / 4; }
double zeta_after(std::size_t n) { return 2 * static_cast<double>(n) - 6; }

Appeared count_appeared(PointsView points, std::span<const Index> order) {
  AnyTriangulation t(3);
  Appeared appeared;
  CellId near = kNoCell;
  const auto see = [&](const Edit& e) {
    near = e.rebuilt || e.created.empty() ? kNoCell : e.created.front();
    if (t.affine_dimension() < 3) return;
    if (e.rebuilt) {  // the point left the flat of all before: it is a corner of all there is now
      appeared.tetrahedra += static_cast<double>(t.cell_count());
      return;
    }
    for (const CellId c : e.created) appeared.tetrahedra += t.complex().is_ghost(c) ? 0 : 1;
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    insert(t, points[order[i]], 0.0, {.near = near, .on_edit = see});
    if (t.affine_dimension() < 3) continue;
    appeared.last = static_cast<double>(t.cell_count());
    appeared.most = std::max(appeared.most, appeared.last);
    appeared.samples += 4 * appeared.last / static_cast<double>(i + 1);
  }
  return appeared;
}

std::vector<SpheresRow> run_spheres(const SpheresOptions& options) {
  Work work(options.progress, work_of(options));
  std::vector<SpheresRow> rows;
  for (const std::size_t n : options.uniform_sizes) rows.push_back(run_sites("uniform", true, n, options, work));
  for (const bool random : {false, true}) {
    for (const std::size_t n : options.zeta_sizes) rows.push_back(run_sites("gks-zeta", random, n, options, work));
  }
  return rows;
}

namespace {

constexpr std::size_t kUsualSize = 10000, kUsualZetaSize = 1025;
constexpr int kUsualRuns = 20, kZetaRunsPerRun = 5;

SpheresOptions spheres_options(const LabOptions& options) {
  const std::size_t n = options.n == 0 ? kUsualSize : options.n;
  if (n < 20) throw InputError("lab spheres: growth is seen from 20 points on, not of " + std::to_string(n));
  SpheresOptions chosen;
  chosen.uniform_sizes = sizes_up_to(n, 100, 10);
  chosen.zeta_sizes.clear();
  for (std::size_t half = 32; 2 * half < std::min(n, kUsualZetaSize); half *= 2)
    chosen.zeta_sizes.push_back(2 * half + 1);
  if (chosen.zeta_sizes.empty()) chosen.zeta_sizes = {n % 2 == 1 ? n : n - 1};
  chosen.runs = options.runs == 0 ? kUsualRuns : options.runs;
  chosen.zeta_runs = kZetaRunsPerRun * chosen.runs;
  chosen.seed = options.seed;
  chosen.progress = options.progress;
  return chosen;
}

std::string name_of(const SpheresRow& row) { return row.kind + (row.random ? ", random order" : ", zeta last"); }

using Curve = std::vector<std::array<double, 2>>;

Curve curve_of(std::span<const SpheresRow> rows, const Estimate SpheresRow::*value) {
  Curve curve;
  for (const SpheresRow& row : rows) curve.push_back({static_cast<double>(row.n), (row.*value).mean});
  return curve;
}

/// What the theorems say of one row.
std::vector<Value> expected_of(const SpheresRow& row) {
  if (row.kind == "uniform") return {row.tetrahedra.mean / static_cast<double>(row.n), kStar};
  if (row.random) return {square(row.n) / 6, zeta_after(row.n)};
  return {zeta_before(row.n) + zeta_after(row.n), zeta_after(row.n)};
}

std::vector<std::string> expected_names(const SpheresRow& row) {
  if (row.kind == "uniform") return {"appeared / n", "96 pi^2 / 35"};
  if (row.random) return {"n^2 / 6", "2n - 6"};
  return {"((n-3)/2)^2 + 2n - 6", "2n - 6"};
}

/// Rows of one kind and order with their exponents below.
LabTable spheres_table(std::span<const SpheresRow> rows) {
  const bool random = rows.front().random;
  const auto power = [&](const Estimate SpheresRow::*value) { return exponent(curve_of(rows, value)); };
  LabTable table;
  table.title = name_of(rows.front());
  table.columns = {"n", "appeared"};
  std::vector<Value> exponents{"exponent", power(&SpheresRow::tetrahedra)};
  if (random) {
    table.columns.insert(table.columns.end(), {"spread", "sum of 4 F(r) / r", "spread"});
    exponents.insert(exponents.end(), {"", power(&SpheresRow::samples), ""});
  }
  table.columns.insert(table.columns.end(), {"most at a time", "in the end"});
  exponents.insert(exponents.end(), {power(&SpheresRow::most), power(&SpheresRow::last)});
  for (const std::string& name : expected_names(rows.front())) {
    table.columns.push_back(name);
    exponents.emplace_back("");
  }
  for (const SpheresRow& row : rows) {
    std::vector<Value> line{static_cast<double>(row.n), row.tetrahedra.mean};
    if (random) line.insert(line.end(), {row.tetrahedra.deviation, row.samples.mean, row.samples.deviation});
    line.insert(line.end(), {row.most.mean, row.last.mean});
    for (Value& value : expected_of(row)) line.push_back(std::move(value));
    table.rows.push_back(std::move(line));
  }
  table.rows.push_back(std::move(exponents));
  return table;
}

Panel spheres_panel(std::span<const SpheresRow> rows) {
  Panel panel{name_of(rows.front()), {"sites", true}, {"thousand tetrahedra", true}, {}};
  const auto add = [&](const char* name, Curve curve, bool dashed) {
    for (auto& point : curve) point[1] /= 1000;
    panel.series.push_back({name, std::move(curve), dashed});
  };
  add("appeared", curve_of(rows, &SpheresRow::tetrahedra), false);
  if (rows.front().random) add("sum of 4 F(r) / r", curve_of(rows, &SpheresRow::samples), true);
  if (rows.front().kind != "uniform") add("most at a time", curve_of(rows, &SpheresRow::most), false);
  add("in the end", curve_of(rows, &SpheresRow::last), false);
  if (rows.front().kind == "uniform") return panel;
  Curve squares;
  for (const SpheresRow& row : rows) squares.push_back({static_cast<double>(row.n), square(row.n) / 4});
  add("n^2 / 4", std::move(squares), true);
  return panel;
}

LabReport run_report(const LabOptions& options) {
  const std::vector<SpheresRow> rows = run_spheres(spheres_options(options));
  LabReport report;
  report.heading =
      "[GKS92] theorems 4.6 and 4.7: random insertion in space is expected to create O(n^2) tetrahedra, and by "
      "looking\n"
      "backward exactly the sum of 4 F(r) / r, where F(r) is the expected size for r random sites. The points of 4.3\n"
      "(kind gks-zeta) have few tetrahedra in the end and n^2 / 4 before zeta comes; in random order about n^2 / 6 "
      "appear.";
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t end = first;
    while (end < rows.size() && name_of(rows[end]) == name_of(rows[first])) ++end;
    const auto group = std::span(rows).subspan(first, end - first);
    report.tables.push_back(spheres_table(group));
    report.panels.push_back(spheres_panel(group));
    first = end;
  }
  report.chart_title = "Tetrahedra created by inserting sites one by one";
  return report;
}

}  // namespace

Experiment spheres_experiment() {
  return {"spheres", "Tetrahedra ever created by insertion in space [GKS92] 4.3",
          [](const LabOptions& options) { return 5e-7 * work_of(spheres_options(options)); }, run_report};
}

}  // namespace delone::lab
