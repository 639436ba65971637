// Points to ask about: the hard places of a point set, and places far from it.
#pragma once

#include <algorithm>
#include <cmath>

#include "delone/mesh/triangulation.hpp"
#include "support/families.hpp"

namespace delone::test {

/// Vertices, midpoints and centroids of rows (on edges, faces and bisectors of lattices), random points in and around
/// the box of the points, and points that are far, enormous or next to nothing.
inline PointSet queries_around(const PointSet& points, std::uint64_t seed) {
  PointSet queries{"queries", points.dimension, {}};
  const auto d = static_cast<std::size_t>(points.dimension);
  Random random(seed);
  const auto view = points.view();
  const auto add = [&](auto coordinate) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      const double x = coordinate(axis);
      queries.coordinates.push_back(std::isfinite(x) ? x : 0.0);
    }
  };
  for (int trial = 0; trial < (view.empty() ? 0 : 5); ++trial) {
    const auto a = view[random() % view.size()];
    const auto b = view[random() % view.size()];
    const auto c = view[random() % view.size()];
    add([&](std::size_t j) { return a[j]; });
    add([&](std::size_t j) { return 0.5 * a[j] + 0.5 * b[j]; });
    add([&](std::size_t j) { return 0.25 * a[j] + 0.25 * b[j] + 0.5 * c[j]; });
    add([&](std::size_t j) { return 2.0 * a[j] - b[j]; });
    add([&](std::size_t j) { return a[j] + (unit_random(random) - 0.5) * (b[j] - a[j]); });
  }
  for (int trial = 0; trial < 4; ++trial) {
    add([&](std::size_t) { return std::floor(4.0 * unit_random(random)) * 0.5; });
    add([&](std::size_t) { return 4.0 * unit_random(random) - 1.0; });
  }
  for (const double size : {1e6, 1e300, 5e-324}) {
    add([&](std::size_t) { return size * (static_cast<double>(random() % 3) - 1.0); });
  }
  return queries;
}

/// kNoCell in a triangulation without any.
inline CellId any_live_cell(const AnyTriangulation& t, Random& random) {
  const std::size_t slots = t.complex().slot_count();
  if (slots == 0) return kNoCell;
  for (;;) {
    const CellId c{static_cast<Index>(random() % slots)};
    if (t.complex().is_live(c)) return c;
  }
}

}  // namespace delone::test
