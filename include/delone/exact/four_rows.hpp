// The determinant behind the test in space: four rows of x, y, z and a squared length, two rows at a time. One formula
// for every kind of pair: of doubles for the filter, the same with the sizes of all terms, of double-doubles for the
// stage after it.
#pragma once

#include "delone/base/pair.hpp"

namespace delone {

/// Two numbers, and for each the sum of its terms' absolute values: the permanent of a determinant.
struct SizedPair {
  Pair value, size;

  explicit SizedPair(Pair x) : SizedPair(x, larger(x, -x)) {}
  SizedPair(Pair x, Pair sizes) : value(x), size(sizes) {}
  [[gnu::always_inline]] friend SizedPair operator+(const SizedPair& a, const SizedPair& b) {
    return {a.value + b.value, a.size + b.size};
  }
  [[gnu::always_inline]] friend SizedPair operator-(const SizedPair& a, const SizedPair& b) {
    return {a.value - b.value, a.size + b.size};
  }
  [[gnu::always_inline]] friend SizedPair operator*(const SizedPair& a, const SizedPair& b) {
    return {a.value * b.value, a.size * b.size};
  }
  [[gnu::always_inline]] friend SizedPair turned(const SizedPair& a, const SizedPair& b) {
    return {turned(a.value, b.value), turned(a.size, b.size)};
  }
};

/// Of rows a, b, c, d: the determinants abc and bcd, cda and dab of x, y, z, and the squared lengths of a and b, c and
/// d.
template <class P>
struct FourRows {
  P abc, cda, ab_lifts, cd_lifts;
};

/// From the entries of rows (a, b) and (c, d) in each column. Turning the four rows by one takes the minors ab, bc, cd,
/// da of two columns, and abc, bcd, cda, dab of three, into one another.
template <class P>
[[gnu::always_inline]] inline FourRows<P> four_rows(P x0, P x1, P y0, P y1, P z0, P z1) {
  const P p0 = x0 * turned(y0, y1) - turned(x0, x1) * y0;  // ab, bc
  const P p1 = x1 * turned(y1, y0) - turned(x1, x0) * y1;  // cd, da
  const P r = x0 * y1 - x1 * y0;                           // ac, bd
  return {z0 * turned(p0, p1) - turned(z0, z1) * r + z1 * p0, z1 * turned(p1, p0) + turned(z1, z0) * r + z0 * p1,
          x0 * x0 + y0 * y0 + z0 * z0, x1 * x1 + y1 * y1 + z1 * z1};
}

/// The lifted determinant is the second of these less the first.
template <class P>
[[gnu::always_inline]] inline P lifted_terms(const FourRows<P>& rows) {
  return turned(rows.cd_lifts, rows.ab_lifts) * rows.abc + turned(rows.ab_lifts, rows.cd_lifts) * rows.cda;
}

}  // namespace delone
