// Few sites of space, sixteen looked at side by side: which of them makes the next cell, and which may lie below a
// hyperplane. In floats: what these do not tell is left to exact tests.
//
// Error: coordinates are multiplied by a power of two that makes them less than 1; lifts are then at most L. A plane
// N . x + h l + c through lifted sites has terms whose sizes sum up to at most 2 s, s = |N_x| + |N_y| + |N_z| + L |h|.
// In floats each passes at most 6 roundings, of its factor, of the site and of sums: 12 * 2^-24 s, which is less than
// 1e-6 s. N and h come from doubles, where they are sums of products of at most three differences, each at most 2, or
// 2 L for lifts; what that is off by moves no sum of terms by more than 9000 * 2^-53 (L + 6).
#pragma once

#include "geometry/sixteen.hpp"

#ifdef DELONE_SIXTEENS

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "delone/geometry/filter.hpp"
#include "delone/geometry/sites.hpp"

namespace delone::sixteen {

class InSpace {
  using Four = Doubles;  // x, y, z and lift of a site, or of a normal
  using Sixteen = Floats;

 public:
  /// A hyperplane in lifted space: how far sites lie above it or, where it is vertical, inside.
  struct Plane {
    __m128 factors;  ///< of x, y, z and lift
    float offset;
    float bound;  ///< of errors
  };
  /// A facet as seen from outside.
  struct Facet {
    Four origin, first, second;  ///< a corner, and how it sees the others
    Four outwards;
    Plane wall;  ///< vertical, through the facet
  };
  /// A set of sites, a bit each.
  using Set = std::array<std::uint16_t, kMostSites / 16>;
  static bool has(const Set& set, Index i) { return (set[i / 16] >> (i % 16) & 1) != 0; }

  /// At most kMostSites sites that lie in space.
  DELONE_BY_SIXTEENS explicit InSpace(const Sites& sites) : groups_((sites.size() + 15) / 16) {
    const double scale = std::ldexp(1.0, std::min(-std::ilogb(sites.range().magnitude) - 1, 1023));
    for (std::size_t i = 0; i < sites.size(); ++i) {
      std::array<double, 4>& row = rows_[i];
      for (std::size_t j = 0; j < 3; ++j) row[j] = scale * sites.leading()[3 * i + j];
      row[3] = row[0] * row[0] + row[1] * row[1] + row[2] * row[2];
      if (sites.weighted()) row[3] -= scale * (scale * sites.weights()[i]);
      largest_lift_ = std::max(largest_lift_, std::abs(row[3]));
      for (std::size_t j = 0; j < 4; ++j) lanes_[j][i] = static_cast<float>(row[j]);
    }
    for (std::size_t i = sites.size(); i < 16 * groups_; ++i) set_aside(static_cast<Index>(i));
    least_bound_ = 9000 * filter::kU * (largest_lift_ + 6.0);
  }

  /// The site takes part in nothing any more.
  void set_aside(Index i) {
    for (auto& lane : lanes_) lane[i] = std::numeric_limits<float>::quiet_NaN();
  }
  /// x, y, z and lift of a site, scaled.
  const std::array<double, 4>& row(Index i) const { return rows_[i]; }

  /// The first site of which floats do not tell that it does not stand where site i does.
  DELONE_INLINE_BY_SIXTEENS Index first_alike(Index i) const {
    const Sixteen x = _mm512_set1_ps(lanes_[0][i]), y = _mm512_set1_ps(lanes_[1][i]), z = _mm512_set1_ps(lanes_[2][i]);
    for (std::size_t g = 0;; ++g) {
      const auto alike = static_cast<unsigned>(_mm512_cmp_ps_mask(lanes(0, g), x, _CMP_EQ_OQ) &
                                               _mm512_cmp_ps_mask(lanes(1, g), y, _CMP_EQ_OQ) &
                                               _mm512_cmp_ps_mask(lanes(2, g), z, _CMP_EQ_OQ));
      if (alike != 0) return static_cast<Index>(16 * g) + static_cast<Index>(std::countr_zero(alike));
    }
  }

  /// @param corners  counter-clockwise when seen from outside
  DELONE_INLINE_BY_SIXTEENS Facet facet(const std::array<Index, 4>& corners) const {
    Facet f;
    f.origin = place(corners[0]);
    f.first = _mm256_sub_pd(place(corners[1]), f.origin);
    f.second = _mm256_sub_pd(place(corners[2]), f.origin);
    f.outwards = cross(f.first, f.second);
    const __m128d s = sums(_mm256_mul_pd(f.outwards, f.origin), magnitude(f.outwards));
    f.wall = rounded(_mm256_sub_pd(_mm256_setzero_pd(), f.outwards), first(s), second(s));
    return f;
  }
  /// Of the cell that a facet makes with a site outside.
  DELONE_INLINE_BY_SIXTEENS Plane plane(const Facet& f, Index apex) const {
    const Four to = _mm256_sub_pd(place(apex), f.origin);
    const Four turned = _mm256_sub_pd(_mm256_mul_pd(f.first, lift(f.second)), _mm256_mul_pd(lift(f.first), f.second));
    const Four normal = _mm256_sub_pd(cross(turned, to), _mm256_mul_pd(lift(to), f.outwards));
    const __m128d s = sums(_mm256_mul_pd(normal, f.origin), magnitude(normal));
    const double height = first(sums(_mm256_mul_pd(f.outwards, to), to));
    const double offset = -first(s) - height * first(_mm256_castpd256_pd128(lift(f.origin)));
    return rounded(_mm256_blend_pd(normal, _mm256_set1_pd(height), 8), offset,
                   second(s) + largest_lift_ * std::abs(height));
  }
  /// Whether plane(f, apex) is of a positively oriented cell, for sure. Never where weights are so large that something
  /// might overflow: a height is less than 48.
  bool is_positive(const Plane& plane) const {
    return _mm_cvtss_f32(_mm_shuffle_ps(plane.factors, plane.factors, 0xFF)) > least_bound_;
  }

  /// The site outside a facet that makes with it the cell that no other one is in conflict with, or one that would but
  /// for rounding; kNobody when none is outside, or none for sure.
  /// @param inside  of the cell inside
  DELONE_INLINE_BY_SIXTEENS Index apex(const Facet& f, const Plane& inside) const {
    // The hyperplanes through the facet are ordered by their slope across it. That of a site is how far it lies above
    // the cell inside, by how far it lies outside the facet; the least is sought.
    const Heights above(inside);
    const Heights within(f.wall);
    const Sixteen tiny = _mm512_set1_ps(kTiny);
    const Sixteen bound = _mm512_set1_ps(-f.wall.bound);
    Sixteen best = tiny;
    for (std::size_t g = 0; g < groups_; ++g) {
      const Sixteen outside = _mm512_sub_ps(bound, within.flat(*this, g));
      const Sixteen steep = _mm512_mul_ps(outside, _mm512_rcp14_ps(_mm512_max_ps(above(*this, g), tiny)));
      best = _mm512_max_ps(named(steep, g), best);
    }
    return name_of(_mm512_reduce_max_ps(best), 2 * kTiny);
  }
  /// The site that lies lowest below a hyperplane, but for rounding; kNobody when none clearly does.
  DELONE_INLINE_BY_SIXTEENS Index lowest(const Plane& plane) const {
    const Heights above(plane);
    Sixteen best = _mm512_setzero_ps();
    for (std::size_t g = 0; g < groups_; ++g) {
      best = _mm512_max_ps(named(_mm512_sub_ps(_mm512_setzero_ps(), above(*this, g)), g), best);
    }
    return name_of(_mm512_reduce_max_ps(best), plane.bound);
  }
  /// The sites that may not lie above a hyperplane, or not inside. Those that it passes through are always among them.
  DELONE_INLINE_BY_SIXTEENS Set doubts(const Plane& plane) const {
    const Heights above(plane);
    const Sixteen bound = _mm512_set1_ps(plane.bound);
    Set set{};
    for (std::size_t g = 0; g < groups_; ++g) set[g] = _mm512_cmp_ps_mask(above(*this, g), bound, _CMP_LE_OQ);
    return set;
  }
  /// How many these are.
  DELONE_INLINE_BY_SIXTEENS int count_doubts(const Plane& plane) const {
    const Heights above(plane);
    const Sixteen bound = _mm512_set1_ps(plane.bound);
    int count = 0;
    for (std::size_t g = 0; g < groups_; ++g) {
      count += _mm_popcnt_u32(_mm512_cmp_ps_mask(above(*this, g), bound, _CMP_LE_OQ));
    }
    return count;
  }

 private:
  static constexpr float kTiny = 1e-30F;

  DELONE_INLINE_BY_SIXTEENS Sixteen lanes(std::size_t number, std::size_t group) const {
    return _mm512_load_ps(&lanes_[number][16 * group]);
  }
  /// A plane, ready for sixteen sites.
  struct Heights {
    Sixteen x, y, z, lift, offset;

    DELONE_INLINE_BY_SIXTEENS explicit Heights(const Plane& p)
        : x(_mm512_broadcastss_ps(p.factors)),
          y(_mm512_broadcastss_ps(_mm_permute_ps(p.factors, 0x55))),
          z(_mm512_broadcastss_ps(_mm_permute_ps(p.factors, 0xAA))),
          lift(_mm512_broadcastss_ps(_mm_permute_ps(p.factors, 0xFF))),
          offset(_mm512_set1_ps(p.offset)) {}
    DELONE_INLINE_BY_SIXTEENS Sixteen operator()(const InSpace& sites, std::size_t group) const {
      return _mm512_fmadd_ps(lift, sites.lanes(3, group), flat(sites, group));
    }
    /// The same of a vertical one.
    DELONE_INLINE_BY_SIXTEENS Sixteen flat(const InSpace& sites, std::size_t group) const {
      const Sixteen sum = _mm512_fmadd_ps(x, sites.lanes(0, group), offset);
      return _mm512_fmadd_ps(z, sites.lanes(2, group), _mm512_fmadd_ps(y, sites.lanes(1, group), sum));
    }
  };

  /// The same if that is above a bound.
  static Index name_of(float number, float bound) { return number > bound ? sixteen::name_of(number) : kNobody; }

  DELONE_INLINE_BY_SIXTEENS Four place(Index i) const { return _mm256_load_pd(rows_[i].data()); }
  DELONE_INLINE_BY_SIXTEENS static Four lift(Four a) { return _mm256_permute4x64_pd(a, 0xFF); }
  DELONE_INLINE_BY_SIXTEENS static Four magnitude(Four a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
  DELONE_INLINE_BY_SIXTEENS static double second(__m128d a) { return _mm_cvtsd_f64(_mm_unpackhi_pd(a, a)); }
  DELONE_INLINE_BY_SIXTEENS Plane rounded(Four factors, double offset, double size) const {
    return {_mm256_cvtpd_ps(factors), static_cast<float>(offset), static_cast<float>(1e-6 * size + least_bound_)};
  }

  std::size_t groups_;
  double largest_lift_ = 0.0;
  double least_bound_ = 0.0;
  alignas(64) std::array<std::array<double, 4>, kMostSites> rows_;
  alignas(64) std::array<std::array<float, kMostSites>, 4> lanes_;
};

}  // namespace delone::sixteen

#endif
