// The same cells by voro++, cell by cell.
#include <gtest/gtest.h>

#include <cmath>
#include <voro++/voro++.hh>

#include "delone/build/build.hpp"
#include "delone/dual/clip.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

struct TheirCell {
  double volume = 0, surface = 0;
  std::array<double, 3> centroid{};
  std::vector<Index> neighbours;
};

/// Within the unit cube. @param Container  of points, or of balls, whose radii are the roots of the weights
template <class Container>
std::vector<TheirCell> their_cells(PointsView points) {
  Container container(0, 1, 0, 1, 0, 1, 6, 6, 6, false, false, false, 8);
  for (std::size_t row = 0; row < points.size(); ++row) {
    const auto x = points[row];
    if constexpr (std::is_same_v<Container, voro::container_poly>) {
      container.put(static_cast<int>(row), x[0], x[1], x[2], std::sqrt(points.weight(row)));
    } else {
      container.put(static_cast<int>(row), x[0], x[1], x[2]);
    }
  }
  std::vector<TheirCell> cells(points.size());
  voro::c_loop_all all(container);
  voro::voronoicell_neighbor cell;
  if (!all.start()) return cells;
  do {
    if (!container.compute_cell(cell, all)) continue;
    TheirCell& own = cells[static_cast<std::size_t>(all.pid())];
    own.volume = cell.volume();
    own.surface = cell.surface_area();
    double x = 0, y = 0, z = 0;
    cell.centroid(x, y, z);
    const auto site = points[static_cast<std::size_t>(all.pid())];
    own.centroid = {site[0] + x, site[1] + y, site[2] + z};
    std::vector<int> neighbours;
    cell.neighbors(neighbours);
    for (const int neighbour : neighbours) {
      if (neighbour >= 0) own.neighbours.push_back(static_cast<Index>(neighbour));  // sides of the cube are negative
    }
    std::sort(own.neighbours.begin(), own.neighbours.end());
  } while (all.inc());
  return cells;
}

void expect_same(PointsView points, const std::vector<TheirCell>& theirs) {
  const std::vector<double> low{0, 0, 0}, high{1, 1, 1};
  const CellMeasures ours = measure_cells(build(points), Region::box(low, high));
  for (std::size_t row = 0; row < points.size(); ++row) {
    EXPECT_NEAR(ours.volume[row], theirs[row].volume, 1e-13) << row;
    EXPECT_NEAR(ours.surface[row], theirs[row].surface, 1e-12) << row;
    if (theirs[row].volume == 0) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(ours.centroid[3 * row + axis], theirs[row].centroid[axis], 1e-10) << row;
    const std::vector<Index> neighbours(ours.neighbours.begin() + static_cast<std::ptrdiff_t>(ours.offsets[row]),
                                        ours.neighbours.begin() + static_cast<std::ptrdiff_t>(ours.offsets[row + 1]));
    EXPECT_EQ(neighbours, theirs[row].neighbours) << row;
  }
}

TEST(CompareVoro, cells_of_random_points) {
  const test::PointSet points = test::uniform(3, 2000, 5);
  expect_same(points.view(), their_cells<voro::container>(points.view()));
}

TEST(CompareVoro, power_cells_of_random_balls) {
  test::PointSet points = test::uniform(3, 1000, 6);
  test::Random random(7);
  for (std::size_t row = 0; row < points.size(); ++row)
    points.weights.push_back(std::pow(0.1 * test::unit_random(random), 2));
  expect_same(points.view(), their_cells<voro::container_poly>(points.view()));
}

}  // namespace
}  // namespace delone
