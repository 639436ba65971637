// The kernel answers signs about sites and knows nothing about cells' links: filter, then the slow stages, then the tie
// rule.
//
//   orient(v0 .. vK)    sign of det(v1 - v0, ..., vK - v0); exact, never perturbed: no flat cell can appear
//   conflict(cell, q)   is the lifted q below the lifted hyperplane of a positive cell; never undecided, since ties are
//                       broken by lowering heights (perturb.hpp)
//
// Error bounds, u = 2^-53. Differences to a common vertex carry one rounding each; [Shewchuk97] section 4 bounds the
// error of the determinants as written below by (3 + 16u)u, (7 + 56u)u, (10 + 96u)u, (16 + 224u)u times the permanent,
// for orient 2D and 3D, incircle and insphere. With S the largest squared length of the differences, every permanent of
// three unit rows is at most 3!/3^(3/2) < 1.155 [CLL06] and of two at most 1, so the permanent of insphere is at most
// 4 * 1.155 S^(5/2), that of incircle 3 S^2: bounds that cost one comparison. A weight difference of size W adds at
// most W to the S of one lift.
// What underflows is off by less than 2^-1074 times its other factors, which a small number added to a bound covers. It
// is added to S, too, since heights may be large where differences are tiny.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "delone/base/pair.hpp"
#include "delone/exact/determinant.hpp"
#include "delone/exact/four_rows.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "delone/geometry/filter.hpp"
#include "delone/geometry/perturb.hpp"
#include "delone/geometry/sites.hpp"

namespace delone {

/// How many tests each stage decided.
struct PredicateStats {
  std::uint64_t orient_filter = 0;
  std::uint64_t orient_exact = 0;
  std::uint64_t conflict_filter = 0;
  std::uint64_t conflict_adaptive = 0;
  std::uint64_t conflict_exact = 0;
  std::uint64_t conflict_symbolic = 0;

  PredicateStats& operator+=(const PredicateStats& other);
};

/// The lifted hyperplane of a positive cell, seen from one of its vertices, the origin: a point q at d = q - origin, of
/// height l above it, is in conflict when normal . d + height * l < 0. The height is 1 in a finite cell; it is 0 in a
/// ghost cell, whose hyperplane is vertical. Kept per cell above dimension 3, where it turns a test from a determinant
/// into a dot product (advice of [For92] 4.8).
template <int K>
struct Hyperplane {
  std::array<double, K> normal;
  double tilt_error;  ///< times the sum of |d_j|: bounds the error, but for that of l; 0 when nothing is known yet
  VertexId origin;
  float height;
};

/// How far above a hyperplane a site lies, in units of `height` above, and a bound on the error of that.
struct Sight {
  double value, bound;
  bool surely_below() const { return value < -bound; }
};

/// A site of the plane as another one sees it.
struct Ray {
  Pair to;
  double lift;  ///< how much higher its lifted point lies, but for the plane that touches at the other one
  double size;  ///< the sum of the sizes of its parts

  /// Twice the area of the triangle with both, positive when `next` follows in turning order.
  [[gnu::always_inline]] double turn(const Ray& next) const { return to[0] * next.to[1] - to[1] * next.to[0]; }
};

template <int K>
class Kernel {
  static constexpr std::size_t kCoordinates = K;
  static constexpr int kPairs = (K + 1) / 2;

 public:
  using Cell = std::array<VertexId, K + 1>;
  /// K coordinates each, of sites or of other points.
  using Points = std::array<const double*, K + 1>;

  explicit Kernel(const Sites& sites) : Kernel(sites, sites.range()) {}
  /// For tests of points that are no sites, too. @param range  holds the coordinates of both
  Kernel(const Sites& sites, const NumberRange& range)
      : x_(sites.leading()),
        others_(sites.others()),
        weights_(sites.weights()),
        other_count_(sites.dimension() - K),
        plain_(other_count_ == 0 && weights_ == nullptr),
        tame_(range.magnitude < filter::kLargest),
        short_integers_(range.magnitude < filter::power_of_two(range.unit + 120 / (K + 2))),
        orient_exact_below_(filter::exact_below(range.unit, K)),
        conflict_exact_below_(filter::conflict_exact_below<K>(range.unit)),
        conflict_bound_(tame_ ? filter::kU * (filter::conflict_roundings(K) + (plain_ ? 0 : 2 * other_count_ + 4))
                              : std::numeric_limits<double>::infinity()) {}

  const double* at(VertexId v) const { return x_ + raw(v) * kCoordinates; }
  Points at(const Cell& cell) const {
    Points points;
    for (std::size_t i = 0; i <= kCoordinates; ++i) points[i] = at(cell[i]);
    return points;
  }
  const PredicateStats& stats() const { return stats_; }
  /// Counts conflict tests that a search decided for itself.
  void count_filtered(std::uint64_t tests) { stats_.conflict_filter += tests; }

  /// Sign of det(v1 - v0, ..., vK - v0) of finite vertices.
  [[gnu::always_inline]] int orient(const Cell& v) { return orient(at(v)); }
  [[gnu::always_inline]] int orient(const Points& v) {
    const int sign = filtered_orient(v);
    if (sign != kUnsure) [[likely]] {
      ++stats_.orient_filter;
      return sign;
    }
    ++stats_.orient_exact;
    return exact_orient(v);
  }
  /// The same with the point q in slot i.
  [[gnu::always_inline]] int orient(const Cell& v, int i, const double* q) {
    Points points;
    for (std::size_t j = 0; j <= kCoordinates; ++j) points[j] = static_cast<int>(j) == i ? q : at(v[j]);
    return orient(points);
  }

  /// A slot of the finite cell such that q lies strictly beyond the facet opposite to it, or -1 when q is in the closed
  /// cell. It is known that q is not beyond the facet opposite slot `entered`, unless that is -1.
  [[gnu::always_inline]] int separating_slot(const Cell& cell, const double* q, int entered);

  /// Whether the lifted q lies below the hyperplane of a finite, positively oriented cell; ties are broken.
  [[gnu::always_inline]] bool conflict(const Cell& cell, VertexId q) { return decide(estimate(cell, q), cell, q); }

  Sight sight(const Hyperplane<K>& plane, VertexId q) const;
  /// Whether inserting a site destroys a cell, finite or ghost, whose hyperplane sees it so; where that leaves it open,
  /// in_doubt().
  template <class F>
  [[gnu::always_inline]] bool conflict(const Sight& s, const F& in_doubt) {
    if (std::abs(s.value) > s.bound) [[likely]] {
      ++stats_.conflict_filter;
      return s.value < 0.0;
    }
    return in_doubt();
  }
  [[gnu::noinline]] bool conflict_in_doubt(const Cell& cell, VertexId q) { return decide_slowly({}, cell, q); }
  /// From the coordinates of a cell, finite or ghost; unknown where doubles do not tell it.
  Hyperplane<K> hyperplane(const Cell& cell) const;
  /// The same for the new cell on the facet between one that q destroys and one that stays, from their hyperplanes and
  /// how these see q.
  Hyperplane<K> hyperplane(const Hyperplane<K>& inside, const Sight& in, const Hyperplane<K>& outside, const Sight& out,
                           VertexId q) const;

  /// v as `from` sees it.
  [[gnu::always_inline]] Ray ray(VertexId v, VertexId from) const requires(K == 2) {
    const Pair to = load_pair(at(v)) - load_pair(at(from));
    const double square = to[0] * to[0] + to[1] * to[1];
    if (plain_) [[likely]]
      return {to, square, square};
    const Lift extra = extra_lift(v, from);
    return {to, square + extra.value, square + extra.size};
  }
  /// conflict() of a cell whose corners q sees as a, b, c, with their turns; `cell` tells it where that is in doubt.
  template <class F>
  [[gnu::always_inline]] bool conflict(const Ray& a, const Ray& b, const Ray& c, double ab, double bc, double ca,
                                       VertexId q, const F& cell) requires(K == 2) {
    const double value = a.lift * bc + b.lift * ca + c.lift * ab;
    if (std::abs(value) > lifted_bound(std::max(std::max(a.size, b.size), c.size))) [[likely]] {
      ++stats_.conflict_filter;
      return value > 0.0;
    }
    return conflict_from_coordinates(cell(), q);
  }
  /// The same of a cell with corner `seer`, from where the others are seen as a and b, and the query as q.
  template <class F>
  [[gnu::always_inline]] bool conflict_seen(const Ray& a, const Ray& b, const Ray& q, double ab, double bq, double aq,
                                            VertexId query, const F& cell) requires(K == 2) {
    const double value = b.lift * aq - a.lift * bq - q.lift * ab;
    if (std::abs(value) > lifted_bound(std::max(std::max(a.size, b.size), q.size))) [[likely]] {
      ++stats_.conflict_filter;
      return value > 0.0;
    }
    return conflict_from_coordinates(cell(), query);
  }

  /// orient() of a cell whose first corner sees the others as a and b, with this turn between them.
  template <class F>
  [[gnu::always_inline]] int orient_seen(const Ray& a, const Ray& b, double turn, const F& cell) requires(K == 2) {
    // Of each product the size is at most half the sum of the squares of its factors.
    if (std::abs(turn) > 1.6 * filter::kU * (a.size + b.size) + 0x1p-1000) [[likely]] {
      ++stats_.orient_filter;
      return turn > 0.0 ? 1 : -1;
    }
    return orient(cell());
  }

  /// The error of a lifted determinant of sites that are seen with lifts of at most this size, which stands for S and
  /// for S + W. No determinant lies beyond it where one might overflow: then it is infinite, or no number.
  [[gnu::always_inline]] double lifted_bound(double size) const {
    if constexpr (K == 2) return conflict_bound_ * (3.0 * (size + 0x1p-900) * size) + 0x1p-1000;
    const double s = size + 0x1p-300;
    return (4 * 1.155 * (1 + 0x1p-40)) * conflict_bound_ * std::sqrt((s * s) * (s * s) * s) + 0x1p-447;
  }

  /// Where the fifth power of their size lies below this, a determinant of lifts in space is computed without any
  /// rounding, so that a zero is a tie.
  double exact_lifts_below() const requires(K == 3) { return conflict_exact_below_; }
  /// conflict() where q is known to lie exactly on the cell's lifted hyperplane.
  [[gnu::noinline]] bool conflict_by_tie(const Cell& cell, VertexId q);

  /// Null without weights.
  const double* weights() const { return weights_; }
  /// Whether the sites lie in a flat of more dimensions, whose other coordinates count in heights.
  bool flat() const { return other_count_ != 0; }
  bool weighted() const { return weights_ != nullptr; }

  /// Which of `corners`, 1 to 32 sites on the inner side of edge (a, b) of a triangulation or on its outer side, makes
  /// with it the cell (a, corner, b) that no other one is in conflict with. At least one is on the inner side.
  std::size_t innermost(VertexId a, VertexId b, std::span<const VertexId> corners) requires(K == 2);

  /// On the leading axes, rounded.
  double squared_distance(VertexId v, const double* q) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < kCoordinates; ++j) sum += (at(v)[j] - q[j]) * (at(v)[j] - q[j]);
    return sum;
  }

  /// Lexicographic order of two sites; equal only at the same place. Without branches: on lattices it is a coin toss.
  bool before(VertexId a, VertexId b) const {
    int less = 0;
    for (std::size_t j = kCoordinates; j-- > 0;) {
      less = static_cast<int>(at(a)[j] < at(b)[j]) | (static_cast<int>(at(a)[j] == at(b)[j]) & less);
    }
    return less != 0;
  }
  bool same_place(VertexId a, VertexId b) const {
    bool same = true;
    for (std::size_t j = 0; j < kCoordinates; ++j) same &= at(a)[j] == at(b)[j];
    return same;
  }

  // The stages one by one.
  static constexpr int kUnsure = filter::kUnsure;
  int filtered_orient(const Points& v) const;
  int filtered_orient(const Cell& v) const { return filtered_orient(at(v)); }
  int filtered_conflict(const Cell& cell, VertexId q) const { return sign(estimate(cell, q)); }
  int filtered_conflict(const Hyperplane<K>& plane, VertexId q) const {
    const Sight s = sight(plane, q);
    return filter::sign_beyond(-s.value, s.bound);
  }
  int conflict_sign_by_permanent(const Cell& cell, VertexId q) const { return sign(estimate_by_permanent(cell, q)); }
  [[gnu::noinline]] int exact_orient(const Points& v) const { return slow_orient<K>(v).sign; }
  int exact_orient(const Cell& v) const { return exact_orient(at(v)); }
  SlowSign slow_conflict_sign(const Cell& cell, VertexId q) const;

 private:
  /// In 3D from the differences of a cell's corners to q.
  template <class P>
  FourRows<P> seen_from(const Cell& cell, const double* q) const requires(K == 3);

  /// The orientations of the cell with one vertex after the other replaced by q, and what bounds their errors. Each has
  /// the number of its slot in its last two bits, which changes its size by less than the bound was rounded up by. In
  /// the plane slot 3 is slot 1 again.
  struct Sides {
    Pair even, odd;
    double bound;
  };
  Sides sides(const Cell& cell, const double* q) const requires(K == 2 || K == 3);

  /// The lifted determinant, positive when q is in conflict, or what has its sign. Sure when its error is smaller; free
  /// of any error when `size` lies below conflict_exact_below_ (see there).
  struct Estimate {
    double value = 0.0;
    double size = std::numeric_limits<double>::infinity();
    bool sure = false;
  };
  Estimate estimate(const Cell& cell, VertexId q) const;
  /// With a bound from the sizes of all terms: where a cell is long and thin, it is much smaller than one from lengths.
  Estimate estimate_by_permanent(const Cell& cell, VertexId q) const;

  int sign(const Estimate& e) const {
    return e.sure || e.size < conflict_exact_below_ ? filter::exact_sign(e.value) : kUnsure;
  }
  /// No branch depends on the outcome, which nobody can predict.
  [[gnu::always_inline]] bool decide(const Estimate& e, const Cell& cell, VertexId q) {
    if (e.sure) [[likely]] {
      ++stats_.conflict_filter;
      return e.value > 0.0;
    }
    return decide_slowly(e, cell, q);
  }
  [[gnu::noinline]] bool decide_slowly(Estimate e, const Cell& cell, VertexId q);
  [[gnu::noinline]] bool conflict_from_coordinates(const Cell& cell, VertexId q) { return conflict(cell, q); }

  struct Lift {
    double value, size;
  };
  /// What other coordinates and weights add to the height of v above q, and the sum of its parts' sizes.
  Lift extra_lift(VertexId v, VertexId q) const;

  const double* x_;
  const double* others_;
  const double* weights_;
  int other_count_;
  bool plain_;  // heights are |x|^2 of the leading coordinates and nothing else
  bool tame_;   // no coordinate is so large that partial products could overflow, or drown others that underflow
  bool short_integers_;        // coordinates are integers times a power of two, so short that 128 bits do
  double orient_exact_below_;  // determinants whose permanent lies below are computed without any rounding
  double conflict_exact_below_;
  double conflict_bound_;  // times the permanent: error of the lifted determinant; infinite for untame coordinates
  PredicateStats stats_;
};

namespace filter {

/// orient from the differences to v0, by Laplace expansion of the determinant and of its permanent.
template <int K>
[[gnu::always_inline]] inline int orient_of_differences(const Matrix<K, double>& m, double exact_below) {
  if constexpr (K == 2) {
    const double left = m[0][0] * m[1][1];
    const double right = m[0][1] * m[1][0];
    const double size = std::abs(left) + std::abs(right);
    if (size < exact_below) return exact_sign(left - right);
    if (!(size > 0x1p-900)) return kUnsure;
    return sign_beyond(left - right, 3.01 * kU * size);
  } else {
    // A product of K entries and the sums around it round at most 2K + K(K+1)/2 times, the differences once per factor.
    const double value = determinant<K>(m);
    const double size = absolute_permanent<K>(m);
    if (size < exact_below) return exact_sign(value);
    if (!(size > 0x1p-400 && size < 0x1p400)) return kUnsure;
    return sign_beyond(value, (K == 3 ? 7.1 : 2.1 * K + 0.5 * K * (K + 1)) * kU * size);
  }
}

}  // namespace filter

template <int K>
[[gnu::always_inline]] inline int Kernel<K>::filtered_orient(const Points& v) const {
  if constexpr (K != 1) {
    if (!tame_) [[unlikely]]
      return kUnsure;
  }
  const double* origin = v[0];
  if constexpr (K == 1) {
    const double a = *origin;
    const double b = *v[1];
    return b > a ? 1 : (b < a ? -1 : 0);
  } else {
    Matrix<K, double> m;
    for (std::size_t i = 0; i < kCoordinates; ++i) {
      for (std::size_t j = 0; j < kCoordinates; ++j) m[i][j] = v[i + 1][j] - origin[j];
    }
    return filter::orient_of_differences<K>(m, orient_exact_below_);
  }
}

template <int K>
template <class P>
[[gnu::always_inline]] inline FourRows<P> Kernel<K>::seen_from(const Cell& cell, const double* q) const
    requires(K == 3) {
  const Pair xy = load_pair(q);
  const Pair a = load_pair(at(cell[0])) - xy;
  const Pair b = load_pair(at(cell[1])) - xy;
  const Pair c = load_pair(at(cell[2])) - xy;
  const Pair d = load_pair(at(cell[3])) - xy;
  const Pair z0 = Pair{at(cell[0])[2], at(cell[1])[2]} - q[2];
  const Pair z1 = Pair{at(cell[2])[2], at(cell[3])[2]} - q[2];
  return four_rows(P(firsts(a, b)), P(firsts(c, d)), P(seconds(a, b)), P(seconds(c, d)), P(z0), P(z1));
}

template <int K>
[[gnu::always_inline]] inline typename Kernel<K>::Estimate Kernel<K>::estimate(const Cell& cell, VertexId q) const {
  const double* origin = at(q);
  if constexpr (K == 2) {
    const Pair xy = load_pair(origin);
    const Pair a = load_pair(at(cell[0])) - xy;
    const Pair b = load_pair(at(cell[1])) - xy;
    const Pair c = load_pair(at(cell[2])) - xy;
    const Pair x = firsts(a, b);
    const Pair y = seconds(a, b);
    Pair lift = x * x + y * y;
    double c_lift = c[0] * c[0] + c[1] * c[1];
    const double square = std::max(std::max(lift[0], lift[1]), c_lift);  // S
    double height = square;                                              // S + W
    if (!plain_) [[unlikely]] {
      const Lift la = extra_lift(cell[0], q);
      const Lift lb = extra_lift(cell[1], q);
      const Lift lc = extra_lift(cell[2], q);
      height = std::max({lift[0] + la.size, lift[1] + lb.size, c_lift + lc.size});
      lift += Pair{la.value, lb.value};
      c_lift += lc.value;
    }
    const Pair with_c = x * c[1] - y * c[0];  // ac, bc
    const double ab = a[0] * b[1] - b[0] * a[1];
    const Pair terms = lift * turned(with_c, with_c);
    const double value = terms[0] - terms[1] + c_lift * ab;
    const double permanent = 3.0 * (square + 0x1p-900) * height;
    return {value, permanent, tame_ && std::abs(value) > conflict_bound_ * permanent + 0x1p-1000};
  } else if constexpr (K == 3) {
    auto [abc, cda, l0, l1] = seen_from<Pair>(cell, at(q));
    const Pair larger_lifts = larger(l0, l1);
    const double square = std::max(larger_lifts[0], larger_lifts[1]);
    double height = square;
    if (!plain_) [[unlikely]] {
      const Lift la = extra_lift(cell[0], q);
      const Lift lb = extra_lift(cell[1], q);
      const Lift lc = extra_lift(cell[2], q);
      const Lift ld = extra_lift(cell[3], q);
      const Pair heights = larger(l0 + Pair{la.size, lb.size}, l1 + Pair{lc.size, ld.size});
      height = std::max(heights[0], heights[1]);
      l0 += Pair{la.value, lb.value};
      l1 += Pair{lc.value, ld.value};
    }
    const Pair terms = lifted_terms<Pair>({abc, cda, l0, l1});
    const double value = terms[1] - terms[0];
    // |value| > c (S + W) S^(3/2), squared on both sides: no root.
    const double s = square + 0x1p-300;
    const double size = (s * s * s) * (height * height);
    const double c2 = (4 * 1.155 * conflict_bound_) * (4 * 1.155 * conflict_bound_) * (1 + 0x1p-40);
    return {value, size, tame_ && value * value > c2 * size + 0x1p-895};
  } else {
    return estimate_by_permanent(cell, q);
  }
}

// A term of the determinant multiplies K differences, of one rounding each, and a lift of at most K + 8 + 4, in K
// products and at most (K + 1) K / 2 sums.
template <int K>
typename Kernel<K>::Estimate Kernel<K>::estimate_by_permanent(const Cell& cell, VertexId q) const {
  const auto estimate = [this](double value, double permanent, double height) -> Estimate {
    constexpr double kBound = 1.01 * filter::kU * (K + (K + kMaxDimension + 4) + K + 0.5 * K * (K + 1));
    // A minor that underflows is off by 2^-1075, and its cofactor below 2^(100 (K - 2) + 200): less than the bound.
    constexpr double kSmallest = K <= 6 ? 0x1p-400 : (K == 7 ? 0x1p-300 : 0x1p-200);
    const bool safe = tame_ && height < 0x1p200 && permanent > kSmallest && permanent < 0x1p900;
    return {value, std::numeric_limits<double>::infinity(), safe && std::abs(value) > kBound * permanent};
  };
  std::array<Lift, K + 1> extra{};
  if (!plain_) {
    for (std::size_t i = 0; i <= kCoordinates; ++i) extra[i] = extra_lift(cell[i], q);
  }
  if constexpr (K == 3) {  // half the instructions
    auto rows = seen_from<SizedPair>(cell, at(q));
    rows.ab_lifts.value += Pair{extra[0].value, extra[1].value};
    rows.cd_lifts.value += Pair{extra[2].value, extra[3].value};
    rows.ab_lifts.size += Pair{extra[0].size, extra[1].size};
    rows.cd_lifts.size += Pair{extra[2].size, extra[3].size};
    const Pair heights = larger(rows.ab_lifts.size, rows.cd_lifts.size);
    const SizedPair terms = lifted_terms(rows);
    return estimate(terms.value[1] - terms.value[0], terms.size[0] + terms.size[1], std::max(heights[0], heights[1]));
  } else {
    const double* origin = at(q);
    Matrix<K + 1, double> m;
    Matrix<K + 1, double> sizes;
    double height = 0.0;
    for (std::size_t i = 0; i <= kCoordinates; ++i) {
      const double* p = at(cell[i]);
      double lift = 0.0;
      for (std::size_t j = 0; j < kCoordinates; ++j) {
        m[i][j] = p[j] - origin[j];
        sizes[i][j] = m[i][j];
        lift += m[i][j] * m[i][j];
      }
      m[i][K] = lift + extra[i].value;
      sizes[i][K] = lift + extra[i].size;
      height = std::max(height, sizes[i][K]);
    }
    const double value = K % 2 == 0 ? determinant<K + 1>(m) : -determinant<K + 1>(m);
    return estimate(value, absolute_permanent<K + 1>(sizes), height);
  }
}

template <int K>
[[gnu::always_inline]] inline typename Kernel<K>::Sides Kernel<K>::sides(const Cell& cell, const double* q) const
    requires(K == 2 || K == 3) {
  const double slack = tame_ ? 0x1p-1000 : std::numeric_limits<double>::infinity();
  if constexpr (K == 2) {
    const Pair origin = load_pair(q);
    const Pair a = load_pair(at(cell[0])) - origin;
    const Pair b = load_pair(at(cell[1])) - origin;
    const Pair c = load_pair(at(cell[2])) - origin;
    const Pair squares = larger(larger(a * a, b * b), c * c);
    const double ca = c[0] * a[1] - c[1] * a[0];
    return {numbered(Pair{b[0] * c[1] - b[1] * c[0], a[0] * b[1] - a[1] * b[0]}, 0, 2), numbered(Pair{ca, ca}, 1, 1),
            3.1 * filter::kU * (squares[0] + squares[1]) + slack};
  } else {
    const auto [abc, cda, ab_lifts, cd_lifts] = seen_from<Pair>(cell, q);
    const Pair squares = larger(ab_lifts, cd_lifts);
    const double square = std::max(squares[0], squares[1]);
    return {numbered(seconds(abc, cda), 0, 2), numbered(-firsts(cda, abc), 1, 3),
            8.3 * filter::kU * square * std::sqrt(square) + slack};
  }
}

template <int K>
[[gnu::always_inline]] inline int Kernel<K>::separating_slot(const Cell& cell, const double* q, int entered) {
  std::array<bool, K + 1> open{};  // sides of unknown sign
  if constexpr (K == 2 || K == 3) {
    const auto [even, odd, bound] = sides(cell, q);
    const Pair lower = smaller(even, odd);
    const double lowest = std::min(lower[0], lower[1]);
    if (std::abs(lowest) > bound) [[likely]] {
      ++stats_.orient_filter;
      return lowest < 0.0 ? number_in(lowest) : -1;
    }
    for (std::size_t i = 0; i <= kCoordinates; ++i) open[i] = !((i % 2 == 0 ? even : odd)[i / 2] > bound);
  } else {
    open.fill(true);
  }
  for (std::size_t i = 0; i <= kCoordinates; ++i) {
    const int slot = static_cast<int>(i);
    if (slot == entered || !open[i]) continue;
    if (orient(cell, slot, q) < 0) return slot;
  }
  return -1;
}

template <int K>
[[gnu::always_inline]] inline typename Kernel<K>::Lift Kernel<K>::extra_lift(VertexId v, VertexId q) const {
  Lift lift{0.0, 0.0};
  const auto count = static_cast<std::size_t>(other_count_);
  for (std::size_t j = 0; j < count; ++j) {
    const double e = others_[raw(v) * count + j] - others_[raw(q) * count + j];
    lift.value += e * e;
  }
  lift.size = lift.value;
  if (weights_ != nullptr) {
    const double w = weights_[raw(v)] - weights_[raw(q)];
    lift.value -= w;
    lift.size += std::abs(w);
  }
  return lift;
}

// Products of a normal with d round K + 3 times, with the difference and the last sum; l rounds twice in each
// difference, then at most K + 8 + 4 times.
template <int K>
[[gnu::always_inline]] inline Sight Kernel<K>::sight(const Hyperplane<K>& plane, VertexId q) const {
  constexpr double kLiftBound = 1.01 * filter::kU * (2 + K + kMaxDimension + 4);
  const double* a = at(plane.origin);
  const double* b = at(q);
  Sight s;
  Pair values{};
  Pair lengths{};
  Pair squares{};
  for (int i = 0; i < kPairs; ++i) {
    const Pair d = load_pair<K>(b, i) - load_pair<K>(a, i);
    values += load_pair<K>(plane.normal.data(), i) * d;
    lengths += magnitude(d);
    squares += d * d;
  }
  double lift = sum(squares);
  double size = lift;
  if (!plain_) [[unlikely]] {
    const Lift extra = extra_lift(q, plane.origin);
    lift += extra.value;
    size += extra.size;
  }
  const double height = static_cast<double>(plane.height);
  s.value = sum(values) + height * lift;
  s.bound = plane.tilt_error * sum(lengths) + kLiftBound * height * size;
  if (!(size > 0x1p-180 && size < 0x1p190)) s.bound = std::numeric_limits<double>::infinity();
  return s;
}

// Errors of minors, all relative to K! times the product of the columns' maxima, column j left out for the minor j: an
// entry of the K rows carries one rounding, a lift at most K + 8 + 4; a minor of k rows adds k of them to those of
// k - 1 rows. The row of a ghost is the direction of heights, so that only column K of it counts. What is then divided
// by the height h or, in a ghost cell, by the largest of the normal n is off by (error of n + |n / h| error of h) /
// |h|.
template <int K>
Hyperplane<K> Kernel<K>::hyperplane(const Cell& cell) const {
  constexpr double kBound = 1.01 * filter::kU * (0.5 * K * (K + 1) + K + K + kMaxDimension + 4 + 2);
  const bool ghost = cell[K] == kGhost;
  const double* origin = at(cell[0]);
  std::array<std::array<double, K + 1>, K> rows;
  std::array<double, K + 1> maxima{};
  for (std::size_t i = 0; i < kCoordinates - (ghost ? 1 : 0); ++i) {
    const double* p = at(cell[i + 1]);
    double lift = 0.0;
    for (std::size_t j = 0; j < kCoordinates; ++j) {
      const double d = p[j] - origin[j];
      rows[i][j] = d;
      lift += d * d;
      maxima[j] = std::max(maxima[j], std::abs(d));
    }
    double size = lift;
    if (!plain_) [[unlikely]] {
      const Lift extra = extra_lift(cell[i + 1], cell[0]);
      lift += extra.value;
      size += extra.size;
    }
    rows[i][K] = ghost ? 0.0 : lift;
    maxima[K] = std::max(maxima[K], ghost ? 1.0 : size);
  }
  if (ghost) {
    rows[K - 1].fill(0.0);
    rows[K - 1][K] = 1.0;
  }
  const auto minors = minors_without_column<K>(rows);
  double flattest = maxima[0];
  double product = kBound;
  double largest = 0.0;
  bool safe = tame_;
  for (std::size_t j = 0; j < kCoordinates; ++j) {
    flattest = std::min(flattest, maxima[j]);
    product *= maxima[j] * static_cast<double>(j + 1);
    safe = safe && maxima[j] > 0x1p-60 && maxima[j] < 0x1p60;
    largest = std::max(largest, std::abs(minors[j]));
  }
  const double tilt_error = product / flattest * maxima[K];
  const double scale = ghost ? largest : minors[K];
  const double scale_error = ghost ? tilt_error : product;
  Hyperplane<K> plane{};
  if (!(safe && maxima[K] < 0x1p121 && scale > 4.0 * scale_error)) return plane;
  for (std::size_t j = 0; j < kCoordinates; ++j) {
    plane.normal[j] = ((kCoordinates - j) % 2 == 0 ? minors[j] : -minors[j]) / scale;
  }
  largest /= scale;
  plane.tilt_error =
      1.01 * ((tilt_error + largest * scale_error) / (scale - scale_error) + (K + 4) * filter::kU * largest);
  plane.origin = cell[0];
  plane.height = ghost ? 0.0F : 1.0F;
  return plane;
}

// All hyperplanes through the facet that two cells share are sums of theirs, and the one that holds q, too, is
// G = a I + b O, where q lies a above the outer one O and b below the inner one I. Moved to the origin q, which lies s
// from the old one, a normal n becomes n + 2 height s, and what lies on G at q is 0. Scaled to height 1 again, G is
// divided by w = a i + b o, where i and o are the heights; when both are vertical, i = o = 1 does here as well.
//
// Errors: with a off by A, b by B, and true normals n_I and n_O,
//   (true w) (error of n) = a (error of n_I) + b (error of n_O) + A (n_I - i n) + B (n_O - o n)
// and n_I - i n = (b / w) x, n_O - o n = -(a / w) x, x = o n_I - i n_O. Here x has errors, too: A and B times those of
// n_I and n_O come on top. What is then rounded: a / w and b / w 5 times, products with n_I and 2 i s and sums of these
// 4 times at most.
template <int K>
Hyperplane<K> Kernel<K>::hyperplane(const Hyperplane<K>& inside, const Sight& in, const Hyperplane<K>& outside,
                                    const Sight& out, VertexId q) const {
  Hyperplane<K> plane{};
  if (other_count_ != 0 || inside.tilt_error == 0.0 || outside.tilt_error == 0.0) return plane;
  const bool vertical = inside.height + outside.height == 0.0F;
  const double i = vertical ? 1.0 : static_cast<double>(inside.height);
  const double o = vertical ? 1.0 : static_cast<double>(outside.height);
  const double w = out.value * i - in.value * o;
  if (!(0x1p-6 * w > out.bound * i + in.bound * o && w > 0x1p-300)) return plane;
  const double part = 1.0 / w;
  const double a = out.value * part;
  const double b = -in.value * part;
  const double a_size = std::abs(a);
  const double b_size = std::abs(b);
  const double in_shift = vertical ? 0.0 : 2.0 * i;
  const double out_shift = vertical ? 0.0 : 2.0 * o;
  Pair turn{};
  Pair terms{};
  Pair normal{};
  for (int j = 0; j < kPairs; ++j) {
    const Pair n_in = load_pair<K>(inside.normal.data(), j);
    const Pair n_out = load_pair<K>(outside.normal.data(), j);
    const Pair s_in = in_shift * (load_pair<K>(at(q), j) - load_pair<K>(at(inside.origin), j));
    const Pair s_out = out_shift * (load_pair<K>(at(q), j) - load_pair<K>(at(outside.origin), j));
    const Pair n = a * (n_in + s_in) + b * (n_out + s_out);
    store_pair<K>(n, plane.normal.data(), j);
    turn = larger(turn, magnitude(o * (n_in + s_in) - i * (n_out + s_out)));
    terms =
        larger(terms, a_size * (magnitude(n_in) + magnitude(s_in)) + b_size * (magnitude(n_out) + magnitude(s_out)));
    normal = larger(normal, magnitude(n));
  }
  const double size = largest(terms);
  if (!(size > 0x1p-200 && size < 0x1p200)) return plane;
  const double a_error = out.bound * part;
  const double b_error = in.bound * part;
  const double inherited = (a_size + a_error) * inside.tilt_error + (b_size + b_error) * outside.tilt_error;
  const double tilt = (a_error * b_size + b_error * a_size) * largest(turn);
  plane.tilt_error = 1.05 * (inherited + tilt + 10 * filter::kU * size) + 1.01 * (K + 4) * filter::kU * largest(normal);
  plane.origin = q;
  plane.height = vertical ? 0.0F : 1.0F;
  return plane;
}

// Each test is that of conflict() with a as the common vertex, so with its bound; what belongs to one corner is
// computed once. No orientation is asked for: all planes through the edge's two lifted ends are ordered by their slope
// across it, and that of the cell beyond the edge, which no corner is in conflict with, lies between those through
// inner corners and those through outer ones. So the test, whose sign turns with the cell's, always prefers an inner
// corner to an outer one, and among inner ones it is the plain one. Ties are no exception, since they are broken as if
// heights differed; a query that is the first of all in their order counts as in conflict, which is right for an inner
// one whatever the cell.
template <int K>
std::size_t Kernel<K>::innermost(VertexId a, VertexId b, std::span<const VertexId> corners) requires(K == 2) {
  if (corners.size() == 1) return 0;
  const Ray end = ray(b, a);
  std::array<Ray, 32> rays;
  std::array<double, 32> sides;
  double size = end.size;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    rays[i] = ray(corners[i], a);
    sides[i] = end.turn(rays[i]);
    size = std::max(size, rays[i].size);
  }
  const double bound = lifted_bound(size);
  std::size_t best = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double value = end.lift * rays[best].turn(rays[i]) - rays[best].lift * sides[i] + rays[i].lift * sides[best];
    bool lower = value > 0.0;
    if (!(std::abs(value) > bound)) [[unlikely]] {
      lower = conflict_from_coordinates({a, corners[best], b}, corners[i]);
    } else {
      ++stats_.conflict_filter;
    }
    best = lower ? i : best;
  }
  return best;
}

template <int K>
SlowSign Kernel<K>::slow_conflict_sign(const Cell& cell, VertexId q) const {
  SiteRefs<K, K + 2> refs;
  refs.other_count = other_count_;
  refs.weighted = weights_ != nullptr;
  refs.short_integers = short_integers_;
  for (std::size_t i = 0; i < K + 2; ++i) {
    const VertexId v = i <= kCoordinates ? cell[i] : q;
    refs.leading[i] = at(v);
    refs.others[i] = others_ + raw(v) * static_cast<std::size_t>(other_count_);
    refs.weights[i] = refs.weighted ? weights_[raw(v)] : 0.0;
  }
  return slow_conflict<K>(refs);
}

template <int K>
bool Kernel<K>::decide_slowly(Estimate e, const Cell& cell, VertexId q) {
  if (e.size < conflict_exact_below_) {
    if (e.value == 0.0) return conflict_by_tie(cell, q);
    ++stats_.conflict_filter;
    return e.value > 0.0;
  }
  if (const Estimate closer = estimate_by_permanent(cell, q); closer.sure) {
    ++stats_.conflict_filter;
    return closer.value > 0.0;
  }
  const SlowSign slow = slow_conflict_sign(cell, q);
  if (slow.sign == 0) return conflict_by_tie(cell, q);
  ++(slow.stage == Stage::adaptive ? stats_.conflict_adaptive : stats_.conflict_exact);
  return slow.sign > 0;
}

template <int K>
bool Kernel<K>::conflict_by_tie(const Cell& cell, VertexId q) {
  ++stats_.conflict_symbolic;
  return perturbed_conflict<K>(
      cell, q, [this](VertexId a, VertexId b) { return before(a, b); }, [this](const Cell& v) { return orient(v); });
}

// Compiled once (src/geometry/kernel.cpp): unrolled as they are, they would take a third of the time of every source
// that is made for all dimensions. In line they gain nothing.
extern template class Kernel<4>;
extern template class Kernel<5>;
extern template class Kernel<6>;
extern template class Kernel<7>;
extern template class Kernel<8>;

}  // namespace delone
