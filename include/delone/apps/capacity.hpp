// Power diagrams whose cells have measures that are asked for: the same as optimal transport from a region to its
// sites. Source: [AHA98] (such weights exist, are those of least transport, and maximise a concave function); [KMT19]
// algorithm 1 (damped Newton steps find them).
#pragma once

#include <span>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/dual/region.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

struct CapacityOptions {
  double tolerance = 1e-9;  ///< converged when no measure differs from what is wanted by more than this times the mean
  int steps = 100;          ///< at most
  int threads = 1;          ///< build the triangulations and measure the cells
  Progress progress = {};   ///< told of progress, may cancel
};

struct Capacities {
  std::vector<double> weights;   ///< of the sites, as in a PointsView; their mean is 0
  std::vector<double> measures;  ///< of the power cells within the region
  int steps = 0;                 ///< Newton steps that were made
  double error = 0;              ///< the largest difference of a measure from what is wanted, over the mean
  bool converged = false;        ///< whether the error is within the tolerance
};

/// Weights with which the power cells of the sites, within the region, have the wanted areas or volumes.
///
/// Among all ways to share the region out in these amounts, the cells are the one in which the integral of the squared
/// distance to the site is least. Up to a constant, which is chosen so that their mean is 0, no other weights do it. A
/// cell need not contain its site, and sites may lie anywhere.
/// @param sites   2 or 3 coordinates each, as many as the region has dimensions; all different, no weights
/// @param wanted  one per site, positive; their sum is the region's measure, to a millionth of it. What is missing or
///                too much is shared out in proportion.
/// @throws InputError for weights, NaN or infinity, coordinates whose squares are infinite, another dimension than the
/// region's, equal sites, capacities of the wrong number, sign or sum, negative or undefined options; Cancelled;
/// std::bad_alloc
/// Not an error, but `converged` is false: too few steps, or no step that brings the measures nearer. Then rounding is
/// in the way, where sites are close to each other for how far the others are; or the region is a polygon of several
/// pieces, between which no cells reach across, so that nothing tells how much to raise the weights in one of them.
/// Cost: a triangulation, its clipped cells and the solution of a sparse system a step. Steps are few, and hardly more
/// for many sites; where cells are tiny at the start, some of them take several triangulations.
Capacities fit_capacities(PointsView sites, const Region& region, std::span<const double> wanted,
                          const CapacityOptions& options = {});

}  // namespace delone
