#include "io/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace delone::io {
namespace {

double parsed(std::string_view text) {
  double value = 0;
  EXPECT_EQ(parse_number(text, value), NumberFault::none) << text;
  return value;
}

NumberFault fault(std::string_view text) {
  double value = 0;
  return parse_number(text, value);
}

TEST(Numbers, decimals_are_rounded_to_the_nearest_double) {
  EXPECT_EQ(parsed("0.1"), 0x1.999999999999ap-4);
  EXPECT_EQ(parsed("9007199254740993"), 9007199254740992.0);        // a tie: to even
  EXPECT_EQ(parsed("9007199254740993.00001"), 9007199254740994.0);  // just above it
  EXPECT_EQ(parsed("1.7976931348623157e308"), 0x1.fffffffffffffp1023);
  EXPECT_EQ(parsed("4.9406564584124654e-324"), 0x1p-1074);
  EXPECT_EQ(parsed("2.2250738585072011e-308"), 0x0.fffffffffffffp-1022);
}

TEST(Numbers, usual_spellings_are_read) {
  EXPECT_EQ(parsed("1."), 1.0);
  EXPECT_EQ(parsed(".5"), 0.5);
  EXPECT_EQ(parsed("+2.5"), 2.5);
  EXPECT_EQ(parsed("-7"), -7.0);
  EXPECT_EQ(parsed("1E3"), 1000.0);
  EXPECT_EQ(parsed("1e+3"), 1000.0);
  EXPECT_EQ(parsed("00012"), 12.0);
}

TEST(Numbers, zero_keeps_its_sign) {
  EXPECT_FALSE(std::signbit(parsed("0")));
  EXPECT_TRUE(std::signbit(parsed("-0.0")));
  EXPECT_EQ(parsed("0e-999"), 0.0);
  EXPECT_EQ(parsed("0e999"), 0.0);
  EXPECT_EQ(parsed("0x0p-9999"), 0.0);
}

TEST(Numbers, hexadecimals_are_exact_or_rounded_to_nearest) {
  EXPECT_EQ(parsed("0x1.8p3"), 12.0);
  EXPECT_EQ(parsed("-0X1P-1074"), -0x1p-1074);
  EXPECT_EQ(parsed("+0x10"), 16.0);
  EXPECT_EQ(parsed("0x.8"), 0.5);
  EXPECT_EQ(parsed("0x1.00000000000008p0"), 1.0);                // a tie: to even
  EXPECT_EQ(parsed("0x1.000000000000080001p0"), 1.0 + 0x1p-52);  // just above it
  EXPECT_EQ(parsed("0x1.fffffffffffff8p0"), 2.0);                // a tie that carries
  EXPECT_EQ(parsed("0x1.8p-1074"), 0x1p-1073);                   // a tie among denormals
  EXPECT_EQ(parsed("0x1.4p-1074"), 0x1p-1074);
  EXPECT_EQ(parsed("0x0.8000000001p-1074"), 0x1p-1074);  // just above half of the smallest
}

TEST(Numbers, hexadecimals_agree_with_the_c_library) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 20'000; ++trial) {
    char text[64];
    const int exponent = static_cast<int>(random() % 2200) - 1120;
    std::snprintf(text, sizeof text, "0x%llx.%llxp%d", static_cast<unsigned long long>(random() >> (random() % 64)),
                  static_cast<unsigned long long>(random() >> (random() % 64)), exponent);
    const double expected = std::strtod(text, nullptr);
    double value = 0;
    const NumberFault result = parse_number(text, value);
    if (std::isinf(expected)) {
      EXPECT_EQ(result, NumberFault::too_large) << text;
    } else if (result == NumberFault::none) {
      EXPECT_EQ(value, expected) << text;
    } else {
      EXPECT_EQ(expected, 0.0) << text;
      EXPECT_EQ(result, NumberFault::too_small) << text;
    }
  }
}

TEST(Numbers, what_is_beyond_double_is_refused) {
  EXPECT_EQ(fault("1e400"), NumberFault::too_large);
  EXPECT_EQ(fault("-1e400"), NumberFault::too_large);
  EXPECT_EQ(fault("1.7976931348623159e308"), NumberFault::too_large);
  EXPECT_EQ(fault("0x1p1024"), NumberFault::too_large);
  EXPECT_EQ(fault("1e-400"), NumberFault::too_small);
  EXPECT_EQ(fault("2.4e-324"), NumberFault::too_small);
  EXPECT_EQ(fault("0x1p-1076"), NumberFault::too_small);
}

TEST(Numbers, other_programs_spellings_are_told_apart) {
  for (const char* text : {"1.0D5", "1d-3", "+2.D+03", "1Q5"})
    EXPECT_EQ(fault(text), NumberFault::fortran_exponent) << text;
  for (const char* text : {"1,5", "-1,5", "1.234,5", "1,234.5", "1,5e3", ",5"}) {
    EXPECT_EQ(fault(text), NumberFault::decimal_comma) << text;
  }
  for (const char* text : {"5 2", "5  2.5 7"}) EXPECT_EQ(fault(text), NumberFault::several) << text;
  for (const char* text : {"nan", "NaN", "-inf", "Infinity", "+INF"})
    EXPECT_EQ(fault(text), NumberFault::not_finite) << text;
}

TEST(Numbers, texts_are_no_numbers) {
  for (const char* text :
       {"abc", "1x", "1 x", "--1",  "+-1",  "-+1", "e5",    "1e", "1e+",      ".",         "-",
        "+",   "0x", "0xg", "0x1p", "0x-1", "x10", "1.2.3", "D5", "infinite", "nanometre", "1_000"}) {
    EXPECT_EQ(fault(text), NumberFault::text) << text;
  }
  EXPECT_EQ(fault(""), NumberFault::empty);
}

TEST(Numbers, whole_numbers_are_digits_only) {
  std::uint64_t value = 0;
  EXPECT_TRUE(parse_whole("18446744073709551615", value));
  EXPECT_EQ(value, 18446744073709551615U);
  for (const char* text : {"", "-1", "+1", "1.0", "1e3", "18446744073709551616", "1 "}) {
    EXPECT_FALSE(parse_whole(text, value)) << text;
  }
}

}  // namespace
}  // namespace delone::io
