// In a convex region the centroid will do, with a box of the bounding box's shape about it: of all chords through the
// centroid the shorter part is at least 1 / (D + 1).
//
// In another polygon it is the square in a circle of at least half the largest radius. Its center is searched in
// rectangles, those first that may hold the deepest point: no point of a rectangle is deeper than its center by more
// than half its diagonal.
#include "apps/box_within.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <span>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/dual/clip.hpp"

namespace delone {
namespace {

using Corner = std::array<double, 2>;

double distance_to_edge(const Corner& x, const Corner& a, const Corner& b) {
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double t = std::clamp(((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a[0] + t * dx - x[0], a[1] + t * dy - x[1]);
}

/// The distance to the boundary, negative outside.
double depth(const Corner& x, std::span<const Ring> rings) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Corner& a = ring[i];
      const Corner& b = ring[(i + 1) % ring.size()];
      nearest = std::min(nearest, distance_to_edge(x, a, b));
      const bool crosses = (a[1] > x[1]) != (b[1] > x[1]);
      if (crosses && x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
  }
  return inside ? nearest : -nearest;
}

struct Rectangle {
  Corner center, half;
  double bound;  ///< no point of it is deeper
  bool operator<(const Rectangle& other) const { return bound < other.bound; }
};

Box square_in_circle(const Region& region) {
  const std::vector<Ring> rings = region.rings();
  const Corner half{(region.high()[0] - region.low()[0]) / 2, (region.high()[1] - region.low()[1]) / 2};
  std::priority_queue<Rectangle> open;
  open.push({{region.low()[0] + half[0], region.low()[1] + half[1]}, half, std::hypot(half[0], half[1])});
  Corner center{};
  double radius = 0;
  while (!open.empty() && open.top().bound > 2 * radius) {
    const Rectangle whole = open.top();
    open.pop();
    const Corner quarter{whole.half[0] / 2, whole.half[1] / 2};
    for (const Corner& side : {Corner{-1, -1}, Corner{1, -1}, Corner{-1, 1}, Corner{1, 1}}) {
      const Corner x{whole.center[0] + side[0] * quarter[0], whole.center[1] + side[1] * quarter[1]};
      const double deep = depth(x, rings);
      if (deep > radius) {
        center = x;
        radius = deep;
      }
      open.push({x, quarter, deep + std::hypot(quarter[0], quarter[1])});
    }
  }
  const double h = radius / std::numbers::sqrt2;
  return {{center[0] - h, center[1] - h}, {center[0] + h, center[1] + h}};
}

Box about_centroid(const Region& region) {
  const auto d = static_cast<std::size_t>(region.dimension());
  const PointsView anywhere(std::span(region.low()).first(d), region.dimension());
  const std::vector<double> center = measure_cells(build(anywhere), region).centroid;
  double scale = 1;
  for (const HalfSpace& side : region.sides()) {
    double room = side.offset;
    double reach = 0;  // of the box, beyond its center
    for (std::size_t axis = 0; axis < d; ++axis) {
      room -= side.normal[axis] * center[axis];
      reach += std::abs(side.normal[axis]) * (region.high()[axis] - region.low()[axis]) / 2;
    }
    scale = std::min(scale, room / reach);
  }
  Box box;
  for (std::size_t axis = 0; axis < d; ++axis) {
    const double half = scale * (region.high()[axis] - region.low()[axis]) / 2;
    box.low[axis] = center[axis] - half;
    box.high[axis] = center[axis] + half;
  }
  return box;
}

}  // namespace

Box box_within(const Region& region) { return region.convex() ? about_centroid(region) : square_in_circle(region); }

}  // namespace delone
