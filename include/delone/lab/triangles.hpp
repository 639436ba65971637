// How many triangles and edges ever come to be when sites are inserted one by one.
// Source: [Slides] lemma 2 (all triangles that flips make: at most 9n + 1 are expected in random order);
//         [GKS92] theorem 2.3 (those that are Delaunay at some time: O(n)) and figure 1 (an order that takes n^2).
//
// The bounds here are those of [Slides]' proof for one ghost vertex in place of three far points. After r insertions
// the triangulation of the sphere by r sites and the ghost has 3 (r + 1) - 6 edges, and the ghost is on at least three;
// so the degrees of the sites add up to 6 r - 9 at most, and the last of r sites in random order has an expected degree
// of at most 6 - 9/r. A site of degree k ends k triangles, ghosts included, and takes k edges; flips make 2k - 3
// triangles for it, of which k - 3 go again at once. The first three sites come with 4 triangles and 6 edges. Thus
//   by flips       4 + sum over r = 4 .. n of (9 - 18/r)  <  9n
//   Delaunay       4 + sum over r = 4 .. n of (6 -  9/r)  <  6n
//   edges          6 + the same sum                       <  6n
// with equality where the hull is a triangle at all times. Edges are the same in both: [Slides] lemma 1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/build/method.hpp"
#include "delone/geometry/points.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// Expected numbers for n sites in random order are at most these. Zero for n < 3.
double flipped_triangles_bound(std::size_t n);
double delaunay_triangles_bound(std::size_t n);
double created_edges_bound(std::size_t n);

/// What was created for sites in the plane, those at the ghost vertex and those of the first triangle included.
struct Created {
  std::size_t sites = 0;
  double triangles = 0;
  /// Of a method that flips, else 0. The first flip of an insertion, one triangle to three, makes three edges, any
  /// other one.
  double edges = 0;
};
/// @throws InputError for a method that takes no order. Requires points that are not collinear.
Created count_created(PointsView points, Method method, Order order, std::uint64_t seed);

/// One distribution and size; the sites are the same in all runs, their order is not.
struct TrianglesRow {
  std::string kind;
  std::size_t n = 0;  ///< different sites
  Estimate by_flips, delaunay, edges;
};

/// [GKS92] figure 1: all lower sites, then the upper ones from right to left; and the same sites in random order.
struct FigureOneRow {
  std::size_t n = 0;
  double by_flips = 0, delaunay = 0;  ///< from right to left
  Estimate random_by_flips, random_delaunay;
};
/// Exactly what an order from right to left takes: each of the U upper sites but the first meets all L lower ones, the
/// upper one before it and the ghost. So 4 + 3 (L - 2) + (U - 1)(2L + 1) by flips, 4 + 3 (L - 2) + (U - 1)(L + 2)
/// Delaunay. Requires n > 4.
double figure_one_by_flips(std::size_t n);
double figure_one_delaunay(std::size_t n);

struct TrianglesOptions {
  std::vector<std::size_t> sizes{100, 1000, 10000};
  std::vector<std::string> kinds;  ///< none for all that exist in the plane
  std::vector<std::size_t> figure_one_sizes{250, 500, 1000, 2000};
  int runs = 10;
  std::uint64_t seed = 1;
  Progress progress = {};
};

struct TrianglesResult {
  std::vector<TrianglesRow> rows;  ///< by kind, then size
  std::vector<FigureOneRow> figure_one;
};
/// @throws InputError for unknown kinds; Cancelled
TrianglesResult run_triangles(const TrianglesOptions& options);

}  // namespace delone::lab
