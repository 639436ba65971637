#include "delone/lab/devillers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <optional>
#include <utility>

#include "delone/base/errors.hpp"
#include "delone/base/random.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/mesh/export.hpp"

namespace delone::lab {
namespace {

constexpr int kBits = 24;
constexpr std::size_t kMethods = 4;

/// The table of [Dev97] 5.5.2: seconds on a Sun Ultra 1 at 200 MHz; 0 where it says "long".
struct PaperRow {
  const char* distribution;
  std::size_t points;
  std::array<double, kMethods> seconds;
};
constexpr std::array<PaperRow, 15> kPaper{{
    {"random", 5000, {0.3, 0.17, 0.15, 0.14}},
    {"random", 50000, {12, 3.8, 2.7, 2.3}},
    {"random", 500000, {460, 72, 36, 31}},
    {"ellipse2", 5000, {0.53, 0.34, 0.21, 0.20}},
    {"ellipse2", 50000, {49, 21, 3.9, 3.5}},
    {"ellipse2", 500000, {930, 760, 57, 49}},
    {"ellipse", 5000, {2.2, 0.46, 0.31, 0.21}},
    {"ellipse", 50000, {187, 21, 3.9, 3.7}},
    {"ellipse", 500000, {0, 270, 54, 55}},
    {"parabola", 5000, {2.5, 0.31, 0.21, 0.16}},
    {"parabola", 50000, {87, 5.9, 3.2, 3.0}},
    {"parabola", 500000, {0, 74, 69, 45}},
    {"circle", 5000, {0.15, 0.13, 0.13, 0.14}},
    {"circle", 50000, {2.4, 2.6, 2.4, 2.4}},
    {"circle", 500000, {39, 44, 36, 36}},
}};

double paper_seconds(const std::string& distribution, std::size_t points, std::size_t method) {
  for (const PaperRow& row : kPaper) {
    if (row.distribution == distribution && row.points == points) return row.seconds[method];
  }
  return 0;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::vector<std::size_t> random_order(std::size_t n, std::uint64_t seed) {
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[mix(mix(seed) + i) % i]);
  return order;
}

double per(std::uint64_t count, std::size_t points) {
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(points, 1));
}

/// Inserts the points in the given order, until the time is over.
void insert_one_by_one(InsertionRun& run, Hierarchy locator, PointsView points, const std::vector<std::size_t>& order,
                       double limit) {
  constexpr std::size_t kTick = 256;
  AnyTriangulation t(points.dimension());
  const double start = processor_seconds();
  std::size_t done = 0;
  for (const std::size_t row : order) {
    insert(t, points[row], 0.0, locator);
    if (++done % kTick == 0 && processor_seconds() - start > limit) break;
  }
  run.seconds = processor_seconds() - start;
  if (done < order.size()) run.measured = Measured::stopped;
  const LocateCounts counts = locator.counts();
  run.steps = per(t.statistics().walk_steps + counts.crossed + counts.turned, done);
  // Every insertion ends with a test of all sides of the cell that was found, one more for every step to it.
  run.orientations = per(t.statistics().walk_steps + done + counts.line_tests + counts.facet_tests, done);
  run.distances = per(counts.distances, done);
  run.levels = locator.level_count() + 1;
  run.locator_bytes = static_cast<double>(locator.memory_bytes()) / static_cast<double>(done);
  run.hash = canonical_hash(t);
}

/// The time of `points` points from those of fewer, along the line through the last two in logarithms; with only one
/// the exponent is 3/2.
std::optional<double> estimate(const std::vector<InsertionRun>& smaller, std::size_t points) {
  if (smaller.empty()) return std::nullopt;
  const auto log_points = [](const InsertionRun& run) { return std::log(static_cast<double>(run.points)); };
  const InsertionRun& last = smaller.back();
  double exponent = 1.5;
  if (smaller.size() > 1) {
    const InsertionRun& before = smaller[smaller.size() - 2];
    exponent = std::log(last.seconds / before.seconds) / (log_points(last) - log_points(before));
  }
  return last.seconds * std::pow(static_cast<double>(points) / static_cast<double>(last.points), exponent);
}

}  // namespace

std::vector<LocationMethod> location_methods(bool straight) {
  std::vector<LocationMethod> methods{{"walk", {}}, {"jump and walk", {}}, {"hierarchy", {}}, {"hierarchy + jump", {}}};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    Hierarchy& locator = methods[i].locator;
    locator.max_levels = i < 2 ? 0 : locator.max_levels;
    locator.jump_and_walk = i % 2 == 1;
    locator.straight = locator.arrive = straight;
  }
  return methods;
}

std::vector<InsertionRun> run_insertions(const InsertionOptions& options) {
  std::vector<InsertionRun> runs;
  std::vector<std::size_t> sizes = options.sizes;
  std::ranges::sort(sizes);
  const std::vector<LocationMethod> methods = location_methods(options.straight);
  for (const std::string& distribution : options.distributions) {
    std::vector<std::vector<InsertionRun>> whole(methods.size());  // entries that ran to their end
    for (const std::size_t n : sizes) {
      const io::Generated made =
          io::generate(distribution == "random" ? "uniform" : distribution, n, 2, options.seed, kBits);
      const std::vector<std::size_t> order = random_order(n, options.seed);
      for (std::size_t m = 0; m < methods.size(); ++m) {
        InsertionRun run{.distribution = distribution, .method = methods[m].name, .points = n};
        run.paper_seconds = paper_seconds(distribution, n, m);
        const std::optional<double> expected = estimate(whole[m], n);
        if (expected && *expected > options.limit) {
          run.measured = Measured::estimated;
          run.seconds = *expected;
        } else {
          insert_one_by_one(run, methods[m].locator, PointsView(made.coordinates, 2), order, options.limit);
        }
        if (run.measured == Measured::whole) whole[m].push_back(run);
        runs.push_back(run);
        if (options.on_run) options.on_run(run);
      }
    }
  }
  return runs;
}

namespace {

/// Weighed as in [Dev97] 4.4: a level takes 5 operations to begin, a test against the fixed line 4, another orientation
/// test 7, a squared distance 5.
double operations(const LocateCounts& counts) {
  return 5.0 * static_cast<double>(counts.levels) + 4.0 * static_cast<double>(counts.line_tests) +
         7.0 * static_cast<double>(counts.facet_tests) + 5.0 * static_cast<double>(counts.distances);
}

void add_size(TuningPoint& point, const AnyTriangulation& t, const TuningOptions& options, std::uint64_t seed) {
  Hierarchy locator;
  locator.ratio = point.ratio;
  locator.jump_and_walk = false;
  locator.arrive = true;
  locator.seed = seed;
  attach(locator, t);
  const io::Generated queries = io::generate("uniform", options.queries, 2, seed + 1000);
  const PointsView at(queries.coordinates, 2);
  for (std::size_t i = 0; i < at.size(); ++i) locator.hint(t, at[i]);
  const LocateCounts counts = locator.counts();
  const double share = 1.0 / (static_cast<double>(options.queries) * static_cast<double>(options.size_count));
  point.levels += share * static_cast<double>(counts.levels);
  point.line_tests += share * static_cast<double>(counts.line_tests);
  point.facet_tests += share * static_cast<double>(counts.facet_tests);
  point.distances += share * static_cast<double>(counts.distances);
  point.operations += share * operations(counts);
  point.per_logarithm += share * operations(counts) / std::log2(static_cast<double>(t.vertex_count()));
}

}  // namespace

std::vector<TuningPoint> run_tuning(const TuningOptions& options) {
  std::vector<TuningPoint> curve(options.ratios.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve[i].ratio = options.ratios[i];
    // [Dev97] 4.4 adds 5 + 4 * 3 + 5 * 3 to 32 and goes on with 29; its minimum and its range follow from 32.
    // Departure from [Dev97] 4.4, in the second curve: by 4.2 a march crosses 2 sqrt(ratio / pi) edges and makes two
    // tests at each, (4 + 7) * 2 sqrt(ratio / pi) operations; 4.4 goes on with half of that.
    const double root = std::sqrt(curve[i].ratio);
    curve[i].paper_per_logarithm = (32 + 6.2 * root) / std::log2(curve[i].ratio);
    curve[i].doubled_per_logarithm = (32 + 12.4 * root) / std::log2(curve[i].ratio);
  }
  const double span = static_cast<double>(options.most_size) / static_cast<double>(options.least_size);
  for (std::size_t s = 0; s < options.size_count; ++s) {
    const double part =
        options.size_count == 1 ? 0 : static_cast<double>(s) / static_cast<double>(options.size_count - 1);
    const auto n = static_cast<std::size_t>(static_cast<double>(options.least_size) * std::pow(span, part));
    const io::Generated made = io::generate("uniform", n, 2, options.seed + s);
    const AnyTriangulation t = build(PointsView(made.coordinates, 2));
    for (std::size_t i = 0; i < curve.size(); ++i) {
      add_size(curve[i], t, options, options.seed + s);
      const double done =
          static_cast<double>(s * curve.size() + i + 1) / static_cast<double>(options.size_count * curve.size());
      if (options.progress && !options.progress(done)) throw Cancelled();
    }
  }
  return curve;
}

}  // namespace delone::lab
