// Runs that take turns in one process, each repeated when it had to share its processor.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "bench/describe.hpp"
#include "bench/peer.hpp"

namespace delone::bench {

struct Sample {
  double seconds = 0;
  double processor = 0;
};

inline Sample timed(const std::function<void()>& work) {
  const Clock clock;
  work();
  Run run;
  clock.stop(run);
  return {run.seconds, run.processor};
}

/// Runs that something else disturbed are repeated; what stays disturbed is counted.
inline int disturbed = 0;

inline double undisturbed_seconds(const std::function<void()>& work) {
  Sample sample = timed(work);
  for (int again = 0; again < 3 && sample.processor < 0.97 * sample.seconds; ++again) sample = timed(work);
  if (sample.processor < 0.97 * sample.seconds) ++disturbed;
  return sample.seconds;
}

inline std::vector<double> uniform(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> x(count);
  for (double& value : x) value = static_cast<double>(random() >> 11) * 0x1p-53;
  return x;
}

/// "median (least-most)".
inline std::string spread_text(const std::vector<double>& values, double scale, int digits) {
  if (values.empty()) return "";
  const auto s = lab::spread(values);
  return number(s.median * scale, digits) + " (" + number(s.least * scale, digits) + "-" +
         number(s.most * scale, digits) + ")";
}

/// What a benchmark's main does: NAME [--quick] [ROUNDS], 5 rounds or with --quick one. run(quick, rounds)
template <class Run>
int main_of(const char* name, int argc, char** argv, const Run& run) {
  try {
    const bool quick = argc > 1 && argv[1] == std::string("--quick");
    const int given = argc > (quick ? 2 : 1) ? std::atoi(argv[quick ? 2 : 1]) : 0;
    run(quick, given > 0 ? given : (quick ? 1 : 5));
    if (disturbed > 0) std::printf("\n%d runs had to share their processor: measure again.\n", disturbed);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
}

}  // namespace delone::bench
