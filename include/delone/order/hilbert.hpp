// Position along Hilbert's curve, in any dimension.
// Source: [Ham06] (compact formulas for the curve's states: an entry corner e and a direction d per level). Up to
// dimension 3 the states are few, and a table that the compiler fills takes two or four levels in one look-up.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace delone {

template <int K>
class HilbertCurve {
  static constexpr unsigned kMask = (1U << K) - 1;
  /// Levels that one look-up takes.
  static constexpr int kTabled = K == 2 ? 4 : (K == 3 ? 2 : 1);

 public:
  using Place = std::array<std::uint32_t, K>;

  /// Distance along the curve of the grid point `x`, whose coordinates have `bits` bits each; K * bits <= 64.
  static std::uint64_t distance(const Place& x, int bits) { return distances(std::array<Place, 1>{x}, bits)[0]; }
  /// The same of several points: the look-ups of one wait for each other, those of the others fill the time.
  template <std::size_t N>
  static std::array<std::uint64_t, N> distances(const std::array<Place, N>& x, int bits) {
    std::array<std::uint64_t, N> h{};
    if constexpr (K == 1) {
      for (std::size_t i = 0; i < N; ++i) h[i] = x[i][0];
    } else if constexpr (K > 3) {
      std::array<State, N> state{};
      for (int level = bits; --level >= 0;) {
        for (std::size_t i = 0; i < N; ++i) h[i] = h[i] << K | advance(state[i], corner(x[i], level));
      }
    } else {
      std::array<unsigned, N> state{};
      int level = bits;
      const auto look_up = [&](const auto& table, int levels) {
        level -= levels;
        for (std::size_t i = 0; i < N; ++i) state[i] = next(table, state[i], h[i], x[i], level, levels);
      };
      while (level % kTabled != 0) look_up(kTable<1>, 1);
      while (level != 0) look_up(kTable<kTabled>, kTabled);
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

  static constexpr unsigned corner(const Place& x, int level) {
    unsigned corner = 0;
    for (std::size_t j = 0; j < K; ++j) corner |= ((x[j] >> level) & 1U) << j;
    return corner;
  }

  static constexpr unsigned kStates = K << K;

  /// By state and the next `Levels` bits of each coordinate: the state after them above, their distance below.
  template <int Levels>
  static constexpr auto kTable = [] {
    constexpr unsigned kBits = K * Levels;
    std::array<std::uint16_t, kStates << kBits> table{};
    for (unsigned i = 0; i < table.size(); ++i) {
      State s{(i >> kBits) / K, (i >> kBits) % K};
      Place x;
      for (std::size_t j = 0; j < K; ++j) x[j] = i >> (static_cast<int>(j) * Levels);
      unsigned h = 0;
      for (int level = Levels - 1; level >= 0; --level) h = h << K | advance(s, corner(x, level));
      table[i] = static_cast<std::uint16_t>((s.entry * K + s.direction) << kBits | h);
    }
    return table;
  }();

  /// Looks up the bits of x from `level` on, lengthens h by them, and returns the state after them.
  static unsigned next(const auto& table, unsigned state, std::uint64_t& h, const Place& x, int level, int levels) {
    unsigned index = state;
    for (std::size_t j = K; j-- > 0;) index = index << levels | ((x[j] >> level) & ((1U << levels) - 1));
    const unsigned found = table[index];
    h = h << (K * levels) | (found & ((1U << (K * levels)) - 1));
    return found >> (K * levels);
  }
};

}  // namespace delone
