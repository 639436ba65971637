// What filters of predicates share: when a double tells a sign for sure, and when it holds every digit.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace delone {

namespace filter {

inline constexpr int kUnsure = 2;
inline constexpr double kU = 0x1p-53;
/// Coordinates up to here: products of eight differences and a lift stay below 2^1001.
inline constexpr double kLargest = 0x1p99;

/// @param bound  at least 0; unsure when either is no number
inline int sign_beyond(double value, double bound) {
  if (!(std::abs(value) > bound)) [[unlikely]]
    return kUnsure;
  return value > 0.0 ? 1 : -1;
}

/// 2^exponent; zero where that is no normal number, infinity where it is too large.
inline double power_of_two(int exponent) {
  if (exponent < -1022) return 0.0;
  if (exponent > 1023) return std::numeric_limits<double>::infinity();
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// On coordinates that are integers times 2^unit all terms of a determinant of `degree` factors are integers times
/// 2^(unit degree): while their sum stays below 2^53 of these, doubles hold every one, and a zero is a zero. So
/// lattices never leave the filter in 2D and 3D.
inline double exact_below(int unit, int degree) {
  const int exponent = unit * degree + 53;
  return exponent > -900 && exponent < 900 ? power_of_two(exponent) : 0.0;
}

/// The same for the `size` of an estimate: in 2D a bound on the permanent, in 3D the square of S^(3/2) H, of which the
/// permanent is less than 4.8 times the root.
template <int K>
double conflict_exact_below(int unit) {
  if constexpr (K == 2) return exact_below(unit, 4);
  if constexpr (K == 3) {
    const double below = exact_below(unit, 5) / (4.0 * 1.2);
    return below > 0x1p-400 && below < 0x1p400 ? below * below : 0.0;
  }
  return 0.0;  // never: sizes are infinite
}

/// Roundings of the lifted determinant as written for K = 2 and 3. A lift that also sums other coordinates and a weight
/// carries for each of the former a difference taken twice, a square and a sum, and for the latter two more: since all
/// these share their place with the squares already counted, two for each and four in all cover them.
constexpr double conflict_roundings(int k) { return k == 2 ? 10.1 : 16.1; }

inline int exact_sign(double value) { return static_cast<int>(value > 0.0) - static_cast<int>(value < 0.0); }

}  // namespace filter

}  // namespace delone
