// Where diagrams are clipped: a box, a convex polytope, or a polygon with holes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "delone/base/errors.hpp"

namespace delone {

/// The points x with normal . x <= offset. In the plane the third component is not looked at.
struct HalfSpace {
  std::array<double, 3> normal{};
  double offset = 0;
};

/// The corners of a simple polygon in either direction, the first one not repeated.
using Ring = std::vector<std::array<double, 2>>;

/// A bounded region of the plane or of space with an interior.
class Region {
 public:
  /// Corners with low < high on each of 2 or 3 axes.
  /// @throws InputError  naming the axis
  static Region box(std::span<const double> low, std::span<const double> high);
  /// What all half-spaces have in common, in dimension 2 or 3.
  /// @throws InputError  naming the half-space that is none, or when nothing is left, or it has no end
  static Region half_spaces(int dimension, std::vector<HalfSpace> half_spaces);
  /// What an odd number of rings goes around. Rings do not cross and are not crossed; two may share a corner.
  /// @throws InputError  naming the ring and the corner (both counted from 0) where it crosses itself or another one,
  /// has
  ///                     fewer than 3 corners, or no area
  static Region polygon(std::vector<Ring> rings);

  int dimension() const { return dimension_; }
  bool convex() const { return convex_; }
  /// Area or volume.
  double measure() const { return measure_; }
  /// Of its bounding box; the last axis of a region of the plane is 0.
  const std::array<double, 3>& low() const { return low_; }
  const std::array<double, 3>& high() const { return high_; }
  /// In the plane: outer rings counter-clockwise, holes clockwise, so that the region lies to the left of every edge.
  std::vector<Ring> rings() const;
  /// Of a convex region, those that bound it, with normals of length 1.
  std::vector<HalfSpace> sides() const;
  /// In space: the corners of its face on each side, counter-clockwise from outside.
  std::vector<std::vector<std::array<double, 3>>> faces() const;

  /// The same seen from an origin, which is near where coordinates there have more digits.
  struct Seen {
    std::array<double, 3> origin{};
    std::vector<Ring> rings;
    std::vector<HalfSpace> sides;
    std::vector<std::vector<std::array<double, 3>>> faces;
  };
  const Seen& seen() const { return seen_; }

 private:
  Region() = default;
  void settle();
  void enlarge(int power);

  int dimension_ = 2;
  bool convex_ = false;
  double measure_ = 0;
  std::array<double, 3> low_{}, high_{};
  Seen seen_;
};

}  // namespace delone
