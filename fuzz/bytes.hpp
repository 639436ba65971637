// Bytes of a fuzzer as numbers, in codings that give many ties or reach every double.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

namespace delone::fuzz {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> left) : left_(left) {}
  bool empty() const { return left_.empty(); }
  std::uint8_t next() {
    if (left_.empty()) return 0;
    const std::uint8_t byte = left_.front();
    left_ = left_.subspan(1);
    return byte;
  }
  double raw_double() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | next();
    const double x = std::bit_cast<double>(bits);
    return std::isfinite(x) ? x : 0.0;
  }

 private:
  std::span<const std::uint8_t> left_;
};

/// One number in the coding that the input has chosen.
inline double number(Bytes& bytes, int coding) {
  const std::uint8_t byte = bytes.next();
  const double small = static_cast<double>(byte % 8) - 3;
  switch (coding) {
    case 0:
      return small;  // a lattice
    case 1:
      return static_cast<double>(static_cast<std::int8_t>(byte));  // a larger one
    case 2:
      return std::ldexp(small, byte / 8 * 4 - 64);  // mixed magnitudes
    case 3:
      return std::ldexp(small, 1020);  // close to overflow
    case 4:
      return std::ldexp(small, -1074);  // denormal
    case 5:
      return std::nextafter(small, byte < 128 ? 10.0 : -10.0);  // a lattice, just missed
    case 6:
      return 1e6 + small * 0.1;  // decimals far from the origin
    default:
      return bytes.raw_double();  // any double
  }
}

}  // namespace delone::fuzz
