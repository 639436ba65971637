// The smallest ball grows: while a point lies outside, the smallest ball of the support and that point takes its place.
// Each is larger than the one before, so it ends, and the last one holds all.
//
// Why it is the right ball: a ball that passes through affinely independent points is the smallest one that holds them
// exactly when its centre is a convex combination of them, and without superfluous points all weights are positive. The
// smallest ball of a support S and a point q outside passes through q (else it would be that of S). So some subset of S
// makes with q a support, which is found by trying all of the at most 2^(D + 1) subsets.
// In the diagram of furthest sites the centre lies on the face of the sites on the sphere, which is dual to a face of
// furthest_delaunay() that the centre lies in; a diagram of high dimension is large, so it is not made for that.
//
// Which rows are inside: in doubles, s is the squared distance from the rounded centre c'. It is off by (D + 2) u of
// itself, and c' by u |c'_j| in each coordinate, so that a point is inside when sqrt(s (1 + 12 u)) + u |c'| < r. What
// this leaves open is decided by integers.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "delone/apps/furthest_voronoi.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"
#include "delone/geometry/sites.hpp"
#include "exact/gram.hpp"
#include "exact/quotient.hpp"

namespace delone {
namespace {

using exact::BigInt;
using exact::dot;
using exact::Integers;

/// The double nearest to sqrt(numerator / denominator) * 2^exponent. The root of at least 60 bits stands for itself, or
/// with a half added for all that lies between it and the next one.
double nearest_root(const BigInt& numerator, const BigInt& denominator, int exponent) {
  if (numerator == 0) return 0.0;
  const int shift = 60 + std::max(0, static_cast<int>(msb(denominator)) - static_cast<int>(msb(numerator)));
  BigInt square, rest, left;
  divide_qr(BigInt(numerator << (2 * shift)), denominator, square, left);
  const BigInt root = sqrt(square, rest);
  return exact::nearest_double(2 * root + (rest != 0 || left != 0 ? 1 : 0), 1, exponent - shift - 1);
}

/// A ball with its centre over a common denominator, in a unit of a power of two.
struct ExactBall {
  std::vector<Index> support;
  Integers centre;
  BigInt denominator, squared_radius;  // the latter over the square of the former
};

class BallFinder {
 public:
  explicit BallFinder(PointsView points) : points_(points) {
    NumberRange range;
    range.include(points.coordinates());
    unit_ = range.unit;
  }

  EnclosingBall find() {
    ExactBall ball = *smallest(std::array{Index{0}});
    for (Index outside = look_outside(ball); outside != kNone; outside = look_outside(ball)) {
      ball = enlarged(ball, outside);
    }
    EnclosingBall result = rounded(ball);
    std::ranges::copy_if(doubtful_, std::back_inserter(result.on_sphere),
                         [&](Index row) { return side(ball, row) == 0; });
    return result;
  }

 private:
  Integers at(Index row) const {
    Integers x;
    for (const double coordinate : points_[row])
      x.push_back(exact::to_integer<BigInt>(exact::decompose(coordinate), unit_));
    return x;
  }

  /// The ball through these points, if they are a support: independent, with the centre strictly inside of their
  /// simplex.
  std::optional<ExactBall> smallest(std::span<const Index> rows) const {
    const Integers origin = at(rows[0]);
    std::vector<Integers> edges;
    Integers squares;
    for (const Index row : rows.subspan(1)) {
      edges.push_back(at(row));
      for (std::size_t j = 0; j < origin.size(); ++j) edges.back()[j] -= origin[j];
      squares.push_back(dot(edges.back(), edges.back()));
    }
    const auto [weights, determinant] = exact::solve_gram(edges, squares);  // twice the barycentric coordinates
    BigInt rest = 2 * determinant;
    for (const BigInt& weight : weights) rest -= weight;
    if (determinant == 0 || rest <= 0 || std::ranges::any_of(weights, [](const BigInt& w) { return w <= 0; }))
      return {};

    ExactBall ball{{rows.begin(), rows.end()}, Integers(origin.size()), 2 * determinant, 0};
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t j = 0; j < origin.size(); ++j) ball.centre[j] += weights[i] * edges[i][j];
    }
    ball.squared_radius = dot(ball.centre, ball.centre);
    for (std::size_t j = 0; j < origin.size(); ++j) ball.centre[j] += ball.denominator * origin[j];
    return ball;
  }

  /// +1 outside, 0 on the sphere, -1 inside.
  int side(const ExactBall& ball, Index row) const {
    Integers x = at(row);
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = x[j] * ball.denominator - ball.centre[j];
    return exact::sign(BigInt(dot(x, x) - ball.squared_radius));
  }

  ExactBall enlarged(const ExactBall& ball, Index outside) const {
    for (std::size_t set = 0;; ++set) {  // ends: some subset is the rest of a support
      std::vector<Index> rows{outside};
      for (std::size_t i = 0; i < ball.support.size(); ++i) {
        if ((set >> i & 1) != 0) rows.push_back(ball.support[i]);
      }
      std::optional<ExactBall> next = smallest(rows);
      const auto is_outside = [&](Index row) { return side(*next, row) > 0; };
      if (next && std::ranges::none_of(ball.support, is_outside)) return *std::move(next);
    }
  }

  /// A row outside of the ball, kNone when there is none; leaves in doubtful_ all rows that doubles do not tell to be
  /// inside. The furthest of them is likely to be outside, and to make the ball grow most.
  Index look_outside(const ExactBall& ball) {
    const EnclosingBall near = rounded(ball);
    const double limit = certainly_inside(near);
    double largest = -1.0;
    Index furthest = kNone;
    doubtful_.clear();
    for (std::size_t row = 0; row < points_.size(); ++row) {
      double square = 0.0;
      for (std::size_t j = 0; j < near.centre.size(); ++j) {
        const double d = points_[row][j] - near.centre[j];
        square += d * d;
      }
      if (square < limit) continue;
      doubtful_.push_back(static_cast<Index>(row));
      if (square > largest) {
        largest = square;
        furthest = static_cast<Index>(row);
      }
    }
    if (furthest != kNone && side(ball, furthest) > 0) return furthest;
    const auto found = std::ranges::find_if(doubtful_, [&](Index row) { return side(ball, row) > 0; });
    return found == doubtful_.end() ? kNone : *found;
  }

  /// Squared distances from the rounded centre below this belong to points inside; 0 where nothing is sure.
  static double certainly_inside(const EnclosingBall& ball) {
    const double off = std::accumulate(ball.centre.begin(), ball.centre.end(), 0x1p-1000,
                                       [](double sum, double x) { return sum + std::abs(x) * 0x1p-52; });
    const double rest = ball.radius * (1 - 0x1p-48) - off;
    const double limit = rest > 0 ? rest * rest * (1 - 0x1p-48) : 0.0;
    return limit > 0x1p-900 && limit < 0x1p1000 ? limit : 0.0;  // squares neither overflow nor vanish
  }

  EnclosingBall rounded(const ExactBall& ball) const {
    EnclosingBall result;
    for (const BigInt& x : ball.centre) result.centre.push_back(exact::nearest_double(x, ball.denominator, unit_));
    const BigInt square = ball.denominator * ball.denominator;
    result.radius = nearest_root(ball.squared_radius, square, unit_);
    result.squared_radius = exact::nearest_double(ball.squared_radius, square, 2 * unit_);
    result.support = ball.support;
    std::ranges::sort(result.support);
    return result;
  }

  PointsView points_;
  int unit_;
  std::vector<Index> doubtful_;
};

}  // namespace

EnclosingBall smallest_enclosing_ball(PointsView points) {
  require_row_count(points.size(), 1);  // of numbers for rows: no cells are made
  if (points.weighted()) throw InputError("a smallest ball is that of points: weights have no meaning here");
  require_finite(points);
  const ExactEnvironment environment;
  return points.empty() ? EnclosingBall{} : BallFinder(points).find();
}

}  // namespace delone
