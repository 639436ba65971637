// Source: [Lloyd82], [DFG99]. Let E be the integral of |x - nearest site|^2 over the region. Of all places for a site,
// the centroid of its cell has the least integral of |x - site|^2 over that cell, and every point then takes the
// nearest of the new places: both steps lower E or leave it. That cells are clipped, that sites are outside, or that
// some have no cells changes nothing of this.
#include "delone/apps/relax.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "apps/plain_sites.hpp"
#include "base/part_of.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/build/build.hpp"
#include "delone/dual/clip.hpp"

namespace delone {
namespace {

double longest_side(const Region& region) {
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) longest = std::max(longest, region.high()[axis] - region.low()[axis]);
  return longest;
}

double largest_distance(PointsView a, PointsView b) {
  double largest = 0;
  for (std::size_t row = 0; row < a.size(); ++row) largest = std::max(largest, distance(a[row], b[row]));
  return largest;
}

}  // namespace

Relaxed relax(PointsView points, const Region& region, const RelaxOptions& options) {
  require_plain_sites(points, region);
  require_steps(options.steps, options.tolerance);
  const ExactEnvironment environment;
  Relaxed result;
  result.coordinates.assign(points.coordinates().begin(), points.coordinates().end());
  for (int step = 0; step < options.steps; ++step) {
    const auto half_step = [&](double from) {
      return part_of(options.progress, (step + from) / options.steps, (step + from + 0.5) / options.steps);
    };
    const PointsView sites(result.coordinates, points.dimension());
    const AnyTriangulation t = build(sites, {.threads = options.threads, .progress = half_step(0)});
    CellMeasures cells = measure_cells(t, region, {.threads = options.threads, .progress = half_step(0.5)});
    result.energy.push_back(std::reduce(cells.second_moment.begin(), cells.second_moment.end()));
    result.moved.push_back(largest_distance(sites, PointsView(cells.centroid, points.dimension())));
    result.coordinates = std::move(cells.centroid);  // an empty cell's is its site
    if (result.moved.back() <= options.tolerance * longest_side(region)) break;
  }
  return result;
}

}  // namespace delone
