#include <cmath>
#include <voro++/voro++.hh>

#include "bench/cells_peer.hpp"

namespace delone::bench {

std::vector<double> voro_volumes(PointsView points) {
  const int blocks =
      static_cast<int>(std::ceil(std::cbrt(static_cast<double>(points.size()) / voro::optimal_particles)));
  voro::container container(0, 1, 0, 1, 0, 1, blocks, blocks, blocks, false, false, false, 8);
  for (std::size_t row = 0; row < points.size(); ++row)
    container.put(static_cast<int>(row), points[row][0], points[row][1], points[row][2]);
  std::vector<double> volumes(points.size());
  voro::c_loop_all all(container);
  voro::voronoicell cell;
  if (!all.start()) return volumes;
  do {
    if (container.compute_cell(cell, all)) volumes[static_cast<std::size_t>(all.pid())] = cell.volume();
  } while (all.inc());
  return volumes;
}

std::string voro_version() { return "0.4.6"; }

}  // namespace delone::bench
