// The double nearest to a quotient of long integers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "exact/integer.hpp"

namespace delone::exact {

/// numerator / denominator * 2^exponent, rounded once, to nearest and ties to even; infinite beyond the largest double.
/// @param denominator  positive
inline double nearest_double(const BigInt& numerator, const BigInt& denominator, int exponent) {
  if (numerator == 0) return 0.0;
  const BigInt size = abs(numerator);
  // A quotient of 56 or 57 bits, the last of which tells whether something was cut off.
  const int shift = 56 - (static_cast<int>(msb(size)) - static_cast<int>(msb(denominator)));
  BigInt quotient, rest;
  divide_qr(shift > 0 ? BigInt(size << shift) : size, shift < 0 ? BigInt(denominator << -shift) : denominator, quotient,
            rest);
  auto bits = static_cast<std::uint64_t>(quotient) << 1 | (rest != 0 ? 1U : 0U);
  const int unit = exponent - shift - 1;
  const int last = std::max(unit + static_cast<int>(std::bit_width(bits)) - 53, -1074);  // of the result
  const int dropped = last - unit;
  if (dropped > 60) return numerator < 0 ? -0.0 : 0.0;
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  const std::uint64_t tail = bits & (2 * half - 1);
  bits >>= dropped;
  bits += tail > half || (tail == half && (bits & 1) != 0) ? 1 : 0;
  return std::ldexp(numerator < 0 ? -static_cast<double>(bits) : static_cast<double>(bits), last);
}

}  // namespace delone::exact
