// How many flips flipping takes, and where it gets stuck.
// Source: [For92] 4.2 (the bound of n (n - 1) / 2, the example of figure 8, flips in random order), [GKS92] 3 (their
// expected number), [ES96] 5 (figure 5.1: weights on which flips that follow no order get stuck).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/base/progress.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// Flips by site: of Lawson's method from the sorted triangulation, and of sites inserted in random order, which is 3
/// less than the mean degree at which a site comes in.
struct FlipCounts {
  std::string distribution;
  std::size_t n = 0;
  Estimate lawson, incremental;
};

struct FlipCountOptions {
  std::vector<std::string> distributions{"uniform", "gaussian", "clusters", "ellipse", "parabola"};
  std::vector<std::size_t> sizes{500, 1000, 2000, 4000, 8000, 16000};
  int runs = 3;
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// Rows by distribution, then size.
std::vector<FlipCounts> run_flip_counts(const FlipCountOptions& options);
/// The exponent e of the fit flips = c n^e to the counts of Lawson's method, by least squares in logarithms.
double lawson_exponent(const std::vector<FlipCounts>& counts, const std::string& distribution);

/// Sites in convex position, half of them in each of two flat rows, and a triangulation of which every way to
/// Delaunay's that flips only edges that are not locally Delaunay takes (n/2 - 1)^2 flips.
///
/// The upper row goes from (-1, 1) to the left and the lower one from (1, 0) to the right, m sites each, both bent
/// outwards so little that the circle of any three sites of a row contains the other row. Every triangle has its base
/// in one row and its apex in the other, and keeps to that: a flip that would cut an ear off a row is none of
/// Delaunay's. So a triangulation is a way from left to right with m - 1 steps up and m - 1 down, and a flip exchanges
/// two steps that are neighbours. At the start the lower steps come first, in Delaunay's they come last.
struct ForcedFlips {
  std::size_t n = 0;
  std::uint64_t queue = 0, stack = 0, random = 0;  ///< flips, by the order in which edges are looked at
  std::uint64_t enough = 0;                        ///< flips that would do if any edge may be flipped
  bool convex = false;                             ///< all sites are on the hull
  bool delaunay = false;                           ///< all three ended at Delaunay's triangulation
};

/// @param m  sites in each row, 2 to 2^20
ForcedFlips run_forced_flips(std::size_t m, std::uint64_t seed);

/// [ES96] figure 5.1: six weighted sites, a triangulation of them, and what its inner edges allow.
struct StuckFlips {
  struct Edge {
    Index a, b;
    bool regular;    ///< the lifted surface is convex along the edge
    bool flippable;  ///< its two triangles make a strictly convex quadrilateral
  };
  std::vector<std::array<double, 2>> points;
  std::vector<double> weights;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Edge> edges;
  std::size_t least_degree = 0;                    ///< of the inner sites: a flip that removes one wants degree 3
  std::vector<std::array<Index, 3>> by_insertion;  ///< the regular triangulation, from flips as sites come in
  std::vector<std::array<Index, 3>> by_cavities;   ///< the same without flips
  std::size_t hidden = 0;

  /// No edge that is not regular can be flipped, and no site can be removed.
  bool stuck() const;
};

StuckFlips run_stuck_flips();

}  // namespace delone::lab
