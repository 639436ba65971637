#include "delone/lab/arithmetic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <string>
#include <utility>

#include "delone/base/assert.hpp"
#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/exact/determinant.hpp"
#include "delone/io/generate.hpp"
#include "lab/experiments.hpp"

namespace delone::lab {
namespace {

/// Bits before the point of |x| / 2^unit. Determinants of long doubles are exact enough for that.
int bits_of(long double x, int unit) {
  if (x == 0) return 0;
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::max(exponent - unit, 0);
}

template <int K>
using Rows = Matrix<K + 1, long double>;

/// Differences to the first of K + 2 sites, and their heights over it.
template <int K>
Rows<K> lifted_differences(const Sites& sites, const std::array<VertexId, K + 2>& v) {
  Rows<K> rows{};
  for (std::size_t i = 0; i <= K; ++i) {
    for (int axis = 0; axis < K; ++axis) {
      const long double d = static_cast<long double>(sites.coordinate(v[i + 1], axis)) - sites.coordinate(v[0], axis);
      rows[i][static_cast<std::size_t>(axis)] = d;
      rows[i][K] += d * d;
    }
  }
  return rows;
}

template <int K>
void measure_bits(const AnyTriangulation& t, StageCounts& counts) {
  const ConstComplexView<K> complex(t.complex());
  const int unit = t.sites().range().unit;
  counts.input_bits = bits_of(t.sites().range().magnitude, unit);
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c) || complex.is_ghost(c)) continue;
    for (int i = 0; i <= K; ++i) {
      const FacetId across = complex.twin(c, i);
      if (complex.is_ghost(complex.cell(across))) continue;
      std::array<VertexId, K + 2> v;
      std::ranges::copy(complex.vertices(c), v.begin());
      v[K + 1] = complex.vertex(across);
      const Rows<K> rows = lifted_differences<K>(t.sites(), v);
      Matrix<K, long double> plain{};
      for (std::size_t row = 0; row < K; ++row) std::copy_n(rows[row].begin(), K, plain[row].begin());
      counts.orient_bits = std::max(counts.orient_bits, bits_of(determinant<K>(plain), unit * K));
      counts.conflict_bits = std::max(counts.conflict_bits, bits_of(determinant<K + 1>(rows), unit * (K + 2)));
    }
  }
}

/// Tests every cell against the sites beyond its facets, again and again for about 20 ms.
template <int K>
double time_of_test(const AnyTriangulation& t) {
  const ConstComplexView<K> complex(t.complex());
  Kernel<K> kernel(t.sites());
  std::vector<std::pair<std::array<VertexId, K + 1>, VertexId>> tests;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c) || complex.is_ghost(c)) continue;
    for (int i = 0; i <= K; ++i) {
      const FacetId across = complex.twin(c, i);
      if (!complex.is_ghost(complex.cell(across))) tests.emplace_back(complex.vertices(c), complex.vertex(across));
    }
  }
  if (tests.empty()) return 0;
  std::size_t conflicts = 0, rounds = 0;
  const std::clock_t start = std::clock();
  std::clock_t now = start;
  for (; now - start < CLOCKS_PER_SEC / 50; now = std::clock(), ++rounds) {
    for (const auto& [cell, site] : tests) conflicts += kernel.conflict(cell, site) ? 1 : 0;
  }
  DELONE_ASSERT(conflicts == 0, "the triangulation is Delaunay's");
  return 1e9 * static_cast<double>(now - start) / CLOCKS_PER_SEC / static_cast<double>(rounds * tests.size());
}

StageCounts count_stages(const std::string& kind, int dimension, std::size_t n, int bits, std::uint64_t seed,
                         bool timed) {
  const io::Generated made = io::generate(kind, n, dimension, seed, bits);
  const AnyTriangulation t = build(PointsView(made.coordinates, dimension), {.method = Method::cavity});
  StageCounts counts{.kind = kind, .dimension = dimension, .rounded_to = bits, .n = n, .tests = {}};
  counts.tests = t.statistics().predicates;
  if (t.affine_dimension() == 2 && dimension == 2) {
    measure_bits<2>(t, counts);
    if (timed) counts.nanoseconds = time_of_test<2>(t);
  } else if (t.affine_dimension() == 3) {
    measure_bits<3>(t, counts);
    if (timed) counts.nanoseconds = time_of_test<3>(t);
  }
  return counts;
}

/// With a number of tetrahedra like n^2.
bool is_square(const std::string& kind, int dimension) {
  return dimension == 3 && (kind == "skew" || kind == "gks-zeta" || kind == "moment");
}

}  // namespace

// A difference has b + 1 bits. d rows of d of them, each shorter than sqrt(d) 2^(b+1): Hadamard.
int orient_bits_bound(int dimension, int input_bits) {
  const double d = dimension;
  return static_cast<int>(std::ceil(d * (input_bits + 1) + d / 2 * std::log2(d)));
}
// d + 1 rows; along the column of heights, each at most d 4^(b+1), there are d + 1 minors as above.
int conflict_bits_bound(int dimension, int input_bits) {
  const double d = dimension;
  return static_cast<int>(
      std::ceil((d + 2) * (input_bits + 1) + d / 2 * std::log2(d) + std::log2(d) + std::log2(d + 1)));
}

std::vector<StageCounts> run_arithmetic(const ArithmeticOptions& options) {
  std::vector<StageCounts> all;
  std::vector<std::pair<std::string, int>> sets;
  for (const int dimension : {2, 3}) {
    for (const std::string& kind : io::kinds()) {
      const io::KindInfo info = io::kind_info(kind);
      if (info.least_dimension <= dimension && dimension <= info.most_dimension) sets.emplace_back(kind, dimension);
    }
  }
  for (const auto& [kind, dimension] : sets) {
    for (const int bits : options.bits) {
      const std::size_t n = is_square(kind, dimension) ? options.n_square : options.n;
      all.push_back(count_stages(kind, dimension, n, bits, options.seed, options.timed));
    }
    const auto done = static_cast<double>(all.size()) / static_cast<double>(sets.size() * options.bits.size());
    if (options.progress && !options.progress(done)) throw Cancelled();
  }
  return all;
}

namespace {

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

Value rounding(const StageCounts& c) { return c.rounded_to == 0 ? Value("-") : Value(double(c.rounded_to)); }

LabTable stages_table(const std::vector<StageCounts>& all, int dimension) {
  LabTable table{.title = fmt::format("Percent of the tests that each stage decides, d = {}", dimension),
                 .columns = {"points", "bits", "n", "orient by site", "filter", "exact", "conflict by site", "filter",
                             "adaptive", "exact", "symbolic", "ns by test"},
                 .rows = {},
                 .note = {}};
  for (const StageCounts& c : all) {
    if (c.dimension != dimension) continue;
    const auto n = static_cast<double>(c.n);
    const PredicateStats& s = c.tests;
    table.rows.push_back({c.kind, rounding(c), n, static_cast<double>(c.orients()) / n,
                          percent(s.orient_filter, c.orients()), percent(s.orient_exact, c.orients()),
                          static_cast<double>(c.conflicts()) / n, percent(s.conflict_filter, c.conflicts()),
                          percent(s.conflict_adaptive, c.conflicts()), percent(s.conflict_exact, c.conflicts()),
                          percent(s.conflict_symbolic, c.conflicts()), c.nanoseconds});
  }
  table.note = "ns by test: of each cell against the site beyond each of its facets, on this machine.";
  return table;
}

LabTable bits_table(const std::vector<StageCounts>& all) {
  LabTable table{
      .title = "Bits of the coordinates, and of the largest determinant of cells that are neighbours",
      .columns = {"points", "d", "bits", "input b", "orient", "d b", "at most", "conflict", "(d + 2) b", "at most"},
      .rows = {},
      .note = "A double holds 53 bits, an adaptive stage of integers 127."};
  for (const StageCounts& c : all) {
    if (c.input_bits == 0) continue;
    table.rows.push_back({c.kind, static_cast<double>(c.dimension), rounding(c), static_cast<double>(c.input_bits),
                          static_cast<double>(c.orient_bits), static_cast<double>(c.dimension * c.input_bits),
                          static_cast<double>(orient_bits_bound(c.dimension, c.input_bits)),
                          static_cast<double>(c.conflict_bits), static_cast<double>((c.dimension + 2) * c.input_bits),
                          static_cast<double>(conflict_bits_bound(c.dimension, c.input_bits))});
  }
  return table;
}

/// Bits of determinants of uniform points by the bits that these are rounded to.
Panel bits_panel(int dimension, std::size_t n, std::uint64_t seed) {
  Panel panel{fmt::format("Uniform points, d = {}", dimension), {"bits of a coordinate"}, {"bits"}, {}};
  Series orient{"orient, largest", {}}, conflict{"conflict, largest", {}};
  Series orient_law{"bound", {}, true}, conflict_law{"bound", {}, true};
  for (int bits = 8; bits <= 52; bits += 4) {
    const StageCounts c = count_stages("uniform", dimension, n, bits, seed, false);
    const double b = bits;
    orient.points.push_back({b, static_cast<double>(c.orient_bits)});
    conflict.points.push_back({b, static_cast<double>(c.conflict_bits)});
    orient_law.points.push_back({b, static_cast<double>(orient_bits_bound(dimension, bits))});
    conflict_law.points.push_back({b, static_cast<double>(conflict_bits_bound(dimension, bits))});
  }
  panel.series = {orient, conflict, orient_law, conflict_law};
  return panel;
}

/// Percent of the conflict tests past the filter.
Panel slow_panel(std::size_t n, std::uint64_t seed) {
  Panel panel{"Conflict tests past the filter, d = 3", {"bits of a coordinate"}, {"percent"}, {}};
  for (const std::string kind : {"uniform", "sphere"}) {
    Series line{kind, {}};
    for (int bits = 8; bits <= 52; bits += 4) {
      const StageCounts c = count_stages(kind, 3, n, bits, seed, false);
      line.points.push_back({double(bits), percent(c.conflicts() - c.tests.conflict_filter, c.conflicts())});
    }
    panel.series.push_back(line);
  }
  return panel;
}

ArithmeticOptions how(const LabOptions& options) {
  ArithmeticOptions result;
  if (options.n != 0) result.n = options.n;
  result.n_square = std::min<std::size_t>(result.n, 1000);
  result.seed = options.seed;
  result.timed = true;
  result.progress = options.progress;
  return result;
}

LabReport report(const LabOptions& options) {
  if (options.n != 0 && options.n < 20) throw InputError("lab arithmetic: at least 20 points");
  const ArithmeticOptions counting = how(options);
  const std::vector<StageCounts> all = run_arithmetic(counting);
  LabReport report;
  report.heading =
      "[For92] 4.7: a determinant of degree k in b-bit numbers takes about k b bits; k is d for orientation and d + 2\n"
      "for a conflict with a circumscribing sphere. [Dev97] 5.2, 5.3: 2 and 4 in the plane, where on integers of 24 "
      "bits\n"
      "doubles are exact for the one and almost never fail for the other; a filter finds out, and only what it leaves\n"
      "is computed exactly.";
  report.tables = {stages_table(all, 2), stages_table(all, 3), bits_table(all)};
  report.chart_title = "Which arithmetic decides";
  const std::size_t n = std::min<std::size_t>(counting.n, 3000);
  report.panels = {bits_panel(2, n, options.seed), bits_panel(3, n, options.seed), slow_panel(n, options.seed)};
  return report;
}

}  // namespace

Experiment arithmetic_experiment() {
  return {.name = "arithmetic",
          .text = "How many tests each stage of the predicates decides, and how long numbers get",
          .seconds = [](const LabOptions& options) { return 8 + 1e-3 * static_cast<double>(how(options).n); },
          .run = report};
}

}  // namespace delone::lab
