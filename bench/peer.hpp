// What the harness asks of every library it measures: build from points in memory, and say how long that took.
#pragma once

#include <malloc.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "bench/cache_misses.hpp"
#include "delone/geometry/points.hpp"

namespace delone::bench {

struct Run {
  double seconds = 0;        ///< construction, the library's own sort included; its copy of the points is made before
  double processor = 0;      ///< seconds of processor time in the same span: less when something else ran
  std::size_t cells = 0;     ///< finite ones
  std::size_t vertices = 0;  ///< 0 where the library does not say
  std::size_t bytes = 0;     ///< that the finished triangulation holds, its coordinates included
  std::map<std::string, double> counts;  ///< by name: what the library says of its work, and cache misses

  Run& operator+=(const Run& other) {
    seconds += other.seconds;
    processor += other.processor;
    cells += other.cells;
    vertices += other.vertices;
    bytes += other.bytes;
    for (const auto& [name, count] : other.counts) counts[name] += count;
    return *this;
  }
};

struct Peer {
  std::string name;     ///< as the harness spells it
  std::string version;  ///< of the library
  bool (*fits)(int dimension, bool weighted);
  Run (*run)(PointsView points);
};

// One translation unit per library.
std::vector<Peer> delone_peers();
std::vector<Peer> file_peers();
std::vector<Peer> cgal_2d_peers();
std::vector<Peer> cgal_3d_peers();
std::vector<Peer> cgal_d_peers();
std::vector<Peer> qhull_peers();

class Clock {
 public:
  Clock() {
    CacheMisses::here().start();
    processor_start_ = processor_now();
    start_ = std::chrono::steady_clock::now();
  }
  void stop(Run& run) const {
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    run.processor = processor_now() - processor_start_;
    if (const auto misses = CacheMisses::here().count()) run.counts["cache_misses"] = static_cast<double>(*misses);
  }

 private:
  static double processor_now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

  double processor_start_;
  std::chrono::steady_clock::time_point start_;
};

/// Bytes that the program holds from malloc, mapped blocks included.
inline std::size_t allocated() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Times `build()` and weighs what it returns; `counts(result)` gives cells and vertices.
template <class Build, class Counts>
Run measure(Build&& build, Counts&& counts) {
  const std::size_t before = allocated();
  const Clock clock;
  const auto result = build();
  Run run;
  clock.stop(run);
  run.bytes = allocated() - before;
  counts(*result, run);
  return run;
}

/// The time to remove one vertex in `share`, chosen at random, one after the other. Counts as for measure().
template <class T, class Handles, class Counts>
Run measure_removal(T& t, Handles vertices, std::size_t share, Counts&& counts) {
  std::mt19937_64 random(1);
  std::shuffle(vertices.begin(), vertices.end(), random);
  vertices.resize(vertices.size() / share);
  const Clock clock;
  for (const auto& v : vertices) t.remove(v);
  Run run;
  clock.stop(run);
  run.bytes = allocated();
  counts(t, run);
  return run;
}

}  // namespace delone::bench
