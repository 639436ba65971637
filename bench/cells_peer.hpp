// What the harness asks of another library: the volumes of Voronoi cells in the unit cube.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "delone/geometry/points.hpp"

namespace delone::bench {

/// By voro++, with the number of points a block that it recommends to aim at.
std::vector<double> voro_volumes(PointsView points);
std::string voro_version();

}  // namespace delone::bench
