// Position along Hilbert's curve, in any dimension.
// Source: [Ham06] (compact formulas for the curve's states: an entry corner e and a direction d per level). Up to
// dimension 3 the states are few, and a table that the compiler fills takes a level in one look-up.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace delone {

template <int K>
class HilbertCurve {
  static constexpr unsigned kMask = (1U << K) - 1;
  static constexpr bool kTabled = K <= 3;

 public:
  /// Distance along the curve of the grid point `x`, whose coordinates have `bits` bits each; K * bits <= 64.
  static std::uint64_t distance(const std::array<std::uint32_t, K>& x, int bits) {
    std::uint64_t h = 0;
    State state{0, 0};
    unsigned index = 0;
    for (int level = bits - 1; level >= 0; --level) {
      unsigned corner = 0;
      for (std::size_t j = 0; j < K; ++j) corner |= ((x[j] >> level) & 1U) << j;
      if constexpr (kTabled) {
        const std::uint16_t step = kTable[index << K | corner];
        h = h << K | (step & kMask);
        index = step >> K;
      } else {
        h = h << K | advance(state, corner);
      }
    }
    return h;
  }

 private:
  struct State {
    unsigned entry, direction;
  };

  static constexpr unsigned rotate_left(unsigned x, unsigned by) {
    by %= K;
    return by == 0 ? x : ((x << by) | (x >> (K - by))) & kMask;
  }
  static constexpr unsigned gray(unsigned x) { return x ^ (x >> 1); }
  static constexpr unsigned gray_inverse(unsigned x) {
    unsigned result = x;
    while ((x >>= 1) != 0) result ^= x;
    return result;
  }

  /// The corner's place among the 2^K of this level; moves `s` to the state inside that corner.
  static constexpr unsigned advance(State& s, unsigned corner) {
    const unsigned w = gray_inverse(rotate_left(corner ^ s.entry, K - (s.direction + 1) % K));
    const unsigned entry = w == 0 ? 0 : gray((w - 1) & ~1U);
    unsigned turn = 0;
    if (w != 0) turn = static_cast<unsigned>(std::countr_one(w % 2 == 0 ? w - 1 : w)) % K;
    s.entry ^= rotate_left(entry, s.direction + 1);
    s.direction = (s.direction + turn + 1) % K;
    return w;
  }

  static constexpr std::size_t kStates = kTabled ? (std::size_t{1} << K) * K : 1;
  static constexpr auto kTable = [] {
    std::array<std::uint16_t, kStates << K> table{};
    if constexpr (kTabled) {
      for (unsigned i = 0; i < table.size(); ++i) {
        State s{(i >> K) / K, (i >> K) % K};
        const unsigned w = advance(s, i & kMask);
        table[i] = static_cast<std::uint16_t>((s.entry * K + s.direction) << K | w);
      }
    }
    return table;
  }();
};

}  // namespace delone
