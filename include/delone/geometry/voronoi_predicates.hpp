// What point location in a planar Voronoi diagram asks, decided on sites and query alone: no computed Voronoi vertex
// and no computed bisector takes part.
//
//   nearer         which of two sites is nearer to the query: on which side of their bisector it lies
//   side_of_ray    on which side of the ray from a site through one of its Voronoi vertices a heading leads
//   same_way       the same where the vertex lies at infinity
//
// Each is a polynomial in differences, of degree 2 or 4: a filter of doubles with a bound, then integers. In the error
// bounds u = 2^-53; a term that passes r roundings is off by less than (r + 0.1) u of its size, where 0.1 u covers the
// second order, the roundings of the size and what underflows: off by 2^-1074 times its other factors, which the limits
// on sizes keep below 2^-20 of the bound. Overflow leaves an infinity or a NaN in the size and so in the bound, and
// nothing lies beyond that.
#pragma once

#include <array>
#include <cmath>

#include "delone/geometry/exact_predicates.hpp"
#include "delone/geometry/filter.hpp"

namespace delone {

using Point2 = std::array<double, 2>;

/// The vector from one point to another, which need not be a double.
struct Heading {
  Point2 from, to;
};

namespace voronoi {

// The stages one by one; filters answer filter::kUnsure when they cannot tell.
int filtered_nearer(Point2 q, Point2 a, Point2 b);
int filtered_side_of_ray(Point2 o, Point2 a, Point2 b, Heading d);
int filtered_same_way(Heading a, Heading b);
SlowSign slow_nearer(Point2 q, Point2 a, Point2 b);
SlowSign slow_side_of_ray(Point2 o, Point2 a, Point2 b, Heading d);
SlowSign slow_same_way(Heading a, Heading b);

}  // namespace voronoi

/// +1 if q is nearer to a than to b, -1 if nearer to b, 0 exactly if it is as near to both.
///   nearer(q, b, a) == -nearer(q, a, b)
/// Coordinates: any finite doubles.
inline int nearer(Point2 q, Point2 a, Point2 b) {
  const int sign = voronoi::filtered_nearer(q, a, b);
  return sign != filter::kUnsure ? sign : voronoi::slow_nearer(q, a, b).sign;
}

/// With o, a, b turning left and c the centre of their circle: +1 if d leads left of the ray from o through c, -1 if
/// right, 0 exactly if along it, straight against it, or nowhere.
/// With A = a - o and B = b - o, c - o is (B_y |A|^2 - A_y |B|^2, A_x |B|^2 - B_x |A|^2) / (2 A x B), so that
///   sign((c - o) x d) = sign(|A|^2 (B . d) - |B|^2 (A . d)).
/// (Along d the bisector of o and k is met after |K|^2 / (2 K . d): the sign says whose bisector is met first.)
///   side_of_ray(o, b, a, d) == side_of_ray(o, a, b, -d) == -side_of_ray(o, a, b, d)
/// Coordinates: any finite doubles.
inline int side_of_ray(Point2 o, Point2 a, Point2 b, Heading d) {
  const int sign = voronoi::filtered_side_of_ray(o, a, b, d);
  return sign != filter::kUnsure ? sign : voronoi::slow_side_of_ray(o, a, b, d).sign;
}

/// Sign of the dot product: +1 if a and b lead the same way, -1 if opposite ways, 0 exactly if at right angles. It is
/// side_of_ray with a, or with its sign turned b, at infinity.
///   same_way(b, a) == same_way(a, b)        same_way(-a, b) == -same_way(a, b)
/// Coordinates: any finite doubles.
inline int same_way(Heading a, Heading b) {
  const int sign = voronoi::filtered_same_way(a, b);
  return sign != filter::kUnsure ? sign : voronoi::slow_same_way(a, b).sign;
}

namespace voronoi {

/// A sum of two products and of their sizes.
struct Sum {
  double value, size;
};

inline Point2 difference(Point2 a, Point2 b) { return {a[0] - b[0], a[1] - b[1]}; }

inline Sum dot(Point2 a, Point2 b) {
  const double x = a[0] * b[0];
  const double y = a[1] * b[1];
  return {x + y, std::abs(x) + std::abs(y)};
}

/// |q - b|^2 - |q - a|^2 = (a - b) . ((q - a) + (q - b)), not the difference of two squares: where q is far away and
/// a, b are close, its terms are much smaller. Roundings of a term: one in a - b, one in the differences to q and one
/// in their sum, one each for the product and the last sum.
inline int filtered_nearer(Point2 q, Point2 a, Point2 b) {
  const Point2 ab = difference(a, b);
  const Point2 qa = difference(q, a);
  const Point2 qb = difference(q, b);
  const double value = ab[0] * (qa[0] + qb[0]) + ab[1] * (qa[1] + qb[1]);
  const double size =
      std::abs(ab[0]) * (std::abs(qa[0]) + std::abs(qb[0])) + std::abs(ab[1]) * (std::abs(qa[1]) + std::abs(qb[1]));
  if (!(size > 0x1p-950)) return filter::kUnsure;
  return filter::sign_beyond(value, 5.1 * filter::kU * size);
}

/// Roundings of a term: a square length has two in its factors, one product, one sum; so has a dot product; one for
/// their product and one for the difference. Underflow is off by less than 2^-1074 (2^402 + 1), the bound more than
/// 2^-653.
inline int filtered_side_of_ray(Point2 o, Point2 a, Point2 b, Heading d) {
  const Point2 oa = difference(a, o);
  const Point2 ob = difference(b, o);
  const Point2 way = difference(d.to, d.from);
  const double aa = oa[0] * oa[0] + oa[1] * oa[1];
  const double bb = ob[0] * ob[0] + ob[1] * ob[1];
  const Sum ad = dot(oa, way);
  const Sum bd = dot(ob, way);
  const double size = aa * bd.size + bb * ad.size;
  if (!(size > 0x1p-600 && aa + bb + ad.size + bd.size < 0x1p400)) return filter::kUnsure;
  return filter::sign_beyond(aa * bd.value - bb * ad.value, 10.1 * filter::kU * size);
}

/// Roundings of a term: one in each difference, one product, one sum.
inline int filtered_same_way(Heading a, Heading b) {
  const Sum ab = dot(difference(a.to, a.from), difference(b.to, b.from));
  if (!(ab.size > 0x1p-950)) return filter::kUnsure;
  return filter::sign_beyond(ab.value, 4.1 * filter::kU * ab.size);
}

}  // namespace voronoi
}  // namespace delone
