// Exact signs about rows of the points, in a flat of dimension K. No rounding anywhere.
//
// Every test takes its handful of rows, writes their coordinates as integers over the largest power of two that divides
// them all, and subtracts: neighbours in space differ by few bits, whatever the units. Three lengths of integers
// decide: short (differences of up to 61 bits: nearly always), 640 bits where the determinant is sure to fit, and any
// length when 1e300 meets 1e-300. Matrices have a row per axis and a column per point.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include "check/affine_hull.hpp"
#include "delone/base/ids.hpp"
#include "delone/exact/determinant.hpp"
#include "delone/geometry/points.hpp"
#include "exact/integer.hpp"
#include "exact/short_determinant.hpp"
#include "exact/wide.hpp"

namespace delone::check_detail {

using exact::BigInt;
using exact::Int128;
using exact::Scaled;
using exact::Wide;

/// The least power of two, as an exponent, that is at least n!.
constexpr int factorial_bits(int n) {
  std::uint64_t factorial = 1;
  for (int i = 2; i <= n; ++i) factorial *= static_cast<std::uint64_t>(i);
  return static_cast<int>(std::bit_width(factorial - 1));
}

/// Bits of the integer x: |x| <= 2^bits. Kept as an OR over many integers.
class Magnitude {
 public:
  void add(Int128 x) { bits_ |= static_cast<unsigned __int128>(x < 0 ? ~x : x); }
  int bits() const {
    const auto high = static_cast<std::uint64_t>(bits_ >> 64);
    return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                     : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(bits_)));
  }

 private:
  unsigned __int128 bits_ = 0;
};

template <class Int>
inline constexpr bool kAnyLength = std::is_same_v<Int, BigInt>;

/// The integers for determinants that are too long for short_determinant_sign.
using Long = Wide<10>;
constexpr bool fits_into_long(int bits) { return bits <= 638; }  // a sign, and one bit to spare

template <int K>
class ExactKernel {
 public:
  using Cell = std::array<Index, static_cast<std::size_t>(K) + 1>;
  using Facet = std::array<Index, static_cast<std::size_t>(K)>;

  /// @param furthest  heights are turned over: what is said of the inside of orthospheres holds for their outside
  ExactKernel(PointsView points, const AffineHull& hull, bool furthest = false)
      : points_(points), axes_(hull.axes), height_(furthest ? -1 : 1) {}

  /// The orientation of a cell on the first K axes: +1, -1, or 0 when it is flat. Odd permutations turn the sign.
  int orient(const Cell& cell) const {
    const auto local = gather<K>(cell);
    return local.fits_in(kNarrow - 1) ? orient_by<Int128>(local) : orient_by<BigInt>(local);
  }

  /// +1 when q lies strictly inside of the orthosphere of the cell (its lifted point below the cell's hyperplane), 0 on
  /// it, -1 outside. `orientation` is that of the cell, not 0.
  int inside_orthosphere(const Cell& cell, int orientation, Index q) const {
    std::array<Index, kRows + 1> rows;
    std::copy(cell.begin(), cell.end(), rows.begin());
    rows.back() = q;
    const auto local = gather<0>(rows);
    const auto weights = gather_weights(rows, local.unit);
    const bool narrow = local.fits_in(kNarrow - 1) && weights.bits < kNarrow && weights.shift < kNarrow;
    const int above = narrow ? lifted_by<Int128>(local, weights) : lifted_by<BigInt>(local, weights);
    return -above * orientation * height_;
  }

  /// Whether q, on the orthosphere of the cell, destroys the cell in the canonical triangulation. Each lifted height is
  /// lowered by an infinitesimal, the lexicographically smallest point's dominating all others: the smallest of the
  /// points decides, unless lowering it leaves the cell's hyperplane at q as it was; then the next.
  bool wins_tie(const Cell& cell, int orientation, Index q) const {
    std::array<std::size_t, kRows + 1> order;  // positions in the cell, kRows for q
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto row = [&](std::size_t i) { return i == kRows ? q : cell[i]; };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return lexicographically_less(row(a), row(b)); });
    for (const std::size_t i : order) {
      if (i == kRows) return true;
      Cell replaced = cell;
      replaced[i] = q;
      const int barycentric = orient(replaced) * orientation;
      if (barycentric != 0) return barycentric < 0;
    }
    return true;  // never reached: q is among the points
  }

  /// The orientation of the simplex (o, facet), where o is the barycentre of the rows of `centre`.
  int orient_about(const Cell& centre, const Facet& facet) const { return about(centre, facet, kNoCorner, facet); }

  /// The same with the corner of that position moved onto the ray from o through the barycentre of `target`.
  int orient_about(const Cell& centre, const Facet& facet, std::size_t corner, const Facet& target) const {
    return about(centre, facet, corner, target);
  }

  /// Rows are compared by their coordinates, axis 0 first.
  bool lexicographically_less(Index a, Index b) const {
    const auto x = points_[a];
    const auto y = points_[b];
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
  }

 private:
  static constexpr std::size_t kAxes = static_cast<std::size_t>(K);
  static constexpr std::size_t kRows = kAxes + 1;
  static constexpr std::size_t kNoCorner = kAxes;
  static constexpr int kNarrow = 126;  // bits of a coordinate that Int128 may hold, room for one sum left

  /// Coordinates [row][axis] over 2^unit.
  template <std::size_t Rows>
  struct Local {
    std::array<std::array<Scaled, kMaxDimension>, Rows> x;
    int unit = INT_MAX;
    int top = INT_MIN;  // all are below 2^top

    bool fits_in(int bits) const { return top - unit <= bits; }
    template <class Int>
    Int at(std::size_t row, std::size_t axis) const {
      return exact::to_integer<Int>(x[row][axis], unit);
    }
  };

  /// Weights over 2^unit; coordinates squared are over 2^(unit + shift).
  struct LocalWeights {
    std::array<Scaled, kRows + 1> w;
    int unit = 0;
    int shift = 0;
    int bits = 0;
  };

  /// `Axes` leading axes, or all of them for 0.
  template <int Axes, std::size_t Rows>
  Local<Rows> gather(const std::array<Index, Rows>& rows) const {
    Local<Rows> local;
    const std::size_t axes = Axes != 0 ? static_cast<std::size_t>(Axes) : static_cast<std::size_t>(points_.dimension());
    for (std::size_t i = 0; i < Rows; ++i) {
      const auto point = points_[rows[i]];
      for (std::size_t j = 0; j < axes; ++j) {
        const Scaled x = exact::decompose(point[static_cast<std::size_t>(axes_[j])]);
        local.x[i][j] = x;
        if (x.mantissa == 0) continue;
        local.unit = std::min(local.unit, x.exponent);
        local.top = std::max(local.top, exact::bit_length(x, 0));
      }
    }
    if (local.top == INT_MIN) local.unit = local.top = 0;
    return local;
  }

  LocalWeights gather_weights(const std::array<Index, kRows + 1>& rows, int coordinate_unit) const {
    LocalWeights weights;
    if (!points_.weighted()) return weights;
    weights.unit = 2 * coordinate_unit;
    int top = weights.unit;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      weights.w[i] = exact::decompose(points_.weight(rows[i]));
      if (weights.w[i].mantissa == 0) continue;
      weights.unit = std::min(weights.unit, weights.w[i].exponent);
      top = std::max(top, exact::bit_length(weights.w[i], 0));
    }
    weights.shift = 2 * coordinate_unit - weights.unit;
    weights.bits = top - weights.unit;
    return weights;
  }

  /// The sign of a determinant of differences.
  template <class Difference>
  static int sign_of(const Matrix<K, Difference>& d) {
    if constexpr (kAnyLength<Difference>) {
      return exact::sign(determinant<K>(d));
    } else {
      int longest = 0;
      int bits = factorial_bits(K);
      for (const auto& row : d) {
        const int length = magnitude(row).bits();
        longest = std::max(longest, length);
        bits += length;
      }
      if (longest <= exact::kShortBits) return exact::short_determinant_sign<K>(converted<std::int64_t, K>(d));
      return fits_into_long(bits) ? exact::sign(determinant<K>(converted<Long, K>(d)))
                                  : exact::sign(determinant<K>(converted<BigInt, K>(d)));
    }
  }

  template <class Row>
  static Magnitude magnitude(const Row& row) {
    Magnitude all;
    for (const Int128 x : row) all.add(x);
    return all;
  }

  /// The first `Rows` rows in other integers.
  template <class Int, int Rows, class Table>
  static auto converted(const Table& from) {
    std::array<std::array<Int, std::tuple_size_v<typename Table::value_type>>, static_cast<std::size_t>(Rows)> to;
    for (std::size_t i = 0; i < to.size(); ++i) {
      for (std::size_t j = 0; j < to[i].size(); ++j) to[i][j] = static_cast<Int>(from[i][j]);
    }
    return to;
  }

  template <class Difference>
  static int orient_by(const Local<kRows>& local) {
    Matrix<K, Difference> d;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto origin = local.template at<Difference>(0, axis);
      for (std::size_t i = 0; i < kAxes; ++i) d[axis][i] = local.template at<Difference>(i + 1, axis) - origin;
    }
    return sign_of<Difference>(d);
  }

  /// The other points of a cell and q, seen from the cell's first corner, with weights relative to it.
  template <class Difference>
  struct Lifted {
    std::array<std::array<Difference, kRows>, kMaxDimension> d;  // axis by axis
    std::array<Difference, kRows> w;
    std::size_t axes;
    int weight_shift;  // squares, times two to it, are in the unit of the weights

    /// |p - origin|^2 - w(p) + w(origin): an affine function away from |p|^2 - w(p), over all axes of the input.
    template <class Int>
    Int height(std::size_t point) const {
      Int sum(0);
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const Int x(d[axis][point]);
        sum = sum + x * x;
      }
      return sum * Int(Difference(1) << weight_shift) - Int(w[point]);
    }

    template <class Int>
    int sign_by() const {
      Matrix<K + 1, Int> m;
      for (std::size_t i = 0; i < kRows; ++i) {
        for (std::size_t axis = 0; axis < kAxes; ++axis) m[axis][i] = Int(d[axis][i]);
        m[kAxes][i] = height<Int>(i);
      }
      return exact::sign(determinant<K + 1>(m));
    }

    int short_sign() const {
      std::array<Int128, kRows> heights;
      for (std::size_t i = 0; i < kRows; ++i) heights[i] = height<Int128>(i);
      return exact::short_determinant_sign<K>(converted<std::int64_t, K>(d), heights);
    }
  };

  /// The sign of the determinant of the lifted points, q the last: +1 when q lies above a cell of orientation +1.
  template <class Difference>
  int lifted_by(const Local<kRows + 1>& local, const LocalWeights& weights) const {
    Lifted<Difference> lifted;
    lifted.axes = static_cast<std::size_t>(points_.dimension());
    lifted.weight_shift = weights.shift;
    for (std::size_t axis = 0; axis < lifted.axes; ++axis) {
      const auto origin = local.template at<Difference>(0, axis);
      for (std::size_t i = 0; i < kRows; ++i) {
        lifted.d[axis][i] = local.template at<Difference>(i + 1, axis) - origin;
      }
    }
    lifted.w.fill(Difference(0));
    if (points_.weighted()) {
      const auto origin = exact::to_integer<Difference>(weights.w[0], weights.unit);
      for (std::size_t i = 0; i < kRows; ++i) {
        lifted.w[i] = exact::to_integer<Difference>(weights.w[i + 1], weights.unit) - origin;
      }
    }
    if constexpr (kAnyLength<Difference>) {
      return lifted.template sign_by<BigInt>();
    } else {
      return sign_of_lifted(lifted, weights);
    }
  }

  /// A height is at most D * 2^(2 longest + shift) + 2^(bits of weights + 1).
  static int sign_of_lifted(const Lifted<Int128>& lifted, const LocalWeights& weights) {
    int longest = 0;
    int bits = factorial_bits(K + 1);
    for (std::size_t axis = 0; axis < lifted.axes; ++axis) {
      const int length = magnitude(lifted.d[axis]).bits();
      longest = std::max(longest, length);
      if (axis < kAxes) bits += length;
    }
    const int square = 2 * longest + weights.shift + static_cast<int>(std::bit_width(lifted.axes - 1));
    const int height = std::max(square, weights.bits + 1) + 1;
    if (longest <= exact::kShortBits && height <= kNarrow) return lifted.short_sign();
    return fits_into_long(bits + height) ? lifted.template sign_by<Long>() : lifted.template sign_by<BigInt>();
  }

  /// Everything times K + 1, and the target's ray times K once more, to keep the barycentres integral.
  int about(const Cell& centre, const Facet& facet, std::size_t corner, const Facet& target) const {
    std::array<Index, kRows + 2 * kAxes> rows;
    std::copy(centre.begin(), centre.end(), rows.begin());
    std::copy(facet.begin(), facet.end(), rows.begin() + kRows);
    std::copy(target.begin(), target.end(), rows.begin() + kRows + kAxes);
    const auto local = gather<K>(rows);
    constexpr int kSlack = 8;  // (K + 1) * K * 2 <= 144
    return local.fits_in(kNarrow - kSlack) ? about_by<Int128>(local, corner) : about_by<BigInt>(local, corner);
  }

  template <class Difference>
  static int about_by(const Local<kRows + 2 * kAxes>& local, std::size_t corner) {
    Matrix<K, Difference> d;
    for (std::size_t j = 0; j < kAxes; ++j) {
      Difference centre(0);
      Difference target(0);
      for (std::size_t i = 0; i < kRows; ++i) centre += local.template at<Difference>(i, j);
      for (std::size_t i = 0; i < kAxes; ++i) target += local.template at<Difference>(kRows + kAxes + i, j);
      for (std::size_t i = 0; i < kAxes; ++i) {
        d[j][i] = i == corner ? Difference(target * (K + 1) - centre * K)
                              : Difference(local.template at<Difference>(kRows + i, j) * (K + 1) - centre);
      }
    }
    return sign_of<Difference>(d);
  }

  PointsView points_;
  std::array<int, kMaxDimension> axes_;
  int height_;
};

}  // namespace delone::check_detail
