// Two doubles side by side: what every x86-64 and 64-bit ARM computes in one instruction.
#pragma once

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
inline Pair magnitude(Pair a) {
  using Bits = std::int64_t __attribute__((vector_size(16)));
  constexpr std::int64_t kAllButSign = std::numeric_limits<std::int64_t>::max();
  return reinterpret_cast<Pair>(reinterpret_cast<Bits>(a) & kAllButSign);
}
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
