#include "mesh/glue.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/mesh/export.hpp"
#include "mesh/triangulate.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// The rows whose coordinate on `axis` lies below `at`, or those where it does not, with their names.
Mesh half(const PointSet& points, std::size_t axis, double at, bool upper) {
  const auto d = static_cast<std::size_t>(points.dimension);
  PointSet chosen{points.name, points.dimension, {}, {}};
  std::vector<Index> names;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const auto* const point = points.coordinates.data() + row * d;
    if ((point[axis] < at) == upper) continue;
    names.push_back(static_cast<Index>(row));
    chosen.coordinates.insert(chosen.coordinates.end(), point, point + d);
    if (!points.weights.empty()) chosen.weights.push_back(points.weights[row]);
  }
  Mesh mesh = triangulate_points(chosen.view(), 1, {});
  mesh.rename_rows(names, points.size());
  return mesh;
}

/// Glues halves wherever both span as much as the whole and few enough sites are near the border; how often that was.
int glue_halves(const PointSet& points) {
  const AnyTriangulation whole = built(points);
  const std::string expected = description(whole);
  int glued = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(points.dimension); ++axis) {
    for (const Index row : {Index{0}, Index{1}, Index{2}}) {
      const double at = points.coordinates[row * static_cast<std::size_t>(points.dimension) + axis];
      Mesh a = half(points, axis, at, false);
      const Mesh b = half(points, axis, at, true);
      const int k = whole.affine_dimension();
      if (k < 2 || a.complex.dimension() != k || b.complex.dimension() != k) continue;
      std::optional<Mesh> mesh = glue(std::move(a), b, row == 0 ? 2 : 1);
      if (!mesh) continue;
      ++glued;
      const AnyTriangulation t(std::move(*mesh));
      EXPECT_EQ(broken_invariant(t), "") << points;
      EXPECT_EQ(description(t), expected) << points;
    }
  }
  return glued;
}

TEST(Glue, halves_of_every_family_make_the_whole) {
  int glued = 0;
  for (const PointSet& points : families(2, 60, 1)) glued += glue_halves(points);
  for (const PointSet& points : families(3, 60, 1)) glued += glue_halves(points);
  EXPECT_GT(glued, 20);
}

TEST(Glue, halves_of_large_sets_make_the_whole) {
  EXPECT_EQ(glue_halves(uniform(2, 3000, 1)), 6);
  EXPECT_EQ(glue_halves(with_random_weights(uniform(2, 3000, 1), 2)), 6);
  EXPECT_GE(glue_halves(lattice(2, 3000, 60, 1)), 4);
  EXPECT_GE(glue_halves(uniform(3, 4000, 1)), 6);
  EXPECT_GE(glue_halves(lattice(3, 4000, 17, 1)), 4);
}

TEST(Glue, vertices_near_the_border_may_become_hidden) {
  PointSet points = uniform(3, 4000, 1);
  points.weights.assign(points.size(), 0.0);
  for (std::size_t row = 0; row < points.size(); row += 50) points.weights[row] = 0.01;
  EXPECT_GE(glue_halves(points), 3);
}

TEST(Glue, the_border_of_a_sphere_is_all_of_it) {
  PointSet points{"sphere", 3, {}, {}};
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    std::array<double, 3> x;
    for (double& c : x) c = unit_random(random) - 0.5;
    const double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    for (const double c : x) points.coordinates.push_back(c / std::sqrt(square));
  }
  const Mesh a = half(points, 0, 0.0, false);
  const Mesh b = half(points, 0, 0.0, true);
  EXPECT_GT(border_share(a, b), 0.9);
  EXPECT_FALSE(glue(a, b, 1));
  EXPECT_LT(border_share(half(uniform(3, 4000, 1), 0, 0.5, false), half(uniform(3, 4000, 1), 0, 0.5, true)), 0.5);
}

}  // namespace
}  // namespace delone
