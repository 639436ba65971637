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

/// Coordinates of `count` points, one at random of each of so many parts of the rows.
std::vector<double> sample_of(PointsView points, std::size_t count) {
  std::vector<double> sample;
  sample.reserve(count * static_cast<std::size_t>(points.dimension()));
  const std::size_t share = points.size() / count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::span<const double> point = points[i * share + mix(i) % share];
    sample.insert(sample.end(), point.begin(), point.end());
  }
  return sample;
}

/// Cells that divide and conquer makes for each point.
double cells_made(PointsView points, const Flat& flat, const CutPlan& plan) {
  const Mesh mesh = triangulate_plane(points, flat, plan, 1, {});
  return static_cast<double>(mesh.statistics.cells_created) / static_cast<double>(points.size());
}

}  // namespace

CutPlan plane_cuts(PointsView points, const Flat& flat, int threads) {
  constexpr std::size_t kLeast = 256;  // of a sample
  constexpr std::size_t kMost = 2048;
  constexpr double kMany = 9.0;  // cells a point; boxes make 7 where points fill an area
  constexpr double kFew = 5.0;   // strips that hold what faces each other make 3.3
  const std::span<const int> axes(flat.axes.data(), 2);
  const std::size_t count = std::min(points.size() / 64, kMost);
  if (count < kLeast) return {curve_cuts(points, axes, threads)};
  const std::vector<double> coordinates = sample_of(points, count);
  const PointsView sample(coordinates, points.dimension());
  if (cells_made(sample, flat, {curve_cuts(sample, axes)}) < kMany) return {curve_cuts(points, axes, threads)};
  for (const std::array across : {std::array{axes[0], axes[1]}, std::array{axes[1], axes[0]}}) {
    if (cells_made(sample, flat, {strip_cuts(sample, across)}) < kFew) return {strip_cuts(points, across, threads)};
  }
  return {curve_cuts(points, axes, threads), true};
}

}  // namespace delone
