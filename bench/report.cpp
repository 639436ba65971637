// Lets the libraries alternate on the same points, round after round, each run in a process of its own, and prints
// the results as Markdown: medians with the smallest and largest value, ratios, and whether the targets are met.
//   bench_report NATIVE_WORKER PORTABLE_WORKER [--quick] [SECTION...]
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/describe.hpp"

namespace {

using delone::bench::number;
using delone::bench::Spread;

struct Workload {
  std::string title;
  std::string kind;
  std::size_t n = 0;
  int dimension = 2;
  int bits = 0;
  double weight = 0;
};

struct Sample {
  double seconds = 0, processor = 0;
  std::size_t cells = 0, vertices = 0, bytes = 0, peak_bytes = 0;
};

/// One library in one build on one workload, with what was measured so far.
struct Contestant {
  std::string label;
  std::string worker;
  std::string peer;
  Workload workload;
  std::vector<Sample> samples{};
  bool may_fail = false;  ///< a rival that stops with an error is reported as such, not a fault of the run
  bool failed = false;
};

Spread spread(const std::vector<Sample>& samples) {
  std::vector<double> seconds;
  for (const Sample& s : samples) seconds.push_back(s.seconds);
  return delone::bench::spread(std::move(seconds));
}

/// Runs that stayed disturbed however often they were repeated.
int disturbed = 0;

double median(const Contestant& c) { return spread(c.samples).median; }

std::string seconds_text(const Contestant& c) {
  if (c.failed) return "stops with an error";
  if (c.samples.empty()) return "";
  const Spread s = spread(c.samples);
  const int digits = s.median < 0.1 ? 4 : 2;
  std::string text = number(s.median, digits);
  if (c.samples.size() > 1) text += " (" + number(s.least, digits) + "-" + number(s.most, digits) + ")";
  return text;
}

/// What the command prints on its standard output; its peak memory goes to `peak_bytes`.
std::string output_of(const std::vector<std::string>& command, std::size_t* peak_bytes = nullptr) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    std::vector<char*> arguments;
    std::vector<std::string> copy = command;
    for (std::string& argument : copy) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    alarm(1200);  // outlives the exec: no run holds up the rest for ever
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = read(ends[0], buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), static_cast<std::size_t>(got));
  close(ends[0]);
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    std::string line;
    for (const std::string& argument : command) line += argument + " ";
    throw std::runtime_error("failed: " + line);
  }
  if (peak_bytes != nullptr) *peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  return text;
}

Sample measure(const Contestant& c, std::uint64_t seed) {
  const Workload& w = c.workload;
  Sample sample;
  std::istringstream result(output_of({c.worker, c.peer, w.kind, std::to_string(w.n), std::to_string(w.dimension),
                                       std::to_string(seed), std::to_string(w.bits), number(w.weight, 9)},
                                      &sample.peak_bytes));
  result >> sample.seconds >> sample.processor >> sample.cells >> sample.vertices >> sample.bytes;
  return sample;
}

/// A run that something else disturbed, so that it had a processor for less than 97 % of the time, is thrown away.
void run_once(Contestant& c, std::uint64_t seed) try {
  if (c.failed) return;
  Sample sample = measure(c, seed);
  for (int again = 0; again < 5 && sample.processor < 0.97 * sample.seconds; ++again) sample = measure(c, seed);
  if (sample.processor < 0.97 * sample.seconds) ++disturbed;
  std::fprintf(stderr, "  %-40s %-16s %.3f s\n", c.workload.title.c_str(), c.label.c_str(), sample.seconds);
  c.samples.push_back(sample);
} catch (const std::runtime_error&) {
  if (!c.may_fail) throw;
  c.failed = true;
}

/// Rounds in which every contestant runs once; the order turns from round to round. All rounds have the same points.
void alternate(std::vector<Contestant>& contestants, int rounds) {
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i)
      run_once(contestants[(i + static_cast<std::size_t>(round)) % contestants.size()], 1);
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
};

struct Verdict {
  std::string what, target, reached;
  bool met = false;
};

/// Beyond the coordinates and weights themselves, which every library holds too.
double bytes_a_point(const Contestant& c) {
  const double input = 8.0 * (c.workload.dimension + (c.workload.weight > 0 ? 1 : 0));
  return static_cast<double>(c.samples.front().bytes) / static_cast<double>(c.workload.n) - input;
}

std::string bytes_text(const Contestant& c) { return number(bytes_a_point(c), 0); }

/// Delone (tuned for the machine, and portable) against rivals on one workload.
struct Race {
  std::string section;
  Workload workload;
  std::vector<std::string> rivals;
  double target = 0;        ///< times the fastest of the rivals; 0: no target
  double target_bytes = 0;  ///< a point; 0: no target
  int rounds = 5;
};

std::vector<Race> races(const Options& o) {
  const auto at = [&](std::string title, std::string kind, std::size_t n, int d, double weight = 0) {
    return Workload{std::move(title), std::move(kind), o.points(n), d, 0, o.quick ? 5 * weight : weight};
  };
  return {
      {"2d", at("2D uniform 1e6", "uniform", 1000000, 2), {"CGAL", "CGAL-indexed"}, 1.0, 80, 3},
      {"2d", at("2D uniform 1e5", "uniform", 100000, 2), {"CGAL", "CGAL-indexed"}, 0, 0, 3},
      {"2d", at("2D weighted 1e6, many hidden", "uniform", 1000000, 2, 5e-6), {"CGAL"}, 0, 0, 3},
      {"3d", at("3D uniform 1e6", "uniform", 1000000, 3), {"CGAL"}, 1.5, 300, 3},
      {"3d", at("3D uniform 1e5", "uniform", 100000, 3), {"CGAL"}, 0, 0, 3},
      {"3d", at("3D sphere 1e5", "sphere", 100000, 3), {"CGAL"}, 0, 0, 3},
      {"3d", at("3D lattice 46 x 46 x 46", "lattice", 97336, 3), {"CGAL"}, 0, 0, 3},
      {"weighted", at("3D weighted 1e6, few hidden", "uniform", 1000000, 3, 3e-5), {"CGAL"}, 1.5, 0, 3},
      {"weighted", at("3D weighted 1e6, most hidden", "uniform", 1000000, 3, 1e-3), {"CGAL"}, 1.5, 0, 3},
      {"dd", at("4D uniform 1e5", "uniform", 100000, 4), {"CGAL", "Qhull"}, 2.0, 0, 2},
      {"dd", at("5D uniform 1e4", "uniform", 10000, 5), {"CGAL", "Qhull"}, 2.0, 0, 2},
  };
}

std::string report_races(const Options& o, std::vector<Verdict>& verdicts) {
  std::string text =
      "## Against its peers\n\nSeconds. Ratio: the fastest rival's median by Delone's, both tuned for the machine.\n\n"
      "| points | cells | Delone | Delone, portable build | CGAL | CGAL, index per vertex | Qhull | ratio |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  std::string memory =
      "\n## Memory of the finished triangulation\n\nBytes a point beyond the input: what the library says (Delone), "
      "what "
      "it holds from malloc (the others).\n\n| points | Delone | CGAL | CGAL, index per vertex | Qhull |\n"
      "| --- | --- | --- | --- | --- |\n";
  const std::vector<std::string> columns{"CGAL", "CGAL-indexed", "Qhull"};
  bool any = false;
  for (const Race& race : races(o)) {
    if (!o.wants(race.section)) continue;
    any = true;
    std::vector<Contestant> contestants{{"Delone", o.native, "Delone", race.workload},
                                        {"Delone, portable", o.portable, "Delone", race.workload}};
    for (const std::string& rival : race.rivals) contestants.push_back({rival, o.native, rival, race.workload});
    alternate(contestants, o.rounds(race.rounds));

    double fastest = 0;
    std::string counts = std::to_string(contestants.front().samples.front().cells);
    for (std::size_t i = 2; i < contestants.size(); ++i) {
      const double rival = median(contestants[i]);
      if (fastest == 0 || rival < fastest) fastest = rival;
      const std::size_t cells = contestants[i].samples.front().cells;
      // Only ties allow different counts: random points have one triangulation.
      if (cells != contestants.front().samples.front().cells)
        counts += ", " + contestants[i].label + " " + std::to_string(cells);
    }
    const double ratio = fastest / median(contestants.front());
    text += "| " + race.workload.title + " | " + counts + " | " + seconds_text(contestants[0]) + " | " +
            seconds_text(contestants[1]);
    memory += "| " + race.workload.title + " | " + bytes_text(contestants[0]);
    for (const std::string& column : columns) {
      const auto rival = std::ranges::find(contestants, column, &Contestant::label);
      text += " | " + (rival == contestants.end() ? "" : seconds_text(*rival));
      memory += " | " + (rival == contestants.end() ? "" : bytes_text(*rival));
    }
    text += " | " + number(ratio, 2) + " |\n";
    memory += " |\n";
    if (race.target > 0)
      verdicts.push_back({race.workload.title + ", times as fast as the fastest rival", number(race.target, 1),
                          number(ratio, 2), ratio >= race.target});
    if (race.target_bytes > 0) {
      const double bytes = bytes_a_point(contestants.front());
      verdicts.push_back({race.workload.title + ", bytes a point at most", number(race.target_bytes, 0),
                          number(bytes, 0), bytes <= race.target_bytes});
    }
  }
  return any ? text + memory : "";
}

std::string report_distributions(const Options& o, std::vector<Verdict>& verdicts) {
  if (!o.wants("distributions")) return "";
  const std::size_t n = o.points(1000000);
  std::vector<Workload> workloads{{"random", "uniform", n, 2}};
  for (const char* kind : {"uniform", "ellipse2", "ellipse", "parabola", "circle"})
    workloads.push_back(
        {(kind == std::string("uniform") ? "random" : kind) + std::string(", 24 bits"), kind, n, 2, 24});
  for (const char* kind : {"ellipse2", "ellipse", "parabola", "circle", "clusters", "lattice"})
    workloads.push_back({kind, kind, n, 2});

  std::vector<Contestant> contestants;
  for (const char* peer : {"Delone", "CGAL"})
    for (const Workload& w : workloads) contestants.push_back({peer, o.native, peer, w});
  alternate(contestants, o.rounds(5));

  std::string text =
      "\n## Distributions of [Dev97] 5.5.1, and a lattice\n\n2D, " + std::to_string(n) +
      " points (the lattice 1000 x 1000). Seconds; relative: the time to that of random points (doubles).\n\n"
      "| points | vertices | Delone | relative | CGAL | relative |\n| --- | --- | --- | --- | --- | --- |\n";
  double worst = 0;
  std::string worst_name;
  const std::size_t rival = workloads.size();
  for (std::size_t i = 0; i < workloads.size(); ++i) {
    const double relative = median(contestants[i]) / median(contestants[0]);
    text += "| " + workloads[i].title + " | " + std::to_string(contestants[i].samples.front().vertices) + " | " +
            seconds_text(contestants[i]) + " | " + number(relative, 2) + " | " + seconds_text(contestants[rival + i]) +
            " | " + number(median(contestants[rival + i]) / median(contestants[rival]), 2) + " |\n";
    if (relative > worst) {
      worst = relative;
      worst_name = workloads[i].title;
    }
  }
  verdicts.push_back({"2D distributions and lattice, slowest against random, at most", "1.5",
                      number(worst, 2) + " (" + worst_name + ")", worst <= 1.5});
  return text;
}

/// [Dev97] 5.5.3 against what there is today.
std::string report_devillers(const Options& o) {
  if (!o.wants("devillers")) return "";
  const std::vector<std::string> peers{"Delone", "Delone-hierarchy", "CGAL", "CGAL-hierarchy", "Qhull"};
  const std::size_t n = o.points(500000);
  std::string text =
      "\n## Comparison of [Dev97] 5.5.3\n\n2D, " + std::to_string(n) +
      " points of 24 bits. Seconds. In the columns \"one by one\" the points are inserted in the order in "
      "which they come, which is\nrandom, and located by a hierarchy of levels; the other columns choose "
      "their order themselves.\n\n"
      "| points | Delone | Delone, one by one | CGAL | CGAL, one by one | Qhull |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const char* kind : {"uniform", "ellipse2", "ellipse", "parabola", "circle"}) {
    const std::string title = kind == std::string("uniform") ? "random" : kind;
    std::vector<Contestant> contestants;
    for (const std::string& peer : peers)
      contestants.push_back({peer, o.native, peer, {title, kind, n, 2, 24}, {}, peer == "Qhull"});
    alternate(contestants, o.rounds(3));
    text += "| " + title;
    for (const Contestant& c : contestants) text += " | " + seconds_text(c);
    text += " |\n";
  }
  return text;
}

/// Removal of random vertices, one call each, from a triangulation that is built outside the clock.
std::string report_removal(const Options& o, std::vector<Verdict>& verdicts) {
  if (!o.wants("removal")) return "";
  std::string text =
      "\n## Removal of random vertices\n\nOne call each, from a triangulation of uniform points that was built before. "
      "Seconds, and microseconds a vertex.\n\n| points | removed | Delone | a vertex | CGAL | a vertex | ratio |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const int dimension : {2, 3}) {
    for (const std::size_t share : {10, 20}) {
      const Workload w{std::to_string(dimension) + "D uniform 1e6", "uniform", o.points(1000000), dimension};
      const std::string verb = "-remove-" + std::to_string(share);
      std::vector<Contestant> contestants{{"Delone", o.native, "Delone" + verb, w},
                                          {"CGAL", o.native, "CGAL" + verb, w}};
      alternate(contestants, o.rounds(dimension == 2 ? 9 : 3));
      const double removed = static_cast<double>(w.n / share);
      const double ratio = median(contestants[1]) / median(contestants[0]);
      text += "| " + w.title + " | " + number(removed, 0);
      for (const Contestant& c : contestants)
        text += " | " + seconds_text(c) + " | " + number(1e6 * median(c) / removed, 2);
      text += " | " + number(ratio, 2) + " |\n";
      const double target = dimension == 2 ? 1.5 : 2.0;
      verdicts.push_back({w.title + ", " + number(removed, 0) + " removals, times as fast as CGAL", number(target, 1),
                          number(ratio, 2), ratio >= target});
    }
  }
  return text;
}

std::string report_large(const Options& o, std::vector<Verdict>& verdicts) {
  if (!o.wants("large")) return "";
  std::string text =
      "\n## Large inputs\n\nOne run each. Peak: the whole process, input included.\n\n"
      "| points | cells | seconds | bytes a point | peak MiB |\n| --- | --- | --- | --- | --- |\n";
  for (const Workload& w : {Workload{"2D uniform 1e7", "uniform", o.points(10000000), 2},
                            Workload{"3D uniform 3e6", "uniform", o.points(3000000), 3}}) {
    Contestant c{"Delone", o.native, "Delone", w};
    run_once(c, 1);
    text += "| " + w.title + " | " + std::to_string(c.samples[0].cells) + " | " + seconds_text(c) + " | " +
            bytes_text(c) + " | " + std::to_string(c.samples[0].peak_bytes >> 20) + " |\n";
    verdicts.push_back({w.title, "finishes", seconds_text(c) + " s", true});
  }
  return text;
}

std::string header(const Options& o) {
  std::string text = "# Results\n\n" + delone::bench::when_and_where(o.quick ? ", QUICK" : "");
  std::istringstream versions(output_of({o.native, "--versions"}));
  for (std::string line; std::getline(versions, line);) text += "* " + line + "\n";
  std::istringstream portable(output_of({o.portable, "--versions"}));
  for (std::string line; std::getline(portable, line);)
    if (line.starts_with("flags")) text += "* portable build: " + line + "\n";
  text +=
      "* Qhull is the shared library as Debian builds it; Delone, and no rival, is compiled with -ffp-contract=off\n\n"
      "One thread. Points in memory in random order; the clock covers construction with the library's own sort. Every "
      "run\n"
      "is a process of its own, repeated when it had to share its processor; the contestants of a row take turns on "
      "the\n"
      "same points, round after round. Given are the median and, in brackets, the least and the largest value.\n\n";
  return text;
}

void report(const Options& o) {
  std::vector<Verdict> verdicts;
  const std::string head = header(o);
  std::string body = report_races(o, verdicts);
  body += report_distributions(o, verdicts);
  body += report_removal(o, verdicts);
  body += report_devillers(o);
  body += report_large(o, verdicts);

  std::string targets;
  if (!verdicts.empty()) targets = "## Targets\n\n| what | target | reached | met |\n| --- | --- | --- | --- |\n";
  for (const Verdict& v : verdicts)
    targets += "| " + v.what + " | " + v.target + " | " + v.reached + " | " + (v.met ? "yes" : "**no**") + " |\n";
  if (disturbed > 0)
    targets +=
        "\n" + std::to_string(disturbed) + " runs had a processor for less than 97 % of their time: measure again.\n";
  std::printf("%s%s\n%s", head.c_str(), targets.c_str(), body.c_str());
}

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
                   "[2d|3d|weighted|dd|distributions|removal|devillers|large ...]\n");
      return 2;
    }
    report(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_report: %s\n", error.what());
    return 1;
  }
}
