// Integers modulo 2^(64 Limbs) in two's complement: additions and products may wrap, and a polynomial whose true value
// fits comes out right all the same, since the integers modulo a power of two are a ring. So only the result of a
// determinant must be bounded, never what is met on the way to it. No branches, no memory, no size kept at run time:
// a 256-bit product costs ten machine products, by a machine word four.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "exact/integer.hpp"

namespace delone::exact {

template <int Limbs>
class Wide {
 public:
  Wide() = default;  // not initialised, like a built-in integer
  template <std::integral Small>
  explicit Wide(Small x) : Wide(static_cast<Int128>(x)) {}
  explicit Wide(Int128 x) {
    limb_.fill(x < 0 ? ~std::uint64_t{0} : 0);
    limb_[0] = static_cast<std::uint64_t>(x);
    limb_[1] = static_cast<std::uint64_t>(x >> 64);
  }

  template <int Fewer>
  requires(Fewer < Limbs) explicit Wide(const Wide<Fewer>& x) {
    limb_.fill(x.negative() ? ~std::uint64_t{0} : 0);
    std::copy(x.limb_.begin(), x.limb_.end(), limb_.begin());
  }

  friend Wide operator+(const Wide& a, const Wide& b) {
    Wide sum;
    UInt128 carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      carry += static_cast<UInt128>(a.limb_[i]) + b.limb_[i];
      sum.limb_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }

  friend Wide operator-(const Wide& a, const Wide& b) {  // a + ~b + 1
    Wide difference;
    UInt128 carry = 1;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      carry += static_cast<UInt128>(a.limb_[i]) + ~b.limb_[i];
      difference.limb_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return difference;
  }

  friend Wide operator*(const Wide& a, const Wide& b) {
    Wide product;
    product.limb_.fill(0);
    for (std::size_t i = 0; i < kLimbs; ++i) {
      UInt128 carry = 0;
      for (std::size_t j = 0; i + j < kLimbs; ++j) {
        carry += static_cast<UInt128>(a.limb_[i]) * b.limb_[j] + product.limb_[i + j];
        product.limb_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return product;
  }

  friend Wide operator*(const Wide& a, std::int64_t x) {  // x is its bits, less 2^64 when it is negative
    const auto factor = static_cast<std::uint64_t>(x);
    const std::uint64_t mask = x < 0 ? ~std::uint64_t{0} : 0;
    Wide product;
    UInt128 carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      carry += static_cast<UInt128>(a.limb_[i]) * factor;
      product.limb_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    carry = 1;
    for (std::size_t i = 1; i < kLimbs; ++i) {
      carry += static_cast<UInt128>(product.limb_[i]) + ~(a.limb_[i - 1] & mask);
      product.limb_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return product;
  }

  bool negative() const { return (limb_[kLimbs - 1] >> 63) != 0; }
  int sign() const {
    if (negative()) return -1;
    for (const std::uint64_t limb : limb_) {
      if (limb != 0) return 1;
    }
    return 0;
  }

 private:
  template <int>
  friend class Wide;
  using UInt128 = unsigned __int128;
  static_assert(Limbs >= 2);
  static constexpr std::size_t kLimbs = Limbs;

  std::array<std::uint64_t, kLimbs> limb_;
};

template <int Limbs>
int sign(const Wide<Limbs>& x) {
  return x.sign();
}

}  // namespace delone::exact
