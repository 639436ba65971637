// Vertices of diagrams as measures need them: in a frame, with an error far below the size of the cells they belong to,
// quickly.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
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
  float reach;  ///< of the cell's corners and the centre from its first corner: the error of the centre is less than
                ///< 2^-42 of it, and than 2^-46 of the region's size while the reach is no larger
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
    if (entry.cell != c) entry = {c, computed(c)};
    return entry.centre;
  }

  /// Have two neighbouring finite cells the same centre, exactly?
  /// @param a, b  their centres  @param c  one of the cells  @param apex  the vertex of the other that c lacks
  bool coincide(const Centre& a, const Centre& b, CellId c, VertexId apex) const {
    const double error = 0x1p-41 * (double{a.reach} + double{b.reach}) + 0x1p-50 * extent_;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (std::abs(a.at[axis] - b.at[axis]) > error) return false;
    }
    return on_common_orthosphere<K>(kernel_, complex_, c, apex);
  }

 private:
  static constexpr std::size_t kCached = 1 << 14;
  struct Entry {
    CellId cell = kNoCell;
    Centre centre;
  };

  /// By Cramer's rule from the differences d_i to the first corner: (c - p_0) = N / (2 det(d)). Every term of det and N
  /// passes at most 14 roundings (3 differences, a square and 3 sums of the lift, 2 products and 2 sums of the
  /// determinant, the quotient; 2 for the bound itself); where that
  /// leaves too much open, the offset is computed anew, correctly rounded.
  Centre computed(CellId c) const {
    std::array<VertexId, kAxes + 1> v;
    for (std::size_t i = 0; i <= kAxes; ++i) v[i] = complex_.vertex(c, static_cast<int>(i));
    const double* origin = sites_.leading() + raw(v[0]) * kAxes;
    std::array<std::array<double, kAxes>, kAxes> d;
    std::array<double, kAxes> lift, size;
    double reach = 0;
    for (std::size_t i = 0; i < kAxes; ++i) {
      const double* p = sites_.leading() + raw(v[i + 1]) * kAxes;
      const double w = sites_.weight(v[0]) - sites_.weight(v[i + 1]);
      lift[i] = w;
      size[i] = std::abs(w);
      for (std::size_t j = 0; j < kAxes; ++j) {
        d[i][j] = p[j] - origin[j];
        lift[i] += d[i][j] * d[i][j];
        size[i] += d[i][j] * d[i][j];
        reach = std::max(reach, std::abs(d[i][j]));
      }
    }
    std::array<double, kAxes> offset, error;
    solve(d, lift, size, offset, error);
    for (std::size_t j = 0; j < kAxes; ++j) reach = std::max(reach, std::abs(offset[j]));
    const double tolerance = std::min(0x1p-43 * reach, 0x1p-47 * frame_.radius / frame_.scale);
    bool good = reach < 0x1p300 && reach > 0x1p-200;  // no product overflows, and what underflows is far below
    for (std::size_t j = 0; j < kAxes; ++j) good = good && error[j] < tolerance;
    if (!good) {
      const Vector exact = power_centre_offset(sites_, v);
      for (std::size_t j = 0; j < kAxes; ++j) {
        offset[j] = exact[j];
        reach = std::max(reach, std::abs(offset[j]));
      }
    }
    Centre centre{{}, static_cast<float>(frame_.scaled(reach)), true, true};
    for (std::size_t j = 0; j < kAxes; ++j) {
      centre.at[j] = frame_.scaled((origin[j] - frame_.middle[j]) + offset[j]);
      centre.near &= std::abs(centre.at[j]) <= 64 * frame_.radius;
    }
    for (const Plane& side : frame_.sides) centre.within &= dot(side.normal, centre.at) <= side.offset;
    return centre;
  }

  using Rows = std::array<std::array<double, kAxes>, kAxes>;
  using Column = std::array<double, kAxes>;
  static constexpr double kRoundings = 14 * 0x1p-53;

  static void solve(const Rows& d, const Column& lift, const Column& size, Column& offset, Column& error) {
    if constexpr (K == 2) {
      const double a = d[0][0] * d[1][1], b = d[0][1] * d[1][0];
      const double doubled = 2 * (a - b);
      const double doubt = 2 * kRoundings * (std::abs(a) + std::abs(b));
      const double least = std::abs(doubled) - doubt;
      offset = {(lift[0] * d[1][1] - lift[1] * d[0][1]) / doubled, (lift[1] * d[0][0] - lift[0] * d[1][0]) / doubled};
      const auto bound = [&](std::size_t j, double x) {
        const double terms = size[0] * std::abs(d[1][j]) + size[1] * std::abs(d[0][j]);
        return least > 0 ? (kRoundings * terms + std::abs(x) * doubt) / least : std::numeric_limits<double>::infinity();
      };
      error = {bound(1, offset[0]), bound(0, offset[1])};
    } else {
      // The rows of the cofactors: minors of two rows of d.
      Rows minor, sum;
      for (std::size_t i = 0; i < 3; ++i) {
        const Column& a = d[(i + 1) % 3];
        const Column& b = d[(i + 2) % 3];
        for (std::size_t j = 0; j < 3; ++j) {
          const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
          const double left = a[k] * b[l], right = a[l] * b[k];
          minor[i][j] = left - right;
          sum[i][j] = std::abs(left) + std::abs(right);
        }
      }
      double doubled = 0, doubt = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        doubled += 2 * d[0][j] * minor[0][j];
        doubt += 2 * kRoundings * std::abs(d[0][j]) * sum[0][j];
      }
      const double least = std::abs(doubled) - doubt;
      for (std::size_t j = 0; j < 3; ++j) {
        double top = 0, terms = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          top += lift[i] * minor[i][j];
          terms += size[i] * sum[i][j];
        }
        offset[j] = top / doubled;
        error[j] = least > 0 ? (kRoundings * terms + std::abs(offset[j]) * doubt) / least
                             : std::numeric_limits<double>::infinity();
      }
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
