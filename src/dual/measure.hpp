// What shapes measure.
#pragma once

#include <array>
#include <vector>

#include "delone/dual/clip.hpp"
#include "dual/polytope.hpp"

namespace delone::dual_detail {

/// Integrals over a cell, seen from one of its corners, so that none drowns in the distance of the cell from the
/// origin: sums over simplices or cones, signed, that have their apex there.
template <int D>
struct Moments {
  using Place = std::array<double, static_cast<std::size_t>(D)>;

  double volume = 0;
  Place first{};      ///< of x
  double second = 0;  ///< of |x|^2

  /// @param size  the volume times D!  @param sum  of the other corners  @param squares  of their lengths, summed
  void add_simplex(double size, const Place& sum, double squares) {
    const double part = size / (D == 2 ? 2 : 6);
    volume += part;
    first = first + part / (D + 1) * sum;
    second += part / ((D + 1) * (D + 2)) * (squares + dot(sum, sum));
  }
  /// @param area  the normal of the base, as long as it is large  @param centroid  of the base
  /// @param square  the mean of |x|^2 over it
  void add_cone(const Place& area, const Place& centroid, double square) {
    const double part = dot(area, centroid) / D;
    volume += part;
    first = first + part * D / (D + 1) * centroid;
    second += part * D / (D + 2) * square;
  }

  /// The corner is given as it is seen from elsewhere, and the centroid so; of nothing it is `otherwise`.
  Place centroid(const Place& corner, const Place& otherwise) const {
    if (!(volume > 0)) return otherwise;
    Place x;
    for (std::size_t axis = 0; axis < D; ++axis) x[axis] = corner[axis] + first[axis] / volume;
    return x;
  }
  /// The integral of |x - place|^2.
  double second_about(const Place& corner, const Place& place) const {
    const Place shift = corner - place;
    return second + 2 * dot(shift, first) + dot(shift, shift) * volume;
  }
};

/// Appends the measures of all cells of `shapes`.
/// @param sites  one per cell, seen as the corners are
void append_measures(const CellShapes& shapes, const std::vector<Point3>& sites, CellMeasures& measures);

}  // namespace delone::dual_detail
