// Which of two sites is closer to a point: distances in doubles with a bound on their error, then exact integers.
//
// The distance of a site p of weight w from q is its power |q - p|^2 - w, without weights the squared distance. All D
// coordinates count; the kernel's K leading ones are only where they stand.
//
// Error bound, u = 2^-53, n = D coordinates. A difference carries one rounding (and never underflows), its square two
// and one more, a sum of n squares n - 1 more: (n + 2) u times the sum s, to first order. Subtracting w adds u (s +
// |w|), and so does moving the value by its error, as comparisons do. In all (n + 4) u (s + |w|); one more u covers
// what is of second order. Squares that underflow are off by 2^-1075 each, which the absolute part covers. What
// overflows makes value and error infinite, and the comparisons below then say "unsure".
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "delone/base/ids.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "delone/geometry/filter.hpp"
#include "delone/geometry/sites.hpp"

namespace delone {

/// Two sites and a point that see each other: D coordinates each, in one order of axes.
struct DistanceRefs {
  std::array<double, kMaxDimension> q{}, a{}, b{};
  double a_weight = 0.0, b_weight = 0.0;
  int dimension = 0;
};

/// Sign of (|q - a|^2 - a_weight) - (|q - b|^2 - b_weight).
SlowSign slow_compare_distance(const DistanceRefs& refs);
/// Sign of |q - a|^2 - a_weight - radius^2; b is not looked at.
SlowSign slow_compare_radius(const DistanceRefs& refs, double radius);

/// A power distance and a bound on its error.
struct Power {
  double value;
  double error;
};

/// The distances of sites from one point after another. Cheap to make; valid as long as the sites.
template <int K>
class Distances {
  static constexpr std::size_t kLeading = K;

 public:
  explicit Distances(const Sites& sites)
      : sites_(&sites),
        x_(sites.leading()),
        others_(sites.others()),
        weights_(sites.weights()),
        other_count_(static_cast<std::size_t>(sites.dimension() - K)),
        plain_(other_count_ == 0 && weights_ == nullptr),
        bound_((sites.dimension() + 5) * filter::kU) {}

  /// From here on distances are those from q. @param q  as Sites::placed gives it
  void measure_from(const std::array<double, kMaxDimension>& q) { q_ = q; }

  [[gnu::always_inline]] Power power(VertexId v) const {
    const double* p = x_ + raw(v) * kLeading;
    double square = 0.0;
    for (std::size_t j = 0; j < kLeading; ++j) square += (p[j] - q_[j]) * (p[j] - q_[j]);
    if (plain_) [[likely]]
      return {square, bound_ * square + kSlack};
    for (std::size_t j = 0; j < other_count_; ++j) {
      const double e = others_[raw(v) * other_count_ + j] - q_[kLeading + j];
      square += e * e;
    }
    const double weight = weights_ == nullptr ? 0.0 : weights_[raw(v)];
    return {square - weight, bound_ * (square + std::abs(weight)) + kSlack};
  }

  /// Sign of the distance of a less that of b; exact.
  [[gnu::always_inline]] int compare(VertexId a, Power pa, VertexId b, Power pb) const {
    const int sign = filtered_compare(pa, pb);
    return sign != filter::kUnsure ? sign : decide(a, pa, b, pb);
  }
  int compare(VertexId a, VertexId b) const { return compare(a, power(a), b, power(b)); }
  /// Sign of the distance of a less radius^2, the latter not rounded; exact. @param radius  not negative
  int compare_with_radius(VertexId a, Power pa, double radius) const {
    const double square = radius * radius;
    const int sign = filtered_compare(pa, {square, 2.0 * filter::kU * square + kSlack});
    return sign != filter::kUnsure ? sign : slow_compare_radius(refs(a, a), radius).sign;
  }

  // The stages one by one.
  static int filtered_compare(Power a, Power b) {
    if (a.value - a.error > b.value + b.error) return 1;
    if (a.value + a.error < b.value - b.error) return -1;
    return filter::kUnsure;
  }
  /// Sure where all coordinates are integers times a power of two, so short that doubles hold every square: there equal
  /// distances are found without integers, too.
  int integral_compare(Power a, Power b) const {
    NumberRange range = sites_->range();
    range.include(std::span(q_).first(kLeading + other_count_));
    const double largest = bound_ * (0.5 * filter::exact_below(range.unit, 2));  // half: both sums stay below
    if (!(a.error < largest && b.error < largest)) return filter::kUnsure;
    return filter::exact_sign(a.value - b.value);
  }
  SlowSign slow_compare(VertexId a, VertexId b) const { return slow_compare_distance(refs(a, b)); }

 private:
  static constexpr double kSlack = 0x1p-1060;

  [[gnu::noinline]] int decide(VertexId a, Power pa, VertexId b, Power pb) const {
    const int sign = integral_compare(pa, pb);
    return sign != filter::kUnsure ? sign : slow_compare(a, b).sign;
  }

  DistanceRefs refs(VertexId a, VertexId b) const {
    DistanceRefs refs;
    refs.q = q_;
    refs.dimension = sites_->dimension();
    for (std::size_t j = 0; j < kLeading + other_count_; ++j) {
      refs.a[j] = coordinate(a, j);
      refs.b[j] = coordinate(b, j);
    }
    refs.a_weight = sites_->weight(a);
    refs.b_weight = sites_->weight(b);
    return refs;
  }
  double coordinate(VertexId v, std::size_t place) const {
    return place < kLeading ? x_[raw(v) * kLeading + place] : others_[raw(v) * other_count_ + place - kLeading];
  }

  const Sites* sites_;
  const double* x_;
  const double* others_;
  const double* weights_;
  std::size_t other_count_;
  bool plain_;  // no others, no weights
  double bound_;
  std::array<double, kMaxDimension> q_{};
};

}  // namespace delone
