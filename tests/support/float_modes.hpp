// Floating-point modes that a caller may have left, for the length of a scope.
#pragma once

#include <cfenv>
#include <limits>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace delone::test {

class Rounding {
 public:
  explicit Rounding(int mode) : saved_(std::fegetround()) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(saved_); }
  Rounding(const Rounding&) = delete;
  Rounding& operator=(const Rounding&) = delete;

 private:
  int saved_;
};

#if defined(__SSE2__)
constexpr bool can_flush_denormals() { return true; }
enum class Flush : unsigned { operands = 0x0040, results = 0x8000, both = 0x8040 };

class FlushedDenormals {
 public:
  explicit FlushedDenormals(Flush what) : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | static_cast<unsigned>(what)); }
  ~FlushedDenormals() { _mm_setcsr(saved_); }
  FlushedDenormals(const FlushedDenormals&) = delete;
  FlushedDenormals& operator=(const FlushedDenormals&) = delete;

 private:
  unsigned saved_;
};
#else
constexpr bool can_flush_denormals() { return false; }
enum class Flush { operands, results, both };
struct FlushedDenormals {
  explicit FlushedDenormals(Flush) {}
};
#endif

inline bool denormals_are_flushed() {
  volatile double smallest = std::numeric_limits<double>::min();
  volatile double half = smallest * 0.5;
  return half == 0.0;
}

}  // namespace delone::test
