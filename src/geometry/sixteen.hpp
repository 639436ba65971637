// Sixteen floats side by side, one for each of sixteen sites.
//
// Departure, for speed: vector instructions of one family of processors, written out. The compiler may use them in
// functions marked so only; whoever calls these has asked the processor.
#pragma once

#if defined(__x86_64__)
#define DELONE_SIXTEENS 1
#define DELONE_BY_SIXTEENS [[gnu::target("avx512f,fma,popcnt")]]
#define DELONE_INLINE_BY_SIXTEENS DELONE_BY_SIXTEENS [[gnu::always_inline]] inline

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"  // of a vector of any value, which GCC 12 writes like that
#include <immintrin.h>
#pragma GCC diagnostic pop

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "delone/base/ids.hpp"

namespace delone::sixteen {

using Floats = __m512;    // of sixteen sites
using Doubles = __m256d;  // of one: up to three coordinates, and one more

constexpr std::size_t kMostSites = 240;
/// No site.
constexpr Index kNobody = 255;
static_assert(kMostSites % 16 == 0 && kMostSites <= kNobody);

constexpr int kName = 0xFF;

/// Whether this processor can.
inline bool possible() {
  static const bool can = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("fma") != 0 &&
                          __builtin_cpu_supports("popcnt") != 0;
  return can;
}

/// 0, 1, 2, ...
alignas(64) inline constexpr std::array<std::int32_t, kMostSites> kNames = [] {
  std::array<std::int32_t, kMostSites> names{};
  std::iota(names.begin(), names.end(), 0);
  return names;
}();

/// Numbers of sites 16 * group to 16 * group + 15, with those of their sites in the last binary digits: the least or
/// the greatest number tells whose it is. This changes a number by less than 2^-15 of itself.
DELONE_INLINE_BY_SIXTEENS Floats named(Floats numbers, std::size_t group) {
  const __m512i names = _mm512_load_si512(&kNames[16 * group]);
  constexpr int kKeptOrNamed = 0xEA;  // a & b | c
  return _mm512_castsi512_ps(
      _mm512_ternarylogic_epi32(_mm512_castps_si512(numbers), _mm512_set1_epi32(~kName), names, kKeptOrNamed));
}
/// Whose number this is.
inline Index name_of(float number) { return std::bit_cast<std::uint32_t>(number) & kName; }

/// Of the first three numbers; of the fourth nothing is left.
DELONE_INLINE_BY_SIXTEENS Doubles next(Doubles a) { return _mm256_permute4x64_pd(a, 0b11001001); }
DELONE_INLINE_BY_SIXTEENS Doubles cross(Doubles a, Doubles b) {
  return next(_mm256_sub_pd(_mm256_mul_pd(a, next(b)), _mm256_mul_pd(next(a), b)));
}
/// Of the four numbers of a, and of those of b.
DELONE_INLINE_BY_SIXTEENS __m128d sums(Doubles a, Doubles b) {
  const Doubles pairs = _mm256_hadd_pd(a, b);
  return _mm_add_pd(_mm256_castpd256_pd128(pairs), _mm256_extractf128_pd(pairs, 1));
}
inline double first(__m128d a) { return _mm_cvtsd_f64(a); }

}  // namespace delone::sixteen

#endif
