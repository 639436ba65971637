// Numbers in text: decimal and C99 hexadecimal, rounded to the nearest double, or the reason why not.
#pragma once

#include <fast_float/fast_float.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace delone::io {

enum class NumberFault {
  none,
  empty,             ///< nothing there
  text,              ///< does not look like a number
  not_finite,        ///< nan, inf, infinity
  too_large,         ///< beyond the largest double: 1e400
  too_small,         ///< not zero, but the nearest double is: 1e-400
  fortran_exponent,  ///< 1.0D5
  decimal_comma,     ///< 1,5
  several,           ///< 1 2: what "0,1 2,3" looks like between commas
};

/// Everything that fast parsing does not settle: leading '+', hexadecimal, zero, and faults.
NumberFault parse_number_slowly(std::string_view text, double& value);

/// Where the number at the front of [first, last) ends; null where fast parsing does not settle that it is one.
inline const char* parse_leading_number(const char* first, const char* last, double& value) {
  const auto [end, error] = fast_float::from_chars(first, last, value);
  if (error != std::errc() || !std::isfinite(value)) return nullptr;
  const bool settled = value != 0.0 || parse_number_slowly({first, end}, value) == NumberFault::none;
  return settled ? end : nullptr;
}

/// The double nearest to `text`, all of which must be the number.
inline NumberFault parse_number(std::string_view text, double& value) {
  const char* const last = text.data() + text.size();
  const char* const end = parse_leading_number(text.data(), last, value);
  if (end != nullptr && end == last) return NumberFault::none;
  return parse_number_slowly(text, value);
}

/// A written number, if perhaps one that is refused: anything but text and nothing.
inline bool looks_like_number(std::string_view text) {
  double value = 0;
  const NumberFault fault = parse_number(text, value);
  return fault != NumberFault::text && fault != NumberFault::empty;
}

/// "expected a number, found '1.0D5': write the exponent with e"
std::string explain(NumberFault fault, std::string_view text);

/// All of `text` as a whole number of at least zero; false when it is none or too large.
bool parse_whole(std::string_view text, std::uint64_t& value);

}  // namespace delone::io
