// The lifted determinants of the four cells across the facets of one, side by side: lane i is of the cell that has
// another vertex, its apex, in place of corner i. What the query sees of the corners is computed once, and so are the
// minors of the pairs (0, 1) and (2, 3): a cell across lacks one corner, so that one of the pairs stays.
//
// Departure, for speed: vector instructions of one family of processors, written out (a fifth less time for an
// insertion than with one cell after the other, bench/DEAD_ENDS.md). The compiler may use them in these functions only;
// whoever calls them has asked the processor.
//
// Error: a term passes 16 roundings, as in kernel.hpp: 3 differences, 5 of the lift, 4 of the two minors, their product
// and 3 sums; one more with weights. Fused products and sums round less often. Where all numbers are integers times a
// power of two, below 2^53 of these, nothing is rounded, fused or not.
#pragma once

#if defined(__x86_64__)
#define DELONE_FOURS 1
#define DELONE_BY_FOURS [[gnu::target("avx2,fma")]]

#include <immintrin.h>

#include "delone/geometry/kernel.hpp"

namespace delone {

/// Whether this processor has the instructions.
inline bool can_test_fours() {
  static const bool can = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  return can;
}

/// A bit for each cell across.
struct FourAnswers {
  unsigned conflict;  ///< where it is sure, whether the query is in conflict with it
  unsigned sure;
  unsigned tie;  ///< the query is known to lie exactly on its lifted hyperplane
};

/// The tests of one query. The sites lie in no flat of more dimensions.
template <bool Weighted>
class FourConflicts {
 public:
  using Cell = Kernel<3>::Cell;

  FourConflicts(const Kernel<3>& kernel, VertexId q) : kernel_(&kernel), query_(q) {}

  /// Expects cells about as large as this one, which is finite.
  DELONE_BY_FOURS [[gnu::always_inline]] inline void expect(const Cell& cell) { set_limit(largest(see(cell).size)); }

  /// Of cells that are finite, and positively oriented.
  /// @param apexes  in slot i the vertex of the cell across facet i that `cell` has not
  DELONE_BY_FOURS [[gnu::always_inline]] inline FourAnswers operator()(const Cell& cell, const Cell& apexes) {
    const Seen corner = see(cell);
    const Seen apex = see(apexes);
    // In lanes 0 to 3 corners 1, 0, 3, 2; and the minors of 2 and 3, 3 and 2, 0 and 1, 1 and 0.
    const Four x = partners(corner.x);
    const Four y = partners(corner.y);
    const Four z = partners(corner.z);
    const Four l = partners(corner.lift);
    const Four xy = others(minor(corner.x, corner.y, x, y));
    const Four xz = others(minor(corner.x, corner.z, x, z));
    const Four xl = others(minor(corner.x, corner.lift, x, l));
    const Four yz = others(minor(corner.y, corner.z, y, z));
    const Four yl = others(minor(corner.y, corner.lift, y, l));
    const Four zl = others(minor(corner.z, corner.lift, z, l));
    Four first = _mm256_mul_pd(minor(apex.x, apex.y, x, y), zl);
    first = _mm256_fnmadd_pd(minor(apex.x, apex.z, x, z), yl, first);
    first = _mm256_fmadd_pd(minor(apex.x, apex.lift, x, l), yz, first);
    Four second = _mm256_mul_pd(minor(apex.y, apex.z, y, z), xl);
    second = _mm256_fnmadd_pd(minor(apex.y, apex.lift, y, l), xz, second);
    second = _mm256_fmadd_pd(minor(apex.z, apex.lift, z, l), xy, second);
    const Four value = _mm256_add_pd(first, second);
    const unsigned conflict = above(value, _mm256_setzero_pd());
    if (above(magnitude(value), _mm256_set1_pd(bound_)) != 15 ||
        above(_mm256_max_pd(corner.size, apex.size), _mm256_set1_pd(limit_)) != 0) [[unlikely]]
      return reconsidered(conflict, value, corner.size, apex.size);
    return {conflict, 15, 0};
  }

 private:
  using Four = __m256d;

  /// What the query sees of four sites; `size` sums the sizes of the lift's parts.
  struct Seen {
    Four x, y, z, lift, size;
  };
  DELONE_BY_FOURS [[gnu::always_inline]] inline Seen see(const Cell& v) const {
    const double* const a = kernel_->at(v[0]);
    const double* const b = kernel_->at(v[1]);
    const double* const c = kernel_->at(v[2]);
    const double* const d = kernel_->at(v[3]);
    const double* const q = kernel_->at(query_);
    const Four ac = _mm256_set_m128d(_mm_loadu_pd(c), _mm_loadu_pd(a));
    const Four bd = _mm256_set_m128d(_mm_loadu_pd(d), _mm_loadu_pd(b));
    Seen seen;
    seen.x = _mm256_sub_pd(_mm256_unpacklo_pd(ac, bd), _mm256_set1_pd(q[0]));
    seen.y = _mm256_sub_pd(_mm256_unpackhi_pd(ac, bd), _mm256_set1_pd(q[1]));
    seen.z = _mm256_sub_pd(_mm256_setr_pd(a[2], b[2], c[2], d[2]), _mm256_set1_pd(q[2]));
    seen.lift = _mm256_mul_pd(seen.x, seen.x);
    seen.lift = _mm256_fmadd_pd(seen.y, seen.y, seen.lift);
    seen.lift = _mm256_fmadd_pd(seen.z, seen.z, seen.lift);
    seen.size = seen.lift;
    if constexpr (Weighted) {
      const double* const w = kernel_->weights();
      const Four more = _mm256_sub_pd(_mm256_setr_pd(w[raw(v[0])], w[raw(v[1])], w[raw(v[2])], w[raw(v[3])]),
                                      _mm256_set1_pd(w[raw(query_)]));
      seen.lift = _mm256_sub_pd(seen.lift, more);
      seen.size = _mm256_add_pd(seen.size, magnitude(more));
    }
    return seen;
  }
  /// Bounds for cells with corners of such sizes, and somewhat larger ones, as nearly all to come will be.
  DELONE_BY_FOURS [[gnu::always_inline]] inline void set_limit(double size) {
    limit_ = 16.0 * size;
    bound_ = kernel_->lifted_bound(limit_);
  }
  /// What is sure by the sizes of each cell alone. Corners larger than the limit raise it.
  DELONE_BY_FOURS [[gnu::noinline]] FourAnswers reconsidered(unsigned conflict, Four values, Four corners,
                                                             Four apexes) {
    const double size = largest(corners);
    if (size > limit_) set_limit(size);
    const Four sizes = _mm256_max_pd(apexes, _mm256_set1_pd(size));
    const Four s = _mm256_add_pd(sizes, _mm256_set1_pd(0x1p-300));
    const Four square = _mm256_mul_pd(s, s);
    const Four power = _mm256_mul_pd(_mm256_mul_pd(square, square), s);
    const Four bounds = _mm256_add_pd(_mm256_mul_pd(_mm256_sqrt_pd(power), _mm256_set1_pd(kernel_->lifted_bound(1.0))),
                                      _mm256_set1_pd(0x1p-447));  // lifted_bound() of each
    const unsigned exact = above(_mm256_set1_pd(kernel_->exact_lifts_below()), power);
    const unsigned nonzero = above(magnitude(values), _mm256_setzero_pd());
    return {conflict, (exact & nonzero) | (~exact & above(magnitude(values), bounds)), exact & ~nonzero};
  }

  DELONE_BY_FOURS [[gnu::always_inline]] static inline Four partners(Four a) { return _mm256_permute_pd(a, 0b0101); }
  DELONE_BY_FOURS [[gnu::always_inline]] static inline Four others(Four a) { return _mm256_permute2f128_pd(a, a, 1); }
  DELONE_BY_FOURS [[gnu::always_inline]] static inline Four minor(Four ax, Four ay, Four bx, Four by) {
    return _mm256_fmsub_pd(ax, by, _mm256_mul_pd(ay, bx));
  }
  DELONE_BY_FOURS [[gnu::always_inline]] static inline Four magnitude(Four a) {
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
  }
  DELONE_BY_FOURS [[gnu::always_inline]] static inline unsigned above(Four a, Four b) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GT_OQ)));
  }
  DELONE_BY_FOURS [[gnu::always_inline]] static inline double largest(Four a) {
    const Four two = _mm256_max_pd(a, partners(a));
    return _mm256_cvtsd_f64(_mm256_max_pd(two, others(two)));
  }

  const Kernel<3>* kernel_;
  VertexId query_;
  double limit_ = -1.0;
  double bound_ = 0.0;  // of the error of a determinant, where no size is above the limit
};

}  // namespace delone

#endif
