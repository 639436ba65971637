// Two doubles side by side: what every x86-64 and 64-bit ARM computes in one instruction.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace delone {

// The compiler's own vector type: + - * and comparisons act on both lanes, each rounded as a double is.
using Pair = double __attribute__((vector_size(16)));

inline Pair load_pair(const double* x) {
  Pair p;
  std::memcpy(&p, x, sizeof p);
  return p;
}
inline Pair firsts(Pair a, Pair b) { return __builtin_shufflevector(a, b, 0, 2); }
inline Pair seconds(Pair a, Pair b) { return __builtin_shufflevector(a, b, 1, 3); }
/// (a[1], b[0]): of four lanes (a, b) turned left by one, the first two.
inline Pair turned(Pair a, Pair b) { return __builtin_shufflevector(a, b, 1, 2); }
inline Pair larger(Pair a, Pair b) { return a > b ? a : b; }
inline Pair smaller(Pair a, Pair b) { return a < b ? a : b; }
using PairBits = std::int64_t __attribute__((vector_size(16)));
inline Pair magnitude(Pair a) {
  constexpr std::int64_t kAllButSign = std::numeric_limits<std::int64_t>::max();
  return reinterpret_cast<Pair>(reinterpret_cast<PairBits>(a) & kAllButSign);
}
/// The same but for the last two bits, which hold a number, so that who is smallest is known as soon as what is.
/// Changes a by at most 6 units of 2^-53 of its size, and what is subnormal by 3 * 2^-1074.
inline Pair numbered(Pair a, std::int64_t first, std::int64_t second) {
  return reinterpret_cast<Pair>((reinterpret_cast<PairBits>(a) & ~std::int64_t{3}) | PairBits{first, second});
}
inline int number_in(double a) { return static_cast<int>(std::bit_cast<std::uint64_t>(a) & 3); }
inline double sum(Pair a) { return a[0] + a[1]; }
inline double largest(Pair a) { return a[0] > a[1] ? a[0] : a[1]; }

/// Pair number i of `Count` doubles; beside the last of an odd number stands a zero.
template <int Count>
inline Pair load_pair(const double* x, int i) {
  if (2 * i + 1 == Count) return Pair{x[2 * i], 0.0};
  return load_pair(x + 2 * i);
}
template <int Count>
inline void store_pair(Pair p, double* x, int i) {
  x[2 * i] = p[0];
  if (2 * i + 1 != Count) x[2 * i + 1] = p[1];
}

}  // namespace delone
