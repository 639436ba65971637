#include "mesh/plane_cuts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "delone/base/random.hpp"
#include "mesh/triangulate.hpp"

namespace delone {
namespace {

/// Coordinates of `count` points, one at random of each of so many parts of the rows, and of the rows given.
std::vector<double> sample_of(PointsView points, std::size_t count, std::span<const Index> given) {
  std::vector<double> sample;
  sample.reserve((count + given.size()) * static_cast<std::size_t>(points.dimension()));
  const auto add = [&](std::size_t row) { sample.insert(sample.end(), points[row].begin(), points[row].end()); };
  const std::size_t share = points.size() / count;
  for (std::size_t i = 0; i < count; ++i) add(i * share + mix(i) % share);
  for (const Index row : given) add(row);
  return sample;
}

/// Cells that divide and conquer along these cuts makes for each point.
double cells_made(PointsView points, const Flat& flat, const CurveCuts& cuts) {
  const Mesh mesh = triangulate_plane(points, flat, cuts, 1, {});
  return static_cast<double>(mesh.statistics.cells_created) / static_cast<double>(points.size());
}

}  // namespace

CurveCuts plane_cuts(PointsView points, const AffineHull& hull, int threads) {
  constexpr std::size_t kLeast = 256;  // of a sample
  constexpr std::size_t kMost = 2048;
  constexpr double kUsual = 9.0;  // cells a point; boxes make 7 where points fill an area
  constexpr double kWorthwhile = 0.7;
  const std::span<const int> axes(hull.flat.axes.data(), 2);
  const std::size_t count = std::min(points.size() / 64, kMost);
  if (count < kLeast) return curve_cuts(points, axes, threads);
  const std::vector<double> coordinates =
      sample_of(points, count, std::span(hull.basis).first(3));  // so that the sample spans the plane
  const PointsView sample(coordinates, points.dimension());
  const double by_boxes = cells_made(sample, hull.flat, curve_cuts(sample, axes));
  if (by_boxes < kUsual) return curve_cuts(points, axes, threads);
  const std::array turned{axes[1], axes[0]};
  const double across_first = cells_made(sample, hull.flat, strip_cuts(sample, axes));
  const double across_second = cells_made(sample, hull.flat, strip_cuts(sample, turned));
  if (std::min(across_first, across_second) > kWorthwhile * by_boxes) return curve_cuts(points, axes, threads);
  return strip_cuts(points, across_first < across_second ? axes : std::span<const int>(turned), threads);
}

}  // namespace delone
