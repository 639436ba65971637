// Lets the libraries take turns on the same points (lab/race.hpp) and prints the results as Markdown: medians with the
// smallest and largest value, ratios, counts, and whether the targets are met.
//   bench_report NATIVE_WORKER PORTABLE_WORKER [--quick] [SECTION...]
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bench/describe.hpp"

namespace {

using delone::bench::number;
using delone::lab::Contestant;
using delone::lab::Sample;
using delone::lab::Workload;

constexpr const char* kScan = "data/scan_lonestar.csv.gz";
constexpr std::size_t kScanPoints = 518862;

double median(const Contestant& c) { return c.seconds().median; }

std::string seconds_text(const Contestant& c) {
  if (c.failed) return "stops with an error";
  if (c.samples.empty()) return "";
  const auto s = c.seconds();
  const int digits = s.median < 0.1 ? 4 : 2;
  std::string text = number(s.median, digits);
  if (c.samples.size() > 1) text += " (" + number(s.least, digits) + "-" + number(s.most, digits) + ")";
  return text;
}

double points_of(const Workload& w) { return static_cast<double>(w.n * w.repeats); }

/// Beyond the coordinates and weights themselves, which every library holds too.
double bytes_a_point(const Contestant& c) {
  const double input = 8.0 * (c.workload.dimension + (c.workload.weight > 0 ? 1 : 0));
  return static_cast<double>(c.samples.front().bytes) / points_of(c.workload) - input;
}

std::string bytes_text(const Contestant& c) { return c.samples.empty() ? "" : number(bytes_a_point(c), 0); }

/// "| a | b |".
std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

/// A heading row and the line below it.
std::string heading(const std::vector<std::string>& cells) {
  return row(cells) + row(std::vector<std::string>(cells.size(), "---"));
}

struct Options {
  std::string native, portable;
  bool quick = false;
  std::vector<std::string> sections;

  bool wants(const std::string& section) const {
    return sections.empty() || std::ranges::find(sections, section) != sections.end();
  }
  std::size_t points(std::size_t n) const { return quick ? n / 10 : n; }
  int rounds(int full) const { return quick ? 1 : full; }
  Workload workload(std::string title, std::string kind, std::size_t n, int dimension, double weight = 0) const {
    return {.title = std::move(title),
            .kind = std::move(kind),
            .n = points(n),
            .dimension = dimension,
            .weight = quick ? 5 * weight : weight};
  }
  Workload scan(int dimension) const {
    return {
        .title = std::to_string(dimension) + "D laser scan", .kind = kScan, .n = kScanPoints, .dimension = dimension};
  }
  Workload repeated(std::string title, std::size_t n, int dimension, std::size_t repeats) const {
    return {.title = std::move(title),
            .kind = "uniform",
            .n = n,
            .dimension = dimension,
            .repeats = std::max<std::size_t>(points(repeats), 1)};
  }
};

struct Rival {
  std::string peer;
  double target = 0;  ///< times as fast as it; 0: no target
};

/// Delone (tuned for the machine, and portable) against rivals on one workload.
struct Race {
  std::string section;
  Workload workload;
  std::vector<Rival> rivals;
  double target_bytes = 0;  ///< a point; 0: no target
  int rounds = 3;
};

std::vector<Race> races(const Options& o) {
  std::vector<Race> all;
  const std::vector<Rival> planar{{"CGAL", 2}, {"CGAL-indexed", 3}};
  for (const char* kind : {"uniform", "clusters", "lattice", "ellipse2", "parabola", "circle", "ellipse"}) {
    const double bytes = kind == std::string("uniform") ? 75 : 0;
    all.push_back({"2d", o.workload("2D " + std::string(kind) + " 1e6", kind, 1000000, 2), planar, bytes});
  }
  const auto add = [&](const char* section, const Workload& w, const std::vector<Rival>& rivals, double bytes = 0,
                       int rounds = 3) {
    all.push_back({section, w, rivals, bytes, rounds});
  };
  const std::vector<Rival> high{{"CGAL", 5}, {"Qhull", 5}};
  add("2d", o.workload("2D uniform 1e5", "uniform", 100000, 2), {{"CGAL"}, {"CGAL-indexed"}});
  add("2d", o.workload("2D uniform 1e7", "uniform", 10000000, 2), {{"CGAL", 2.5}});
  add("2d", o.workload("2D weighted 1e6, many hidden", "uniform", 1000000, 2, 5e-6), {{"CGAL"}});
  add("3d", o.workload("3D uniform 1e6", "uniform", 1000000, 3), {{"CGAL", 3}}, 260);
  add("3d", o.workload("3D clusters 1e6", "clusters", 1000000, 3), {{"CGAL", 3}});
  add("3d", o.workload("3D uniform 1e5", "uniform", 100000, 3), {{"CGAL"}});
  add("3d", o.workload("3D sphere 1e5", "sphere", 100000, 3), {{"CGAL", 3}});
  add("3d", o.workload("3D moment curve 2e3", "moment", 2000, 3), {{"CGAL", 1.5}});
  add("3d", o.workload("3D skew lines 2e3", "skew", 2000, 3), {{"CGAL", 1.5}});
  add("3d", o.workload("3D lattice 100 x 100 x 100", "lattice", 1000000, 3), {{"CGAL", 2}});
  add("3d", o.scan(3), {{"CGAL", 2}});
  add("weighted", o.workload("3D weighted 1e6, few hidden", "uniform", 1000000, 3, 3e-5), {{"CGAL", 3}});
  add("weighted", o.workload("3D weighted 1e6, most hidden", "uniform", 1000000, 3, 1e-3), {{"CGAL", 3}});
  add("dd", o.workload("4D uniform 1e5", "uniform", 100000, 4), high, 0, 2);
  add("dd", o.workload("5D uniform 1e4", "uniform", 10000, 5), high, 0, 2);
  add("dd", o.workload("6D uniform 5e3", "uniform", 5000, 6), high, 0, 2);
  add("small", o.repeated("2D uniform 100, 1000 times", 100, 2, 1000), {{"CGAL", 3}});
  add("small", o.repeated("3D uniform 100, 1000 times", 100, 3, 1000), {{"CGAL", 3}});
  return all;
}

/// One row a race of what Delone says of its work: seconds by phase, and counts a point.
class Counts {
 public:
  void add(const Contestant& c) {
    const auto of = [](const Sample& sample, const char* name) {
      const auto found = sample.counts.find(name);
      return found == sample.counts.end() ? 0.0 : found->second;
    };
    std::vector<std::string> cells{c.workload.title};
    for (const char* phase : {"order_seconds", "insert_seconds"}) {
      std::vector<double> seconds;
      for (const Sample& sample : c.samples) seconds.push_back(of(sample, phase));
      cells.push_back(number(delone::lab::spread(seconds).median, 3));
    }
    const Sample& sample = c.samples.front();
    for (const char* name : {"orient_filter", "orient_exact", "conflict_filter", "conflict_adaptive", "conflict_exact",
                             "conflict_symbolic", "walk_steps", "cells_created"})
      cells.push_back(number(of(sample, name) / points_of(c.workload), 3));
    const bool counted = sample.counts.contains("cache_misses");
    cells.push_back(counted ? number(of(sample, "cache_misses") / points_of(c.workload), 2) : "");
    misses_ |= counted;
    rows_ += row(cells);
  }

  std::string text() const {
    return "\n## Where Delone's time goes\n\nSeconds by phase (medians); and a point: orientation tests by the stage "
           "that decided, conflict tests likewise,\ncells walked through, cells made, misses of the last cache.\n\n" +
           heading({"points", "order", "insert", "orient: filter", "exact", "conflict: filter", "adaptive", "exact",
                    "tie rule", "walk steps", "cells made",
                    misses_ ? "cache misses" : "cache misses: no hardware counters on this machine"}) +
           rows_;
  }

 private:
  bool misses_ = false;
  std::string rows_;
};

class Report {
 public:
  explicit Report(Options options) : o_(std::move(options)) {}

  std::string text() {
    const std::string body = race_all() + files() + threads() + growth() + distributions() + removal() + devillers();
    return head() + targets() + body;
  }

 private:
  void alternate(std::vector<Contestant>& contestants, int rounds) {
    delone::lab::alternate(contestants, o_.rounds(rounds), [&](const Contestant& c) {
      if (c.samples.empty()) return;
      const Sample& sample = c.samples.back();
      disturbed_ += sample.disturbed ? 1 : 0;
      std::fprintf(stderr, "  %-40s %-16s %.3f s\n", c.workload.title.c_str(), c.label.c_str(), sample.seconds);
    });
  }
  Contestant native(const std::string& peer, const Workload& w) const { return {peer, o_.native, peer, w}; }

  void judge(const std::string& what, double target, double reached, bool met, int digits = 1,
             const std::string& remark = "") {
    verdicts_ += row({what, number(target, digits), number(reached, 2) + remark, met ? "yes" : "**no**"});
  }
  void at_least(const std::string& what, double target, double reached) {
    judge(what, target, reached, reached >= target);
  }
  void at_most(const std::string& what, double target, double reached, int digits = 1, const std::string& remark = "") {
    judge(what + ", at most", target, reached, reached <= target, digits, remark);
  }

  std::string head() const {
    std::string text = "# Results\n\n" + delone::bench::when_and_where(o_.quick ? ", QUICK" : "");
    std::istringstream versions(delone::lab::output_of({o_.native, "--versions"}));
    for (std::string line; std::getline(versions, line);) text += "* " + line + "\n";
    std::istringstream portable(delone::lab::output_of({o_.portable, "--versions"}));
    for (std::string line; std::getline(portable, line);)
      if (line.starts_with("flags")) text += "* portable build: " + line + "\n";
    return text +
           "* Qhull is the shared library as Debian builds it; Delone, and no rival, is compiled with "
           "-ffp-contract=off\n\n"
           "One thread. Points in memory in random order; the clock covers construction with the library's own sort. "
           "Every run\nis a process of its own, repeated when it had to share its processor; the contestants of a row "
           "take turns on the\nsame points, round after round. Before the clock each writes to a gibibyte of "
           "huge pages and gives it back: a\nhypervisor that takes free memory back makes new pages cost many times "
           "their price. Given are the median and, in\nbrackets, the least and the largest value.\n\n";
  }

  std::string targets() const {
    std::string text;
    if (!verdicts_.empty()) text = "## Targets\n\n" + heading({"what", "target", "reached", "met"}) + verdicts_;
    if (disturbed_ > 0)
      text += "\n" + std::to_string(disturbed_) +
              " runs had a processor for less than 97 % of their time: measure again.\n";
    return text;
  }

  /// The rows of one race in the tables of time and memory.
  void race(const Race& race, std::string& times, std::string& memory, Counts& counts) {
    const Workload& w = race.workload;
    std::vector<Contestant> contestants{native("Delone", w), {"Delone, portable", o_.portable, "Delone", w}};
    for (const Rival& rival : race.rivals) contestants.push_back(native(rival.peer, w));
    for (Contestant& c : contestants) c.may_fail = c.peer == "Qhull";
    alternate(contestants, race.rounds);

    const Contestant& ours = contestants.front();
    std::string cells = std::to_string(ours.samples.front().cells);
    double least = 0;
    for (std::size_t i = 0; i < race.rivals.size(); ++i) {
      const Contestant& rival = contestants[i + 2];
      if (rival.failed) continue;
      // Only ties allow different counts: random points have one triangulation.
      if (const std::size_t theirs = rival.samples.front().cells; theirs != ours.samples.front().cells)
        cells += ", " + rival.label + " " + std::to_string(theirs);
      const double ratio = median(rival) / median(ours);
      least = least == 0 ? ratio : std::min(least, ratio);
      const double target = race.rivals[i].target;
      if (target > 0) at_least(w.title + ", times as fast as " + rival.label, target, ratio);
    }
    if (race.target_bytes > 0)
      at_most(w.title + ", bytes a point beyond the input", race.target_bytes, bytes_a_point(ours), 0);

    std::vector<std::string> in_times{w.title, cells, seconds_text(ours), seconds_text(contestants[1])};
    std::vector<std::string> in_memory{w.title, bytes_text(ours)};
    for (const char* column : {"CGAL", "CGAL-indexed", "Qhull"}) {
      const auto rival = std::ranges::find(contestants, column, &Contestant::label);
      in_times.push_back(rival == contestants.end() ? "" : seconds_text(*rival));
      in_memory.push_back(rival == contestants.end() ? "" : bytes_text(*rival));
    }
    in_times.push_back(number(least, 2));
    times += row(in_times);
    memory += row(in_memory);
    counts.add(ours);
  }

  std::string race_all() {
    std::string times, memory;
    Counts counts;
    for (const Race& one : races(o_))
      if (o_.wants(one.section)) race(one, times, memory, counts);
    if (times.empty()) return "";
    return "\n## Against its peers\n\nSeconds. Ratio: the fastest rival's median by Delone's, both tuned for the "
           "machine.\n\n" +
           heading({"points", "cells", "Delone", "Delone, portable build", "CGAL", "CGAL, index per vertex", "Qhull",
                    "ratio"}) +
           times +
           "\n## Memory of the finished triangulation\n\nBytes a point beyond the input: what the library says "
           "(Delone), what it holds from malloc (the others).\n\n" +
           heading({"points", "Delone", "CGAL", "CGAL, index per vertex", "Qhull"}) + memory + counts.text();
  }

  std::string files() {
    if (!o_.wants("files")) return "";
    const Workload w = o_.workload("3D uniform 1e6", "uniform", 1000000, 3);
    std::vector<Contestant> contestants{native("Delone-read-csv", w), native("Delone-write-vtu", w)};
    alternate(contestants, 5);
    const Contestant &csv = contestants[0], &vtu = contestants[1];
    at_most(w.title + ", seconds to read as CSV", 0.25, median(csv), 2);
    at_most(w.title + ", seconds to write the cells as VTU", 1, median(vtu));
    const auto line = [&](const char* what, const Contestant& c) {
      return row({what, number(static_cast<double>(c.samples.front().bytes) / 1e6, 0), seconds_text(c)});
    };
    return "\n## Files\n\n" + w.title + ", in the cache of the system; the table of cells included.\n\n" +
           heading({"what", "MB", "seconds"}) + line("points read from CSV", csv) + line("cells written as VTU", vtu);
  }

  std::string threads() {
    if (!o_.wants("threads")) return "";
    std::string text =
        "\n## Two threads\n\nSeconds.\n\n" + heading({"points", "one thread", "two threads", "times as fast"});
    for (const int dimension : {2, 3}) {
      const std::string prefix = std::to_string(dimension) + "D ";
      for (const Workload& w :
           {o_.workload(prefix + "uniform 1e6", "uniform", 1000000, dimension),
            o_.workload(prefix + "clusters 1e6", "clusters", 1000000, dimension), o_.scan(dimension)}) {
        std::vector<Contestant> contestants{native("Delone", w), native("Delone-threads-2", w)};
        alternate(contestants, 5);
        const double ratio = median(contestants[0]) / median(contestants[1]);
        text += row({w.title, seconds_text(contestants[0]), seconds_text(contestants[1]), number(ratio, 2)});
        at_least(w.title + ", two threads, times as fast as one", 1.8, ratio);
      }
    }
    return text + threads_on_paper();
  }

  /// What bounds more threads than this machine has processors: counts, which do not depend on it.
  std::string threads_on_paper() {
    std::string text =
        "\n### More threads, on paper\n\n3D, one run each. Put off: how often a thread left a site to others, a site. "
        "In turn: the share of the sites\nthat were tried one after the other, each time by the busiest thread; times "
        "as fast: its inverse, were all sites\nas much work and memory as fast for many. Written: bytes of cells a "
        "site.\n\n" +
        heading({"points", "threads", "put off", "in turn", "times as fast", "written"});
    for (const char* kind : {"uniform", "clusters", "sphere"}) {
      const Workload w = o_.workload(std::string("3D ") + kind + " 1e6", kind, 1000000, 3);
      for (const char* threads : {"2", "8", "64"}) {
        std::vector<Contestant> one{native(std::string("Delone-threads-") + threads, w)};
        alternate(one, 1);
        const auto& counts = one[0].samples.front().counts;
        const double in_turn = counts.at("in_turn") / points_of(w);
        text += row({w.title, threads, number(counts.at("put_off") / points_of(w), 3), number(in_turn, 3),
                     number(1 / in_turn, 1), number(32 * counts.at("cells_created") / points_of(w), 0)});
      }
    }
    return text;
  }

  std::string growth() {
    if (!o_.wants("growth")) return "";
    std::string text =
        "\n## Growth\n\nSmall sizes are built several times in one process. Peak: the whole process, input "
        "included.\n\n" +
        heading({"points", "seconds", "microseconds a point", "peak MiB"});
    const auto grow = [&](int dimension, const std::vector<Workload>& sizes) {
      double least = 0, most = 0;
      for (const Workload& w : sizes) {
        std::vector<Contestant> contestant{native("Delone", w)};
        alternate(contestant, 3);
        const double one = 1e6 * median(contestant[0]) / points_of(w);
        least = least == 0 ? one : std::min(least, one);
        most = std::max(most, one);
        text += row({w.title, seconds_text(contestant[0]), number(one, 3),
                     std::to_string(contestant[0].samples.front().peak_bytes >> 20)});
      }
      at_most(std::to_string(dimension) + "D uniform, time a point, largest by least size", 1.6, most / least);
    };
    grow(2,
         {o_.repeated("2D uniform 1e4, 50 times", 10000, 2, 50), o_.repeated("2D uniform 1e5, 10 times", 100000, 2, 10),
          o_.workload("2D uniform 1e6", "uniform", 1000000, 2), o_.workload("2D uniform 1e7", "uniform", 10000000, 2)});
    grow(3,
         {o_.repeated("3D uniform 1e4, 20 times", 10000, 3, 20), o_.repeated("3D uniform 1e5, 3 times", 100000, 3, 3),
          o_.workload("3D uniform 1e6", "uniform", 1000000, 3), o_.workload("3D uniform 3e6", "uniform", 3000000, 3)});
    return text;
  }

  std::string distributions() {
    if (!o_.wants("distributions")) return "";
    const std::size_t n = o_.points(1000000);
    std::vector<Workload> workloads{{"random", "uniform", n}};
    for (const char* kind : {"uniform", "ellipse2", "ellipse", "parabola", "circle"})
      workloads.push_back(
          {(kind == std::string("uniform") ? "random" : kind) + std::string(", 24 bits"), kind, n, 2, 24});
    for (const char* kind : {"ellipse2", "ellipse", "parabola", "circle", "clusters", "lattice"})
      workloads.push_back({kind, kind, n});

    std::vector<Contestant> contestants;
    for (const char* peer : {"Delone", "CGAL"})
      for (const Workload& w : workloads) contestants.push_back(native(peer, w));
    alternate(contestants, 5);

    std::string text = "\n## Distributions of [Dev97] 5.5.1, and a lattice\n\n2D, " + std::to_string(n) +
                       " points (the lattice 1000 x 1000). Seconds; relative: the time to that of random points "
                       "(doubles).\n\n" +
                       heading({"points", "vertices", "Delone", "relative", "CGAL", "relative"});
    double worst = 0;
    std::string worst_name;
    for (std::size_t i = 0; i < workloads.size(); ++i) {
      const Contestant &ours = contestants[i], &theirs = contestants[workloads.size() + i];
      const double relative = median(ours) / median(contestants[0]);
      text += row({workloads[i].title, std::to_string(ours.samples.front().vertices), seconds_text(ours),
                   number(relative, 2), seconds_text(theirs),
                   number(median(theirs) / median(contestants[workloads.size()]), 2)});
      if (relative <= worst) continue;
      worst = relative;
      worst_name = workloads[i].title;
    }
    at_most("2D distributions and lattice, slowest against random", 1.5, worst, 1, " (" + worst_name + ")");
    return text;
  }

  /// [Dev97] 5.5.3 against what there is today.
  std::string devillers() {
    if (!o_.wants("devillers")) return "";
    const std::size_t n = o_.points(500000);
    std::string text =
        "\n## Comparison of [Dev97] 5.5.3\n\n2D, " + std::to_string(n) +
        " points of 24 bits. Seconds. In the columns \"one by one\" the points are inserted in the order in "
        "which they come, which is\nrandom, and located by a hierarchy of levels; the other columns choose "
        "their order themselves.\n\n" +
        heading({"points", "Delone", "Delone, one by one", "CGAL", "CGAL, one by one", "Qhull"});
    for (const char* kind : {"uniform", "ellipse2", "ellipse", "parabola", "circle"}) {
      const Workload w{kind == std::string("uniform") ? "random" : kind, kind, n, 2, 24};
      std::vector<Contestant> contestants;
      for (const char* peer : {"Delone", "Delone-hierarchy", "CGAL", "CGAL-hierarchy", "Qhull"})
        contestants.push_back(native(peer, w));
      contestants.back().may_fail = true;
      alternate(contestants, 3);
      std::vector<std::string> cells{w.title};
      for (const Contestant& c : contestants) cells.push_back(seconds_text(c));
      text += row(cells);
    }
    return text;
  }

  /// Removal of random vertices, one call each, from a triangulation that is built outside the clock.
  std::string removal() {
    if (!o_.wants("removal")) return "";
    std::string text =
        "\n## Removal of random vertices\n\nOne call each, from a triangulation of uniform points that was built "
        "before. Seconds, and microseconds a vertex.\n\n" +
        heading({"points", "removed", "Delone", "a vertex", "CGAL", "a vertex", "ratio"});
    for (const int dimension : {2, 3}) {
      for (const std::size_t share : {10, 20}) {
        const Workload w = o_.workload(std::to_string(dimension) + "D uniform 1e6", "uniform", 1000000, dimension);
        const std::string verb = "-remove-" + std::to_string(share);
        std::vector<Contestant> contestants{native("Delone" + verb, w), native("CGAL" + verb, w)};
        alternate(contestants, dimension == 2 ? 9 : 3);
        const double removed = static_cast<double>(w.n / share);
        const double ratio = median(contestants[1]) / median(contestants[0]);
        std::vector<std::string> cells{w.title, number(removed, 0)};
        for (const Contestant& c : contestants)
          cells.insert(cells.end(), {seconds_text(c), number(1e6 * median(c) / removed, 2)});
        cells.push_back(number(ratio, 2));
        text += row(cells);
        at_least(w.title + ", " + number(removed, 0) + " removals, times as fast as CGAL", dimension == 2 ? 1.5 : 2.0,
                 ratio);
      }
    }
    return text;
  }

  Options o_;
  std::string verdicts_;
  int disturbed_ = 0;  // runs that stayed so however often they were repeated
};

}  // namespace

int main(int argc, char** argv) {
  try {
    Options options;
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      if (argument == "--quick") {
        options.quick = true;
      } else if (options.native.empty()) {
        options.native = argument;
      } else if (options.portable.empty()) {
        options.portable = argument;
      } else {
        options.sections.push_back(argument);
      }
    }
    if (options.portable.empty()) {
      std::fprintf(stderr,
                   "usage: bench_report NATIVE_WORKER PORTABLE_WORKER [--quick] "
                   "[2d|3d|weighted|dd|small|files|threads|growth|distributions|removal|devillers ...]\n");
      return 2;
    }
    std::fputs(Report(std::move(options)).text().c_str(), stdout);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_report: %s\n", error.what());
    return 1;
  }
}
