// What floats are sure of is so, and they are sure of most.
#include "geometry/sixteen_in_space.hpp"

#include <gtest/gtest.h>

#ifdef DELONE_SIXTEENS

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "delone/geometry/affine.hpp"
#include "delone/geometry/kernel.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using sixteen::InSpace;
using test::PointSet;
using test::Random;
using test::unit_random;

Sites sites_of(const PointSet& points) {
  Sites sites(3, !points.weights.empty(), Flat{3, {0, 1, 2}});
  std::vector<Index> order;
  for (Index row = 0; row < points.size(); ++row) order.push_back(row);
  sites.append(points.view(), order, 0);
  return sites;
}

/// Four sites, and what floats leave open about the cell that they make, and about its facet opposite the last.
struct Answer {
  std::array<Index, 4> cell;
  InSpace::Set beside_cell, beside_wall;
};

/// Of all that are positively oriented. None when none of them is so for sure: then some weight is very large.
DELONE_BY_SIXTEENS std::vector<Answer> answers_of(const Sites& sites, const Kernel<3>& kernel) {
  const InSpace sixteen(sites);
  std::vector<Answer> answers;
  bool any_sure = false;
  const auto n = static_cast<Index>(sites.size());
  for (Index a = 0; a < n; ++a) {
    for (Index b = a + 1; b < n; ++b) {
      for (Index c = b + 1; c < n; ++c) {
        for (Index d = c + 1; d < n; ++d) {
          std::array<Index, 4> cell{a, b, c, d};
          const int side = kernel.exact_orient({VertexId{a}, VertexId{b}, VertexId{c}, VertexId{d}});
          if (side < 0) std::swap(cell[0], cell[1]);
          if (side == 0) continue;
          const InSpace::Facet facet = sixteen.facet(cell);
          const InSpace::Plane plane = sixteen.plane(facet, d);
          any_sure = any_sure || sixteen.is_positive(plane);
          answers.push_back({cell, sixteen.doubts(plane), sixteen.doubts(facet.wall)});
        }
      }
    }
  }
  if (!any_sure) answers.clear();
  return answers;
}

/// Returns the share of what is sure.
double expect_right(const PointSet& points) {
  if (!sixteen::possible()) return 1.0;
  const Sites sites = sites_of(points);
  Kernel<3> kernel(sites);
  std::size_t sure = 0;
  std::size_t all = 0;
  std::size_t wrong = 0;
  for (const Answer& answer : answers_of(sites, kernel)) {
    const Kernel<3>::Cell cell{VertexId{answer.cell[0]}, VertexId{answer.cell[1]}, VertexId{answer.cell[2]},
                               VertexId{answer.cell[3]}};
    for (Index v = 0; v < points.size(); ++v) {
      const auto corner = std::ranges::find(answer.cell, v) - answer.cell.begin();
      const bool sure_above = !InSpace::has(answer.beside_cell, v);
      const bool sure_inside = !InSpace::has(answer.beside_wall, v);
      if (corner < 4) {
        wrong += sure_above ? 1U : 0U;
        wrong += sure_inside && corner < 3 ? 1U : 0U;
        continue;
      }
      all += 2;
      sure += (sure_above ? 1U : 0U) + (sure_inside ? 1U : 0U);
      wrong += sure_above && kernel.conflict(cell, VertexId{v}) ? 1U : 0U;
      wrong += sure_inside && kernel.exact_orient({cell[0], cell[1], cell[2], VertexId{v}}) >= 0 ? 1U : 0U;
    }
  }
  EXPECT_EQ(wrong, 0U) << points;
  return static_cast<double>(sure) / static_cast<double>(all);
}

/// Most sites close to a line, as close to each other as doubles allow or not: there rounding matters most.
PointSet near_a_line(Random& random) {
  PointSet points{"near a line", 3, {}, {}};
  const double jitter = std::pow(10.0, -16.0 * unit_random(random));
  for (int i = 0; i < 16; ++i) {
    const double along = unit_random(random);
    for (const double slope : {0.9, 0.7, -0.4}) {
      points.coordinates.push_back(i < 4 ? unit_random(random) : slope * along + jitter * (unit_random(random) - 0.5));
    }
  }
  return points;
}

TEST(SixteenInSpace, what_is_sure_is_so) {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    PointSet points = near_a_line(random);
    expect_right(points);
    for (std::size_t j = 0; j < points.size(); ++j) points.weights.push_back(unit_random(random));
    expect_right(points);
    for (std::size_t j = 0; j < 2; ++j) points.weights[j] *= std::pow(10.0, 12.0 * unit_random(random));
    expect_right(points);
  }
}

TEST(SixteenInSpace, every_family) {
  for (const PointSet& points : test::families(3, 12, 5)) {
    if (affine_dimension(points.view()) == 3) expect_right(points);
  }
}

/// What lies below, or outside of a wall, is open by its nature; that is about half.
TEST(SixteenInSpace, uniform_sites_leave_little_open) { EXPECT_GT(expect_right(test::uniform(3, 20, 1)), 0.4); }

}  // namespace
}  // namespace delone

#endif
