// What a line that sweeps the plane asks, decided on sites alone: no computed top of a circle takes part.
//
//   passed_before        which of two sites the line passes first
//   touched_first        which of two sites a circle touches first that grows downwards from a site on the line
//   right_of_breakpoint  on which side of the point between two intervals of the line a site lies
//   compare_tops         which of two circles the line leaves first
//   compare_top          the same of a circle and a site
//
// The line is not quite horizontal: it moves in direction d = (e, 1) with an infinitesimal e > 0. So it passes one site
// after the other, and no site is the last point of a circle that it passes. A function of the tilt is decided by its
// first coefficient that is not zero: each predicate says which these are. Only one tie remains: a circle with itself.
//
// In the error bounds u = 2^-53; a term that passes r roundings is off by less than (r + 0.1) u of its size, where 0.1
// u covers the second order, the roundings of the bound and what underflows: the limits on sizes keep that far below.
// Overflow leaves an infinity or a NaN in the bound, and nothing lies beyond that.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "delone/geometry/exact_predicates.hpp"
#include "delone/geometry/filter.hpp"
#include "delone/geometry/voronoi_predicates.hpp"

namespace delone {

/// The circle through three points that turn left.
struct Circle {
  Point2 a, b, c;
};

/// Roughly the largest y on a circle, and a bound on the error: infinite where doubles do not tell.
struct RoughTop {
  double y = 0.0;
  double error = std::numeric_limits<double>::infinity();
};

namespace sweep {

// The stages one by one; filters answer filter::kUnsure when they cannot tell.
int filtered_touched_first(Point2 s, Point2 u, Point2 v);
int filtered_compare_tops(RoughTop a, RoughTop b);
int filtered_compare_top(RoughTop a, Point2 s);
SlowSign slow_touched_first(Point2 s, Point2 u, Point2 v);
SlowSign slow_compare_tops(const Circle& a, const Circle& b);
SlowSign slow_compare_top(const Circle& a, Point2 s);

}  // namespace sweep

RoughTop rough_top(const Circle& circle);

/// Whether the line passes a before b: by y, then by x.
inline bool passed_before(Point2 a, Point2 b) { return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0]; }

/// Of the circles whose last point is s, +1 if that through u is smaller than that through v, -1 if it is larger, 0
/// exactly if u and v are at one place. The line has passed u and v before s.
/// The radius of the circle through u is |s - u|^2 / (2 (s - u) . d), with d of length 1, so the sign is that of
///   |s - v|^2 ((s - u) . d) - |s - u|^2 ((s - v) . d),
/// of degree 3 and linear in the tilt: first with y alone, then with x. Both are zero only when s - u and s - v,
/// divided by the squares of their lengths, are the same vector, and then so are u and v.
///   touched_first(s, v, u) == -touched_first(s, u, v)
/// Coordinates: any finite doubles.
inline int touched_first(Point2 s, Point2 u, Point2 v) {
  const int sign = sweep::filtered_touched_first(s, u, v);
  return sign != filter::kUnsure ? sign : sweep::slow_touched_first(s, u, v).sign;
}

/// Whether s, on the line, lies right of the point where the interval of u ends and that of v begins. The line has
/// passed u and v before s; they stand at different places. Of two sites alone the one passed last has one interval,
/// with its own x within, and the other one all else. So left of that x the breakpoint is the first end of the
/// interval, and right of it the second.
inline bool right_of_breakpoint(Point2 s, Point2 u, Point2 v) {
  return passed_before(u, v) ? s[0] >= v[0] || touched_first(s, u, v) < 0 : s[0] > u[0] && touched_first(s, u, v) < 0;
}

/// -1 if the line leaves circle a before circle b, +1 if after, 0 exactly if they are the same circle.
/// A circle with centre c and radius r is left at c . d + r |d|: the order is that of c_y + r, then c_x, then -c_y (the
/// smaller one of two that touch in their topmost points is left first). The first has roots in it and becomes, by
/// squaring, a form of degree 20; the others are of degree 5.
///   compare_tops(b, a) == -compare_tops(a, b)
/// Coordinates: any finite doubles.
inline int compare_tops(const Circle& a, const Circle& b) {
  const int sign = sweep::filtered_compare_tops(rough_top(a), rough_top(b));
  return sign != filter::kUnsure ? sign : sweep::slow_compare_tops(a, b).sign;
}

/// -1 if the line leaves circle a before it passes s, +1 if after: never 0, since the topmost point is passed before
/// the tilted line leaves the circle. The order is that of y, a form of degree 6, then that of x, of degree 3.
/// Coordinates: any finite doubles.
inline int compare_top(const Circle& a, Point2 s) {
  const int sign = sweep::filtered_compare_top(rough_top(a), s);
  return sign != filter::kUnsure ? sign : sweep::slow_compare_top(a, s).sign;
}

namespace sweep {

/// Roundings of a term: three in its differences, of which the square takes one twice; a product and a sum in the
/// square; a product and the last difference. Underflow is off by less than 2^-1074 times a difference below 2^200, and
/// 0.1 u of the size is more than 2^-760.
inline int filtered_touched_first(Point2 s, Point2 u, Point2 v) {
  const Point2 su{s[0] - u[0], s[1] - u[1]};
  const Point2 sv{s[0] - v[0], s[1] - v[1]};
  const double by_v = (sv[0] * sv[0] + sv[1] * sv[1]) * su[1];
  const double by_u = (su[0] * su[0] + su[1] * su[1]) * sv[1];
  const double size = by_v + by_u;  // neither is negative
  if (!(size > 0x1p-700 && su[1] < 0x1p200 && sv[1] < 0x1p200)) return filter::kUnsure;
  return filter::sign_beyond(by_v - by_u, 7.1 * filter::kU * size);
}

inline int filtered_compare_tops(RoughTop a, RoughTop b) {
  return filter::sign_beyond(a.y - b.y, a.error + b.error);  // their roundings are part of the errors
}

inline int filtered_compare_top(RoughTop a, Point2 s) { return filter::sign_beyond(a.y - s[1], a.error); }

}  // namespace sweep

/// With p = a - b and q = c - b, twice the area C = q x p > 0, and the circle's centre m and radius r:
///   m_y - b_y = (q_x |p|^2 - p_x |q|^2) / 2C     r = |p| |q| |p - q| / 2C     h = m_y - b_y + r = n / 2C
/// Roundings, of a square: two in the factors, a product, a sum. Of the root: three squares and two products, halved,
/// and its own, so 8. Of the other terms of n: one in a factor, a square, a product, a sum, so 7. Hence with S the sum
/// of the sizes of all three, n is off by less than (8 + 1) u S and one in a hundred. Of C: two in the factors, a
/// product, a sum, so 4 u of the sum Z of its sizes. With L = C - 4.1 u Z, which is less than the true C,
///   |n / 2C - n' / 2C'| <= |n - n'| / 2C' + |n| |C' - C| / (2C C') <= (9.2 u S + 2 |h| 4.1 u Z) / 2L.
/// The quotient and the last sum round by u each, and as much is left for who compares.
inline RoughTop rough_top(const Circle& circle) {
  const Point2 p{circle.a[0] - circle.b[0], circle.a[1] - circle.b[1]};
  const Point2 q{circle.c[0] - circle.b[0], circle.c[1] - circle.b[1]};
  const Point2 d{circle.a[0] - circle.c[0], circle.a[1] - circle.c[1]};
  const double pp = p[0] * p[0] + p[1] * p[1];
  const double qq = q[0] * q[0] + q[1] * q[1];
  const double dd = d[0] * d[0] + d[1] * d[1];
  const double left = q[0] * p[1];
  const double right = q[1] * p[0];
  const double area = left - right;
  const double area_error = 4.1 * filter::kU * (std::abs(left) + std::abs(right));
  const double least = area - area_error;
  const double root = std::sqrt(pp * qq * dd);
  const double size = std::abs(q[0]) * pp + std::abs(p[0]) * qq + root;
  // Within these limits nothing overflows, and what underflows by 2^-1074 is far below the bounds.
  if (!(pp > 0x1p-300 && qq > 0x1p-300 && dd > 0x1p-300 && least > 0x1p-900 && size < 0x1p600)) return {};
  const double h = (q[0] * pp - p[0] * qq + root) / (2.0 * area);
  const double y = circle.b[1] + h;
  const double error = (9.2 * filter::kU * size + 2.0 * std::abs(h) * area_error) / (2.0 * least) +
                       3.0 * filter::kU * (std::abs(circle.b[1]) + std::abs(h));
  return {y, 1.01 * error};
}

}  // namespace delone
