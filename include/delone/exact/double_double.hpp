// Numbers of about 106 bits as the unevaluated sum of two doubles: the cheap and strong middle stage between plain
// doubles and big integers. Source: [Shewchuk97] section 2 for the transformations; the error bounds of the "accurate"
// sum and the product are those of [JMP17] (theorems 3.1 and 5.3): relative error below 3 u^2 + 13 u^3 and 5 u^2, u =
// 2^-53, without over- or underflow.
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

  friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const TwoDoubles s = two_sum(a.high_, b.high_);
    const TwoDoubles t = two_sum(a.low_, b.low_);
    const TwoDoubles v = quick_two_sum(s.high, s.low + t.high);
    return DoubleDouble(quick_two_sum(v.high, t.low + v.low));
  }
  friend DoubleDouble operator-(DoubleDouble a) {
    a.high_ = -a.high_;
    a.low_ = -a.low_;
    return a;
  }
  friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
  friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const TwoDoubles p = two_product(a.high_, b.high_);
    return DoubleDouble(quick_two_sum(p.high, p.low + (a.high_ * b.low_ + a.low_ * b.high_)));
  }

 private:
  explicit DoubleDouble(TwoDoubles x) : high_(x.high), low_(x.low) {}

  double high_, low_;
};

}  // namespace delone
