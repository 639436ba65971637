#include "delone/lab/machine.hpp"

#include <fmt/chrono.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

namespace delone::lab {
namespace {

/// The value of the first line of a file that starts with `key`, after the colon or equals sign.
std::string line_value(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(key)) continue;
    std::string value = line.substr(line.find_first_of(":=") + 1);
    value.erase(0, value.find_first_not_of(" \t\""));
    value.erase(value.find_last_not_of(" \t\"") + 1);
    return value;
  }
  return "unknown";
}

/// Some are all called alike, old ones and new ones.
std::string processor() {
  constexpr const char* kFile = "/proc/cpuinfo";
  const std::string name = line_value(kFile, "model name");
  const std::string family = line_value(kFile, "cpu family");
  if (family == "unknown") return name;
  return fmt::format("{} (family {}, model {})", name, family, line_value(kFile, "model\t"));
}

}  // namespace

std::string machine() {
  const double gib = std::strtod(line_value("/proc/meminfo", "MemTotal").c_str(), nullptr) / (1024 * 1024);
  return fmt::format("{}, {} processors, {:.0f} GiB, {}", processor(), std::thread::hardware_concurrency(), gib,
                     line_value("/etc/os-release", "PRETTY_NAME"));
}

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))); }

}  // namespace delone::lab
