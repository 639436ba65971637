// Monotone chains: the points from left to right make the lower boundary, from right to left the upper.
#include "io/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/integer.hpp"

namespace delone::io {
namespace {

using Point = std::span<const double, 2>;
using exact::BigInt;
using exact::Scaled;

int turn_by_integers(Point a, Point b, Point c) {
  const std::array<Scaled, 6> scaled{exact::decompose(a[0]), exact::decompose(a[1]), exact::decompose(b[0]),
                                     exact::decompose(b[1]), exact::decompose(c[0]), exact::decompose(c[1])};
  int unit = scaled[0].exponent;
  for (const Scaled& number : scaled) unit = std::min(unit, number.exponent);
  const auto whole = [&](std::size_t i) { return exact::to_integer<BigInt>(scaled[i], unit); };
  const BigInt left = (whole(2) - whole(0)) * (whole(5) - whole(1));
  const BigInt right = (whole(3) - whole(1)) * (whole(4) - whole(0));
  return exact::sign(BigInt(left - right));
}

}  // namespace

int turn(Point a, Point b, Point c) {
  // Each product of differences carries three roundings, their difference one more: together below 4.1 units in the
  // last place of the sum of magnitudes, and 2^-50 is 8 of those. Tiny products may have underflowed: ask exactly.
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double difference = left - right;
  const double magnitude = std::abs(left) + std::abs(right);
  if (std::abs(difference) > magnitude * 0x1p-50 && magnitude > 0x1p-900 && std::isfinite(magnitude)) {
    return difference > 0 ? 1 : -1;
  }
  return turn_by_integers(a, b, c);
}

void append_polygon(std::span<const double> coordinates, std::span<const Index> polygon, std::vector<Index>& boundary) {
  const auto at = [&](Index row) { return Point(&coordinates[std::size_t{row} * 2], 2); };
  std::vector<Index> rows(polygon.begin(), polygon.end());
  std::ranges::sort(rows, [&](Index a, Index b) {
    return std::array{at(a)[0], at(a)[1]} < std::array{at(b)[0], at(b)[1]};
  });
  const auto extend = [&](std::size_t start, auto first, auto last) {
    for (; first != last; ++first) {
      while (boundary.size() >= start + 2 && turn(at(boundary.end()[-2]), at(boundary.back()), at(*first)) < 0) {
        boundary.pop_back();
      }
      boundary.push_back(*first);
    }
    boundary.pop_back();  // the first of the other chain
  };
  if (rows.size() < 3) {
    boundary.insert(boundary.end(), rows.begin(), rows.end());
    return;
  }
  extend(boundary.size(), rows.begin(), rows.end());
  extend(boundary.size(), rows.rbegin(), rows.rend());
}

}  // namespace delone::io
