// What the Delaunay triangulation is best at: angles in the plane, min-containment balls in every dimension.
// Source: [For92] 3.1: lemma 3.1 with the sequences of its proof, lemma 3.2, and Mount and Saalfeld's completion.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// Delaunay's triangulation against one kind of others of the same sites, over some runs. The laws hold when each count
/// is that of the runs. Angles are compared exactly; radii as doubles, of which the rounding is allowed for.
struct Comparison {
  std::string other;
  double flips = 0;  ///< random flips by site, if that is how the others are made
  int runs = 0;
  Estimate delaunay_angle, other_angle;    ///< the smallest, in degrees; in the plane only
  Estimate delaunay_radius, other_radius;  ///< of the largest min-containment ball, by the extent of the sites
  int angle_at_least = 0;                  ///< runs in which Delaunay's smallest angle is not less than the other's
  int sequence_at_least = 0;               ///< ... its ascending sequence of angles is lexicographically not less
  int radius_at_most = 0;                  ///< ... its largest radius is not more than the other's
};

struct ComparisonOptions {
  std::size_t plane_sites = 500, space_sites = 300;  ///< without those on the border of the square or cube
  int runs = 10;
  std::uint64_t seed = 1;
  std::vector<double> flips{0.01, 0.1, 1, 10, 100};  ///< by site
  std::vector<double> stretches{1, 10, 100};         ///< see compare_in_space
  Progress progress = {};
};

/// Others: the sorted triangulation; Delaunay's after random flips; Delaunay's of the plane stretched in a random
/// direction.
std::vector<Comparison> compare_in_plane(const ComparisonOptions& options);
/// Others: regular triangulations by other heights that hide no site. Heights |x|^2 + c (v x)^2 with a random v, which
/// are those of a space stretched in this direction; and |x|^2 less random weights, as large as hide no site.
std::vector<Comparison> compare_in_space(const ComparisonOptions& options);

/// Two completions of one Delaunay triangulation with cocircular sites: Delone's usual one, and the most equiangular.
struct Completion {
  std::string points;
  std::size_t n = 0;
  std::size_t polygons = 0, most_corners = 0;  ///< with more than three corners on a circle
  std::size_t differ_at = 0;                   ///< place in the ascending sequences of angles, from 1 on; 0: nowhere
  double canonical_there = 0, equiangular_there = 0;  ///< degrees
  bool at_least = false;                              ///< the equiangular sequence is not less than the other; exact
  std::vector<double> canonical, equiangular;         ///< the sequences, in degrees
};

/// Lattice, sites of a coarse grid, and 12 to 60 sites on a circle.
std::vector<Completion> compare_completions(std::uint64_t seed);

}  // namespace delone::lab
