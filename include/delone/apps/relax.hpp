// Centroidal relaxation: sites move to the centroids of their cells, until they lie evenly.
// Source: [Lloyd82], and [DFG99] for more than one dimension.
#pragma once

#include <vector>

#include "delone/base/progress.hpp"
#include "delone/dual/region.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

struct RelaxOptions {
  int steps = 1;           ///< at most
  double tolerance = 0;    ///< stop after a step that moved nothing further than this times the region's longest side
  int threads = 1;         ///< build the triangulations and measure the cells
  Progress progress = {};  ///< told of progress, may cancel
};

struct Relaxed {
  std::vector<double> coordinates;  ///< the sites where they are now, in the order of the rows
  std::vector<double> moved;        ///< the largest movement of each step
  /// Before each step the integral over the region of the squared distance to the nearest site: it never rises.
  std::vector<double> energy;
};

/// Moves every site to the centroid of its Voronoi cell within the region, step after step.
///
/// Sites without a cell stay where they are: duplicates, and sites outside the region that nothing of it is near to. A
/// duplicate takes part as soon as its twin has moved away. In a region that is not convex the centroid of a cell may
/// lie outside the region, and the site then lies there, too: the energy falls nevertheless, for it asks only how far
/// the region's points are from the sites.
/// @param points  2 or 3 coordinates each, as many as the region has dimensions; anywhere
/// @throws InputError for weights, NaN or infinity, another dimension than the region's, a negative number of steps or
/// a tolerance that is negative or not a number, before any work; Cancelled; std::bad_alloc
/// Cost: a triangulation and its clipped cells a step. Steps are many where sites are many: what is uneven over a long
/// distance evens out slowly.
Relaxed relax(PointsView points, const Region& region, const RelaxOptions& options = {});

}  // namespace delone
