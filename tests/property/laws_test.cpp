// Laws that hold for every point set: what no list of examples could say (DESIGN: free oracles).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/mesh/export.hpp"
#include "exact/integer.hpp"
#include "support/brute_force.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

constexpr std::uint64_t kSeeds = 2;

/// As many points as trying every subset allows.
std::size_t few(int dimension) {
  constexpr std::array<std::size_t, 7> kFew{0, 12, 11, 10, 8, 8, 8};
  return kFew[static_cast<std::size_t>(dimension)];
}

/// Calls law(points) for every family, with and without weights, in dimensions 1 to 6.
template <class Law>
void for_all_families(const Law& law, int last_dimension = 6, std::uint64_t seeds = kSeeds) {
  for (int dimension = 1; dimension <= last_dimension; ++dimension) {
    for (std::uint64_t seed = 1; seed <= (dimension < 4 ? seeds : 1); ++seed) {
      for (const PointSet& points : families(dimension, few(dimension), seed)) {
        SCOPED_TRACE(points.name + ", dimension " + std::to_string(dimension) + ", seed " + std::to_string(seed));
        law(points);
      }
    }
  }
}

TEST(Laws, cells_and_statuses_are_those_of_trying_every_subset) {
  for_all_families([](const PointSet& points) {
    const AnyTriangulation t = built(points);
    EXPECT_EQ(differs_from_brute_force(t, points), "") << points;
    EXPECT_EQ(broken_invariant(t), "") << points;
  });
}

TEST(Laws, the_exact_check_passes_and_counts_alike) {
  for_all_families([](const PointSet& points) { EXPECT_EQ(fails_check(built(points), points), "") << points; });
}

TEST(Laws, the_exact_check_passes_on_larger_sets) {
  for (int dimension = 2; dimension <= 5; ++dimension) {
    const std::size_t n = dimension == 2 ? 2000 : dimension == 3 ? 800 : dimension == 4 ? 150 : 50;
    for (const PointSet& points :
         {uniform(dimension, n, 1), lattice(dimension, n, dimension == 2 ? 30 : 6, 2), cospherical(dimension, n, 3),
          circle_of_24_bits(dimension, n, 4), flat(dimension, dimension - 1, n, 5),
          with_random_weights(uniform(dimension, n, 6), 7), with_random_weights(lattice(dimension, n, 6, 8), 9)}) {
      const AnyTriangulation t = built(points);
      EXPECT_EQ(fails_check(t, points), "") << points.name << ' ' << dimension;
      EXPECT_EQ(broken_invariant(t), "") << points.name << ' ' << dimension;
    }
  }
}

TEST(Laws, the_order_of_rows_does_not_change_the_hash) {
  Random random(1);
  for_all_families(
      [&](const PointSet& points) {
        const std::uint64_t hash = canonical_hash(built(points));
        for (int trial = 0; trial < 3; ++trial) {
          const PointSet other = permuted(points, random_permutation(points.size(), random));
          EXPECT_EQ(canonical_hash(built(other)), hash) << points;
        }
      },
      5, 2);
}

TEST(Laws, the_order_of_rows_does_not_change_the_hash_of_larger_sets) {
  Random random(2);
  for (int dimension = 1; dimension <= 5; ++dimension) {
    const std::size_t n = dimension < 4 ? 3000 : 100;
    for (const PointSet& points :
         {uniform(dimension, n, 1), lattice(dimension, n, dimension < 3 ? 40 : 9, 2),
          circle_of_24_bits(dimension, n, 4), with_random_weights(lattice(dimension, n, 20, 5), 6)}) {
      const PointSet other = permuted(points, random_permutation(points.size(), random));
      EXPECT_EQ(canonical_hash(built(other)), canonical_hash(built(points))) << points.name << ' ' << dimension;
    }
  }
}

TEST(Laws, equal_weights_are_no_weights) {
  for_all_families(
      [](const PointSet& points) {
        if (!points.weights.empty()) return;
        const AnyTriangulation plain = built(points);
        for (const double weight : {0.0, -3.5, 1e300, 5e-324}) {
          PointSet equal = points;
          equal.weights.assign(points.size(), weight);
          const AnyTriangulation t = built(equal);
          EXPECT_EQ(cells(t).vertices, cells(plain).vertices) << points;
          for (Index row = 0; row < points.size(); ++row) EXPECT_EQ(t.status(row), plain.status(row));
        }
      },
      5, 2);
}

/// Merged by hand: cells across a facet on one orthosphere, found by trying every subset of vertices is too slow;
/// instead the points on each cell's orthosphere are collected one by one.
bool on_orthosphere(const PointSet& points, const std::vector<Index>& cell, Index q) {
  // In a set of the cell's points and q alone, q and the cell are cospherical if merging leaves one polytope of all.
  PointSet few{"cell and point", points.dimension, {}, {}};
  std::vector<std::size_t> chosen(cell.begin(), cell.end());
  chosen.push_back(q);
  few = permuted(points, chosen);
  const PolytopeTable merged = merged_cells(built(few));
  return merged.size() == 1 && merged[0].size() == chosen.size();
}

TEST(Laws, merged_cells_do_not_depend_on_the_order_of_rows_and_split_into_the_cells) {
  Random random(3);
  for_all_families(
      [&](const PointSet& points) {
        const AnyTriangulation t = built(points);
        const PolytopeTable merged = merged_cells(t);
        std::size_t covered = 0;
        for (const auto& cell : sorted_cells(t)) {
          std::size_t homes = 0;
          for (std::size_t p = 0; p < merged.size(); ++p) homes += std::ranges::includes(merged[p], cell) ? 1 : 0;
          EXPECT_EQ(homes, 1U) << points;
          covered += homes;
        }
        EXPECT_EQ(covered, t.cell_count());
        // Names of rows aside, another order of rows gives the same polytopes.
        const auto order = random_permutation(points.size(), random);
        const AnyTriangulation other = built(permuted(points, order));
        std::vector<std::vector<std::vector<double>>> mine, theirs;
        const auto places = [](const AnyTriangulation& from, const PolytopeTable& table) {
          std::vector<std::vector<std::vector<double>>> all;
          for (std::size_t p = 0; p < table.size(); ++p) {
            all.emplace_back();
            for (const Index row : table[p]) all.back().push_back(from.point(row));
            std::ranges::sort(all.back());
          }
          std::ranges::sort(all);
          return all;
        };
        EXPECT_EQ(places(t, merged), places(other, merged_cells(other))) << points;
      },
      4, 2);
}

TEST(Laws, merged_cells_are_all_points_of_an_orthosphere) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const PointSet& points :
         {lattice(dimension, 12, 3, 1), cospherical(dimension, 10, 2), uniform(dimension, 10, 3)}) {
      const AnyTriangulation t = built(points);
      if (t.affine_dimension() < dimension) continue;
      const PolytopeTable merged = merged_cells(t);
      for (const auto& cell : sorted_cells(t)) {
        std::vector<Index> expected = cell;
        for (Index row = 0; row < points.size(); ++row) {
          if (t.status(row).status != Status::vertex || std::ranges::find(cell, row) != cell.end()) continue;
          if (on_orthosphere(points, cell, row)) expected.push_back(row);
        }
        std::ranges::sort(expected);
        const auto home = [&](std::size_t p) { return std::ranges::equal(merged[p], expected); };
        std::size_t found = 0;
        for (std::size_t p = 0; p < merged.size(); ++p) found += home(p) ? 1 : 0;
        EXPECT_EQ(found, 1U) << points;
      }
    }
  }
}

TEST(Laws, eulers_formula_counts_the_triangles_of_points_in_general_position) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const std::size_t n : {3U, 10U, 200U, 3000U}) {
      const AnyTriangulation t = built(uniform(2, n, seed));
      EXPECT_EQ(t.cell_count(), 2 * n - t.hull_facet_count() - 2);
    }
  }
}

TEST(Laws, the_mean_degree_of_random_points_is_six_in_2d_and_fifteen_and_a_half_in_3d) {
  // Far from the hull; with it, degrees are a little lower.
  const std::size_t n = 20000;
  const AnyTriangulation plane = built(uniform(2, n, 1));
  const double edges = static_cast<double>(3 * plane.cell_count() + plane.hull_facet_count()) / 2;
  EXPECT_NEAR(2 * edges / static_cast<double>(n), 6.0, 0.02);
  const AnyTriangulation space = built(uniform(3, n, 1));
  const auto tetrahedra = static_cast<double>(space.cell_count());
  const double triangles = (4 * tetrahedra + static_cast<double>(space.hull_facet_count())) / 2;
  EXPECT_NEAR(2 * (static_cast<double>(n) - 1 + triangles - tetrahedra) / static_cast<double>(n), 15.54, 0.5);
}

TEST(Laws, scaling_by_powers_of_two_and_shifting_a_grid_change_nothing) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    for (const PointSet& points : {lattice(dimension, 20, 4, 1), lattice(dimension, 15, 50, 2),
                                   cospherical(dimension, 15, 3), flat(dimension, 2, 15, 4)}) {
      const std::uint64_t hash = canonical_hash(built(points));
      for (const int exponent : {-1000, -300, -1, 60, 300, 1000}) {
        PointSet scaled = points;
        for (double& x : scaled.coordinates) x = std::ldexp(x, exponent);
        EXPECT_EQ(canonical_hash(built(scaled)), hash) << points << " times 2^" << exponent;
      }
      for (const double shift : {1.0, -1e6, 0x1p40}) {
        PointSet shifted = points;
        for (double& x : shifted.coordinates) x += shift;
        EXPECT_EQ(canonical_hash(built(shifted)), hash) << points << " plus " << shift;
      }
    }
  }
}

TEST(Laws, moving_and_turning_by_signs_and_axes_keeps_the_merged_cells) {
  for (int dimension = 2; dimension <= 4; ++dimension) {
    for (const PointSet& points :
         {lattice(dimension, 25, 4, 1), cospherical(dimension, 15, 2), uniform(dimension, 25, 3)}) {
      PointSet turned = points;  // axes in reverse order, one of them mirrored
      const auto d = static_cast<std::size_t>(dimension);
      for (std::size_t row = 0; row < points.size(); ++row) {
        for (std::size_t axis = 0; axis < d; ++axis) {
          const double x = points.coordinates[row * d + d - 1 - axis];
          turned.coordinates[row * d + axis] = axis == 0 ? -x : x;
        }
      }
      const PolytopeTable before = merged_cells(built(points));
      EXPECT_EQ(merged_cells(built(turned)).vertices, before.vertices) << points;
      EXPECT_EQ(merged_cells(built(turned)).offsets, before.offsets);
    }
  }
}

/// The flat of the first k axes, lifted into D dimensions by integer combinations: distances change by an affine map,
/// so the truth is a regular triangulation of the flat points with the lifted heights as weights.
TEST(Laws, flat_input_agrees_with_its_projection_under_the_lifted_heights) {
  for (int dimension = 2; dimension <= 5; ++dimension) {
    for (int k = 1; k < dimension; ++k) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const PointSet base = lattice(k, 14, 5, seed);
        PointSet lifted{"lifted", dimension, {}, {}};
        PointSet projected = base;
        for (std::size_t row = 0; row < base.size(); ++row) {
          double others = 0.0;
          for (int axis = 0; axis < dimension; ++axis) {
            double x = 3.0;
            for (int j = 0; j < k; ++j) {
              const double step = base.view()[row][static_cast<std::size_t>(j)];
              x += axis < k ? (axis == j ? step : 0.0) : static_cast<double>((axis + j) % 3 - 1) * step;
            }
            if (axis < k) projected.coordinates[row * static_cast<std::size_t>(k) + static_cast<std::size_t>(axis)] = x;
            if (axis >= k) others += x * x;
            lifted.coordinates.push_back(x);
          }
          projected.weights.push_back(-others);
        }
        EXPECT_EQ(sorted_cells(built(lifted)), sorted_cells(built(projected))) << lifted;
      }
    }
  }
}

TEST(Laws, flat_input_in_a_coordinate_plane_is_the_plane) {
  for (int dimension = 2; dimension <= 6; ++dimension) {
    const PointSet plane = lattice(dimension - 1, 20, 3, 1);
    for (int where = 0; where < dimension; ++where) {
      PointSet wall{"wall", dimension, {}, {}};
      for (std::size_t row = 0; row < plane.size(); ++row) {
        const auto x = plane.view()[row];
        wall.coordinates.insert(wall.coordinates.end(), x.begin(), x.begin() + where);
        wall.coordinates.push_back(7.25);
        wall.coordinates.insert(wall.coordinates.end(), x.begin() + where, x.end());
      }
      EXPECT_EQ(cells(built(wall)).vertices, cells(built(plane)).vertices);
      EXPECT_EQ(cells(built(wall)).neighbours, cells(built(plane)).neighbours);
    }
  }
}

TEST(Laws, the_lower_hull_of_the_lift_is_the_triangulation) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const PointSet points = uniform(dimension, 25, 5);
    PointSet integers = points;  // few bits, so that the lift is exact
    for (double& x : integers.coordinates) x = std::floor(x * 1024);
    PointSet lifted{"lifted", dimension + 1, {}, {}};
    for (std::size_t row = 0; row < integers.size(); ++row) {
      double height = 0.0;
      for (const double x : integers.view()[row]) {
        lifted.coordinates.push_back(x);
        height += x * x;
      }
      lifted.coordinates.push_back(height);
    }
    const AnyTriangulation hull = built(lifted);
    const CellTable facets = hull_facets(hull);
    std::vector<std::vector<Index>> lower;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      // Downwards: a point far below is beyond the facet, so it changes the hull there.
      std::vector<std::size_t> chosen(facets[f].begin(), facets[f].end());
      PointSet simplex = permuted(lifted, chosen);
      for (const double x : lifted.view()[facets[f][0]].first(static_cast<std::size_t>(dimension))) {
        simplex.coordinates.push_back(x);
      }
      simplex.coordinates.push_back(-1e9);
      const auto below = static_cast<Index>(dimension + 1);
      // With outward normals, the facet sees the point below if the simplex of both turns as the facet does.
      const CellTable cell = cells(built(simplex));
      if (cell.size() != 1) continue;
      std::vector<Index> sorted(chosen.begin(), chosen.end());
      std::vector<Index> corner(cell[0].begin(), cell[0].end());
      // Orientation of (facet as given, below): the cell's rows are a permutation of 0 .. dimension + 1.
      bool odd = false;
      for (std::size_t i = 0; i < corner.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) odd ^= corner[j] > corner[i];
      }
      const bool positive = !odd;  // (0, 1, ..., below) is positive
      const bool beyond = positive == ((dimension + 1) % 2 != 0);
      std::ranges::sort(sorted);
      if (beyond) lower.push_back(sorted);
      EXPECT_EQ(below, corner.size() - 1);
    }
    std::ranges::sort(lower);
    EXPECT_EQ(lower, sorted_cells(built(integers))) << dimension;
  }
}

}  // namespace
}  // namespace delone
