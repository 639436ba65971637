// Vertices of diagrams as measures need them: in a frame, with an error far below the size of the cells they belong to,
// quickly.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "delone/geometry/kernel.hpp"
#include "delone/geometry/power_centre.hpp"
#include "delone/mesh/triangulation.hpp"
#include "dual/frame.hpp"
#include "mesh/cospherical.hpp"

namespace delone::dual_detail {

/// The power centre of a cell of a triangulation whose points span the space.
struct Centre {
  Point3 at;
  float error;  ///< bounds how far two computations of one centre lie apart
  bool near;    ///< the region, so that lines between two such centres keep their digits in it
  bool within;  ///< a convex region
};

template <int K>
class Centres {
  static constexpr auto kAxes = static_cast<std::size_t>(K);

 public:
  Centres(const AnyTriangulation& t, const Frame& frame)
      : sites_(t.sites()), complex_(t.complex()), frame_(frame), kernel_(t.sites()), cache_(kCached) {
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      extent_ =
          std::max(extent_, frame.scaled(t.sites().range().magnitude) + frame.scaled(std::abs(frame.middle[axis])));
  }

  /// Of a finite cell; valid until the next call. The last ones are remembered: sites that follow each other share most
  /// of their cells.
  const Centre& operator[](CellId c) {
    Entry& entry = cache_[raw(c) % kCached];
    if (entry.cell != c) entry = {c, compute(c)};
    return entry.centre;
  }

  /// Asks memory for where the centre of a cell may be remembered.
  void prefetch(CellId c) const { __builtin_prefetch(&cache_[raw(c) % kCached]); }

  /// Have two neighbouring finite cells the same centre, exactly?
  /// @param a, b  their centres  @param c  one of the cells  @param apex  the vertex of the other that c lacks
  bool coincide(const Centre& a, const Centre& b, CellId c, VertexId apex) const {
    return !differ(a, b) && on_common_orthosphere<K>(kernel_, complex_, c, apex);
  }
  /// Whether they surely are not the same.
  static bool differ(const Centre& a, const Centre& b) {
    const float error = a.error + b.error;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (std::abs(a.at[axis] - b.at[axis]) > error) return true;
    }
    return false;
  }

  /// By Cramer's rule from the differences d_i to the first corner: (c - p_0) = N / (2 det(d)). Every term of det and N
  /// passes at most 14 roundings (3 differences, a square and 3 sums of the lift, 2 products and 2 sums of the
  /// determinant, two of the quotient; 1 for the bound itself). Where that leaves open more than 2^-43 of the reach,
  /// which is the size of the cell and its offset, or 2^-47 of the region, the offset is computed anew, correctly
  /// rounded.
  Centre compute(CellId c) const {
    const std::array<VertexId, kAxes + 1> v = ConstComplexView<K>(complex_).vertices(c);
    const double* const weights = sites_.weights();
    const double* origin = sites_.at(v[0]);
    std::array<std::array<double, kAxes>, kAxes> d;
    std::array<double, kAxes> lift, size;
    double reach = 0;
    for (std::size_t i = 0; i < kAxes; ++i) {
      const double* p = sites_.at(v[i + 1]);
      const double w = weights == nullptr ? 0 : weights[raw(v[0])] - weights[raw(v[i + 1])];
      lift[i] = w;
      size[i] = std::abs(w);
      for (std::size_t j = 0; j < kAxes; ++j) {
        d[i][j] = p[j] - origin[j];
        lift[i] += d[i][j] * d[i][j];
        size[i] += d[i][j] * d[i][j];
        reach = std::max(reach, std::abs(d[i][j]));
      }
    }
    Solution solution = solve(d, lift, size);
    for (const double x : solution.offset) reach = std::max(reach, std::abs(x));
    // Nothing may overflow, and what underflows must be far below.
    const double tolerance = std::min(0x1p-43 * reach, 0x1p-47 * frame_.radius * frame_.unit);
    const bool good =
        reach < 0x1p300 && reach > 0x1p-200 && solution.doubled > 0x1p-900 && solution.doubled > solution.doubt &&
        kRoundings * solution.terms + reach * solution.doubt < tolerance * (solution.doubled - solution.doubt);
    const bool far = frame_.scaled(reach) > 64 * frame_.radius;  // then the offset has fewer digits than the place
    Vector exact{};
    if (!good) exact = far ? power_centre(sites_, v) : power_centre_offset(sites_, v);
    Centre centre{{}, 0, true, true};
    for (std::size_t j = 0; j < kAxes; ++j) {
      const double offset = good ? solution.offset[j] : exact[j];
      reach = std::max(reach, std::abs(offset));
      centre.at[j] =
          frame_.scaled(!good && far ? exact[j] - frame_.middle[j] : (origin[j] - frame_.middle[j]) + offset);
      centre.near &= std::abs(centre.at[j]) <= 64 * frame_.radius;
    }
    const double error = 0x1p-41 * frame_.scaled(reach) + 0x1p-50 * extent_;
    centre.error = std::max(static_cast<float>(error), std::numeric_limits<float>::min());
    for (const Plane& side : frame_.sides) centre.within &= dot(side.normal, centre.at) <= side.offset;
    return centre;
  }

 private:
  static constexpr std::size_t kCached = 1 << 13;
  struct Entry {
    CellId cell = kNoCell;
    Centre centre;
  };

  using Column = std::array<double, kAxes>;
  using Rows = std::array<Column, kAxes>;
  static constexpr double kRoundings = 14 * 0x1p-53;

  /// An offset is off by less than (kRoundings * terms + |offset| * doubt) / (doubled - doubt).
  struct Solution {
    Column offset;
    double terms;           ///< the largest sum of sizes of the terms of a numerator
    double doubled, doubt;  ///< the size of the denominator, and its error
  };

  static Solution solve(const Rows& d, const Column& lift, const Column& size) {
    if constexpr (K == 2) {
      const double a = d[0][0] * d[1][1], b = d[0][1] * d[1][0];
      const double doubled = 2 * (a - b);
      const double inverse = 1 / doubled;
      const double largest = std::max(std::abs(d[1][1]), std::abs(d[1][0])) * size[0] +
                             std::max(std::abs(d[0][1]), std::abs(d[0][0])) * size[1];
      return {{(lift[0] * d[1][1] - lift[1] * d[0][1]) * inverse, (lift[1] * d[0][0] - lift[0] * d[1][0]) * inverse},
              largest,
              std::abs(doubled),
              2 * kRoundings * (std::abs(a) + std::abs(b))};
    } else {
      // A minor of two rows, and the sum of the sizes of its terms, are at most the product of their lengths.
      Solution solution{{}, 0, 0, 0};
      double doubled = 0;
      std::array<double, 3> length;
      for (std::size_t i = 0; i < 3; ++i)
        length[i] = std::sqrt(d[i][0] * d[i][0] + d[i][1] * d[i][1] + d[i][2] * d[i][2]);
      for (std::size_t i = 0; i < 3; ++i) {
        const Column& a = d[(i + 1) % 3];
        const Column& b = d[(i + 2) % 3];
        for (std::size_t j = 0; j < 3; ++j) {
          const double minor = a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3];
          solution.offset[j] += lift[i] * minor;
          if (i == 0) doubled += 2 * d[0][j] * minor;
        }
        solution.terms += size[i] * length[(i + 1) % 3] * length[(i + 2) % 3];
      }
      const double inverse = 1 / doubled;
      for (double& x : solution.offset) x *= inverse;
      solution.doubled = std::abs(doubled);
      solution.doubt = 2 * kRoundings * length[0] * length[1] * length[2];
      return solution;
    }
  }

  const Sites& sites_;
  const Complex& complex_;
  const Frame& frame_;
  Kernel<K> kernel_;
  std::vector<Entry> cache_;
  double extent_ = 0;
};

}  // namespace delone::dual_detail
