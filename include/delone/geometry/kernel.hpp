// The kernel answers signs about sites and knows nothing about cells' links: filter, then the slow stages, then the tie
// rule.
//
//   orient(v0 .. vK)      sign of det(v1 - v0, ..., vK - v0); exact, never perturbed: no flat cell can appear
//   conflict(cell, q)     is the lifted q below the lifted hyperplane of a positive cell; never undecided, since ties
//   are
//                         broken by lowering heights (perturb.hpp)
// Error bounds, u = 2^-53. Differences to a common vertex carry one rounding each; [Shewchuk97] section 4 bounds the
// error of the determinants as written below by (3 + 16u)u, (7 + 56u)u, (10 + 96u)u, (16 + 224u)u times the permanent,
// for orient 2D and 3D, incircle and insphere. With S the largest squared length of the differences, every permanent of
// three unit rows is at most 3!/3^(3/2) < 1.155 [CLL06] and of two at most 1, so the permanent of insphere is at most 4
// * 1.155 S^(5/2), that of incircle 3 S^2: bounds that cost one comparison. A weight difference of size W adds at most
// W to the S of one lift.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "delone/exact/determinant.hpp"
#include "delone/geometry/exact_predicates.hpp"
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

namespace filter {

inline constexpr int kUnsure = 2;
inline constexpr double kU = 0x1p-53;
/// Coordinates up to here: partial products of differences stay below 2^900, so that what underflows stays far below
/// every bound that passes the checks on its size.
inline constexpr double kLargest = 0x1p99;
/// Below this, products of five differences may underflow and bounds lose their meaning.
inline constexpr double kSmallestSquare = 0x1p-180;

inline int sign_beyond(double value, double bound) { return value > bound ? 1 : (value < -bound ? -1 : kUnsure); }

/// On coordinates that are integers times 2^unit all terms of a determinant of `degree` factors are integers times
/// 2^(unit degree): while their sum stays below 2^53 of these, doubles hold every one, and a zero is a zero. So
/// lattices never leave the filter.
inline double exact_below(int unit, int degree) {
  const int exponent = unit * degree + 53;
  return exponent > -900 && exponent < 900 ? std::ldexp(1.0, exponent) : 0.0;
}

/// Roundings of the lifted determinant as written for K = 1, 2, 3. A lift that also sums other coordinates and a weight
/// carries for each of the former a difference taken twice, a square and a sum, and for the latter two more: since all
/// these share their place with the squares already counted, two for each and four in all cover them.
constexpr double conflict_roundings(int k) { return k == 1 ? 16.0 : (k == 2 ? 10.1 : 16.1); }

inline int exact_sign(double value) { return value > 0.0 ? 1 : (value < 0.0 ? -1 : 0); }

}  // namespace filter

/// The lifted hyperplane of a positive cell, seen from its first vertex v0: a point q at d = q - v0 of height l above
/// v0 is in conflict when normal . d + height * l < 0. Kept per cell above dimension 3, where it turns a test from a
/// determinant into a dot product (advice of [For92] 4.8).
template <int K>
struct Hyperplane {
  std::array<double, K> normal;
  double height;
  double tilt_error;    ///< times the sum of |d_j|, plus
  double height_error;  ///< times the size of l: bounds the rounding error of the sum
};

template <int K>
class Kernel {
  static constexpr std::size_t kCoordinates = K;

 public:
  using Cell = std::array<VertexId, K + 1>;

  explicit Kernel(const Sites& sites)
      : x_(sites.leading()),
        others_(sites.others()),
        weights_(sites.weights()),
        other_count_(sites.dimension() - K),
        plain_(other_count_ == 0 && weights_ == nullptr),
        tame_(sites.magnitude() < filter::kLargest),
        orient_exact_below_(filter::exact_below(sites.unit(), K)),
        conflict_exact_below_(filter::exact_below(sites.unit(), K + 2)),
        conflict_bound_(filter::kU * (filter::conflict_roundings(K) + (plain_ ? 0 : 2 * other_count_ + 4))) {}

  const double* at(VertexId v) const { return x_ + raw(v) * kCoordinates; }
  const PredicateStats& stats() const { return stats_; }

  /// Sign of det(v1 - v0, ..., vK - v0) of finite vertices.
  [[gnu::always_inline]] int orient(const Cell& v) {
    const int sign = filtered_orient(v);
    if (sign != kUnsure) [[likely]] {
      ++stats_.orient_filter;
      return sign;
    }
    ++stats_.orient_exact;
    return exact_orient(v);
  }

  /// Whether the lifted q lies below the hyperplane of a finite, positively oriented cell; ties are broken.
  [[gnu::always_inline]] bool conflict(const Cell& cell, VertexId q) {
    const int sign = filtered_conflict(cell, q);
    if (sign == 1 || sign == -1) [[likely]] {
      ++stats_.conflict_filter;
      return sign > 0;
    }
    return sign == 0 ? tie(cell, q) : slow_perturbed_conflict(cell, q);
  }

  /// The same from the cell's hyperplane.
  [[gnu::always_inline]] bool conflict(const Hyperplane<K>& plane, const Cell& cell, VertexId q) {
    const int sign = filtered_conflict(plane, cell[0], q);
    if (sign != kUnsure) [[likely]] {
      ++stats_.conflict_filter;
      return sign > 0;
    }
    return slow_perturbed_conflict(cell, q);
  }
  Hyperplane<K> hyperplane(const Cell& cell) const;

  /// Lexicographic order of two sites; equal only at the same place.
  bool before(VertexId a, VertexId b) const {
    for (std::size_t j = 0; j < kCoordinates; ++j) {
      if (at(a)[j] != at(b)[j]) return at(a)[j] < at(b)[j];
    }
    return false;
  }
  bool same_place(VertexId a, VertexId b) const { return !before(a, b) && !before(b, a); }

  // The stages one by one, for tests.
  static constexpr int kUnsure = filter::kUnsure;
  int filtered_orient(const Cell& v) const;
  int filtered_conflict(const Cell& cell, VertexId q) const;
  int filtered_conflict(const Hyperplane<K>& plane, VertexId origin, VertexId q) const;
  [[gnu::noinline]] int exact_orient(const Cell& v) const;
  SlowSign slow_conflict_sign(const Cell& cell, VertexId q) const;

 private:
  [[gnu::noinline]] bool slow_perturbed_conflict(const Cell& cell, VertexId q);
  /// q lies exactly on the cell's lifted hyperplane.
  [[gnu::noinline]] bool tie(const Cell& cell, VertexId q);

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
  double orient_exact_below_;  // determinants whose permanent lies below are computed without any rounding
  double conflict_exact_below_;
  double conflict_bound_;  // times the permanent: error of the lifted determinant
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
    return sign_beyond(value, (K == 3 ? 7.1 : 2.1 * K + K * (K + 1) / 2) * kU * size);
  }
}

}  // namespace filter

template <int K>
[[gnu::always_inline]] inline int Kernel<K>::filtered_orient(const Cell& v) const {
  if constexpr (K != 1) {
    if (!tame_) [[unlikely]]
      return kUnsure;
  }
  const double* origin = at(v[0]);
  if constexpr (K == 1) {
    const double a = *origin;
    const double b = *at(v[1]);
    return b > a ? 1 : (b < a ? -1 : 0);
  } else {
    Matrix<K, double> m;
    for (std::size_t i = 0; i < kCoordinates; ++i) {
      const double* p = at(v[i + 1]);
      for (std::size_t j = 0; j < kCoordinates; ++j) m[i][j] = p[j] - origin[j];
    }
    return filter::orient_of_differences<K>(m, orient_exact_below_);
  }
}

template <int K>
[[gnu::always_inline]] inline int Kernel<K>::filtered_conflict(const Cell& cell, VertexId q) const {
  if (!tame_) [[unlikely]]
    return kUnsure;
  const double* origin = at(q);
  std::array<std::array<double, kCoordinates>, K + 1> d;
  std::array<double, K + 1> lift;
  double square = 0.0;  // S
  for (std::size_t i = 0; i <= kCoordinates; ++i) {
    const double* p = at(cell[i]);
    double sum = 0.0;
    for (std::size_t j = 0; j < kCoordinates; ++j) {
      d[i][j] = p[j] - origin[j];
      sum += d[i][j] * d[i][j];
    }
    lift[i] = sum;
    square = sum > square ? sum : square;
  }
  double height = square;  // S + W
  if (!plain_) [[unlikely]] {
    for (std::size_t i = 0; i <= kCoordinates; ++i) {
      const Lift extra = extra_lift(cell[i], q);
      const double size = lift[i] + extra.size;
      lift[i] += extra.value;
      height = size > height ? size : height;
    }
  }
  if (!(square > filter::kSmallestSquare && height < 0x1p190)) return kUnsure;

  if constexpr (K == 1) {
    const double value = d[1][0] * lift[0] - d[0][0] * lift[1];
    return filter::sign_beyond(value, conflict_bound_ * std::sqrt(square) * height);
  } else if constexpr (K == 2) {
    const double value = lift[0] * (d[1][0] * d[2][1] - d[2][0] * d[1][1]) +
                         lift[1] * (d[2][0] * d[0][1] - d[0][0] * d[2][1]) +
                         lift[2] * (d[0][0] * d[1][1] - d[1][0] * d[0][1]);
    const double permanent = 3.0 * square * height;
    if (permanent < conflict_exact_below_) [[unlikely]]
      return filter::exact_sign(value);
    return filter::sign_beyond(value, conflict_bound_ * permanent);
  } else if constexpr (K == 3) {
    const double ab = d[0][0] * d[1][1] - d[1][0] * d[0][1];
    const double bc = d[1][0] * d[2][1] - d[2][0] * d[1][1];
    const double cd = d[2][0] * d[3][1] - d[3][0] * d[2][1];
    const double da = d[3][0] * d[0][1] - d[0][0] * d[3][1];
    const double ac = d[0][0] * d[2][1] - d[2][0] * d[0][1];
    const double bd = d[1][0] * d[3][1] - d[3][0] * d[1][1];
    const double abc = d[0][2] * bc - d[1][2] * ac + d[2][2] * ab;
    const double bcd = d[1][2] * cd - d[2][2] * bd + d[3][2] * bc;
    const double cda = d[2][2] * da + d[3][2] * ac + d[0][2] * cd;
    const double dab = d[3][2] * ab + d[0][2] * bd + d[1][2] * da;
    const double value = (lift[3] * abc - lift[2] * dab) + (lift[1] * cda - lift[0] * bcd);
    // |value| > c (S + W) S^(3/2), squared on both sides: no root.
    const double c = 4 * 1.155 * conflict_bound_;
    if (value * value > (c * c * (1 + 0x1p-40)) * (square * square * square) * (height * height)) {
      return value < 0 ? 1 : -1;
    }
    if (4.0 * 1.2 * height * square * std::sqrt(square) < conflict_exact_below_) return -filter::exact_sign(value);
    return kUnsure;
  } else {
    Matrix<K + 1, double> m;
    std::array<double, K> maxima{};
    for (std::size_t i = 0; i <= kCoordinates; ++i) {
      for (std::size_t j = 0; j < kCoordinates; ++j) {
        m[i][j] = d[i][j];
        maxima[j] = std::max(maxima[j], std::abs(d[i][j]));
      }
      m[i][K] = lift[i];
    }
    double size = height;
    for (int j = 1; j <= K + 1; ++j) size *= j;
    for (const double x : maxima) size *= x;
    if (!(size > 0x1p-900 && size < 0x1p900)) return kUnsure;
    constexpr int roundings = 2 * (K + 1) + (K + 1) * (K + 2) / 2 + K + kMaxDimension + 4;
    const int sign = filter::sign_beyond(determinant<K + 1>(m), 1.01 * roundings * filter::kU * size);
    return sign == kUnsure || K % 2 == 0 ? sign : -sign;
  }
}

template <int K>
typename Kernel<K>::Lift Kernel<K>::extra_lift(VertexId v, VertexId q) const {
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

// Errors, all relative to K! times the product of the columns' maxima, column j left out for the minor j: an entry of
// the K rows carries one rounding, a lift at most K + 8 + 4; a minor of k rows adds k of them to those of k - 1 rows.
// The sum of K + 1 products adds K + 2, the differences and the lift of q again as many as those of a row.
template <int K>
Hyperplane<K> Kernel<K>::hyperplane(const Cell& cell) const {
  constexpr int kLiftRoundings = K + kMaxDimension + 4;
  constexpr double kBound = 1.01 * filter::kU * (K * (K + 1) / 2 + K + kLiftRoundings + K + 3 + kLiftRoundings);
  const double* origin = at(cell[0]);
  std::array<std::array<double, K + 1>, K> rows;
  std::array<double, K + 1> maxima{};
  for (std::size_t i = 0; i < kCoordinates; ++i) {
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
    rows[i][K] = lift;
    maxima[K] = std::max(maxima[K], size);
  }
  const auto minors = minors_without_column<K>(rows);
  Hyperplane<K> plane;
  for (std::size_t j = 0; j < kCoordinates; ++j) plane.normal[j] = (kCoordinates - j) % 2 == 0 ? minors[j] : -minors[j];
  plane.height = minors[K];
  double flattest = maxima[0];
  double product = kBound;
  bool safe = tame_;
  for (std::size_t j = 0; j < kCoordinates; ++j) {
    flattest = std::min(flattest, maxima[j]);
    product *= maxima[j] * static_cast<double>(j + 1);
    safe = safe && maxima[j] > 0x1p-60 && maxima[j] < 0x1p60;
  }
  safe = safe && maxima[K] < 0x1p121;
  plane.height_error = safe ? product : std::numeric_limits<double>::infinity();
  plane.tilt_error = safe ? product / flattest * maxima[K] : 0.0;
  return plane;
}

template <int K>
[[gnu::always_inline]] inline int Kernel<K>::filtered_conflict(const Hyperplane<K>& plane, VertexId origin,
                                                               VertexId q) const {
  const double* a = at(origin);
  const double* b = at(q);
  double value = 0.0;
  double length = 0.0;
  double lift = 0.0;
  for (std::size_t j = 0; j < kCoordinates; ++j) {
    const double d = b[j] - a[j];
    value += plane.normal[j] * d;
    length += std::abs(d);
    lift += d * d;
  }
  double size = lift;
  if (!plain_) [[unlikely]] {
    const Lift extra = extra_lift(q, origin);
    lift += extra.value;
    size += extra.size;
  }
  if (!(size > filter::kSmallestSquare && size < 0x1p190)) return kUnsure;
  value += plane.height * lift;
  const double bound = plane.tilt_error * length + plane.height_error * size;
  return value < -bound ? 1 : (value > bound ? -1 : kUnsure);
}

template <int K>
int Kernel<K>::exact_orient(const Cell& v) const {
  std::array<const double*, K + 1> points;
  for (std::size_t i = 0; i <= kCoordinates; ++i) points[i] = at(v[i]);
  return slow_orient<K>(points).sign;
}

template <int K>
SlowSign Kernel<K>::slow_conflict_sign(const Cell& cell, VertexId q) const {
  SiteRefs<K, K + 2> refs;
  refs.other_count = other_count_;
  refs.weighted = weights_ != nullptr;
  for (std::size_t i = 0; i < K + 2; ++i) {
    const VertexId v = i <= kCoordinates ? cell[i] : q;
    refs.leading[i] = at(v);
    refs.others[i] = others_ + raw(v) * static_cast<std::size_t>(other_count_);
    refs.weights[i] = refs.weighted ? weights_[raw(v)] : 0.0;
  }
  return slow_conflict<K>(refs);
}

template <int K>
bool Kernel<K>::slow_perturbed_conflict(const Cell& cell, VertexId q) {
  const SlowSign slow = slow_conflict_sign(cell, q);
  if (slow.sign != 0) {
    ++(slow.stage == Stage::adaptive ? stats_.conflict_adaptive : stats_.conflict_exact);
    return slow.sign > 0;
  }
  return tie(cell, q);
}

template <int K>
bool Kernel<K>::tie(const Cell& cell, VertexId q) {
  ++stats_.conflict_symbolic;
  return perturbed_conflict<K>(
      cell, q, [this](VertexId a, VertexId b) { return before(a, b); }, [this](const Cell& v) { return orient(v); });
}

}  // namespace delone
