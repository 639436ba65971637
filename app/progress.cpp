#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "interrupt.hpp"

namespace delone::cli {

ProgressBar::ProgressBar(std::string label) : label_(std::move(label)), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

Progress ProgressBar::callback() {
  return [this](double done) {
    if (terminal_ && watch_.seconds() >= next_) draw(std::clamp(done, 0.0, 1.0));
    return interrupted() == 0;
  };
}

void ProgressBar::draw(double done) {
  constexpr int kWidth = 30;
  const auto full = static_cast<std::size_t>(done * kWidth);
  const std::string bar = std::string(full, '#') + std::string(kWidth - full, '.');
  std::fputs(fmt::format("\r{} [{}] {:3.0f} %\033[K", label_, bar, 100 * done).c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
  next_ = watch_.seconds() + 0.1;
}

}  // namespace delone::cli
