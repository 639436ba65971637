// How many triangles come to be when n sites are added in random order to m that are there already.
// Source: [GKS92] 2.3, theorem 2.6: O(m log n + n), which is tight in the worst case.
//
// A bound with constants, by looking backward as the remark after theorem 2.6 suggests. After i of the new sites the
// triangulation of the sphere has m + i + 1 vertices with the ghost, so 3 (m + i + 1) - 6 edges; at most 3i - 6 of them
// join two new sites, and at most 2 (m + i + 1) - 4 join a new one to one of the others. Hence the degrees of the new
// sites add up to at most
//   3m + 6i - 9  and  2m + 8i - 14        (i >= 3)
// and the last of them, which ends as many triangles as it has neighbours, is expected to end a 1/i of that; but never
// more than m + i. The sum over i is less than 2m H(n) + 8n.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// At most so many triangles, those at the ghost vertex included, are expected to be Delaunay at some time after the
/// first m sites. Requires m >= 3.
double added_triangles_bound(std::size_t m, std::size_t n);

/// m H(n) + n.
double added_triangles_scale(std::size_t m, std::size_t n);

/// What the worst case of run_batch is expected to take, exactly: (m - 3) H(n) + 4n. A new site that is the leftmost so
/// far meets all m - 1 old ones on the x axis, the upper site to its right and the ghost; there are H(n) of these. Any
/// other one meets its two upper neighbours, (-1, 0) and the ghost.
double worst_case_expected(std::size_t m, std::size_t n);

struct BatchRow {
  std::size_t m = 0, n = 0;
  /// Triangles made by the n sites, those at the ghost included.
  Estimate uniform;  ///< all points evenly in a square
  Estimate worst;    ///< [GKS92] 2.3: old sites on the negative x axis, new ones on the positive part of y = 1
};

struct BatchOptions {
  std::vector<std::size_t> old_sizes{100, 1000, 10000};
  std::vector<std::size_t> new_sizes{10, 100, 1000, 10000};
  int runs = 20;
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// By m, then n. In the worst case one of the m sites lies on y = 1, to the right of all new ones, so that the old ones
/// are not collinear.
/// @throws InputError unless all m are 3 or more; Cancelled
std::vector<BatchRow> run_batch(const BatchOptions& options);

}  // namespace delone::lab
