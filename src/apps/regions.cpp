#include "delone/apps/regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "dual/polytope.hpp"

namespace delone {
namespace {

using dual_detail::Point3;
using dual_detail::operator-;
using dual_detail::operator*;
using dual_detail::cross;
using dual_detail::dot;

/// From corner to corner by the edges, each of which leads to the next one.
Ring ring_of(PointsView points, const ConvexHull& hull) {
  std::vector<Index> next(points.size(), kNone);
  for (std::size_t edge = 0; edge < hull.facets.size(); ++edge) next[hull.facets[edge][0]] = hull.facets[edge][1];
  Ring ring;
  Index row = hull.corners.front();
  do {
    ring.push_back({points[row][0], points[row][1]});
    row = next[row];
  } while (row != hull.corners.front());
  return ring;
}

/// The half-space that three corners of a face, which lie well apart, and all corners of the hull lie in. Where the
/// three are nearly in line its direction is rounded, so that it may touch the hull elsewhere; it never cuts it.
std::optional<HalfSpace> side_of(PointsView points, const ConvexHull& hull, std::span<const Index> face,
                                 const Point3& inside) {
  const auto at = [&](Index row) { return Point3{points[row][0], points[row][1], points[row][2]}; };
  const Point3 a = at(face[0]);
  const Point3 b = at(face[face.size() / 3]);
  const Point3 c = at(face[face.size() * 2 / 3]);
  HalfSpace side{cross(b - a, c - a), -std::numeric_limits<double>::infinity()};
  if (dot(side.normal, inside - a) > 0) side.normal = -1.0 * side.normal;
  const double length = std::hypot(side.normal[0], side.normal[1], side.normal[2]);
  if (!(length > 0)) return std::nullopt;
  for (double& x : side.normal) x /= length;
  for (const Index row : hull.corners) side.offset = std::max(side.offset, dot(side.normal, at(row)));
  return side;
}

Point3 mean(PointsView points, std::span<const Index> rows) {
  Point3 sum{};
  for (const Index row : rows) {
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += points[row][axis] / static_cast<double>(rows.size());
  }
  return sum;
}

}  // namespace

Region region_around(PointsView points, double margin) {
  if (points.empty()) throw InputError("there are no points that a box could hold");
  require_finite(points);
  const auto dimension = static_cast<std::size_t>(points.dimension());
  std::vector<double> low(points[0].begin(), points[0].end());
  std::vector<double> high = low;
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      low[axis] = std::min(low[axis], points[row][axis]);
      high[axis] = std::max(high[axis], points[row][axis]);
    }
  }
  double longest = 0;
  for (std::size_t axis = 0; axis < dimension; ++axis) longest = std::max(longest, high[axis] - low[axis]);
  const double wider = longest == 0 ? 1 : margin * longest;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    low[axis] = std::min(low[axis] - wider, std::nextafter(low[axis], -kInfinity));
    high[axis] = std::max(high[axis] + wider, std::nextafter(high[axis], kInfinity));
  }
  return Region::box(low, high);
}

Region hull_region(PointsView points, const HullOptions& options) {
  const int dimension = points.dimension();
  if (dimension != 2 && dimension != 3)
    throw InputError("regions have dimension 2 or 3, the points have " + std::to_string(dimension));
  const ConvexHull hull = convex_hull(points, options);
  if (hull.affine_dimension < dimension)
    throw InputError("the points span no " + std::string(dimension == 2 ? "area" : "volume") +
                     ": their hull cannot be a region");
  if (dimension == 2) return Region::polygon({ring_of(points, hull)});
  const Point3 inside = mean(points, hull.corners);
  std::vector<HalfSpace> sides;
  for (std::size_t face = 0; face < hull.faces.size(); ++face) {
    if (const auto side = side_of(points, hull, hull.faces[face], inside)) sides.push_back(*side);
  }
  return Region::half_spaces(3, std::move(sides));
}

}  // namespace delone
