#include "mesh/distinct.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "delone/geometry/affine.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/order/brio.hpp"

namespace delone {
namespace {

/// Per row the row that stands for its place.
std::vector<Index> rows_of_places(PointsView points, std::span<const int> axes, int threads) {
  const CurveCuts cuts = curve_cuts(points, axes, threads);
  std::vector<Index> standing(points.size());
  const auto better = [&](Index a, Index b) {
    if (points.weighted() && points.weight(a) != points.weight(b)) return points.weight(a) > points.weight(b);
    return a < b;
  };
  for (std::size_t begin = 0, end; begin < cuts.order.size(); begin = end) {
    for (end = begin + 1; end < cuts.order.size() && cuts.cut[end] == CurveCuts::kSamePlace;) ++end;
    const std::span rows = std::span(cuts.order).subspan(begin, end - begin);
    const Index best = *std::ranges::min_element(rows, better);
    for (const Index row : rows) standing[row] = best;
  }
  return standing;
}

/// The first rows in their order that span the flat of dimension k.
void bring_first_simplex_to_front(PointsView points, std::span<Index> rows, std::size_t k) {
  std::vector<double> coordinates;
  coordinates.reserve(rows.size() * static_cast<std::size_t>(points.dimension()));
  for (const Index row : rows) coordinates.insert(coordinates.end(), points[row].begin(), points[row].end());
  const AffineHull hull = affine_hull(PointsView(coordinates, points.dimension()));
  auto place = rows.begin();
  for (const Index found : std::span(hull.basis).first(k + 1)) {
    std::rotate(place++, rows.begin() + found, rows.begin() + found + 1);
  }
}

}  // namespace

DistinctSites distinct_sites(PointsView points, Order order, std::uint64_t seed, int threads) {
  const AffineHull hull = affine_hull(points);
  const std::span axes = std::span(hull.flat.axes).first(static_cast<std::size_t>(hull.flat.dimension));
  const std::vector<Index> standing = rows_of_places(points, axes, threads);
  std::vector<Index> rows = ordered_rows(order, points, axes, seed, threads);
  const auto repeated = std::ranges::stable_partition(rows, [&](Index row) { return standing[row] == row; });
  const std::size_t count = rows.size() - repeated.size();
  bring_first_simplex_to_front(points, std::span(rows).first(count), axes.size());
  DistinctSites result{Mesh(Sites(points.dimension(), points.weighted(), hull.flat)), count};
  Mesh& mesh = result.mesh;
  mesh.sites.append(points, rows, 0, threads);
  for (std::size_t i = count; i < rows.size(); ++i) {
    meet_at_same_place(mesh, VertexId{static_cast<Index>(i)}, mesh.sites.vertex(standing[rows[i]]));
  }
  return result;
}

}  // namespace delone
