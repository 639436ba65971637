// delone bench fortune: every method beside the others, beside the figures of 1992, and beside CGAL and Qhull.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "bench.hpp"
#include "delone/base/errors.hpp"
#include "delone/lab/chart.hpp"
#include "delone/lab/fortune.hpp"
#include "delone/lab/machine.hpp"
#include "delone/lab/race.hpp"
#include "interrupt.hpp"
#include "progress.hpp"

namespace delone::cli {
namespace {

using lab::Contestant;
using lab::MethodRun;

struct Options {
  std::vector<std::string> sizes, methods;
  std::string worker, csv, svg;
  double limit = 20;
  std::uint64_t seed = 1;
  bool quick = false, flipping = false;
};

/// A line of a table: a method or a rival on one kind of points, by size.
struct Line {
  std::string kind, name;
  int dimension = 2, lines = 0, lines_1992 = 0;
  std::vector<std::size_t> points = {};
  std::vector<double> seconds = {}, seconds_1992 = {};  ///< NaN where there is none
  std::size_t cells = 0;                                ///< of the largest size
};

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

std::vector<Line> lines_of(const std::vector<MethodRun>& runs) {
  std::vector<Line> lines;
  for (const MethodRun& run : runs) {
    const std::string name = info(run.method).name;
    if (lines.empty() || lines.back().name != name || lines.back().dimension != run.dimension ||
        lines.back().kind != run.kind)
      lines.push_back({.kind = run.kind,
                       .name = name,
                       .dimension = run.dimension,
                       .lines = lab::source_lines(run.method),
                       .lines_1992 = lab::lines_1992(run.method)});
    Line& line = lines.back();
    const double old = run.kind == "uniform" ? lab::seconds_1992(run.method, run.dimension, run.points) : 0;
    line.points.push_back(run.points);
    line.seconds.push_back(run.skipped ? kMissing : run.seconds);
    line.seconds_1992.push_back(old > 0 ? old : kMissing);
    if (!run.skipped) line.cells = run.cells;
  }
  return lines;
}

/// CGAL and Qhull on the same kinds and sizes, where there is a worker to run them.
std::vector<Line> rivals(const lab::FortuneOptions& options, const std::string& worker) {
  std::vector<Line> lines;
  for (const int dimension : options.dimensions) {
    for (const std::string& kind : options.kinds) {
      for (const char* peer : {"CGAL", "Qhull"}) {
        Line line{.kind = kind, .name = peer, .dimension = dimension};
        for (const std::size_t n : options.sizes) {
          line.points.push_back(n);
          line.seconds_1992.push_back(kMissing);
          const bool slow = !line.seconds.empty() && !(line.seconds.back() * 5 < options.limit);
          std::vector<Contestant> one{
              {peer, worker, peer, {.title = kind, .kind = kind, .n = n, .dimension = dimension}, {}, true}};
          if (!slow) lab::alternate(one, 1, [](const Contestant&) {});
          line.seconds.push_back(slow || one.front().failed ? kMissing : one.front().seconds().median);
        }
        lines.push_back(std::move(line));
      }
    }
  }
  return lines;
}

std::string seconds_text(double seconds, double before) {
  if (std::isnan(seconds)) return std::isnan(before) ? "-" : fmt::format("- ({:g})", before);
  return fmt::format("{:#.3g}", seconds) + (std::isnan(before) ? "" : fmt::format(" ({:g})", before));
}

std::string count_text(int lines, int before) {
  if (lines == 0) return "";
  return std::to_string(lines) + (before == 0 ? "" : fmt::format(" ({})", before));
}

std::string table(const std::vector<Line>& lines, const std::string& kind, int dimension) {
  std::string text;
  for (const Line& line : lines) {
    if (line.kind != kind || line.dimension != dimension) continue;
    if (text.empty()) {
      text = fmt::format("\n{}, {} dimensions\n{:<18}{:>12}", kind, dimension, "", "lines");
      for (const std::size_t n : line.points) text += fmt::format("{:>16}", grouped(n));
      text += "\n";
    }
    text += fmt::format("{:<18}{:>12}", line.name, count_text(line.lines, line.lines_1992));
    for (std::size_t i = 0; i < line.points.size(); ++i)
      text += fmt::format("{:>16}", seconds_text(line.seconds[i], line.seconds_1992[i]));
    text += "\n";
  }
  return text;
}

std::string to_csv(const std::vector<Line>& lines) {
  std::string text = "kind,dimension,method,lines,lines_1992,points,seconds,seconds_1992\n";
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const auto number = [](double x) { return std::isnan(x) ? std::string() : fmt::format("{:.6g}", x); };
      text += fmt::format("{},{},{},{},{},{},{},{}\n", line.kind, line.dimension, line.name, line.lines,
                          line.lines_1992, line.points[i], number(line.seconds[i]), number(line.seconds_1992[i]));
    }
  }
  return text;
}

std::string to_svg(const std::vector<Line>& lines) {
  std::vector<lab::Panel> panels;
  for (const Line& line : lines) {
    const std::string title = fmt::format("{}, {}D", line.kind, line.dimension);
    if (std::ranges::find(panels, title, &lab::Panel::title) == panels.end())
      panels.push_back({title, {"points", true}, {"seconds", true}, {}});
    lab::Series series{line.name, {}, line.lines == 0};
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      if (!std::isnan(line.seconds[i])) series.points.push_back({static_cast<double>(line.points[i]), line.seconds[i]});
    }
    std::ranges::find(panels, title, &lab::Panel::title)->series.push_back(std::move(series));
  }
  return lab::draw_chart("Every method, in turn", panels, 2);
}

lab::FortuneOptions experiment(const Options& options) {
  lab::FortuneOptions how;
  how.limit = options.quick ? std::min(options.limit, 2.0) : options.limit;
  how.seed = options.seed;
  how.methods = lab::all_methods();
  if (options.flipping) {
    how.methods = {Method::flip, Method::conflict_graph, Method::shelling};
    how.kinds = {"uniform", "sphere", "moment"};
    how.dimensions = {2, 3, 4, 5, 6};
    how.sizes = {50, 100, 200, 500, 1000, 2000};
  }
  if (options.quick)
    how.sizes = options.flipping ? std::vector<std::size_t>{50, 100} : std::vector<std::size_t>{500, 1000};
  if (!options.methods.empty()) how.methods.clear();
  for (const std::string& method : options.methods) how.methods.push_back(method_named(method));
  if (!options.sizes.empty()) how.sizes.clear();
  for (const std::string& size : options.sizes) how.sizes.push_back(parse_size("--sizes", size));
  std::ranges::sort(how.sizes);
  return how;
}

int run(const Options& options) {
  if (!(options.limit > 0)) throw UsageError("--limit: expected seconds, more than 0");
  require_writable_outputs(options.csv, options.svg);
  lab::FortuneOptions how = experiment(options);
  const std::optional<std::string> worker = find_worker(options.worker);
  ProgressBar bar("measuring");
  const Progress progress = bar.callback();
  double done = 0;
  double all = 0;
  for (const Method method : how.methods) {
    for (const int d : how.dimensions) {
      if (d >= info(method).least_dimension && d <= info(method).most_dimension)
        all += static_cast<double>(how.kinds.size() * how.sizes.size());
    }
  }
  how.on_run = [&](const MethodRun&) {
    if (!progress(std::min(1.0, ++done / all))) throw Cancelled();
  };
  std::vector<Line> lines = lines_of(lab::run_methods(how));
  if (worker) {
    const DeferInterrupt defer;
    const std::vector<Line> others = rivals(how, *worker);
    if (interrupted() != 0) throw Cancelled();
    lines.insert(lines.end(), others.begin(), others.end());
  }
  std::string text = fmt::format(
      "{}, {}\n{}\nSeconds of processor time for one triangulation; lines of source without blanks and comments.\n",
      lab::machine(), lab::today(),
      options.flipping ? "[ES96] 10: flipping beside Clarkson and Shor, and Seidel."
                       : "[For92] figure 12, in brackets the figures of 1992 (VAX 8550), and all other methods.");
  for (const int dimension : how.dimensions) {
    for (const std::string& kind : how.kinds) text += table(lines, kind, dimension);
  }
  if (!worker) text += "\nCGAL and Qhull are not here: `make bench-worker` builds the program that holds them.\n";
  print(text);
  write_outputs(options.csv, to_csv(lines), options.svg, to_svg(lines));
  return kDone;
}

}  // namespace

void add_bench_fortune(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = bench.add_subcommand("fortune", "All methods in turn, beside figure 12 of [For92]");
  command->add_option("--sizes", options->sizes, "Numbers of points [500,1000,5000,10000,50000]")
      ->delimiter(',')
      ->option_text("N,N");
  command->add_option("--methods", options->methods, "Methods [all]")->delimiter(',')->option_text("M,M");
  command->add_option("--limit", options->limit, "Seconds for one entry; longer ones are left out [20]")
      ->option_text("SECONDS");
  command->add_option("--seed", options->seed, "Of points and random orders [1]")
      ->check(CLI::NonNegativeNumber)
      ->option_text("S");
  command->add_option("--worker", options->worker, "The program that `make bench-worker` builds")->option_text("PATH");
  command->add_flag("--flipping", options->flipping, "What [ES96] 10 asks for: flipping, Clarkson and Shor, Seidel");
  command->add_flag("--quick", options->quick, "Few points: some seconds in all");
  command->add_option("--csv", options->csv, "Write the numbers")->option_text("FILE");
  command->add_option("--svg", options->svg, "Draw them")->option_text("FILE");
  command->footer(
      "Examples:\n"
      "  delone bench fortune --quick\n"
      "  delone bench fortune --flipping --svg flipping.svg");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
