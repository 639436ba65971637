// Triangulations by several threads: each half of the points by half of the threads, then the halves are glued.
#pragma once

#include <optional>
#include <span>

#include "delone/base/progress.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// The triangulation of points that span dimension 2 or more, as triangulate_points() makes it; nothing where two
/// halves would be no faster: where points are few, or most of them, as on a sphere, have to do with the other half.
/// @param axes  coordinate axes that span the points
/// @param room  as there
std::optional<Mesh> triangulate_in_halves(PointsView points, std::span<const int> axes, int threads,
                                          const Progress& progress, std::size_t room = 0);

}  // namespace delone
