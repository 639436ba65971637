#include "delone/lab/fortune.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <utility>

#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"

namespace delone::lab {
namespace {

constexpr std::array<std::size_t, 5> kSizes{500, 1000, 5000, 10000, 50000};

/// A line of figure 12.
struct PaperLine {
  Method method;
  int lines, dimension;
  std::array<double, 5> seconds;  // 0 where there is a dash
};
constexpr std::array<PaperLine, 7> kPaper{{
    {Method::lawson, 300, 2, {2.1, 4.5, 26.2, 59.3, 316.9}},
    {Method::divide_conquer, 900, 2, {2.0, 3.8, 21.5, 42.3, 222.0}},
    {Method::sweep, 900, 2, {1.2, 2.5, 12.1, 24.1, 128.0}},
    {Method::history_simplices, 1500, 2, {2.2, 4.5, 24.2, 51.0, 285.0}},
    {Method::history_simplices, 1500, 3, {8.4, 18.5, 102.4, 210.0, 0}},
    {Method::history_simplices, 1500, 4, {45.3, 103.0, 638.0, 0, 0}},
    {Method::history_simplices, 1500, 5, {287.0, 0, 0, 0, 0}},
}};

/// Counted when the build is configured.
constexpr std::array kSourceLines{DELONE_SOURCE_LINES};
constexpr std::array<Method, kSourceLines.size()> kCounted{
    Method::cavity, Method::divide_conquer, Method::flip,      Method::history_simplices, Method::conflict_graph,
    Method::lawson, Method::sweep,          Method::gift_wrap, Method::shelling};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void measure(MethodRun& run, PointsView points, const FortuneOptions& options) {
  int builds = 0;
  const double start = processor_seconds();
  double seconds = 0;
  do {
    run.cells = build(points, {.method = run.method, .seed = options.seed}).cell_count();
    ++builds;
    seconds = processor_seconds() - start;
  } while (seconds < options.enough);
  run.seconds = seconds / builds;
}

/// What a run of that size is likely to take, from the one before: no less than quadratic where cells are many.
double expected_seconds(const MethodRun& last, std::size_t points) {
  const double growth = static_cast<double>(points) / static_cast<double>(last.points);
  const double crowded = static_cast<double>(last.cells) / (20.0 * static_cast<double>(last.points));
  return last.seconds * std::pow(growth, crowded > last.dimension ? 2.0 : 1.2);
}

}  // namespace

std::vector<Method> all_methods() {
  std::vector<Method> all;
  for (const MethodInfo& method : methods()) {
    if (method.method != Method::automatic) all.push_back(method.method);
  }
  return all;
}

double seconds_1992(Method method, int dimension, std::size_t points) {
  for (const PaperLine& line : kPaper) {
    if (line.method != method || line.dimension != dimension) continue;
    const auto size = std::ranges::find(kSizes, points);
    if (size != kSizes.end()) return line.seconds[static_cast<std::size_t>(size - kSizes.begin())];
  }
  return 0;
}

int lines_1992(Method method) {
  const auto line = std::ranges::find(kPaper, method, &PaperLine::method);
  return line == kPaper.end() ? 0 : line->lines;
}

int source_lines(Method method) {
  if (method == Method::flip_loop || method == Method::flip_legalize) method = Method::flip;
  const auto counted = std::ranges::find(kCounted, method);
  return counted == kCounted.end() ? 0 : kSourceLines[static_cast<std::size_t>(counted - kCounted.begin())];
}

std::vector<MethodRun> run_methods(const FortuneOptions& options) {
  std::vector<MethodRun> runs;
  std::vector<std::size_t> sizes = options.sizes;
  std::ranges::sort(sizes);
  for (const int dimension : options.dimensions) {
    for (const std::string& kind : options.kinds) {
      for (const Method method : options.methods) {
        const MethodInfo& served = info(method);
        if (dimension < served.least_dimension || dimension > served.most_dimension) continue;
        const MethodRun* last = nullptr;
        std::vector<MethodRun> row;
        row.reserve(sizes.size());
        for (const std::size_t n : sizes) {
          MethodRun run{.method = method, .kind = kind, .dimension = dimension, .points = n};
          if (last != nullptr && (last->skipped || expected_seconds(*last, n) > options.limit)) {
            run.skipped = true;
          } else {
            const io::Generated made = io::generate(kind, n, dimension, options.seed);
            measure(run, PointsView(made.coordinates, dimension), options);
          }
          if (options.on_run) options.on_run(run);
          row.push_back(std::move(run));
          last = &row.back();
        }
        runs.insert(runs.end(), row.begin(), row.end());
      }
    }
  }
  return runs;
}

}  // namespace delone::lab
