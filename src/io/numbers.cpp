#include "io/numbers.hpp"

#include <algorithm>
#include <charconv>

#include "io/complain.hpp"

namespace delone::io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }

bool same_word(std::string_view text, std::string_view word) { return std::ranges::equal(text, word, {}, lower); }

bool is_not_finite(std::string_view unsigned_text) {
  for (const char* word : {"nan", "inf", "infinity", "nan(ind)", "nan(snan)", "1.#inf", "1.#ind", "1.#qnan"}) {
    if (same_word(unsigned_text, word)) return true;
  }
  return false;
}

/// Digits with at most one `point` among them; at least one digit.
bool is_digits(std::string_view text, char point) {
  const auto digits = std::ranges::count_if(text, is_digit);
  const auto points = std::ranges::count(text, point);
  return digits > 0 && points <= 1 && static_cast<std::size_t>(digits + points) == text.size();
}

bool is_exponent(std::string_view text) {
  if (!text.empty() && is_sign(text.front())) text.remove_prefix(1);
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

bool has_fortran_exponent(std::string_view text) {
  const std::size_t mark = text.find_first_of("dDqQ");
  return mark != std::string_view::npos && is_digits(text.substr(0, mark), '.') && is_exponent(text.substr(mark + 1));
}

bool has_decimal_comma(std::string_view text) {
  if (text.find(',') == std::string_view::npos) return false;
  const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
  if (mark < text.size() && !is_exponent(text.substr(mark + 1))) return false;
  const std::string_view digits = text.substr(0, mark);
  return std::ranges::any_of(digits, is_digit) &&
         std::ranges::all_of(digits, [](char c) { return is_digit(c) || c == ',' || c == '.'; });
}

bool is_several(std::string_view text) {
  const std::size_t blank = text.find(' ');
  if (blank == std::string_view::npos) return false;
  const std::size_t second = std::min(text.find_first_not_of(' ', blank), text.size());
  const std::size_t end = std::min(text.find(' ', second), text.size());
  const auto number = [](std::string_view part) {
    double value = 0;
    return parse_number(part, value) == NumberFault::none;
  };
  return number(text.substr(0, blank)) && number(text.substr(second, end - second));
}

NumberFault parse_hexadecimal(std::string_view digits, bool negative, double& value) {
  if (digits.empty() || is_sign(digits.front())) return NumberFault::text;
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value, std::chars_format::hex);
  if (end != last || error == std::errc::invalid_argument) return NumberFault::text;
  const std::string_view mantissa = digits.substr(0, digits.find_first_of("pP"));
  const bool zero = mantissa.find_first_not_of("0.") == std::string_view::npos;
  if (error == std::errc::result_out_of_range) {
    if (zero) {  // a zero with a wild exponent is still zero
      value = negative ? -0.0 : 0.0;
      return NumberFault::none;
    }
    const std::size_t mark = digits.find_first_of("pP");
    const bool small = mark != std::string_view::npos && digits.substr(mark + 1).starts_with('-');
    return small ? NumberFault::too_small : NumberFault::too_large;
  }
  if (!std::isfinite(value)) return NumberFault::text;  // from_chars reads the words inf and nan in every base
  if (value == 0.0 && !zero) return NumberFault::too_small;
  if (negative) value = -value;
  return NumberFault::none;
}

}  // namespace

NumberFault parse_number_slowly(std::string_view text, double& value) {
  if (text.empty()) return NumberFault::empty;
  const bool negative = text.front() == '-';
  const std::string_view body = text.substr(is_sign(text.front()) ? 1 : 0);
  if (body.empty()) return NumberFault::text;
  if (is_not_finite(body)) return NumberFault::not_finite;
  if (body.starts_with("0x") || body.starts_with("0X")) return parse_hexadecimal(body.substr(2), negative, value);
  if (has_fortran_exponent(body)) return NumberFault::fortran_exponent;
  if (has_decimal_comma(body)) return NumberFault::decimal_comma;
  if (is_several(text)) return NumberFault::several;
  if (!is_digit(body.front()) && body.front() != '.') return NumberFault::text;

  const char* const last = body.data() + body.size();
  const auto [end, error] = fast_float::from_chars(body.data(), last, value);
  if (end != last || error == std::errc::invalid_argument) return NumberFault::text;
  const std::string_view mantissa = body.substr(0, body.find_first_of("eE"));
  const bool zero = mantissa.find_first_not_of("0.") == std::string_view::npos;
  if (zero) {
    value = negative ? -0.0 : 0.0;
    return NumberFault::none;
  }
  if (value == 0.0) return NumberFault::too_small;
  if (!std::isfinite(value)) return NumberFault::too_large;
  if (negative) value = -value;
  return NumberFault::none;
}

std::string explain(NumberFault fault, std::string_view text) {
  const std::string found = quoted(text);
  switch (fault) {
    case NumberFault::none:
    case NumberFault::text:
      return "expected a number, found " + found;
    case NumberFault::empty:
      return "expected a number, found nothing";
    case NumberFault::not_finite:
      return "expected a finite number, found " + found;
    case NumberFault::too_large:
      return "expected a number within the range of double, found " + found;
    case NumberFault::too_small:
      return "expected a number within the range of double, found " + found + ", which would become 0";
    case NumberFault::fortran_exponent:
      return "expected a number, found " + found + ": write the exponent with e";
    case NumberFault::decimal_comma:
      return "expected a number, found " + found + ": write a decimal point, and nothing between thousands";
    case NumberFault::several:
      return "expected a number, found " + found + ": write decimal points, and one number per entry";
  }
  return "expected a number, found " + found;
}

bool parse_whole(std::string_view text, std::uint64_t& value) {
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return !text.empty() && end == last && error == std::errc();
}

}  // namespace delone::io
