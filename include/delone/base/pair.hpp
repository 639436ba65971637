// Two doubles side by side: what every x86-64 and 64-bit ARM computes in one instruction.
#pragma once

#include <cstring>

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

}  // namespace delone
