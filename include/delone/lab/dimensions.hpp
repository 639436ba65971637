// How many neighbours and cells a site of random sites has, from dimension to dimension.
// Source: [For92] 2.3: Meijering's mean numbers of neighbours, Dwyer's c_d n cells and his estimate of c_d.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// c_d, the mean number of Delaunay cells by site of a Poisson process in dimension d >= 1: the vertices of its Voronoi
/// diagram by volume,
///   2^(d+1) pi^((d-1)/2) / (d^2 (d+1)) G((d^2+1)/2) / G(d^2/2) (G(d/2+1) / G((d+1)/2))^d   with the gamma function G.
/// It is J. Møller, "Random tessellations in R^d", Advances in Applied Probability 21, 1989; d = 2: 2, d = 3: 24
/// pi^2/35.
double poisson_cells(int d);
/// The estimate of [For92] 2.3, e^(1/4) sqrt(2/pi) / (d (d+1)) (2 pi d)^(d/2): within 1 % for d > 5.
double estimated_cells(int d);
/// The mean number of neighbours, where cells decide it: up to dimension 4; NaN beyond. Without border the numbers of
/// vertices v, edges e and cells c of a triangulation are bound by Euler's and Dehn and Sommerville's equations:
/// d = 2: e = 3 v, d = 3: e = v + c, d = 4: 2 e = 6 v + c, but for a constant.
double poisson_degree(int d);

/// Means over the sites of one size, and over the runs.
struct DimensionCount {
  int dimension = 0;
  std::size_t n = 0;
  Estimate cells_in_cube;              ///< by site, sites evenly in a cube
  Estimate cells_in_ball, degree;      ///< by site, sites evenly in a ball
  double inner = 0;                    ///< sites of the ball that are far from its border, in the mean
  Estimate inner_cells, inner_degree;  ///< cells at one of these by d + 1, and its neighbours
};

struct DimensionSizes {
  int dimension;
  std::vector<std::size_t> sizes;
  int runs;
};

struct DimensionOptions {
  std::vector<DimensionSizes> sizes;
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// Far from the border of the ball is a site when a ball of 12 sites, in the mean, that touches it has room: most balls
/// around Delaunay cells have fewer. In the centre of the ball there always is a site, which counts: a site that is put
/// into a Poisson process anywhere sees what a typical one sees.
std::vector<DimensionCount> run_dimensions(const DimensionOptions& options);

}  // namespace delone::lab
