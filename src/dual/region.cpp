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

using dual_detail::Bound;
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

/// What half-spaces leave of a box, and which of them bound it. Computed around the box's middle, so that a polytope
/// far from the origin keeps its digits.
struct Cut {
  std::vector<HalfSpace> sides;
  Ring ring;
  std::vector<std::vector<Point3>> faces;
  Point3 low{}, high{};

  void include(const Point3& corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], corner[axis]);
      high[axis] = std::max(high[axis], corner[axis]);
    }
  }
};

Cut cut_box(int dimension, std::vector<HalfSpace> sides, const Point3& low, const Point3& high) {
  const Point3 middle = 0.5 * low + 0.5 * high;
  const Point3 half = high - middle;
  const std::vector<HalfSpace> box = box_sides(dimension, low, high);
  sides.insert(sides.end(), box.begin(), box.end());
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < sides.size(); ++i)
    planes.push_back({sides[i].normal, sides[i].offset - dot(sides[i].normal, middle), static_cast<Index>(i)});
  Cut cut;
  cut.low.fill(std::numeric_limits<double>::infinity());
  cut.high.fill(-std::numeric_limits<double>::infinity());
  if (dimension == 2) {
    dual_detail::Loops loops;
    for (const auto& [x, y] : box_ring(-1.0 * half, half)) loops.corners.push_back({{x, y}, kNone});
    loops.ends.push_back(4);
    dual_detail::LoopCutter cutter;
    for (const Plane& plane : planes)
      cutter.cut(loops, {{plane.normal[0], plane.normal[1]}, plane.offset}, plane.across);
    for (const auto& corner : loops.corners) {
      const Point3 at = Point3{corner.at[0], corner.at[1], 0} + middle;
      if (!cut.ring.empty() && cut.ring.back() == std::array{at[0], at[1]}) continue;
      cut.ring.push_back({at[0], at[1]});
      cut.include(at);
      if (corner.across != kNone) cut.sides.push_back(sides[corner.across]);
    }
    return cut;
  }
  dual_detail::FaceCutter cutter;
  const Bound bound{{}, 2 * std::sqrt(dot(half, half))};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    cutter.begin(planes[i], bound);
    for (std::size_t j = 0; j < planes.size(); ++j) {
      if (j != i) cutter.cut(planes[j]);
    }
    std::vector<Point3> face = cutter.end(bound);
    if (face.empty()) continue;
    for (Point3& corner : face) cut.include(corner = corner + middle);
    cut.faces.push_back(std::move(face));
    cut.sides.push_back(sides[i]);
  }
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

void require_dimension(int dimension) {
  if (dimension != 2 && dimension != 3)
    throw InputError("regions have dimension 2 or 3, not " + std::to_string(dimension));
}

}  // namespace

void Region::settle() {
  const Point3 middle = 0.5 * low_ + 0.5 * high_;
  measure_ = 0;
  if (dimension_ == 2) {
    for (const Ring& ring : rings_) {
      std::vector<dual_detail::Corner> corners;
      for (const auto& [x, y] : ring) corners.push_back({{x, y}, kNone});
      measure_ += dual_detail::doubled_area(corners.data(), corners.data() + corners.size()) / 2;
    }
    return;
  }
  for (const auto& face : faces_) measure_ += dot(dual_detail::doubled_area(face), face[0] - middle) / 6;
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
  region.sides_ = box_sides(region.dimension_, region.low_, region.high_);
  if (region.dimension_ == 2) {
    region.rings_ = {box_ring(region.low_, region.high_)};
  } else {
    region.faces_ = box_faces(region.low_, region.high_);
  }
  region.settle();
  return region;
}

/// Cut out of a box so large that it need not be looked for, which costs digits, then again out of one that fits.
Region Region::half_spaces(int dimension, std::vector<HalfSpace> half_spaces) {
  require_dimension(dimension);
  half_spaces = with_unit_normals(dimension, std::move(half_spaces));
  double scale = std::numeric_limits<double>::min();
  for (const HalfSpace& side : half_spaces) scale = std::max(scale, std::abs(side.offset));
  const double far = 0x1p30 * scale;
  Point3 low{}, high{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) low[axis] = -(high[axis] = far);
  Region region;
  region.dimension_ = dimension;
  region.convex_ = true;
  for (int round = 0; round < 3; ++round) {
    Cut cut = cut_box(dimension, half_spaces, low, high);
    if (cut.ring.empty() && cut.faces.empty()) throw InputError("the half-spaces have no interior point in common");
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      if (std::max(-cut.low[axis], cut.high[axis]) > far / 2)
        throw InputError("the half-spaces leave a region without end; add some that close it");
      const double margin = (cut.high[axis] - cut.low[axis]) / 8 + 0x1p-50 * scale;
      low[axis] = cut.low[axis] - margin;
      high[axis] = cut.high[axis] + margin;
    }
    region.low_ = dimension == 3 ? cut.low : Point3{cut.low[0], cut.low[1], 0};
    region.high_ = dimension == 3 ? cut.high : Point3{cut.high[0], cut.high[1], 0};
    region.sides_ = std::move(cut.sides);
    region.faces_ = std::move(cut.faces);
    if (dimension == 2) region.rings_ = {std::move(cut.ring)};
  }
  region.settle();
  if (!(region.measure_ > 0)) throw InputError("the half-spaces have no interior point in common");
  return region;
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
  region.rings_ = std::move(rings);
  region.settle();
  return region;
}

}  // namespace delone
