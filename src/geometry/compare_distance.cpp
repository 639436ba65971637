#include "delone/geometry/compare_distance.hpp"

#include <algorithm>
#include <limits>

#include "exact/integer.hpp"

namespace delone {
namespace {

using exact::BigInt;
using exact::Scaled;

/// Adds or subtracts (x - y)^2.
struct Square {
  Scaled x, y;
  bool added;
};

/// The sign of a sum of squares of differences and of two single numbers, in integers over a common power of two.
class SquareSum {
 public:
  void add(double x, double y) { push({exact::decompose(x), exact::decompose(y), true}); }
  void subtract(double x, double y) { push({exact::decompose(x), exact::decompose(y), false}); }
  void add(double weight) { plus_ = single(weight); }
  void subtract(double weight) { minus_ = single(weight); }

  SlowSign sign() const {
    if (unit_ == std::numeric_limits<int>::max()) return {0, Stage::adaptive};  // everything is zero
    int bits = 0;
    for (const Square& s : used()) {
      bits = std::max({bits, exact::bit_length(s.x, unit_), exact::bit_length(s.y, unit_)});
    }
    const int single_bits = std::max(exact::bit_length(plus_, 2 * unit_), exact::bit_length(minus_, 2 * unit_));
    // A difference has one bit more than its ends, 16 squares four more than one, and two single numbers are as many.
    const int needed = std::max(2 * (bits + 1) + 4, single_bits + 1) + 1;
    const int sign = exact::with_integer(needed, [&]<class Int>(Int) { return exact::sign(sum<Int>()); });
    return {sign, needed < 127 ? Stage::adaptive : Stage::exact};
  }

 private:
  void push(const Square& square) {
    squares_[count_++] = square;
    exact::lower_unit(unit_, square.x);
    exact::lower_unit(unit_, square.y);
  }
  Scaled single(double weight) {
    const Scaled w = exact::decompose(weight);
    exact::lower_unit(unit_, w, 2);
    return w;
  }
  std::span<const Square> used() const { return std::span(squares_).first(count_); }

  template <class Int>
  Int sum() const {
    Int sum = exact::to_integer<Int>(plus_, 2 * unit_) - exact::to_integer<Int>(minus_, 2 * unit_);
    for (const Square& s : used()) {
      const Int d = exact::to_integer<Int>(s.x, unit_) - exact::to_integer<Int>(s.y, unit_);
      sum = s.added ? Int(sum + d * d) : Int(sum - d * d);
    }
    return sum;
  }

  std::array<Square, 2 * kMaxDimension> squares_;
  std::size_t count_ = 0;
  Scaled plus_, minus_;
  int unit_ = std::numeric_limits<int>::max();
};

void add_distance(SquareSum& sum, const DistanceRefs& refs) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(refs.dimension); ++j) sum.add(refs.a[j], refs.q[j]);
  sum.subtract(refs.a_weight);
}

}  // namespace

SlowSign slow_compare_distance(const DistanceRefs& refs) {
  SquareSum sum;
  add_distance(sum, refs);
  for (std::size_t j = 0; j < static_cast<std::size_t>(refs.dimension); ++j) sum.subtract(refs.b[j], refs.q[j]);
  sum.add(refs.b_weight);
  return sum.sign();
}

SlowSign slow_compare_radius(const DistanceRefs& refs, double radius) {
  SquareSum sum;
  add_distance(sum, refs);
  sum.subtract(radius, 0.0);
  return sum.sign();
}

}  // namespace delone
