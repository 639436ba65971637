// Few sites of the plane, sixteen looked at side by side: which of them makes the next triangle. In floats, so it is an
// answer to be checked, for which there are planes through the lifted corners of a triangle, in doubles.
//
// Error of a height: coordinates are seen from the middle of the sites, and multiplied by a power of two that makes
// them less than 1/2; so lifts are. Written out, a height is a sum of 48 products of two coordinates and a lift, each
// less than 1/8. Each passes at most 15 roundings: of these factors, of two differences, of two products, and of sums.
// So it is off by at most 6 * 15 * 2^-53, less than 2^-46; what underflows is less than 2^-1000.
#pragma once

#include "geometry/sixteen.hpp"

#ifdef DELONE_SIXTEENS

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "delone/base/assert.hpp"
#include "delone/geometry/sites.hpp"

namespace delone::sixteen {

class InPlane {
  using Sixteen = Floats;

 public:
  /// In lifted space, through the corners of a triangle, or vertical, through an edge.
  struct Plane {
    Doubles factors;  ///< of x, y, lift and 1
  };
  /// A height or an orientation that is above this is positive.
  static constexpr double kBound = 0x1p-45;

  /// At most kMostSites sites of the plane. Nothing may be asked about them unless they are usable().
  explicit InPlane(const Sites& sites) : count_(static_cast<Index>(sites.size())), groups_((sites.size() + 15) / 16) {
    const double* const x = sites.leading();
    std::array<double, 2> low{x[0], x[1]}, high = low;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        low[j] = std::min(low[j], x[2 * i + j]);
        high[j] = std::max(high[j], x[2 * i + j]);
      }
    }
    const std::array<double, 2> middle{low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2};
    double radius = 0.0;  // seen from a rounded middle, two numbers side by side are both on one side
    for (std::size_t j = 0; j < 2; ++j) radius = std::max({radius, high[j] - middle[j], middle[j] - low[j]});
    usable_ = radius > 0x1p-1000;
    const double scale = usable_ ? std::ldexp(1.0, -std::ilogb(radius) - 2) : 0.0;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      Row& row = rows_[i];
      for (std::size_t j = 0; j < 2; ++j) row[j] = scale * (x[2 * i + j] - middle[j]);
      DELONE_ASSERT(std::abs(row[0]) < 0.5 && std::abs(row[1]) < 0.5, "the bound rests on that");
      row[2] = row[0] * row[0] + row[1] * row[1];
      row[3] = 1.0;
      for (std::size_t j = 0; j < 3; ++j) lanes_[j][i] = static_cast<float>(row[j]);
    }
    rows_[sites.size()] = {0.0, 0.0, kFar, 1.0};
    for (auto& lane : lanes_) {
      std::fill(lane.begin() + static_cast<std::ptrdiff_t>(sites.size()), lane.end(),
                std::numeric_limits<float>::quiet_NaN());
    }
  }

  bool usable() const { return usable_; }

  /// The site next to a site.
  DELONE_BY_SIXTEENS Index nearest(Index i) const {
    const Sixteen x = _mm512_set1_ps(lanes_[0][i]), y = _mm512_set1_ps(lanes_[1][i]);
    Sixteen best = _mm512_set1_ps(kFar);
    for (std::size_t g = 0; g < groups_; ++g) {
      const Sixteen dx = _mm512_sub_ps(lanes(0, g), x), dy = _mm512_sub_ps(lanes(1, g), y);
      const Sixteen squared = _mm512_fmadd_ps(dx, dx, _mm512_mul_ps(dy, dy));
      best = least_where(_mm512_cmp_ps_mask(squared, _mm512_setzero_ps(), _CMP_GT_OQ), squared, g, best);
    }
    return name_of(_mm512_reduce_min_ps(best));
  }
  /// The site left of the edge from a to b that sees it under the largest angle; kNobody where none is.
  DELONE_INLINE_BY_SIXTEENS Index apex(Index a, Index b) const {
    // The cotangent of the angle is (a - p) . (b - p) by how far p lies to the left, times the length of the edge.
    const float xa = lanes_[0][a], ya = lanes_[1][a], xb = lanes_[0][b], yb = lanes_[1][b];
    const float left_x = ya - yb, left_y = xb - xa;
    const Sixteen left[] = {_mm512_set1_ps(left_x), _mm512_set1_ps(left_y),
                            _mm512_set1_ps(-(left_x * xa + left_y * ya))};
    const Sixteen dot[] = {_mm512_set1_ps(-(xa + xb)), _mm512_set1_ps(-(ya + yb)), _mm512_set1_ps(xa * xb + ya * yb)};
    const Sixteen tiny = _mm512_set1_ps(1e-6F * (std::abs(left_x) + std::abs(left_y)));  // more than rounding makes
    Sixteen best = _mm512_set1_ps(kFar);
    for (std::size_t g = 0; g < groups_; ++g) {
      const Sixteen x = lanes(0, g), y = lanes(1, g);
      const Sixteen to_left = _mm512_fmadd_ps(left[0], x, _mm512_fmadd_ps(left[1], y, left[2]));
      const Sixteen product =
          _mm512_fmadd_ps(dot[0], x, _mm512_fmadd_ps(dot[1], y, _mm512_add_ps(lanes(2, g), dot[2])));
      const Sixteen cotangent = _mm512_mul_ps(product, _mm512_rcp14_ps(to_left));
      best = least_where(_mm512_cmp_ps_mask(to_left, tiny, _CMP_GT_OQ), cotangent, g, best);
    }
    return name_of(_mm512_reduce_min_ps(best));
  }

  /// Of the triangle a b c.
  DELONE_INLINE_BY_SIXTEENS Plane plane(Index a, Index b, Index c) const {
    return through(place(a), _mm256_sub_pd(place(b), place(a)), _mm256_sub_pd(place(c), place(a)));
  }
  /// Through the edge from a to b; sites on its right lie above.
  DELONE_INLINE_BY_SIXTEENS Plane wall(Index a, Index b) const {
    return through(place(a), _mm256_sub_pd(place(b), place(a)), _mm256_setr_pd(0.0, 0.0, 1.0, 0.0));
  }
  /// Of its triangle: the factor of lift.
  DELONE_INLINE_BY_SIXTEENS static double orientation(const Plane& plane) {
    return first(_mm256_extractf128_pd(plane.factors, 1));
  }
  /// How high a site lies above, times a positive number. The ghost comes after the last site: it is seen in no
  /// direction and lies above every triangle.
  DELONE_INLINE_BY_SIXTEENS double height(const Plane& plane, Index i) const {
    const Doubles terms = _mm256_mul_pd(plane.factors, place(i));
    return first(sums(terms, terms));
  }
  /// Whether another site may lie on the circle through a triangle, as far as floats tell: then searches are in doubt.
  DELONE_BY_SIXTEENS bool has_tie(const Plane& plane) const {
    const double near = 1e-6 * orientation(plane);
    int on_circle = 0;
    for (Index i = 0; i < count_; ++i) on_circle += height(plane, i) < near ? 1 : 0;
    return on_circle > 3;  // its corners
  }

 private:
  using Row = std::array<double, 4>;  // x, y, lift, 1

  static constexpr float kFar = 1e30F;

  DELONE_INLINE_BY_SIXTEENS Doubles place(Index i) const { return _mm256_load_pd(rows_[i].data()); }
  /// A plane through p in which q and r lie.
  DELONE_INLINE_BY_SIXTEENS static Plane through(Doubles p, Doubles q, Doubles r) {
    const Doubles normal = cross(q, r);
    const Doubles terms = _mm256_mul_pd(normal, p);
    return {_mm256_blend_pd(normal, _mm256_set1_pd(-first(sums(terms, terms))), 8)};
  }
  DELONE_INLINE_BY_SIXTEENS Sixteen lanes(std::size_t number, std::size_t group) const {
    return _mm512_load_ps(&lanes_[number][16 * group]);
  }
  DELONE_INLINE_BY_SIXTEENS static Sixteen least_where(__mmask16 where, Sixteen numbers, std::size_t group,
                                                       Sixteen best) {
    return _mm512_mask_min_ps(best, where, named(numbers, group), best);
  }
  static Index name_of(float number) { return number < kFar / 2 ? sixteen::name_of(number) : kNobody; }

  Index count_;
  std::size_t groups_;
  bool usable_;
  alignas(64) std::array<Row, kMostSites + 1> rows_;
  alignas(64) std::array<std::array<float, kMostSites>, 3> lanes_;
};

}  // namespace delone::sixteen

#endif
