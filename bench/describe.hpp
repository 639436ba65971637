// What the reports have in common: numbers in words, and the machine that they were measured on.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace delone::bench {

struct Spread {
  double median = 0, least = 0, most = 0;
};

inline Spread spread(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  return {median, values.front(), values.back()};
}

inline std::string number(double x, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, x);
  return text.data();
}

/// The value of the first line of a file that starts with `key`, after the colon or equals sign.
inline std::string line_value(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t at = line.find_first_of(":=");
    std::string value = line.substr(at + 1);
    value.erase(0, value.find_first_not_of(" \t\""));
    value.erase(value.find_last_not_of(" \t\"") + 1);
    return value;
  }
  return "unknown";
}

/// "Written by `make bench` on <date><remark>.", and the line of the machine.
inline std::string when_and_where(const std::string& remark) {
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%d", std::gmtime(&now));
  const double gib = std::strtod(line_value("/proc/meminfo", "MemTotal").c_str(), nullptr) / (1024 * 1024);
  return "Written by `make bench` on " + std::string(date.data()) + remark +
         ".\n\n* machine: " + line_value("/proc/cpuinfo", "model name") + ", " +
         std::to_string(std::thread::hardware_concurrency()) + " processors, " + number(gib, 0) + " GiB, " +
         line_value("/etc/os-release", "PRETTY_NAME") + "\n";
}

}  // namespace delone::bench
