#include "delone/base/arithmetic.hpp"

#include <cfenv>
#include <limits>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace delone {

#if defined(__SSE2__)
namespace {
constexpr unsigned kRoundingAndFlushing = 0xE040;  // MXCSR: rounding control, flush to zero, denormals are zero
}
ExactEnvironment::ExactEnvironment() : saved_(_mm_getcsr()) {
  if ((saved_ & kRoundingAndFlushing) != 0) _mm_setcsr(saved_ & ~kRoundingAndFlushing);
}
ExactEnvironment::~ExactEnvironment() {
  if ((saved_ & kRoundingAndFlushing) != 0) _mm_setcsr(saved_);
}
#else
ExactEnvironment::ExactEnvironment() : saved_(static_cast<unsigned>(std::fegetround())) {
  if (saved_ != FE_TONEAREST) std::fesetround(FE_TONEAREST);
}
ExactEnvironment::~ExactEnvironment() {
  if (saved_ != FE_TONEAREST) std::fesetround(static_cast<int>(saved_));
}
#endif

std::vector<std::string> arithmetic_problems() {
  std::vector<std::string> problems;
  volatile double one = 1.0;
  volatile double tiny = 0x1p-60;
  const bool up = one + tiny != 1.0;
  const bool down = -one - tiny != -1.0;
  const bool below = one - tiny != 1.0;
  if (up || down || below) {
    problems.emplace_back("the rounding mode is not to nearest: it is set right inside every call");
  }
  volatile double smallest = std::numeric_limits<double>::min();
  const double half = smallest * 0.5;
  volatile double denormal = std::numeric_limits<double>::denorm_min();
  if (half == 0.0 || denormal * 1.0 == 0.0) {
    problems.emplace_back("denormal numbers are flushed to zero: this is set right inside every call");
  }
  const ExactEnvironment environment;  // what follows is about the build, whatever the mode
  // a * a - b * c with b * c = a * a - 2^-54 in exact numbers: as written both products round to the same double.
  volatile double a = 1.0 + 0x1p-27;
  const double contracted = a * a - (1.0 + 0x1p-26);
  if (contracted != 0.0) {
    problems.emplace_back("multiplications and additions are fused: compile with -ffp-contract=off");
  }
  volatile double large = std::numeric_limits<double>::max();
  const double excess = (large * 2.0) * 0.25;
  if (excess < std::numeric_limits<double>::max()) {
    problems.emplace_back("doubles carry excess precision (x87): compile for SSE2");
  }
  return problems;
}

}  // namespace delone
