// A bar on standard error for jobs that last longer than a second, and the way Ctrl-C gets into the library.
#pragma once

#include <string>

#include "command.hpp"
#include "delone/base/progress.hpp"

namespace delone::cli {

class ProgressBar {
 public:
  /// @param label  what is being done; nothing is ever drawn when standard error is not a terminal
  explicit ProgressBar(std::string label);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// To hand to the library; cancels when the user interrupts. Must not outlive the bar.
  Progress callback();

 private:
  void draw(double done);

  std::string label_;
  bool terminal_;
  bool drawn_ = false;
  Stopwatch watch_;
  double next_ = 1;  // when to draw again, in seconds
};

}  // namespace delone::cli
