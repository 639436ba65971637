// Convex polytopes and polygons in space, and what planes leave of them.
//
// A polytope is faces over common corners. Cutting decides once for each corner on which side of the plane it lies, and
// makes one new corner on each edge between two sides, for both of its faces; so whatever was rounded, the surface
// stays closed, and volumes that share a plane fit together.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

class Polytope {
 public:
  struct Face {
    std::size_t begin, end;  ///< of its corners in loops, counter-clockwise from outside
    Index across;            ///< names what lies beyond
  };

  Polytope() = default;
  /// From its faces, counter-clockwise from outside; equal corners are one. Nothing has a name beyond.
  explicit Polytope(const std::vector<Polygon3>& faces);

  void cut(const Plane& by);
  void move(const Point3& by);
  bool empty() const { return faces_.empty(); }
  const std::vector<Face>& faces() const { return faces_; }
  Point3 corner(std::size_t i) const { return corners_[loops_[i]]; }
  Polygon3 polygon(const Face& face) const;

 private:
  using Corner = std::uint32_t;
  struct Crossing {
    Corner low, high, at;  ///< the edge, and the new corner on it
  };

  bool stays(Corner c) const { return side_[c] <= 0; }
  Corner crossing(Corner stays, Corner goes);
  void cut_face(const Face& face);
  void close(Index across);
  void drop_corners();

  Polygon3 corners_;
  std::vector<Corner> loops_;
  std::vector<Face> faces_;
  // Of the cut at hand.
  std::vector<double> side_;
  std::vector<Crossing> crossings_;
  std::vector<Corner> new_loops_;
  std::vector<Face> new_faces_;
  std::vector<std::array<Corner, 2>> chords_;  ///< edges of the new face
};

/// Cuts one polygon after the other; keeps its memory.
class FaceCutter {
 public:
  void begin(std::span<const Point3> polygon) { polygon_.assign(polygon.begin(), polygon.end()); }
  void cut(const Plane& by);
  /// What is left, in the direction of rotation it began with, without edges that are no longer than `narrow`; empty
  /// when it is no wider than that. Valid until the next begin.
  const Polygon3& end(double narrow);

 private:
  Polygon3 polygon_, next_;
  std::vector<double> side_;
};

template <std::size_t N>
std::array<double, N> operator-(const std::array<double, N>& a, const std::array<double, N>& b) {
  std::array<double, N> c;
  for (std::size_t i = 0; i < N; ++i) c[i] = a[i] - b[i];
  return c;
}
template <std::size_t N>
std::array<double, N> operator+(const std::array<double, N>& a, const std::array<double, N>& b) {
  std::array<double, N> c;
  for (std::size_t i = 0; i < N; ++i) c[i] = a[i] + b[i];
  return c;
}
template <std::size_t N>
std::array<double, N> operator*(double s, const std::array<double, N>& a) {
  std::array<double, N> c;
  for (std::size_t i = 0; i < N; ++i) c[i] = s * a[i];
  return c;
}
template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  double sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}
template <std::size_t N>
double length(const std::array<double, N>& a) {
  return std::sqrt(dot(a, a));
}
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Twice the area times the normal, from the first corner.
Point3 doubled_area(std::span<const Point3> polygon);

/// Edges and faces of a region that is `size` across are taken for nothing when they are narrower than this times it:
/// sixteen roundings of coordinates of that size.
inline constexpr double kNarrow = 0x1p-48;

}  // namespace delone::dual_detail
