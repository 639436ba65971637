#include "delone/dual/voronoi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "delone/build/build.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/export.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

std::vector<Index> list(std::span<const Index> values) { return {values.begin(), values.end()}; }

std::size_t power(std::size_t base, int exponent) {
  std::size_t result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

std::size_t choose(int n, int k) {
  std::size_t result = 1;
  for (int i = 1; i <= k; ++i) result = result * static_cast<std::size_t>(n - k + i) / static_cast<std::size_t>(i);
  return result;
}

test::PointSet grid(int dimension, std::size_t side) {
  test::PointSet points{"grid", dimension, {}};
  for (std::size_t i = 0; i < power(side, dimension); ++i) {
    std::size_t rest = i;
    for (int axis = 0; axis < dimension; ++axis, rest /= side)
      points.coordinates.push_back(static_cast<double>(rest % side));
  }
  return points;
}

TEST(Diagram, of_a_grid_is_the_product_of_lines) {
  for (const auto& [dimension, side] : {std::pair{1, 5U}, {2, 4U}, {3, 3U}, {4, 2U}, {5, 2U}}) {
    const AnyTriangulation t = test::built(grid(dimension, side));
    const Diagram diagram(t);
    for (int j = 0; j <= dimension; ++j) {
      const DiagramFaces faces = diagram.faces(j);
      EXPECT_EQ(faces.size(), choose(dimension, j) * power(side, j) * power(side - 1, dimension - j))
          << dimension << " " << j;
      for (std::size_t f = 0; f < faces.size(); ++f) EXPECT_EQ(faces.sites[f].size(), power(2, dimension - j));
    }
  }
}

/// [For92] theorem 2.1: faces and Delaunay faces correspond, dimensions add up to D, inclusion is reversed.
TEST(Diagram, faces_are_dual_to_delaunay_faces) {
  for (int d = 1; d <= 4; ++d) {
    for (const auto& points : test::families(d, d == 4 ? 9 : 13, 11)) {
      const AnyTriangulation t = test::built(points);
      const Diagram diagram(t);
      const int k = t.affine_dimension();
      ASSERT_EQ(diagram.least_dimension(), k < 0 ? 0 : d - k);
      std::vector<std::vector<Index>> ends_sites;  // of vertices, then of rays
      for (std::size_t v = 0; v < diagram.vertex_count(); ++v) ends_sites.push_back(list(diagram.vertex_sites()[v]));
      for (std::size_t r = 0; r < diagram.ray_count(); ++r) ends_sites.push_back(list(diagram.ray_sites()[r]));
      long euler = 0;
      for (int j = d - std::max(k, 0); j <= d; ++j) {
        const DiagramFaces faces = diagram.faces(j);
        for (std::size_t f = 0; f < faces.size(); ++f) {
          test::PointSet corners{"corners", d, {}};
          for (const Index row : faces.sites[f]) {
            const std::vector<double> x = t.point(row);
            corners.coordinates.insert(corners.coordinates.end(), x.begin(), x.end());
          }
          EXPECT_EQ(affine_dimension(corners.view()), d - j) << points;
          std::vector<Index> ends;
          for (std::size_t e = 0; e < ends_sites.size(); ++e) {
            if (std::ranges::includes(ends_sites[e], faces.sites[f])) ends.push_back(static_cast<Index>(e));
          }
          std::vector<Index> found = list(faces.ends[f]);
          std::ranges::sort(found);
          EXPECT_EQ(found, ends) << points;
        }
        euler += (j % 2 == 0 ? 1 : -1) * static_cast<long>(faces.size());
      }
      // Cells of all dimensions divide the space, an open ball; of compact support that counts (-1)^D.
      EXPECT_EQ(euler, k < 0 ? 0 : d % 2 == 0 ? 1 : -1) << points;
    }
  }
}

TEST(Diagram, vertices_are_merged_cells_and_cells_belong_to_rows) {
  for (int d = 1; d <= 3; ++d) {
    for (const auto& points : test::families(d, 20, 7)) {
      const AnyTriangulation t = test::built(points);
      const Diagram diagram(t);
      const PolytopeTable merged = merged_cells(t);
      ASSERT_EQ(diagram.vertex_count(), merged.size()) << points;
      for (std::size_t v = 0; v < merged.size(); ++v) {
        EXPECT_TRUE(std::ranges::equal(diagram.vertex_sites()[v], merged[v]));
      }
      const Lists cells = diagram.cells();
      ASSERT_EQ(cells.size(), points.size());
      for (std::size_t row = 0; row < cells.size(); ++row)
        EXPECT_EQ(cells[row].empty(), t.status(static_cast<Index>(row)).status != Status::vertex) << points;
    }
  }
}

TEST(Diagram, is_the_same_for_every_order_of_rows) {
  test::Random random(3);
  for (const auto& points : test::unweighted_families(3, 20, 9)) {
    const auto order = test::random_permutation(points.size(), random);
    const AnyTriangulation first_triangulation = test::built(points);
    const AnyTriangulation second_triangulation = test::built(test::permuted(points, order));
    const Diagram first(first_triangulation);
    const Diagram second(second_triangulation);
    const auto places = [](const Diagram& diagram) {
      std::multiset<std::vector<double>> all;
      for (std::size_t v = 0; v < diagram.vertex_count(); ++v)
        all.insert({diagram.vertices().begin() + static_cast<std::ptrdiff_t>(3 * v),
                    diagram.vertices().begin() + static_cast<std::ptrdiff_t>(3 * v + 3)});
      return all;
    };
    EXPECT_EQ(places(first), places(second)) << points;
    for (int j = 0; j <= 3; ++j) EXPECT_EQ(first.faces(j).size(), second.faces(j).size()) << points;
  }
}

TEST(Diagram, polygons_run_around_counter_clockwise) {
  const test::PointSet points = test::uniform(2, 60, 4);
  const AnyTriangulation t = test::built(points);
  const Diagram diagram(t);
  const Lists cells = diagram.cells();
  std::size_t bounded = 0;
  for (std::size_t row = 0; row < cells.size(); ++row) {
    const auto at = [&](std::size_t i) {
      const Index v = cells[row][i % cells[row].size()];
      return std::array{diagram.vertices()[2 * v], diagram.vertices()[2 * v + 1]};
    };
    const bool open = cells[row][0] >= diagram.vertex_count();
    EXPECT_EQ(open, cells[row].back() >= diagram.vertex_count());
    if (open) continue;
    ++bounded;
    for (std::size_t i = 0; i < cells[row].size(); ++i) {
      const auto a = at(i), b = at(i + 1), c = at(i + 2);
      EXPECT_GT((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]), 0) << row;
    }
  }
  EXPECT_GT(bounded, 20U);
}

TEST(Diagram, of_two_places_is_a_wall_of_prisms) {
  const test::PointSet points{"pair", 3, {0, 0, 0, 2, 0, 0}};
  const AnyTriangulation t = test::built(points);
  const Diagram diagram(t);
  EXPECT_EQ(diagram.vertices(), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(diagram.prism_directions(), (std::vector<Vector>{{0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(diagram.ray_directions(), (std::vector<double>{-1, 0, 0, 1, 0, 0}));
  EXPECT_EQ(diagram.faces(2).size(), 1U);
  EXPECT_EQ(diagram.faces(3).size(), 2U);
  EXPECT_EQ(diagram.faces(1).size(), 0U);
}

TEST(Diagram, of_one_place_and_of_none) {
  const AnyTriangulation one = test::built({"one", 2, {3, 4, 3, 4}});
  const Diagram diagram(one);
  EXPECT_EQ(diagram.vertex_count(), 1U);
  EXPECT_EQ(diagram.least_dimension(), 2);
  EXPECT_EQ(diagram.faces(2).size(), 1U);
  EXPECT_EQ(diagram.cells().size(), 2U);
  EXPECT_TRUE(diagram.cells()[1].empty());
  const AnyTriangulation none(2);
  EXPECT_EQ(Diagram(none).faces(2).size(), 0U);
}

TEST(Diagram, not_merged_has_a_vertex_for_every_simplex) {
  const AnyTriangulation t = test::built(grid(2, 2));
  EXPECT_EQ(Diagram(t).vertex_count(), 1U);
  const Diagram diagram(t, {.merged = false});
  EXPECT_EQ(diagram.vertex_count(), 2U);
  EXPECT_EQ(diagram.vertices(), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
  EXPECT_EQ(diagram.faces(1).size(), 5U);
}

}  // namespace
}  // namespace delone
