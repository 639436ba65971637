// Faces of convex polytopes, each by itself: a polygon that holds the face is cut by planes. No links between faces are
// kept, so nothing can become inconsistent; what two faces have in common they agree on up to rounding.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone::dual_detail {

using Point3 = std::array<double, 3>;
using Polygon3 = std::vector<Point3>;

/// The points x with normal . x <= offset; the normal has any length.
struct Plane {
  Point3 normal;
  double offset;
  Index across;  ///< names what lies beyond
};

/// A ball that the polytope lies in.
struct Bound {
  Point3 centre;
  double radius;
};

/// Cuts one polygon after the other; keeps its memory.
class FaceCutter {
 public:
  /// Begins with all of a plane that lies in the bound; with nothing where they do not meet.
  void begin(const Plane& plane, const Bound& bound);
  void begin(std::span<const Point3> polygon) { polygon_.assign(polygon.begin(), polygon.end()); }
  void cut(const Plane& by);
  /// What is left, in the direction of rotation it began with, counter-clockwise from outside a plane; empty when it is
  /// no wider than what rounding leaves. Valid until the next begin.
  const Polygon3& end(const Bound& bound);

 private:
  Polygon3 polygon_, next_;
  std::vector<double> side_;
};

inline Point3 operator-(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point3 operator+(const Point3& a, const Point3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point3 operator*(double s, const Point3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Twice the area times the normal, from the first corner.
Point3 doubled_area(std::span<const Point3> polygon);

/// Edges and faces of a region that is `size` across are taken for nothing when they are narrower than this times it:
/// sixteen roundings of coordinates of that size.
inline constexpr double kNarrow = 0x1p-48;

}  // namespace delone::dual_detail
