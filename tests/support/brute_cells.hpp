// The cells of a power diagram in a convex polygon, slow and obvious: the polygon cut by every bisector.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "delone/dual/region.hpp"
#include "delone/geometry/points.hpp"

namespace delone::test {

/// The part of a counter-clockwise convex polygon that lies nearer to a site than to any other, by power.
inline Ring brute_cell(PointsView sites, std::size_t site, Ring polygon) {
  for (std::size_t other = 0; other < sites.size(); ++other) {
    if (other == site) continue;
    const double nx = sites[other][0] - sites[site][0];
    const double ny = sites[other][1] - sites[site][1];
    const auto beyond = [&](const std::array<double, 2>& x) {
      return nx * (2 * x[0] - sites[other][0] - sites[site][0]) + ny * (2 * x[1] - sites[other][1] - sites[site][1]) +
             sites.weight(other) - sites.weight(site);
    };
    Ring left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto& a = polygon[i];
      const auto& b = polygon[(i + 1) % polygon.size()];
      const double fa = beyond(a);
      const double fb = beyond(b);
      if (fa <= 0) left.push_back(a);
      if ((fa <= 0) != (fb <= 0)) {
        const double t = fa / (fa - fb);
        left.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
      }
    }
    polygon = std::move(left);
  }
  return polygon;
}

inline double area(const Ring& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % polygon.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

inline std::array<double, 2> centroid(const Ring& polygon) {
  std::array<double, 2> sum{};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % polygon.size()];
    for (std::size_t axis = 0; axis < 2; ++axis) sum[axis] += (a[axis] + b[axis]) * (a[0] * b[1] - a[1] * b[0]);
  }
  return {sum[0] / (6 * area(polygon)), sum[1] / (6 * area(polygon))};
}

}  // namespace delone::test
