// What is not the triangulation is not proven, whatever it lacks.
#include "mesh/found_cells.hpp"

#include <gtest/gtest.h>

#ifdef DELONE_SIXTEENS

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/mesh/export.hpp"
#include "mesh/anew.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

using Triangles = std::vector<std::array<Index, 3>>;

Sites sites_of(const PointSet& points) {
  Sites sites(2, false, Flat{2, {0, 1}});
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  sites.append(points.view(), order, 0);
  return sites;
}

/// In such an order that each but the first shares an edge, that of its first two corners, with one before.
Triangles grown(Triangles triangles) {
  for (std::size_t done = 1; done < triangles.size(); ++done) {
    for (std::size_t next = done; next < triangles.size(); ++next) {
      const auto shares = [&](std::array<Index, 3> t) {
        return std::any_of(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(done), [&](auto& other) {
          return std::ranges::find(other, t[0]) != other.end() && std::ranges::find(other, t[1]) != other.end();
        });
      };
      auto& t = triangles[next];
      for (int turn = 0; turn < 3 && !shares(t); ++turn) std::ranges::rotate(t, t.begin() + 1);
      if (!shares(t)) continue;
      std::swap(triangles[done], t);
      break;
    }
  }
  return triangles;
}

/// Triangles and, on the left of edges that have none there, ghosts.
FoundCells found(std::size_t sites, const Triangles& triangles) {
  Triangles cells = grown(triangles);
  const auto ghost = static_cast<Index>(sites);
  std::map<std::pair<Index, Index>, Index> facets;  // by the edge as the cell sees it
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      facets[{cells[c][(i + 1) % 3], cells[c][(i + 2) % 3]}] = static_cast<Index>(4 * c + i);
    }
  }
  for (const auto& [edge, f] : std::map(facets)) {
    const auto [a, b] = edge;
    if (facets.contains({b, a})) continue;
    const auto c = static_cast<Index>(cells.size());
    cells.push_back({b, a, ghost});
    facets[{a, ghost}] = 4 * c;
    facets[{ghost, b}] = 4 * c + 1;
    facets[{b, a}] = 4 * c + 2;
  }
  FoundCells result(sites);
  result.count = cells.size();
  for (std::size_t c = 0; c < cells.size(); ++c) std::ranges::copy(cells[c], result.corners[c].begin());
  for (const auto& [edge, f] : facets) {
    const Index twin = facets.at({edge.second, edge.first});
    result.glue(f, twin);
    if (f < twin && f % 4 != 2 && twin % 4 != 2) result.met[result.met_count++] = f;
  }
  return result;
}

bool proven(const PointSet& points, const FoundCells& cells) {
  Mesh mesh(sites_of(points));
  return prove(mesh, sixteen::InPlane(mesh.sites), cells);
}
bool proven(const PointSet& points, const Triangles& triangles) {
  return proven(points, found(points.size(), triangles));
}

Triangles triangles_of(const PointSet& points) {
  Triangles triangles;
  const auto table = cells(build<2>(points.view()));
  for (std::size_t c = 0; c < table.size(); ++c) triangles.push_back({table[c][0], table[c][1], table[c][2]});
  return triangles;
}

/// Two triangles that share an edge, and it is flipped.
Triangles flipped(Triangles triangles, std::size_t t, std::size_t u) {
  auto& [a, b, c] = triangles[t];
  auto& other = triangles[u];
  while (std::ranges::find(other, a) != other.end()) std::ranges::rotate(triangles[t], triangles[t].begin() + 1);
  while (other[0] == b || other[0] == c) std::ranges::rotate(other, other.begin() + 1);
  const Index d = other[0];
  other = {a, d, c};
  c = d;
  return triangles;
}

const PointSet kSquare{"square", 2, {0, 0, 1, 0, 1, 1, 0, 1}, {}};

/// Also where ties or collinear sites leave much to exact tests; unless doubles do not tell an orientation.
TEST(FoundCells, the_triangulation_is_proven) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  std::size_t proofs = 0, all = 0;
  for (std::size_t n = 4; n < 30; ++n) {
    std::vector<PointSet> sets = unweighted_families(2, n, n);
    for (const PointSet& points : {uniform(2, n, n), cospherical(2, n, n), lattice(2, n, 30, n)}) {
      const AnyTriangulation t = built(points);
      if (t.affine_dimension() != 2 || t.duplicate_count() > 0) continue;
      EXPECT_TRUE(proven(points, triangles_of(points))) << points;
      sets.push_back(points);
    }
    for (const PointSet& points : sets) {
      const AnyTriangulation t = built(points);
      if (t.affine_dimension() != 2 || t.duplicate_count() > 0) continue;
      Mesh mesh(sites_of(points));
      const sixteen::InPlane sites(mesh.sites);
      ++all;
      if (!sites.usable() || !prove(mesh, sites, found(n, triangles_of(points)))) continue;
      ++proofs;
      const AnyTriangulation filled(std::move(mesh));
      EXPECT_EQ(broken_invariant(filled), "") << points;
      EXPECT_EQ(description(filled), description(t)) << points;
    }
  }
  EXPECT_GT(proofs, all * 2 / 3);
}

TEST(FoundCells, no_other_diagonal_is) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  const Triangles one{{0, 1, 2}, {0, 2, 3}}, other{{1, 2, 3}, {1, 3, 0}};
  EXPECT_NE(proven(kSquare, one), proven(kSquare, other));  // of a tie
  PointSet points = kSquare;
  points.coordinates[0] = 0.1;
  EXPECT_TRUE(proven(points, one));
  EXPECT_FALSE(proven(points, other));
  points.coordinates[0] = -0.1;
  EXPECT_FALSE(proven(points, one));
  EXPECT_TRUE(proven(points, other));
  // Where rounding decides of the sign that doubles find.
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    points = kSquare;
    for (double& x : points.coordinates) x = 0.3 + 0.7 * x + 0x1p-53 * static_cast<double>(random() % 8);
    EXPECT_NE(proven(points, one), proven(points, other)) << points;
  }
}

TEST(FoundCells, no_edge_may_be_flipped) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  const PointSet points = uniform(2, 30, 1);
  const Triangles triangles = triangles_of(points);
  ASSERT_TRUE(proven(points, triangles));
  std::size_t flips = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t u = 0; u < t; ++u) {
      const auto shared = std::ranges::count_if(
          triangles[t], [&](Index v) { return std::ranges::find(triangles[u], v) != triangles[u].end(); });
      if (shared != 2) continue;
      EXPECT_FALSE(proven(points, flipped(triangles, t, u)));
      ++flips;
    }
  }
  EXPECT_GT(flips, 60U);
}

/// Nor is one whose orientation doubles do not tell.
TEST(FoundCells, no_triangle_is_turned_over) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  const PointSet thin{"", 2, {0, 0, 2, 0, 1, 0x1p-60, 1, 5}, {}};
  EXPECT_FALSE(proven(thin, triangles_of(thin)));
  const PointSet points = uniform(2, 30, 1);
  Triangles triangles = triangles_of(points);
  for (auto& [a, b, c] : triangles) std::swap(a, b);
  EXPECT_FALSE(proven(points, triangles));
}

TEST(FoundCells, the_hull_has_no_dent) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  const PointSet points{"", 2, {0, 0, 4, 0, 2, 1, 2, 5}, {}};
  EXPECT_TRUE(proven(points, {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}}));
  EXPECT_FALSE(proven(points, {{1, 3, 2}, {3, 0, 2}}));
}

/// Its triangles cover a pentagram twice where it is thick, all of them positive, none in conflict with a neighbour.
TEST(FoundCells, the_hull_goes_round_once) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  PointSet points{"pentagram", 2, {0.0, 0.0}, {}};
  for (int i = 0; i < 5; ++i) {
    const double angle = 0.3 + 1.25664 * i;
    points.coordinates.insert(points.coordinates.end(), {std::cos(angle), std::sin(angle)});
  }
  EXPECT_FALSE(proven(points, {{0, 1, 3}, {0, 3, 5}, {0, 5, 2}, {0, 2, 4}, {0, 4, 1}}));
  EXPECT_TRUE(proven(points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}}));
}

TEST(FoundCells, no_site_is_missing) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  PointSet points = kSquare;
  points.coordinates.insert(points.coordinates.end(), {0.5, 0.25});
  EXPECT_FALSE(proven(points, triangles_of(kSquare)));
  EXPECT_TRUE(proven(points, triangles_of(points)));
}

TEST(FoundCells, no_facet_is_open) {
  if (!sixteen::possible()) GTEST_SKIP() << "the processor cannot";
  const PointSet points = uniform(2, 10, 1);
  const FoundCells cells = found(10, triangles_of(points));
  for (Index f = 0; f < 4 * cells.due(); ++f) {
    if (f % 4 == 3) continue;
    FoundCells open = cells;
    open.twins[open.twins[f]] = open.twins[f];
    EXPECT_FALSE(proven(points, open));
  }
}

}  // namespace
}  // namespace delone

#endif
