#include "dual/polytope.hpp"

#include <cmath>

namespace delone::dual_detail {

Point3 doubled_area(std::span<const Point3> polygon) {
  Point3 sum{};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum = sum + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[i]);
  return sum;
}

void FaceCutter::cut(const Plane& by) {
  if (polygon_.empty()) return;
  side_.resize(polygon_.size());
  bool beyond = false;
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    side_[i] = dot(by.normal, polygon_[i]) - by.offset;
    beyond = beyond || side_[i] > 0;
  }
  if (!beyond) return;
  next_.clear();
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    const std::size_t j = i + 1 == polygon_.size() ? 0 : i + 1;
    if (side_[i] <= 0) next_.push_back(polygon_[i]);
    if ((side_[i] < 0 && side_[j] > 0) || (side_[i] > 0 && side_[j] < 0))
      next_.push_back(polygon_[i] + side_[i] / (side_[i] - side_[j]) * (polygon_[j] - polygon_[i]));
  }
  polygon_.swap(next_);
}

const Polygon3& FaceCutter::end(const Bound& bound) {
  if (polygon_.size() >= 3) {
    double around = 0;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Point3 edge = polygon_[i] - polygon_[i == 0 ? polygon_.size() - 1 : i - 1];
      around += std::sqrt(dot(edge, edge));
    }
    const Point3 area = doubled_area(polygon_);
    if (std::sqrt(dot(area, area)) > kNarrow * bound.radius * around) return polygon_;
  }
  polygon_.clear();
  return polygon_;
}

void FaceCutter::begin(const Plane& plane, const Bound& bound) {
  const Point3& n = plane.normal;
  const double squared = dot(n, n);
  const double length = std::sqrt(squared);
  const double height = plane.offset - dot(n, bound.centre);
  polygon_.clear();
  if (!(std::abs(height) <= bound.radius * length)) return;
  const Point3 foot = bound.centre + height / squared * n;
  std::size_t least = 0;  // the axis that the normal leans on least
  for (std::size_t axis = 1; axis < 3; ++axis) least = std::abs(n[axis]) < std::abs(n[least]) ? axis : least;
  Point3 unit{};
  unit[least] = 1;
  Point3 u = cross(unit, n);
  u = bound.radius / std::sqrt(dot(u, u)) * u;
  const Point3 v = 1 / length * cross(n, u);
  polygon_ = {foot - u - v, foot + u - v, foot + u + v, foot - u + v};
}

}  // namespace delone::dual_detail
