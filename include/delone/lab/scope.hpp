// Scopes of triangles and symmetric scopes of edges: how likely they are ever to be Delaunay.
// Source: [GKS92] 2.1 (scope, lemmas 2.1 and 2.2, theorem 2.3), 2.2 (symmetric scope, lemmas 2.4 and 2.5).
//
// The scope of a triangle is the number of sites inside its circumcircle. For an edge XY with l sites on its left,
// circles through X and Y sweep over all others. When such a circle meets a site p on the left, let y of the left sites
// and x of the right ones be inside: the path of [GKS92] figure 3 goes downward from (x, y + 1). Hence
//   the k-th from last step downward is that of the p with y = k - 1, and x_k + k - 1 is the scope of XYp;
//   XY appears with probability a_l + sum over p on the left of b_(scope of XYp),
//   a_k = 2/((k+1)(k+2)), b_k = 4/((k+1)(k+2)(k+3));
//   the symmetric scope w, the side of the largest square below the path, is the number of p with x > y.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/geometry/points.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// [GKS92] lemma 2.1: 6/((k+1)(k+2)(k+3)).
double triangle_probability(std::size_t scope);
/// [GKS92] lemma 2.4: at most 2 a_w - a_2w, which is less than 4/((w+1)(w+2)); the remark after it: at least a_2w.
double edge_probability_most(std::size_t symmetric_scope);
double edge_probability_least(std::size_t symmetric_scope);
/// [GKS92] theorem 2.3: the sum of 6 ||T_k|| / ((k+1)(k+2)(k+3)). @param counts  ||T_0||, ||T_1||, ...
double expected_triangles(std::span<const std::size_t> counts);

/// [GKS92] lemma 2.2: triangles of scope at most k; min over r of 2r C(n,r) / C(n-k-3,r-3), or all where that is less.
double triangles_up_to_scope_bound(std::size_t n, std::size_t k);
/// [GKS92] lemma 2.5: edges of symmetric scope at most k; min over r of 3r C(n,r) / C(n-2k-2,r-2), or all.
double edges_up_to_scope_bound(std::size_t n, std::size_t k);

/// All triangles and edges of n sites. Triangle a < b < c has number C(c,3) + C(b,2) + a, edge a < b has C(b,2) + a.
struct Scopes {
  std::size_t n = 0;
  std::vector<std::size_t> of_triangle, of_edge;
  std::vector<double> edge_probability;                 ///< of each edge, exactly as in [GKS92] (4)
  std::vector<std::size_t> triangle_count, edge_count;  ///< by scope: ||T_k||, k <= n - 3, and ||E_w||, w < n/2
};
std::size_t triangle_number(std::size_t a, std::size_t b, std::size_t c);
std::size_t edge_number(std::size_t a, std::size_t b);

inline constexpr std::size_t kMostScopeSites = 64;  ///< a set of sites is a word

/// @throws InputError unless there are 3 to 64 points in the plane, no three collinear and no four on a circle
/// Cost: O(n^4) exact tests.
Scopes count_scopes(PointsView points);

/// What appeared in random orders, by scope: the share of the triangles, and of the edges, of that scope. Estimates are
/// over runs; classes that are empty have zeros.
struct ScopeSimulation {
  Estimate triangles, edges;  ///< how many ever appeared
  std::vector<Estimate> triangle_share, edge_share;
};
/// @throws Cancelled
ScopeSimulation simulate_scopes(PointsView points, const Scopes& scopes, int runs, std::uint64_t seed,
                                const Progress& progress = {});

}  // namespace delone::lab
