// How long a phase took.
#pragma once

#include <chrono>
#include <utility>

namespace delone {

class Stopwatch {
 public:
  /// Seconds since it was made, or since the last lap.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - last_).count(); }
  /// The same, and begins the next lap.
  double lap() {
    const auto now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace delone
