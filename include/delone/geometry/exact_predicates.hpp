// The slow, sure stages of the predicates: what the double filter leaves undecided.
//
// Stages, each a proof or a pass to the next:
//   adaptive  128-bit integers where the differences of the points are short enough over their common power of two
//             (integers, lattices, grids with binary steps); before them, where numbers are longer, double-doubles with
//             an error bound;
//   exact     integers as wide as the differences need, for every finite double of any exponent.
// A determinant of differences over a common power of two is a determinant of integers: no expansions are needed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace delone {

enum class Stage : std::uint8_t { filter, adaptive, exact };

struct SlowSign {
  int sign;
  Stage stage;
};

/// A site as the predicates see it: K leading coordinates, `other_count` more that only its height sees, a weight.
template <int K, int Count>
struct SiteRefs {
  std::array<const double*, static_cast<std::size_t>(Count)> leading;
  std::array<const double*, static_cast<std::size_t>(Count)> others;
  std::array<double, static_cast<std::size_t>(Count)> weights;
  int other_count;
  bool weighted;
  bool short_integers;  ///< a hint: integers over a common power of two are likely to be short enough for 128 bits
};

/// Sign of det(p1 - p0, ..., pK - p0) for K + 1 points of K coordinates each.
template <int K>
SlowSign slow_orient(const std::array<const double*, static_cast<std::size_t>(K + 1)>& points);

/// +1 when the lifted last site lies below the hyperplane through the K + 1 lifted sites before it, which are
/// positively oriented; -1 when above; 0 when on it.
template <int K>
SlowSign slow_conflict(const SiteRefs<K, K + 2>& sites);

}  // namespace delone
