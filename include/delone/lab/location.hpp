// How many triangles of the history are traced to find the one that a new site lies in.
// Source: [GKS92] 3 (the history, theorem 3.1, and the remark on a bad site P).
//
// What theorem 3.1's O(n log n) hides. By its proof every traced triangle but the last is charged to one, itself or a
// neighbour, that was Delaunay, is gone, and has the new site P inside its circle; none is charged twice. Let P come
// after r sites, all of them in random order. After the first j of these, P would destroy two triangles less than it
// would have neighbours; so, ghosts included, 4 - 9/(j + 1) at most are expected to have P inside (see triangles.hpp).
// Each was made by the j-th site with probability 3/j at most, one of its corners being the last of j. The first four
// triangles have P inside 4 - 9/4 times at most, and one that is left in the end is not charged. So the expected
// number of triangles traced is at most
//   7/4 + sum over j = 4 .. r of (3/j)(4 - 9/(j + 1))  <  12 ln r.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/build/method.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// For the site that comes after r >= 3 others; the mean over all n sites, of which the first three are not located.
double traced_bound(std::size_t r);
double mean_traced_bound(std::size_t n);

/// Triangles traced for each site, on average; sites are the same in all runs, their order is not.
struct LocationRow {
  std::string kind;
  std::size_t n = 0;
  Estimate traced;
};

/// The triangles traced for P = (1/2, 1 - 2^-40), which comes last: after Y = (1, 1), m sites of the negative x axis in
/// random order, and X = (0, 1). The insertion of X makes and removes the triangles XYb for all bottom sites b, and all
/// of them contain P.
/// @param method  flip, flip_loop or flip_legalize. Requires m >= 2.
double traced_for_bad_site(std::size_t m, Method method, std::uint64_t seed);

struct BadSiteRow {
  std::size_t m = 0;
  double flip = 0, flip_loop = 0, flip_legalize = 0;
};

/// The same n sites, n - 3 of them at the bottom, in random order: all orders alike, or those with Y before X before P.
struct RandomBadSiteRow {
  std::size_t n = 0;
  Estimate traced, traced_if_ordered;
  double before_x = 0;  ///< mean number of bottom sites that came before X, where ordered
};

struct LocationOptions {
  std::vector<std::size_t> sizes{100, 1000, 10000, 100000};
  std::vector<std::string> kinds{"uniform", "gaussian", "clusters", "circle", "parabola", "lattice"};
  std::vector<std::size_t> bad_sizes{100, 1000, 10000};
  int runs = 5;
  int bad_runs = 100;
  std::uint64_t seed = 1;
  Progress progress = {};
};

struct LocationResult {
  std::vector<LocationRow> rows;  ///< by kind, then size
  std::vector<BadSiteRow> bad;
  std::vector<RandomBadSiteRow> random_bad;
};
/// @throws InputError for unknown kinds; Cancelled
LocationResult run_location(const LocationOptions& options);

}  // namespace delone::lab
