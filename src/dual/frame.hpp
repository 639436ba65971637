// How a region is seen while cells are cut: from the middle of its bounding box, in units that make it a few units
// large. There coordinates keep most digits, and nothing overflows or underflows, whatever the units of the input,
// while sites are not astronomically far from the region.
#pragma once

#include <vector>

#include "delone/dual/region.hpp"
#include "dual/loops.hpp"
#include "dual/polytope.hpp"

namespace delone::dual_detail {

struct Frame {
  explicit Frame(const Region& region);

  /// A coordinate as it is seen, a difference of two, and back.
  double seen(double x, std::size_t axis) const { return scaled(x - middle[axis]); }
  double scaled(double difference) const { return difference * scale; }
  double placed(double x, std::size_t axis) const { return x * unit + middle[axis]; }
  /// A length, an area and so on, as large as it is. One power after the other, so that nothing overflows on the way.
  double enlarged(double x, int power) const {
    for (int i = 0; i < power; ++i) x *= unit;
    return x;
  }

  int dimension;
  Point3 middle;
  double scale;  ///< a power of two
  double unit;   ///< 1 / scale
  Point3 low, high;
  double radius;                ///< from the middle to the corners of the box
  Loops loops;                  ///< in the plane
  std::vector<Plane> sides;     ///< of a convex region
  std::vector<Polygon3> faces;  ///< in space, one on each side
  Polytope polytope;            ///< the same
};

}  // namespace delone::dual_detail
