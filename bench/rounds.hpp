// Runs that take turns in one process, each repeated when it had to share its processor.
#pragma once

#include <cstdint>
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

}  // namespace delone::bench
