// How many tetrahedra come to be when points in space are inserted one by one.
// Source: [GKS92] 4.3: theorem 4.6 (O(n^2) in random order), theorem 4.7 (by the sizes of random samples), and the
// example of 2n + 1 points whose last one, zeta, makes a quadratic triangulation linear.
//
// Theorem 4.7 bounds the number by O(sum of F(n/k)/k), where F(r) is the expected size of the triangulation of r random
// sites. Looked at backward this is an equation: a tetrahedron of the triangulation of the first r has the last of them
// for a corner with probability 4/r, so that
//   tetrahedra expected to appear = sum over r = 4 .. n of 4 F(r) / r.
// Ghosts, which have three corners, are left out on both sides. Of the example, r random points have about r^2/4
// tetrahedra while zeta is not among them, which it is with probability r/n: so about n^2/6 appear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/base/progress.hpp"
#include "delone/geometry/points.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// What the example makes, exactly: ((n - 3) / 2)^2 tetrahedra before zeta, 2n - 6 with it. Requires an odd n >= 7.
double zeta_before(std::size_t n);
double zeta_after(std::size_t n);

/// What one insertion after the other brought about in space, ghosts not counted.
struct Appeared {
  double tetrahedra = 0;  ///< that were Delaunay at some time
  double most = 0;        ///< at one time
  double last = 0;        ///< in the end
  double samples = 0;     ///< the sum over r of 4 F(r) / r, with what the first r sites have for F(r)
};
/// @param order  of the rows of `points`
Appeared count_appeared(PointsView points, std::span<const Index> order);

struct SpheresRow {
  std::string kind;
  bool random = true;  ///< else the order of the rows: of gks-zeta, zeta comes last
  std::size_t n = 0;
  Estimate tetrahedra, samples, most, last;
};

struct SpheresOptions {
  std::vector<std::size_t> uniform_sizes{100, 1000, 10000};
  std::vector<std::size_t> zeta_sizes{65, 129, 257, 513, 1025};
  int runs = 20;
  int zeta_runs = 100;  ///< of gks-zeta: much depends on when zeta comes
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// Uniform points in random order, gks-zeta in order, gks-zeta in random order; each by size.
/// @throws Cancelled
std::vector<SpheresRow> run_spheres(const SpheresOptions& options);

}  // namespace delone::lab
