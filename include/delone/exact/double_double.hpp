// Numbers of about 106 bits as the unevaluated sum of two doubles: the cheap and strong middle stage between plain
// doubles and big integers. Source: [Shewchuk97] section 2 for the transformations; the operations are the "sloppy" sum
// and the first product of [JMP17] (algorithms 5 and 10). With u = 2^-53 and without over- or underflow a product is
// off by at most 7 u^2 of itself ([JMP17] theorem 5.1), and a sum of a and b by at most 6 u^2 (|a| + |b|): the sum of
// the low parts rounds by u (u |a| + u |b|), adding it to the error of the sum of the high parts by 2 u^2 (|a| + |b|),
// and the last step, when the high parts cancel, by as much again.
#pragma once

#include <type_traits>

#include "delone/exact/eft.hpp"

namespace delone {

/// One such number, or two of them side by side: T is a double or a Pair.
template <class T>
class DoubleDoubles {
 public:
  DoubleDoubles() = default;
  explicit DoubleDoubles(T x) : high_(x), low_{} {}
  /// The exact difference a - b.
  static DoubleDoubles difference(T a, T b) { return DoubleDoubles(two_sum(a, -b)); }

  T high() const { return high_; }

  [[gnu::always_inline]] friend DoubleDoubles operator+(DoubleDoubles a, DoubleDoubles b) {
    const TwoParts<T> s = two_sum(a.high_, b.high_);
    return DoubleDoubles(quick_two_sum<T>(s.high, s.low + (a.low_ + b.low_)));
  }
  [[gnu::always_inline]] friend DoubleDoubles operator-(DoubleDoubles a) {
    a.high_ = -a.high_;
    a.low_ = -a.low_;
    return a;
  }
  [[gnu::always_inline]] friend DoubleDoubles operator-(DoubleDoubles a, DoubleDoubles b) { return a + -b; }
  [[gnu::always_inline]] friend DoubleDoubles operator*(DoubleDoubles a, DoubleDoubles b) {
    const TwoParts<T> p = two_product(a.high_, b.high_);
    return DoubleDoubles(quick_two_sum<T>(p.high, p.low + (a.high_ * b.low_ + a.low_ * b.high_)));
  }

  // Of two side by side, as of a Pair.
  [[gnu::always_inline]] friend DoubleDoubles turned(DoubleDoubles a, DoubleDoubles b) {
    return DoubleDoubles(TwoParts<T>{turned(a.high_, b.high_), turned(a.low_, b.low_)});
  }
  [[gnu::always_inline]] DoubleDoubles<double> operator[](int lane) const requires(!std::is_same_v<T, double>) {
    return DoubleDoubles<double>(TwoParts<double>{high_[lane], low_[lane]});
  }

 private:
  template <class>
  friend class DoubleDoubles;
  explicit DoubleDoubles(TwoParts<T> x) : high_(x.high), low_(x.low) {}

  T high_, low_;
};

using DoubleDouble = DoubleDoubles<double>;

}  // namespace delone
