// Which arithmetic decides the signs: how many tests end at which stage, and how long the numbers are.
// Source: [For92] 4.7 (bits of a determinant by its degree), [Dev97] 5.2 (degrees of the tests), 5.3 (24 bits).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// What insertion one by one asked of one set of points.
struct StageCounts {
  std::string kind;
  int dimension = 0;
  int rounded_to = 0;  ///< bits that points were rounded to, 0: doubles as they come
  std::size_t n = 0;
  PredicateStats tests;
  int input_bits = 0;  ///< of the largest coordinate, over the largest power of two that divides all
  /// Bits of the largest determinant of the triangulation's cells, and of those with the site beyond each facet.
  int orient_bits = 0, conflict_bits = 0;
  double nanoseconds = 0;  ///< of processor time for each test of a cell against the site beyond a facet, if timed
  std::uint64_t orients() const { return tests.orient_filter + tests.orient_exact; }
  std::uint64_t conflicts() const {
    return tests.conflict_filter + tests.conflict_adaptive + tests.conflict_exact + tests.conflict_symbolic;
  }
};

/// Bits that a determinant of differences of b-bit numbers may have: as a polynomial of degree d (orientation) and
/// d + 2 (conflict) it has about d b and (d + 2) b ([For92] 4.7); with the signs of differences, the sums of squares
/// and Hadamard's bound on the terms the numbers here are sure.
/// Departure from [For92] 4.7, which says d + 1 for orientation: its row of ones is no factor ([Dev97] 5.2: degree 2 in
/// the plane).
int orient_bits_bound(int dimension, int input_bits);
int conflict_bits_bound(int dimension, int input_bits);

struct ArithmeticOptions {
  std::size_t n = 10000;        ///< of kinds whose triangulations are linear
  std::size_t n_square = 1000;  ///< of those with a number of tetrahedra like n^2
  std::vector<int> bits{0, 24};
  bool timed = false;
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// All kinds of points that exist in the plane, then all that exist in space; each rounded to each number of bits.
std::vector<StageCounts> run_arithmetic(const ArithmeticOptions& options);

}  // namespace delone::lab
