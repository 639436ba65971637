#include "delone/dual/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "delone/base/arithmetic.hpp"
#include "dual/loops.hpp"
#include "dual/polytope.hpp"
#include "dual/rings.hpp"

namespace delone {
namespace {

using dual_detail::Plane;
using dual_detail::Point3;
using dual_detail::operator+;
using dual_detail::operator-;
using dual_detail::operator*;
using dual_detail::dot;

/// The sides of an axis-parallel box.
std::vector<HalfSpace> box_sides(int dimension, const Point3& low, const Point3& high) {
  std::vector<HalfSpace> sides;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      HalfSpace side;
      side.normal[axis] = sign;
      side.offset = sign < 0 ? -low[axis] : high[axis];
      sides.push_back(side);
    }
  }
  return sides;
}

Ring box_ring(const Point3& low, const Point3& high) {
  return {{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
}

std::vector<std::vector<Point3>> box_faces(const Point3& low, const Point3& high) {
  std::vector<std::vector<Point3>> faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    const std::size_t last = (axis + 2) % 3;
    for (const bool up : {false, true}) {
      std::vector<Point3> face;
      for (const auto& [b, c] : {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
        Point3 corner;
        corner[axis] = up ? high[axis] : low[axis];
        corner[next] = (up ? b : c) ? high[next] : low[next];
        corner[last] = (up ? c : b) ? high[last] : low[last];
        face.push_back(corner);
      }
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

/// What half-spaces leave of a box, seen from the box's middle, so that a polytope far from the origin keeps its
/// digits.
struct Cut {
  Region::Seen seen;
  Point3 low{}, high{};  ///< seen likewise

  bool empty() const { return seen.rings.empty() && seen.faces.empty(); }
  void include(const Point3& corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], corner[axis]);
      high[axis] = std::max(high[axis], corner[axis]);
    }
  }
};

void cut_in_plane(const Point3& half, const std::vector<Plane>& planes, Cut& cut) {
  dual_detail::Loops loops;
  for (const auto& [x, y] : box_ring(-1.0 * half, half)) loops.corners.push_back({{x, y}, kNone});
  loops.ends.push_back(4);
  dual_detail::LoopCutter cutter;
  for (const Plane& plane : planes) cutter.cut(loops, {{plane.normal[0], plane.normal[1]}, plane.offset}, plane.across);
  if (loops.empty()) return;
  Ring ring;
  for (std::size_t i = 0; i < loops.corners.size(); ++i) {
    const auto& [at, across] = loops.corners[i];
    if (at == loops.corners[i + 1 == loops.corners.size() ? 0 : i + 1].at) continue;
    ring.push_back(at);
    cut.include({at[0], at[1], 0});
    if (across != kNone) cut.seen.sides.push_back({planes[across].normal, planes[across].offset});
  }
  cut.seen.rings.push_back(std::move(ring));
}

void cut_in_space(const Point3& half, const std::vector<Plane>& planes, Cut& cut) {
  dual_detail::Polytope polytope(box_faces(-1.0 * half, half));
  for (const Plane& plane : planes) polytope.cut(plane);
  for (const auto& face : polytope.faces()) {
    dual_detail::Polygon3 polygon = polytope.polygon(face);
    for (const Point3& corner : polygon) cut.include(corner);
    cut.seen.faces.push_back(std::move(polygon));
    if (face.across != kNone) cut.seen.sides.push_back({planes[face.across].normal, planes[face.across].offset});
  }
}

Cut cut_box(int dimension, const std::vector<HalfSpace>& sides, const Point3& low, const Point3& high) {
  const Point3 middle = 0.5 * low + 0.5 * high;
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < sides.size(); ++i)
    planes.push_back({sides[i].normal, sides[i].offset - dot(sides[i].normal, middle), static_cast<Index>(i)});
  Cut cut;
  cut.seen.origin = middle;
  cut.low.fill(std::numeric_limits<double>::infinity());
  cut.high.fill(-std::numeric_limits<double>::infinity());
  dimension == 2 ? cut_in_plane(high - middle, planes, cut) : cut_in_space(high - middle, planes, cut);
  if (dimension == 2) cut.low[2] = cut.high[2] = 0;
  return cut;
}

std::string half_space_at(std::size_t i) { return "half-space " + std::to_string(i) + ": "; }

std::vector<HalfSpace> with_unit_normals(int dimension, std::vector<HalfSpace> sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    auto& [normal, offset] = sides[i];
    if (dimension == 2) normal[2] = 0;
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    if (!std::isfinite(length) || !std::isfinite(offset)) throw InputError(half_space_at(i) + "a number is not finite");
    if (length == 0) throw InputError(half_space_at(i) + "its normal is zero");
    for (double& x : normal) x /= length;
    offset /= length;
  }
  return sides;
}

double largest(const Point3& x) { return std::max({x[0], x[1], x[2]}); }

void require_dimension(int dimension) {
  if (dimension != 2 && dimension != 3)
    throw InputError("regions have dimension 2 or 3, not " + std::to_string(dimension));
}

}  // namespace

void Region::settle() {
  measure_ = 0;
  for (const Ring& ring : seen_.rings) {
    std::vector<dual_detail::Corner> corners;
    for (const auto& at : ring) corners.push_back({at, kNone});
    measure_ += dual_detail::doubled_area(corners.data(), corners.data() + corners.size()) / 2;
  }
  for (const auto& face : seen_.faces)
    measure_ += dot(dual_detail::doubled_area(face), face[0] - seen_.faces[0][0]) / 6;
}

std::vector<Ring> Region::rings() const {
  std::vector<Ring> rings = seen_.rings;
  for (Ring& ring : rings) {
    for (auto& [x, y] : ring) {
      x += seen_.origin[0];
      y += seen_.origin[1];
    }
  }
  return rings;
}

std::vector<HalfSpace> Region::sides() const {
  std::vector<HalfSpace> sides = seen_.sides;
  for (HalfSpace& side : sides) side.offset += dot(side.normal, seen_.origin);
  return sides;
}

std::vector<std::vector<Point3>> Region::faces() const {
  std::vector<std::vector<Point3>> faces = seen_.faces;
  for (auto& face : faces) {
    for (Point3& corner : face) corner = corner + seen_.origin;
  }
  return faces;
}

Region Region::box(std::span<const double> low, std::span<const double> high) {
  require_dimension(static_cast<int>(low.size()));
  if (high.size() != low.size()) throw InputError("the two corners of the box have different dimensions");
  Region region;
  region.dimension_ = static_cast<int>(low.size());
  region.convex_ = true;
  for (std::size_t axis = 0; axis < low.size(); ++axis) {
    if (!std::isfinite(low[axis]) || !std::isfinite(high[axis]) || !(low[axis] < high[axis]))
      throw InputError("the box on axis " + std::to_string(axis) + " must run from a finite number to a larger one");
    region.low_[axis] = low[axis];
    region.high_[axis] = high[axis];
  }
  region.seen_.sides = box_sides(region.dimension_, region.low_, region.high_);
  if (region.dimension_ == 2) {
    region.seen_.rings = {box_ring(region.low_, region.high_)};
  } else {
    region.seen_.faces = box_faces(region.low_, region.high_);
  }
  region.settle();
  return region;
}

/// Cut out of boxes that grow, from the least offset on, until what is left does not reach their ends, then again out
/// of one that fits: large boxes cost digits. In units that make offsets a few units large.
Region Region::half_spaces(int dimension, std::vector<HalfSpace> half_spaces) {
  require_dimension(dimension);
  half_spaces = with_unit_normals(dimension, std::move(half_spaces));
  double scale = std::numeric_limits<double>::min();
  for (const HalfSpace& side : half_spaces) scale = std::max(scale, std::abs(side.offset));
  const int power = std::ilogb(scale);
  double least = 1;
  for (HalfSpace& side : half_spaces) {
    side.offset = std::ldexp(side.offset, -power);
    if (side.offset != 0) least = std::min(least, std::abs(side.offset));
  }
  const auto cube = [&](double half) {
    const double z = dimension == 3 ? half : 0;
    return cut_box(dimension, half_spaces, {-half, -half, -z}, {half, half, z});
  };
  Cut cut;
  bool ends = false;
  for (double half = 4 * std::max(least, 0x1p-60); half < 0x1p36 && !ends; half *= 16) {
    cut = cube(half);
    ends = !cut.empty() && std::max(largest(-1.0 * cut.low), largest(cut.high)) < half / 2;
  }
  if (cut.empty()) throw InputError("the half-spaces have no interior point in common");
  if (!ends) throw InputError("the half-spaces leave a region without end, or nearly so; add some that close it");
  const Point3 margin = 0.125 * (cut.high - cut.low);
  cut = cut_box(dimension, half_spaces, cut.low - margin, cut.high + margin);  // the cube's middle is the origin
  if (cut.empty()) throw InputError("the half-spaces have no interior point in common");
  Region region;
  region.dimension_ = dimension;
  region.convex_ = true;
  region.seen_ = std::move(cut.seen);
  region.settle();
  if (!(region.measure_ > 0)) throw InputError("the half-spaces have no interior point in common");
  region.low_ = region.seen_.origin + cut.low;
  region.high_ = region.seen_.origin + cut.high;
  region.enlarge(power);
  return region;
}

/// By a power of two.
void Region::enlarge(int power) {
  const auto times = [power](Point3& x) {
    for (double& coordinate : x) coordinate = std::ldexp(coordinate, power);
  };
  for (Point3* x : {&low_, &high_, &seen_.origin}) times(*x);
  for (HalfSpace& side : seen_.sides) side.offset = std::ldexp(side.offset, power);
  for (auto& face : seen_.faces) std::ranges::for_each(face, times);
  for (Ring& ring : seen_.rings) {
    for (auto& [x, y] : ring) {
      x = std::ldexp(x, power);
      y = std::ldexp(y, power);
    }
  }
  measure_ = std::ldexp(measure_, dimension_ * power);
}

Region Region::polygon(std::vector<Ring> rings) {
  const ExactEnvironment environment;
  dual_detail::require_simple(rings);
  dual_detail::orient_rings(rings);
  Region region;
  region.dimension_ = 2;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    region.low_[axis] = std::numeric_limits<double>::infinity();
    region.high_[axis] = -std::numeric_limits<double>::infinity();
    for (const Ring& ring : rings) {
      for (const auto& corner : ring) {
        region.low_[axis] = std::min(region.low_[axis], corner[axis]);
        region.high_[axis] = std::max(region.high_[axis], corner[axis]);
      }
    }
  }
  region.seen_.rings = std::move(rings);
  region.settle();
  return region;
}

}  // namespace delone
