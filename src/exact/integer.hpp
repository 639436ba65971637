// Doubles as exact integers: every finite double is m * 2^e with a 53-bit m, so over a common power of two a set of
// doubles is a set of integers. Private to the library: the big integers are Boost's, and Boost stays out of the
// public headers.
#pragma once

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace delone::exact {

using Int128 = __int128;

/// Signed integers of at most `Bits` bits, on the stack; the caller proves that nothing overflows.
template <unsigned Bits>
using FixedInt = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<Bits, Bits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// Integers of any size.
using BigInt = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// x = mantissa * 2^exponent with an odd mantissa of at most 53 bits; zero is 0 * 2^0.
struct Scaled {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

inline Scaled decompose(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>((bits >> 52) & 0x7FF);
  std::int64_t m = static_cast<std::int64_t>(bits & 0xF'FFFF'FFFF'FFFF);
  if (field != 0) m |= std::int64_t{1} << 52;
  if (m == 0) return {};
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(m));
  m >>= zeros;
  const int exponent = (field == 0 ? 1 : field) - 1075 + zeros;
  return {(bits >> 63) != 0 ? -m : m, exponent};
}

/// Bits that |x.mantissa| * 2^(x.exponent - unit) takes; `unit` is at most x.exponent.
inline int bit_length(Scaled x, int unit) {
  if (x.mantissa == 0) return 0;
  const auto magnitude = static_cast<std::uint64_t>(x.mantissa < 0 ? -x.mantissa : x.mantissa);
  return static_cast<int>(std::bit_width(magnitude)) + x.exponent - unit;
}

/// The integer x / 2^unit; `unit` is at most x.exponent, and the result fits into Int.
template <class Int>
Int to_integer(Scaled x, int unit) {
  if (x.mantissa == 0) return Int(0);
  const Int magnitude = Int(x.mantissa < 0 ? -x.mantissa : x.mantissa) << (x.exponent - unit);
  return x.mantissa < 0 ? Int(-magnitude) : magnitude;
}

template <class Int>
int sign(const Int& x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

inline int bit_width(std::int64_t x) {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(x < 0 ? -x : x)));
}

/// Calls f with an integer type of at least `bits` bits and a sign.
template <class F>
int with_integer(int bits, F&& f) {
  if (bits < 127) return f(Int128{});
  if (bits < 255) return f(FixedInt<256>{});
  if (bits < 511) return f(FixedInt<512>{});
  return f(BigInt{});
}

/// Lowers `unit` so that 2^(unit * share) divides x.
inline void lower_unit(int& unit, Scaled x, int share = 1) {
  const int floored = x.exponent >= 0 ? x.exponent / share : -((share - 1 - x.exponent) / share);
  if (x.mantissa != 0) unit = std::min(unit, floored);
}

}  // namespace delone::exact
