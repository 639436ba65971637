// What the reports have in common: numbers in words, and the machine that they were measured on.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "delone/lab/machine.hpp"
#include "delone/lab/race.hpp"

namespace delone::bench {

inline std::string number(double x, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, x);
  return text.data();
}

/// "Written by `make bench` on <date><remark>.", and the line of the machine.
inline std::string when_and_where(const std::string& remark) {
  return "Written by `make bench` on " + lab::today() + remark + ".\n\n* machine: " + lab::machine() + "\n";
}

}  // namespace delone::bench
