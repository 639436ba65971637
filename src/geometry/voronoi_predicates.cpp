#include "delone/geometry/voronoi_predicates.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "exact/integer.hpp"

namespace delone::voronoi {
namespace {

using exact::BigInt;
using exact::FixedInt;
using exact::Int128;
using exact::Scaled;

/// The sign of f, a form of the given degree in the differences of at most three points per factor, from the
/// coordinates as integers over their common power of two. A factor of b-bit coordinates has at most b + 2 bits, and
/// there are at most 8 products.
template <std::size_t N, class Form>
SlowSign sign_in_integers(const std::array<double, N>& x, int degree, const Form& f) {
  std::array<Scaled, N> scaled;
  int unit = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < N; ++i) {
    scaled[i] = exact::decompose(x[i]);
    if (scaled[i].mantissa != 0) unit = std::min(unit, scaled[i].exponent);
  }
  int bits = 0;
  for (const Scaled& s : scaled) bits = std::max(bits, exact::bit_length(s, unit));
  const auto evaluate = [&]<class Int>(Int) {
    std::array<Int, N> integers;
    for (std::size_t i = 0; i < N; ++i) integers[i] = exact::to_integer<Int>(scaled[i], unit);
    return exact::sign<Int>(f(integers));
  };
  const int needed = degree * (bits + 2) + 4;
  if (needed < 127) return {evaluate(Int128{}), Stage::adaptive};
  if (needed < 511) return {evaluate(FixedInt<512>{}), Stage::exact};
  return {evaluate(BigInt{}), Stage::exact};
}

template <class Int>
Int dot(const Int& ax, const Int& ay, const Int& bx, const Int& by) {
  return Int(ax * bx) + Int(ay * by);
}

}  // namespace

SlowSign slow_nearer(Point2 q, Point2 a, Point2 b) {
  return sign_in_integers(std::array{q[0], q[1], a[0], a[1], b[0], b[1]}, 2, []<class Int>(std::array<Int, 6>& x) {
    const auto& [qx, qy, ax, ay, bx, by] = x;
    return dot<Int>(ax - bx, ay - by, (qx - ax) + (qx - bx), (qy - ay) + (qy - by));
  });
}

SlowSign slow_side_of_ray(Point2 o, Point2 a, Point2 b, Heading d) {
  const std::array coordinates{o[0], o[1], a[0], a[1], b[0], b[1], d.from[0], d.from[1], d.to[0], d.to[1]};
  return sign_in_integers(coordinates, 4, []<class Int>(std::array<Int, 10>& x) {
    const auto& [ox, oy, a0, a1, b0, b1, fromx, fromy, tox, toy] = x;
    const Int ax = a0 - ox;
    const Int ay = a1 - oy;
    const Int bx = b0 - ox;
    const Int by = b1 - oy;
    const Int dx = tox - fromx;
    const Int dy = toy - fromy;
    return Int(Int(dot(ax, ay, ax, ay) * dot(bx, by, dx, dy)) - Int(dot(bx, by, bx, by) * dot(ax, ay, dx, dy)));
  });
}

SlowSign slow_same_way(Heading a, Heading b) {
  const std::array coordinates{a.from[0], a.from[1], a.to[0], a.to[1], b.from[0], b.from[1], b.to[0], b.to[1]};
  return sign_in_integers(coordinates, 2, []<class Int>(std::array<Int, 8>& x) {
    return dot<Int>(x[2] - x[0], x[3] - x[1], x[6] - x[4], x[7] - x[5]);
  });
}

}  // namespace delone::voronoi
