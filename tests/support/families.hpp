// Point sets that are hard in one way each: what the laws are tried on. The same seed gives the same points everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "delone/geometry/points.hpp"

namespace delone::test {

using Random = std::mt19937_64;

/// From 0 to 1, 53 random bits.
double unit_random(Random& random);

struct PointSet {
  std::string name;
  int dimension = 1;
  std::vector<double> coordinates;
  std::vector<double> weights = {};

  PointsView view() const { return PointsView(coordinates, dimension, weights); }
  std::size_t size() const { return coordinates.size() / static_cast<std::size_t>(dimension); }
};

std::ostream& operator<<(std::ostream& out, const PointSet& points);  ///< name, dimension and every bit of the numbers

PointSet uniform(int dimension, std::size_t n, std::uint64_t seed);
/// Integers from 0 to `side` - 1: lines, circles and duplicates in every direction.
PointSet lattice(int dimension, std::size_t n, int side, std::uint64_t seed);
/// Signed permutations of (1, 2, ..., D): distinct points of one sphere, while there are enough of them.
PointSet cospherical(int dimension, std::size_t n, std::uint64_t seed);
/// Small integer combinations of `rank` skew vectors, off the origin.
PointSet flat(int dimension, int rank, std::size_t n, std::uint64_t seed);
/// As close to a circle (in the first two axes; the others are 0 or 1) as 24-bit integers come.
PointSet circle_of_24_bits(int dimension, std::size_t n, std::uint64_t seed);

PointSet with_random_weights(PointSet points, std::uint64_t seed);

/// Every family, without weights and with weights that are equal, tied, random and extreme.
std::vector<PointSet> families(int dimension, std::size_t n, std::uint64_t seed);
std::vector<PointSet> unweighted_families(int dimension, std::size_t n, std::uint64_t seed);

/// The same points with rows in another order. @param order  row i of the result is row order[i]
PointSet permuted(const PointSet& points, const std::vector<std::size_t>& order);
std::vector<std::size_t> random_permutation(std::size_t n, Random& random);
/// Rows `first` to `last` - 1.
PointSet rows(const PointSet& points, std::size_t first, std::size_t last);

}  // namespace delone::test
