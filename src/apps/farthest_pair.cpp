// The two ends of the diameter are corners of the hull, and each is furthest from the other. They need not be joined by
// an edge of the furthest Delaunay triangulation: (-500, 0), (500, 0) are furthest apart among these and (-492, 100),
// (-492, -100), but the circles through both leave out one of the latter. What holds is that the furthest site of
// a corner owns the cell that the corner lies in.
//
// In the plane these cells are found without a search. Let i < j < k < l be corners in turning order. Two diagonals are
// longer than two opposite sides, |ik| + |jl| > |il| + |jk|; so when l is at least as far from i as k, it is further
// from j than k. Hence, as i turns, so do the corners furthest from it, all that are equally far included, and each
// half of the corners has its furthest ones on its own side of those of the corner in the middle.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "delone/apps/furthest_voronoi.hpp"
#include "delone/apps/hull.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"
#include "delone/geometry/kernel.hpp"
#include "exact/integer.hpp"

namespace delone {
namespace {

using exact::BigInt;

/// The best of the pairs that it is shown.
class Furthest {
 public:
  explicit Furthest(PointsView points)
      : points_(points), bound_((static_cast<double>(points.dimension()) + 5) * filter::kU) {}

  double square(Index a, Index b) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < points_[a].size(); ++j) {
      const double d = points_[a][j] - points_[b][j];
      sum += d * d;
    }
    return sum;
  }

  /// Sign of |ab| - |cd|, squares rounded as given; exact. The bound is that of compare_distance.hpp.
  int compare(Index a, Index b, double ab, Index c, Index d, double cd) const {
    const double error = bound_ * (ab + cd) + 0x1p-1060;
    if (ab - cd > error) return 1;
    if (cd - ab > error) return -1;
    return slow_compare(a, b, c, d);
  }

  void show(Index a, Index b) {
    if (a > b) std::swap(a, b);
    const double ab = square(a, b);
    const int sign = pair_.first == kNone ? 1 : compare(a, b, ab, pair_.first, pair_.second, square_);
    if (sign < 0 || (sign == 0 && std::pair(a, b) > std::pair(pair_.first, pair_.second))) return;
    pair_.first = a;
    pair_.second = b;
    square_ = ab;
  }

  FarthestPair pair() const {
    FarthestPair result = pair_;
    if (result.first == kNone) return result;
    for (std::size_t j = 0; j < points_[result.first].size(); ++j)
      result.distance = std::hypot(result.distance, points_[result.first][j] - points_[result.second][j]);
    return result;
  }

 private:
  int slow_compare(Index a, Index b, Index c, Index d) const {
    NumberRange range;
    for (const Index row : {a, b, c, d}) range.include(points_[row]);
    BigInt difference = 0;
    const auto add = [&](Index p, Index q, int times) {
      for (std::size_t j = 0; j < points_[p].size(); ++j) {
        const BigInt x = exact::to_integer<BigInt>(exact::decompose(points_[p][j]), range.unit) -
                         exact::to_integer<BigInt>(exact::decompose(points_[q][j]), range.unit);
        difference += times * x * x;
      }
    };
    add(a, b, 1);
    add(c, d, -1);
    return exact::sign(difference);
  }

  PointsView points_;
  double bound_;
  FarthestPair pair_;
  double square_ = 0.0;
};

void show_all(std::span<const Index> rows, Furthest& furthest) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = i + 1; j < rows.size(); ++j) furthest.show(rows[i], rows[j]);
  }
}

/// The corners of a convex polygon in turning order, from its edges.
std::vector<Index> ring_of(const CellTable& edges) {
  std::vector<std::array<Index, 2>> from_to;
  for (std::size_t e = 0; e < edges.size(); ++e) from_to.push_back({edges[e][0], edges[e][1]});
  std::ranges::sort(from_to);
  std::vector<Index> ring{from_to[0][0]};
  while (ring.size() < edges.size())
    ring.push_back((*std::ranges::lower_bound(from_to, std::array{ring.back(), Index{0}}))[1]);
  return ring;
}

/// Shows for corners `begin` to `end` - 1 of a ring those that may be furthest, which lie at places `low` to `high`;
/// places go on after the end of the ring.
void show_turning(std::span<const Index> ring, std::size_t begin, std::size_t end, std::size_t low, std::size_t high,
                  Furthest& furthest) {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const Index corner = ring[middle];
  const auto at = [&](std::size_t place) { return ring[place % ring.size()]; };
  const std::size_t first = std::max(low, middle + 1);
  const std::size_t last = std::min(high, middle + ring.size() - 1);
  std::size_t best = first;
  for (std::size_t place = first; place <= last; ++place) {
    const Index a = at(place), b = at(best);
    if (furthest.compare(corner, a, furthest.square(corner, a), corner, b, furthest.square(corner, b)) > 0)
      best = place;
    furthest.show(corner, a);
  }
  show_turning(ring, begin, middle, low, best, furthest);
  show_turning(ring, middle + 1, end, best, high, furthest);
}

}  // namespace

FarthestPair farthest_pair(PointsView points) {
  require_row_count(points.size(), 1);  // of numbers for rows: no cells are made
  if (points.weighted()) throw InputError("the farthest pair is one of points: weights have no meaning here");
  require_finite(points);
  const ExactEnvironment environment;
  Furthest furthest(points);
  if (points.dimension() > 3) {
    std::vector<Index> all(points.size());
    std::iota(all.begin(), all.end(), Index{0});
    show_all(all, furthest);
    return furthest.pair();
  }
  const ConvexHull hull = convex_hull(points);
  if (hull.affine_dimension == 0 && points.size() > 1) furthest.show(0, 1);
  if (hull.affine_dimension == 2) {
    const std::vector<Index> ring = ring_of(hull.facets);
    show_turning(ring, 0, ring.size(), 0, 2 * ring.size(), furthest);
  } else {
    show_all(hull.corners, furthest);
  }
  return furthest.pair();
}

}  // namespace delone
