#include "dual/frame.hpp"

#include <algorithm>
#include <cmath>

namespace delone::dual_detail {

Frame::Frame(const Region& region) : dimension(region.dimension()) {
  middle = 0.5 * region.low() + 0.5 * region.high();
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    largest = std::max(largest, region.high()[axis] / 2 - region.low()[axis] / 2);
  scale = std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1000, 1000));
  unit = 1 / scale;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = seen(region.low()[axis], axis);
    high[axis] = seen(region.high()[axis], axis);
  }
  radius = std::sqrt(std::max(dot(low, low), dot(high, high)));
  const Region::Seen& shape = region.seen();
  const Point3 shift = shape.origin - middle;
  for (const HalfSpace& side : shape.sides)
    sides.push_back({side.normal, scaled(side.offset + dot(side.normal, shift)), kNone});
  for (const Ring& ring : shape.rings) {
    for (const auto& [x, y] : ring) loops.corners.push_back({{scaled(x + shift[0]), scaled(y + shift[1])}, kNone});
    loops.ends.push_back(loops.corners.size());
  }
  for (const auto& face : shape.faces) {
    Polygon3& polygon = faces.emplace_back();
    for (const Point3& corner : face) polygon.push_back(scale * (corner + shift));
  }
  polytope = Polytope(faces);
}

}  // namespace delone::dual_detail
