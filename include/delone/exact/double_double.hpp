// Numbers of about 106 bits as the unevaluated sum of two doubles: the cheap and strong middle stage between plain
// doubles and big integers. Source: [Shewchuk97] section 2 for the transformations; the operations are the "sloppy" sum
// and the first product of [JMP17] (algorithms 5 and 10). With u = 2^-53 and without over- or underflow a product is
// off by at most 7 u^2 of itself ([JMP17] theorem 5.1), and a sum of a and b by at most 6 u^2 (|a| + |b|): the sum of
// the low parts rounds by u (u |a| + u |b|), adding it to the error of the sum of the high parts by 2 u^2 (|a| + |b|),
// and the last step, when the high parts cancel, by as much again.
#pragma once

#include "delone/exact/eft.hpp"

namespace delone {

class DoubleDouble {
 public:
  DoubleDouble() = default;
  explicit DoubleDouble(double x) : high_(x), low_(0.0) {}
  /// The exact difference a - b.
  static DoubleDouble difference(double a, double b) { return DoubleDouble(two_sum(a, -b)); }

  double high() const { return high_; }

  [[gnu::always_inline]] friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const TwoDoubles s = two_sum(a.high_, b.high_);
    return DoubleDouble(quick_two_sum(s.high, s.low + (a.low_ + b.low_)));
  }
  [[gnu::always_inline]] friend DoubleDouble operator-(DoubleDouble a) {
    a.high_ = -a.high_;
    a.low_ = -a.low_;
    return a;
  }
  [[gnu::always_inline]] friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
  [[gnu::always_inline]] friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const TwoDoubles p = two_product(a.high_, b.high_);
    return DoubleDouble(quick_two_sum(p.high, p.low + (a.high_ * b.low_ + a.low_ * b.high_)));
  }

 private:
  explicit DoubleDouble(TwoDoubles x) : high_(x.high), low_(x.low) {}

  double high_, low_;
};

}  // namespace delone
