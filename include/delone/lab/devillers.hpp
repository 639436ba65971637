// The experiments of [Dev97], run again: the table of 5.5.2 and the curve of 4.4.
// Source: [Dev97] 4.4 (costs in operations against the ratio of two levels), 5.5.1 (distributions), 5.5.2 (the table).
// Departure from [Dev97] 5.5.2: beside seconds, which depend on the machine, operations are counted, which do not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/locate/hierarchy.hpp"

namespace delone::lab {

/// A column of the table: one locator with the parameters that make it this method [Dev97] 5.4.
struct LocationMethod {
  std::string name;
  Hierarchy locator;
};
/// walk, jump and walk, hierarchy, hierarchy with jump and walk on its highest level. @param straight  march as
/// [Dev97] 2.2 on all levels, else by the visibility walk
std::vector<LocationMethod> location_methods(bool straight);

/// How an entry of the table came about.
enum class Measured : std::uint8_t { whole, estimated, stopped };

/// One distribution, size and method. Operations are per point.
struct InsertionRun {
  std::string distribution, method;
  std::size_t points = 0;
  Measured measured = Measured::whole;
  double seconds = 0;        ///< processor time; of an estimate from smaller sizes
  double paper_seconds = 0;  ///< of 1997, 0 where the paper has none
  double steps = 0;          ///< cells walked through or turned through, on all levels
  double orientations = 0;   ///< orientation tests that location took
  double distances = 0;      ///< squared distances
  std::size_t levels = 0;    ///< with the lowest
  double locator_bytes = 0;  ///< per point
  std::uint64_t hash = 0;    ///< of the triangulation: the same for all methods
};

struct InsertionOptions {
  std::vector<std::size_t> sizes{5000, 50000, 500000};
  std::vector<std::string> distributions{"random", "ellipse2", "ellipse", "parabola", "circle"};
  double limit = 120;    ///< seconds that an entry may take; longer ones are estimated from the smaller sizes
  bool straight = true;  ///< see location_methods
  std::uint64_t seed = 1;
  std::function<void(const InsertionRun&)> on_run = nullptr;  ///< hears of every entry when it is done
};

/// [Dev97] 5.5.2: points of 24 bits, inserted one by one in random order. Rows by distribution and size, then method.
/// @throws InputError for an unknown distribution
std::vector<InsertionRun> run_insertions(const InsertionOptions& options);

/// What a query costs at one ratio, on average: operations, and these weighed as [Dev97] 4.4 weighs them.
struct TuningPoint {
  double ratio = 0;
  double levels = 0;
  double line_tests = 0, facet_tests = 0, distances = 0;
  double operations = 0;             ///< floating-point operations
  double per_logarithm = 0;          ///< operations by log2 of the number of points
  double paper_per_logarithm = 0;    ///< (32 + 6.2 sqrt(ratio)) / log2(ratio), as in [Dev97] 4.4
  double doubled_per_logarithm = 0;  ///< (32 + 12.4 sqrt(ratio)) / log2(ratio): with 4.2's number of edges crossed
};

struct TuningOptions {
  std::vector<double> ratios{3, 4, 6, 8, 10, 14, 18, 24, 30, 40, 50, 60, 75, 90, 120, 150, 200, 250, 300};
  std::size_t least_size = 20000, most_size = 200000;  ///< sizes between them are averaged: levels are whole numbers
  std::size_t size_count = 12;
  std::size_t queries = 1000;  ///< for each size
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// [Dev97] 4.4: uniform points in a square, uniform queries.
std::vector<TuningPoint> run_tuning(const TuningOptions& options);

}  // namespace delone::lab
