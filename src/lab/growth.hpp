// How counts grow: sizes to try, and the line through what was measured.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/base/random.hpp"

namespace delone::lab {

/// 1 + 1/2 + ... + 1/n.
double harmonic(std::size_t n);

/// least, least * factor, ... below `most`, and `most` itself.
std::vector<std::size_t> sizes_up_to(std::size_t most, std::size_t least, std::size_t factor);

struct Line {
  double slope = 0, height = 0;  ///< y = slope * x + height
};
/// Of least squares. Requires two points with different x, else the slope is NaN.
Line fitted_line(std::span<const std::array<double, 2>> points);

/// The b of y = a x^b, fitted to logarithms.
double exponent(std::span<const std::array<double, 2>> points);

/// Random numbers of one of several runs: others for every seed and run.
constexpr std::uint64_t run_seed(std::uint64_t seed, int run) {
  return mix(mix(seed) + static_cast<std::uint64_t>(run));
}

/// Tells how much of some work is done, in units of the caller's choice.
class Work {
 public:
  Work(const Progress& progress, double all) : progress_(&progress), all_(all) {}
  /// @throws Cancelled
  void done(double units) {
    done_ += units;
    if (*progress_ && !(*progress_)(done_ < all_ ? done_ / all_ : 1.0)) throw Cancelled();
  }

 private:
  const Progress* progress_;
  double all_, done_ = 0;
};

}  // namespace delone::lab
