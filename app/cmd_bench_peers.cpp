// delone bench peers: Delone and its rivals on this machine, in turns.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include "bench.hpp"
#include "delone/base/errors.hpp"
#include "delone/base/ids.hpp"
#include "delone/io/generate.hpp"
#include "delone/lab/chart.hpp"
#include "delone/lab/machine.hpp"
#include "delone/lab/race.hpp"
#include "interrupt.hpp"
#include "progress.hpp"

namespace delone::cli {
namespace {

using lab::Contestant;
using lab::Workload;

struct Options {
  std::vector<std::string> sets{"2d-uniform", "2d-clusters", "2d-lattice", "3d-uniform", "3d-sphere", "3d-weighted"};
  std::vector<std::string> sizes;
  std::string worker, csv, svg;
  int rounds = 3;
  bool quick = false;
};

/// The contestants on one set and size; Delone is the first.
using Race = std::vector<Contestant>;

/// What the worker was built from, "Delone" to "0.1.0".
std::map<std::string, std::string> versions_of(const std::string& worker) {
  std::map<std::string, std::string> versions;
  std::istringstream lines(lab::output_of({worker, "--versions"}));
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t colon = line.find(": "); colon != std::string::npos)
      versions[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return versions;
}

/// "3d-sphere": n points of this kind; "3d-weighted": uniform ones with weights that hide few.
Workload workload(const std::string& set, std::size_t n) {
  const bool named = set.size() > 3 && set[0] >= '1' && set[0] <= '0' + kMaxDimension && set.substr(1, 2) == "d-";
  if (!named) throw UsageError("--sets " + set + ": expected a dimension and a kind, such as 2d-uniform or 3d-sphere");
  Workload w{.title = set, .kind = set.substr(3), .n = n, .dimension = set[0] - '0'};
  if (w.kind == "weighted") {
    w.kind = "uniform";
    w.weight = 0.3 * std::pow(static_cast<double>(n), -2.0 / w.dimension);
  }
  const io::KindInfo info = io::kind_info(w.kind);
  if (w.dimension < info.least_dimension || w.dimension > info.most_dimension)
    throw UsageError(fmt::format("--sets {}: there is no {} in dimension {}", set, w.kind, w.dimension));
  return w;
}

Race race_on(const Workload& w, const std::string& worker, const std::map<std::string, std::string>& versions) {
  Race race{{"Delone", worker, "Delone", w}};
  const auto add = [&](const std::string& label, const std::string& peer, const std::string& library, bool fits) {
    if (fits && versions.contains(library)) race.push_back({label, worker, peer, w, {}, true});
  };
  const bool weighted = w.weight > 0;
  add("CGAL", "CGAL", "CGAL", weighted ? w.dimension == 2 || w.dimension == 3 : w.dimension >= 2 && w.dimension <= 6);
  add("CGAL, index per vertex", "CGAL-indexed", "CGAL", w.dimension == 2 && !weighted);
  add("Qhull", "Qhull", "Qhull", w.dimension >= 2 && !weighted);
  return race;
}

std::vector<Race> races(const Options& options, const std::string& worker,
                        const std::map<std::string, std::string>& versions) {
  std::vector<Race> all;
  for (const std::string& set : options.sets) {
    const int dimension = workload(set, 1).dimension;
    std::vector<std::size_t> sizes;
    for (const std::string& size : options.sizes) sizes.push_back(parse_size("--sizes", size));
    if (sizes.empty()) sizes = {(dimension <= 3 ? std::size_t{100'000} : 10'000) / (options.quick ? 10 : 1)};
    for (const std::size_t n : sizes) all.push_back(race_on(workload(set, n), worker, versions));
  }
  return all;
}

void run_all(std::vector<Race>& races, int rounds) {
  std::size_t runs = 0, done = 0;
  for (const Race& race : races) runs += race.size() * static_cast<std::size_t>(rounds);
  ProgressBar bar("measuring");
  const Progress progress = bar.callback();
  const DeferInterrupt defer;
  const auto on_run = [&](const Contestant&) {
    if (!progress(static_cast<double>(++done) / static_cast<double>(runs))) throw Cancelled();
  };
  try {
    for (Race& race : races) lab::alternate(race, rounds, on_run);
  } catch (const std::runtime_error&) {
    if (interrupted() != 0) throw Cancelled();  // the worker heard Ctrl-C too
    throw;
  }
}

std::string seconds_text(double seconds) { return fmt::format("{:#.3g}", seconds); }

double ratio(const Contestant& c, const Contestant& ours) { return c.seconds().median / ours.seconds().median; }

std::string table(const std::vector<Race>& races) {
  std::string text = "Seconds: median, and in brackets the least and the most; ratio: times as long as Delone.\n\n" +
                     fmt::format("{:<16}{:>11}  {:<24}{:>8}  {:<19}{:>6}\n", "points", "", "", "median", "", "ratio");
  for (const Race& race : races) {
    for (const Contestant& c : race) {
      const bool first = &c == &race.front();
      text += fmt::format("{:<16}{:>11}  {:<24}", first ? c.workload.title : "", first ? grouped(c.workload.n) : "",
                          c.label);
      if (c.failed) {
        text += "stops with an error\n";
        continue;
      }
      const lab::Spread s = c.seconds();
      const std::string spread = fmt::format("({} - {})", seconds_text(s.least), seconds_text(s.most));
      text += fmt::format("{:>8}  {:<19}{:>6.2f}\n", seconds_text(s.median), spread, ratio(c, race.front()));
    }
  }
  return text;
}

/// How far the numbers can be trusted; empty when nothing is against them.
std::string remark(const std::vector<Race>& races) {
  std::size_t disturbed = 0;
  for (const Race& race : races) {
    for (const Contestant& c : race)
      disturbed += static_cast<std::size_t>(std::ranges::count(c.samples, true, &lab::Sample::disturbed));
  }
  if (disturbed == 0) return "";
  return counted(disturbed, "run", "runs") + " had to share a processor: measure again when the machine is quiet";
}

std::string to_csv(const std::vector<Race>& races) {
  std::string text = "set,points,contestant,round,seconds,processor_seconds,cells,bytes,peak_bytes\n";
  for (const Race& race : races) {
    for (const Contestant& c : race) {
      for (std::size_t round = 0; round < c.samples.size(); ++round) {
        const lab::Sample& s = c.samples[round];
        text += fmt::format("{},{},{},{},{:.6f},{:.6f},{},{},{}\n", c.workload.title, c.workload.n, c.peer, round + 1,
                            s.seconds, s.processor, s.cells, s.bytes, s.peak_bytes);
      }
    }
  }
  return text;
}

std::string to_svg(const std::vector<Race>& races, int rounds, const std::map<std::string, std::string>& versions) {
  std::vector<lab::BarGroup> groups;
  for (const Race& race : races) {
    lab::BarGroup group{race.front().workload.title, grouped(race.front().workload.n) + " points", {}};
    const double unit = race.front().seconds().median;
    for (const Contestant& c : race) {
      if (c.failed) continue;
      const lab::Spread s = c.seconds();
      const std::string times = &c == &race.front() ? "" : fmt::format(" ({:.1f} x)", s.median / unit);
      group.bars.push_back(
          {c.label, s.median / unit, s.least / unit, s.most / unit, seconds_text(s.median) + " s" + times});
    }
    groups.push_back(std::move(group));
  }
  std::string libraries;
  for (const char* name : {"Delone", "CGAL", "Qhull"})
    if (versions.contains(name))
      libraries += fmt::format("{}{} {}", libraries.empty() ? "" : ", ", name, versions.at(name));
  std::vector<std::string> notes{fmt::format("{}; {} {}, one thread; bars are medians, whiskers the least and the most",
                                             lab::today(), rounds, rounds == 1 ? "round" : "rounds"),
                                 lab::machine(), libraries};
  if (const std::string warning = remark(races); !warning.empty()) notes.push_back(warning);
  return lab::draw_bars("Time to triangulate", "times as long as Delone", groups, notes);
}

int run(const Options& options) {
  if (options.rounds < 1) throw UsageError("--rounds: expected at least 1");
  require_writable_outputs(options.csv, options.svg);
  const std::string worker = require_worker(options.worker);
  const auto versions = versions_of(worker);
  std::vector<Race> all = races(options, worker, versions);
  const int rounds = options.quick ? 1 : options.rounds;
  run_all(all, rounds);
  const std::string warning = remark(all);
  print(fmt::format("{}, {}\n", lab::machine(), lab::today()) + table(all) +
        (warning.empty() ? "" : "\n" + warning + ".\n"));
  write_outputs(options.csv, to_csv(all), options.svg, to_svg(all, rounds, versions));
  return kDone;
}

}  // namespace

void add_bench_peers(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = bench.add_subcommand("peers", "Delone beside CGAL and Qhull on this machine");
  command->add_option("--sets", options->sets, "Dimensions and kinds [" + joined(options->sets, ",") + "]")
      ->delimiter(',')
      ->option_text("S,S");
  command->add_option("--sizes", options->sizes, "Numbers of points [1e5, above 3D 1e4]")
      ->delimiter(',')
      ->option_text("N,N");
  command->add_option("--rounds", options->rounds, "In each every library runs once, in turns [3]")->option_text("R");
  command->add_option("--worker", options->worker, "The program that `make bench-worker` builds")->option_text("PATH");
  command->add_flag("--quick", options->quick, "Few points, one round: some seconds in all");
  command->add_option("--csv", options->csv, "Write the numbers")->option_text("FILE");
  command->add_option("--svg", options->svg, "Draw them")->option_text("FILE");
  command->footer(
      "A set is a dimension and a kind of `delone generate`, or weighted: uniform points with weights that hide "
      "few.\n\n"
      "Examples:\n"
      "  make bench-worker && delone bench peers --quick\n"
      "  delone bench peers --sets 2d-uniform,3d-sphere --sizes 1e5,1e6 --svg peers.svg");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
