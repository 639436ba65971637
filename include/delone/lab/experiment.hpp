// An experiment of the laboratory: what a theorem says, beside what a machine counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/lab/chart.hpp"
#include "delone/lab/race.hpp"

namespace delone::lab {

struct LabOptions {
  std::size_t n = 0;  ///< size of the input, 0 for the usual one of the experiment
  int runs = 0;       ///< how many times with other random numbers, 0 for the usual number
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// Mean of some values, and their standard deviation.
struct Estimate {
  double mean = 0, deviation = 0;
};
Estimate estimate(std::span<const double> values);

/// A word, or a number: in a table with few digits, in a file with all.
using Value = std::variant<std::string, double>;

struct LabTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
  std::string note = {};  ///< a line below
};

struct LabReport {
  std::string heading;  ///< which theorem of which paper, in a sentence or two
  std::vector<LabTable> tables;
  std::string chart_title;
  std::vector<Panel> panels;
};

struct Experiment {
  std::string name;
  std::string text;  ///< one line
  /// Seconds that a run is likely to take on a machine of today: a guess that is right within a factor of a few.
  std::function<double(const LabOptions&)> seconds;
  /// @throws InputError for sizes that make no sense, before any work; Cancelled
  std::function<LabReport(const LabOptions&)> run;
};

/// All of them.
std::span<const Experiment> experiments();

/// Tables as text, columns aligned.
std::string to_words(const LabReport& report);
/// Tables as comma-separated values, each below its title in a comment line.
std::string to_csv(const LabReport& report);

}  // namespace delone::lab
