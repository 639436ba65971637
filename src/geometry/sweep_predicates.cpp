#include "delone/geometry/sweep_predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "delone/exact/double_double.hpp"
#include "exact/integer.hpp"

namespace delone::sweep {
namespace {

using exact::BigInt;
using exact::bit_width;
using exact::Scaled;
using exact::sign;

/// Points as integers over their common power of two: of 64 bits where they are short, else of any size.
template <std::size_t N, class Integer>
using Places = std::array<std::array<Integer, 2>, N>;

/// The sign of a form in the differences of points.
/// @param bits   from short places, bits that all integers on the way have at most
/// @param close  a stage for where these are many: a sign, or 0 when it cannot tell
template <std::size_t N, class Bits, class Close, class Form>
SlowSign sign_in_integers(const std::array<Point2, N>& points, const Bits& bits, const Close& close, const Form& form) {
  Places<N, Scaled> scaled;
  int unit = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      scaled[i][j] = exact::decompose(points[i][j]);
      exact::lower_unit(unit, scaled[i][j]);
    }
  }
  int longest = 0;
  for (const auto& point : scaled) {
    for (const Scaled& x : point) longest = std::max(longest, exact::bit_length(x, unit));
  }
  const auto places = [&]<class Integer>(Integer) {
    Places<N, Integer> x;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < 2; ++j) x[i][j] = exact::to_integer<Integer>(scaled[i][j], unit);
    }
    return x;
  };
  if (longest <= 62) {
    const auto x = places(std::int64_t{});
    const int needed = bits(x);
    if (needed < 127) return {form(exact::Int128{}, x), Stage::adaptive};
    if (const int sign = close(); sign != 0) return {sign, Stage::adaptive};
    return {exact::with_integer(needed, [&]<class Int>(Int) { return form(Int{}, x); }), Stage::exact};
  }
  if (const int sign = close(); sign != 0) return {sign, Stage::adaptive};
  return {form(BigInt{}, places(BigInt{})), Stage::exact};
}

/// Bits of the differences between two points, and between the three of a circle from `first` on.
template <std::size_t N>
int bits_between(const Places<N, std::int64_t>& x, std::size_t i, std::size_t j) {
  return std::max(bit_width(x[i][0] - x[j][0]), bit_width(x[i][1] - x[j][1]));
}
template <std::size_t N>
int bits_within(const Places<N, std::int64_t>& x, std::size_t first) {
  return std::max(
      {bits_between(x, first, first + 1), bits_between(x, first + 1, first + 2), bits_between(x, first + 2, first)});
}

template <class Int>
Int square(const Int& x) {
  return Int(x * x);
}

/// A circle seen from its second point b. From differences of l bits:
template <class Int>
struct IntegerCircle {
  Int doubled;      ///< D = 2C: four times the area, 2l + 2 bits
  Int x, y;         ///< D times the centre, 3l + 2 bits
  Int root_square;  ///< the square of D times the radius, 6l + 3 bits

  template <class Integer, std::size_t N>
  IntegerCircle(const Places<N, Integer>& at, std::size_t first) {
    const auto difference = [&](std::size_t i, std::size_t j, std::size_t axis) {
      return Int(Integer(at[first + i][axis] - at[first + j][axis]));
    };
    const Int px = difference(0, 1, 0), py = difference(0, 1, 1);
    const Int qx = difference(2, 1, 0), qy = difference(2, 1, 1);
    const Int pp = square(px) + square(py);
    const Int qq = square(qx) + square(qy);
    const Int dd = square(difference(0, 2, 0)) + square(difference(0, 2, 1));
    doubled = Int(2) * Int(Int(qx * py) - Int(qy * px));
    x = Int(py * qq) - Int(qy * pp);
    y = Int(qx * pp) - Int(px * qq);
    root_square = Int(pp * qq) * dd;
  }
};

/// The sign of p + sqrt(a) - sqrt(b), with a and b positive. Where p and the difference of the roots have opposite
/// signs the larger one decides: p^2 against a + b - 2 sqrt(ab).
template <class Int>
int sign_with_roots(const Int& p, const Int& a, const Int& b) {
  const int of_p = sign(p);
  const int of_roots = sign<Int>(a - b);
  if (of_p == of_roots || of_roots == 0) return of_p;
  if (of_p == 0) return of_roots;
  const Int w = square(p) - a - b;
  const int larger = w >= 0 ? 1 : sign<Int>(Int(4) * a * b - square(w));
  return larger == 0 ? 0 : (larger > 0 ? of_p : of_roots);
}

/// The same circle in double-doubles, with n = y + sqrt(R), and the sizes of what is summed in n and D. Errors in units
/// of u^2, where a product adds 7 and a sum 6: squares 13; y 26 of its size; D 13 of its size; R 53, so its root 27 and
/// what follows; n the larger one of these and 6.
/// The root is r + e / 2r with r the rounded root of R and e = R - r^2: 6 of the sum in e, 2 of the second order, 3 of
/// the quotient in doubles, 6 of the sum. So the root has less than 50 in all, and n less than 56.
struct CloseCircle {
  DoubleDouble doubled, n;
  double doubled_size, n_size;
  bool tame;  ///< within limits where nothing overflows, and what underflows is far below the bounds

  explicit CloseCircle(const Circle& k) {
    const auto difference = [](Point2 a, Point2 b, std::size_t axis) {
      return DoubleDouble::difference(a[axis], b[axis]);
    };
    const DoubleDouble px = difference(k.a, k.b, 0), py = difference(k.a, k.b, 1);
    const DoubleDouble qx = difference(k.c, k.b, 0), qy = difference(k.c, k.b, 1);
    const DoubleDouble dx = difference(k.a, k.c, 0), dy = difference(k.a, k.c, 1);
    const DoubleDouble pp = px * px + py * py;
    const DoubleDouble qq = qx * qx + qy * qy;
    const DoubleDouble dd = dx * dx + dy * dy;
    const DoubleDouble left = qx * py;
    const DoubleDouble right = qy * px;
    doubled = left - right;
    doubled = doubled + doubled;
    doubled_size = 2.0 * (std::abs(left.high()) + std::abs(right.high()));
    const DoubleDouble square = pp * qq * dd;
    const double root = std::sqrt(square.high());
    const DoubleDouble rest = square - DoubleDouble(root) * DoubleDouble(root);
    const DoubleDouble first = qx * pp;
    const DoubleDouble second = px * qq;
    n = (first - second) + (DoubleDouble(root) + DoubleDouble(rest.high() / (2.0 * root)));
    n_size = std::abs(first.high()) + std::abs(second.high()) + root;
    const double least = std::min({pp.high(), qq.high(), dd.high()});
    const double most = std::max({pp.high(), qq.high(), dd.high()});
    tame = least > 0x1p-80 && most < 0x1p160 && doubled_size > 0x1p-160;
  }
};

/// The sign of n1 D2 - n2 D1 + (b1_y - b2_y) D1 D2, 0 when it is not sure. Errors as above: 56 + 13 + 7 of the first
/// two terms, 13 + 13 + 7 + 7 of the third, and two sums of all: less than 100. The factor 4 covers the second order
/// and the rounding of sizes. Underflow is off by less than 2^-1074 times 2^420, the bound more than 2^-385.
int close_compare_tops(const Circle& a, const Circle& b) {
  const CloseCircle k(a);
  const CloseCircle l(b);
  const DoubleDouble between = DoubleDouble::difference(a.b[1], b.b[1]);
  if (!(k.tame && l.tame && std::abs(between.high()) < 0x1p80)) return 0;
  const double value = ((k.n * l.doubled - l.n * k.doubled) + between * (k.doubled * l.doubled)).high();
  const double size = k.n_size * l.doubled_size + l.n_size * k.doubled_size +
                      std::abs(between.high()) * k.doubled_size * l.doubled_size;
  const int sign = filter::sign_beyond(value, 4.0 * 100.0 * 0x1p-106 * size);
  return sign == filter::kUnsure ? 0 : sign;
}

constexpr auto kNoCloseStage = [] { return 0; };

}  // namespace

SlowSign slow_touched_first(Point2 s, Point2 u, Point2 v) {
  const auto bits = [](const Places<3, std::int64_t>& x) { return 3 * bits_within(x, 0) + 3; };
  return sign_in_integers(std::array{s, u, v}, bits, kNoCloseStage,
                          []<class Int, class Integer>(Int, const Places<3, Integer>& at) {
                            const auto difference = [&](std::size_t i, std::size_t axis) {
                              return Int(Integer(at[0][axis] - at[i][axis]));
                            };
                            const Int ux = difference(1, 0), uy = difference(1, 1);
                            const Int vx = difference(2, 0), vy = difference(2, 1);
                            const Int uu = square(ux) + square(uy);
                            const Int vv = square(vx) + square(vy);
                            const int by_y = sign<Int>(Int(vv * uy) - Int(uu * vy));
                            return by_y != 0 ? by_y : sign<Int>(Int(vv * ux) - Int(uu * vx));
                          });
}

// With b1, b2 the second points: c_y + r is b1_y + (y1 + sqrt(R1)) / D1, and so on. Times D1 D2 the difference is
//   P + sqrt(A) - sqrt(B)     P = y1 D2 - y2 D1 + (b1_y - b2_y) D1 D2     A = D2^2 R1     B = D1^2 R2.
// With differences of l bits within a circle and g between them, P has max(5l + 5, 4l + g + 4) + 1 bits, A and B have
// 10l + 7, and what is squared last is the sum of P^2, A and B.
SlowSign slow_compare_tops(const Circle& a, const Circle& b) {
  const auto bits = [](const Places<6, std::int64_t>& x) {
    const int l = std::max(bits_within(x, 0), bits_within(x, 3));
    const int p = 4 * l + 6 + std::max(l, bits_between(x, 1, 4));
    return 2 * (std::max(2 * p, 10 * l + 8) + 1) + 2;
  };
  return sign_in_integers(
      std::array{a.a, a.b, a.c, b.a, b.b, b.c}, bits, [&] { return close_compare_tops(a, b); },
      []<class Int, class Integer>(Int, const Places<6, Integer>& at) {
        const IntegerCircle<Int> k(at, 0);
        const IntegerCircle<Int> l(at, 3);
        const Int both = k.doubled * l.doubled;
        const auto apart = [&](const Int& of_k, const Int& of_l, std::size_t axis) {
          const Int between(Integer(at[1][axis] - at[4][axis]));
          return Int(Int(of_k * l.doubled) - Int(of_l * k.doubled) + Int(between * both));
        };
        const Int p = apart(k.y, l.y, 1);
        const Int k_root = square(l.doubled) * k.root_square;
        const Int l_root = square(k.doubled) * l.root_square;
        if (const int by_top = sign_with_roots(p, k_root, l_root); by_top != 0) return by_top;
        const int by_x = sign(apart(k.x, l.x, 0));
        return by_x != 0 ? by_x : -sign(p);
      });
}

// c_y + r - s_y is (y + sqrt(R) - (s_y - b_y) D) / D.
SlowSign slow_compare_top(const Circle& a, Point2 s) {
  const auto bits = [](const Places<4, std::int64_t>& x) {
    const int l = bits_within(x, 0);
    return 2 * (2 * l + 4 + std::max(l, bits_between(x, 1, 3))) + 2;
  };
  return sign_in_integers(std::array{a.a, a.b, a.c, s}, bits, kNoCloseStage,
                          []<class Int, class Integer>(Int, const Places<4, Integer>& at) {
                            const IntegerCircle<Int> k(at, 0);
                            const auto beyond = [&](const Int& centre, std::size_t axis) {
                              const Int to_s(Integer(at[3][axis] - at[1][axis]));
                              return Int(centre - Int(to_s * k.doubled));
                            };
                            const Int m = beyond(k.y, 1);
                            const int by_y = m >= 0 ? 1 : sign<Int>(k.root_square - square(m));
                            return by_y != 0 ? by_y : (beyond(k.x, 0) < 0 ? -1 : 1);
                          });
}

}  // namespace delone::sweep
