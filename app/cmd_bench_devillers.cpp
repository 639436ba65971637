// delone bench devillers: the experiments of [Dev97], run again on this machine.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "bench.hpp"
#include "delone/base/errors.hpp"
#include "delone/lab/chart.hpp"
#include "delone/lab/devillers.hpp"
#include "progress.hpp"

namespace delone::cli {
namespace {

using lab::InsertionRun;
using lab::Measured;
using lab::TuningPoint;

struct Options {
  std::vector<std::string> sizes, distributions;
  double limit = 120;
  std::uint64_t seed = 1;
  bool quick = false, tuning = false, visibility = false;
  std::string csv, svg;
};

std::string seconds_text(double seconds) {
  return fmt::format(fmt::runtime(seconds < 1 ? "{:.3f}" : seconds < 10 ? "{:.2f}" : "{:.0f}"), seconds);
}

/// "~" is an estimate from smaller sizes, ">" a run that was stopped.
std::string time_text(const InsertionRun& run) {
  return (run.measured == Measured::estimated ? "~"
          : run.measured == Measured::stopped ? ">"
                                              : "") +
         seconds_text(run.seconds);
}

std::string paper_text(double seconds) { return seconds > 0 ? fmt::format("{:g}", seconds) : "-"; }

std::string operations_text(const InsertionRun& run) {
  if (run.measured == Measured::estimated) return "-";
  return fmt::format("{:.0f} / {:.0f} / {:.0f}", run.steps, run.orientations, run.distances);
}

/// A line for the runs of one distribution and size.
template <class Cell>
std::string table_line(std::span<const InsertionRun> runs, int width, const Cell& cell) {
  std::string line = fmt::format("{:<9}{:>9}", runs.front().distribution, grouped(runs.front().points));
  for (const InsertionRun& run : runs) line += fmt::format("{:>{}}", cell(run), width);
  return line + "\n";
}

template <class Cell>
std::string table(const std::vector<InsertionRun>& runs, std::size_t methods, int width, const Cell& cell) {
  std::string text = fmt::format("{:<9}{:>9}", "", "points");
  for (std::size_t m = 0; m < methods; ++m) text += fmt::format("{:>{}}", runs[m].method, width);
  text += "\n";
  for (std::size_t i = 0; i < runs.size(); i += methods)
    text += table_line(std::span(runs).subspan(i, methods), width,
                       [&](const InsertionRun& run) { return cell(run, runs[i]); });
  return text;
}

std::string insertion_tables(const std::vector<InsertionRun>& runs, std::size_t methods) {
  std::string text =
      "[Dev97] 5.5.2: points of 24 bits inserted one by one in random order.\n\n"
      "Seconds of processor time (in brackets those of 1997, on a Sun Ultra 1 of 200 MHz); ~ is estimated from the\n"
      "smaller sizes, > was stopped at the limit:\n\n";
  text += table(runs, methods, 18, [](const InsertionRun& run, const InsertionRun&) {
    return fmt::format("{} ({})", time_text(run), paper_text(run.paper_seconds));
  });
  text += "\nTimes as fast as the walk (in brackets in 1997):\n\n";
  text += table(runs, methods, 18, [](const InsertionRun& run, const InsertionRun& walk) {
    const bool both = run.paper_seconds > 0 && walk.paper_seconds > 0;
    return fmt::format("{:.1f} ({})", walk.seconds / run.seconds,
                       both ? fmt::format("{:.1f}", walk.paper_seconds / run.paper_seconds) : "-");
  });
  text +=
      "\nOperations a point: cells walked through or turned through / orientation tests / squared distances, on all\n"
      "levels:\n\n";
  text += table(runs, methods, 20, [](const InsertionRun& run, const InsertionRun&) { return operations_text(run); });
  return text;
}

std::string insertion_csv(const std::vector<InsertionRun>& runs) {
  std::string text =
      "distribution,points,method,measured,seconds,seconds_1997,steps,orientation_tests,distances,levels,locator_bytes,"
      "hash\n";
  constexpr std::array<const char*, 3> kNames{"whole", "estimated", "stopped"};
  for (const InsertionRun& run : runs)
    text += fmt::format("{},{},{},{},{:.6f},{},{:.3f},{:.3f},{:.3f},{},{:.3f},{:016x}\n", run.distribution, run.points,
                        run.method, kNames[static_cast<std::size_t>(run.measured)], run.seconds,
                        run.paper_seconds > 0 ? fmt::format("{:g}", run.paper_seconds) : "", run.steps,
                        run.orientations, run.distances, run.levels, run.locator_bytes, run.hash);
  return text;
}

std::string insertion_svg(const std::vector<InsertionRun>& runs) {
  std::vector<lab::Panel> panels;
  for (const InsertionRun& run : runs) {
    if (panels.empty() || panels.back().title != run.distribution)
      panels.push_back({run.distribution, {"points", true}, {"tests and distances a point", true, 10, 20000}, {}});
    auto& series = panels.back().series;
    auto found = std::ranges::find(series, run.method, &lab::Series::name);
    if (found == series.end()) found = series.insert(series.end(), {run.method, {}});
    if (run.measured == Measured::whole)
      found->points.push_back({static_cast<double>(run.points), run.orientations + run.distances});
  }
  return lab::draw_chart("What locating a point costs when points are inserted one by one", panels, 3);
}

int run_insertions(const Options& options) {
  lab::InsertionOptions insertion;
  insertion.limit = options.quick ? std::min(options.limit, 10.0) : options.limit;
  insertion.seed = options.seed;
  insertion.straight = !options.visibility;
  if (options.quick) insertion.sizes = {500, 5000};
  if (!options.sizes.empty()) insertion.sizes.clear();
  for (const std::string& size : options.sizes) insertion.sizes.push_back(parse_size("--sizes", size));
  if (!options.distributions.empty()) insertion.distributions = options.distributions;
  const std::size_t methods = lab::location_methods(true).size();
  const auto all = static_cast<double>(methods * insertion.sizes.size() * insertion.distributions.size());

  ProgressBar bar("inserting");
  const Progress progress = bar.callback();
  double done = 0;
  insertion.on_run = [&](const InsertionRun&) {
    if (!progress(++done / all)) throw Cancelled();
  };
  const std::vector<InsertionRun> runs = lab::run_insertions(insertion);
  print(insertion_tables(runs, methods));
  write_outputs(options.csv, insertion_csv(runs), options.svg, insertion_svg(runs));
  return kDone;
}

std::string tuning_table(const std::vector<TuningPoint>& curve) {
  std::string text =
      "[Dev97] 4.4: what a query costs against the ratio of two levels. Uniform points and queries. Operations are\n"
      "weighed as there: 5 a level, 4 a test against the line, 7 another orientation test, 5 a squared distance.\n\n"
      "  ratio  levels  line tests  other tests  distances  operations  by log2 n  paper  2 tests an edge\n";
  for (const TuningPoint& p : curve)
    text += fmt::format("{:>7g}{:>8.1f}{:>12.1f}{:>13.1f}{:>11.1f}{:>12.0f}{:>11.1f}{:>7.1f}{:>17.1f}\n", p.ratio,
                        p.levels, p.line_tests, p.facet_tests, p.distances, p.operations, p.per_logarithm,
                        p.paper_per_logarithm, p.doubled_per_logarithm);
  const auto best = std::ranges::min_element(curve, {}, &TuningPoint::per_logarithm);
  return text + fmt::format("\nfewest operations at ratio {:g}\n", best->ratio);
}

std::string tuning_csv(const std::vector<TuningPoint>& curve) {
  std::string text =
      "ratio,levels,line_tests,other_tests,distances,operations,by_log2_n,paper_by_log2_n,two_tests_an_edge_by_log2_"
      "n\n";
  for (const TuningPoint& p : curve)
    text += fmt::format("{:g},{:.4f},{:.4f},{:.4f},{:.4f},{:.3f},{:.4f},{:.4f},{:.4f}\n", p.ratio, p.levels,
                        p.line_tests, p.facet_tests, p.distances, p.operations, p.per_logarithm, p.paper_per_logarithm,
                        p.doubled_per_logarithm);
  return text;
}

std::string tuning_svg(const std::vector<TuningPoint>& curve) {
  lab::Panel panel{
      "uniform points and queries", {"ratio of two levels", true}, {"operations by log2 n", false, 0, 36}, {}};
  lab::Series counted{"counted", {}}, paper{"[Dev97] 4.4", {}, true}, doubled{"with two tests an edge", {}, true};
  for (const TuningPoint& p : curve) {
    counted.points.push_back({p.ratio, p.per_logarithm});
    paper.points.push_back({p.ratio, p.paper_per_logarithm});
    doubled.points.push_back({p.ratio, p.doubled_per_logarithm});
  }
  panel.series = {counted, paper, doubled};
  return lab::draw_chart("Tuning the ratio of two levels", std::span(&panel, 1), 1);
}

int run_tuning(const Options& options) {
  lab::TuningOptions tuning;
  tuning.seed = options.seed;
  if (options.quick) {
    tuning.least_size = 2000;
    tuning.most_size = 20000;
    tuning.size_count = 4;
    tuning.queries = 300;
  }
  ProgressBar bar("counting");
  tuning.progress = bar.callback();
  const std::vector<TuningPoint> curve = lab::run_tuning(tuning);
  print(tuning_table(curve));
  write_outputs(options.csv, tuning_csv(curve), options.svg, tuning_svg(curve));
  return kDone;
}

int run(const Options& options) {
  if (!(options.limit > 0)) throw UsageError("--limit: expected seconds, more than 0");
  require_writable_outputs(options.csv, options.svg);
  return options.tuning ? run_tuning(options) : run_insertions(options);
}

}  // namespace

void add_bench_devillers(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = bench.add_subcommand("devillers", "Locating points by walks, samples and a hierarchy [Dev97]");
  command->add_option("--sizes", options->sizes, "Numbers of points [5000,50000,500000]")
      ->delimiter(',')
      ->option_text("N,N");
  command->add_option("--kinds", options->distributions, "Distributions [random,ellipse2,ellipse,parabola,circle]")
      ->delimiter(',')
      ->option_text("K,K");
  command->add_option("--limit", options->limit, "Seconds for one entry; longer ones are estimated [120]")
      ->option_text("SECONDS");
  command->add_option("--seed", options->seed, "Of points, order and samples [1]")
      ->check(CLI::NonNegativeNumber)
      ->option_text("S");
  command->add_flag("--quick", options->quick, "Few points: some seconds in all");
  command->add_flag("--visibility", options->visibility, "March as Delone does, not straight as the paper does");
  command->add_flag("--tuning", options->tuning, "The curve of 4.4 in place of the table of 5.5.2");
  command->add_option("--csv", options->csv, "Write the numbers")->option_text("FILE");
  command->add_option("--svg", options->svg, "Draw them")->option_text("FILE");
  command->footer(
      "Examples:\n"
      "  delone bench devillers --quick\n"
      "  delone bench devillers --tuning --svg tuning.svg");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
