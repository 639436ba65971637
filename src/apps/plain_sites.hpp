// What relaxation and capacities ask of their input.
#pragma once

#include <span>

#include "delone/dual/region.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

/// @throws InputError for weights, NaN or infinity, too many rows, another dimension than the region's
void require_plain_sites(PointsView sites, const Region& region);

/// @throws InputError unless both are at least 0
void require_steps(int steps, double tolerance);

double distance(std::span<const double> a, std::span<const double> b);

}  // namespace delone
