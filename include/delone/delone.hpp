// The five-minute header: points in, exact triangulation out.
//
//   std::vector<std::array<double, 2>> points = ...;
//   auto t = delone::triangulate(points);
//   const auto table = delone::cells(t);
//   for (std::size_t c = 0; c < table.size(); ++c) use(table[c]);  // three rows of `points`
#pragma once

#include <array>
#include <span>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/check/delaunay.hpp"
#include "delone/mesh/archive.hpp"
#include "delone/mesh/export.hpp"
#include "delone/remove/move.hpp"
#include "delone/remove/remove.hpp"

namespace delone {

/// The Delaunay triangulation of D-dimensional points; with weights, one per point, the regular triangulation.
template <std::size_t D>
Triangulation<static_cast<int>(D)> triangulate(const std::vector<std::array<double, D>>& points,
                                               std::span<const double> weights = {}) {
  return build<static_cast<int>(D)>(PointsView(std::span(points), weights));
}

}  // namespace delone
