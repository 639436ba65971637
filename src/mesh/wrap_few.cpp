#include "mesh/wrap_few.hpp"

#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "geometry/sixteen.hpp"

namespace delone {

#ifdef DELONE_SIXTEENS

std::optional<Mesh> wrap_few(PointsView points, const AffineHull& hull, const Progress& progress) {
  const int k = hull.flat.dimension;
  const bool in_plane = k == 2 && !points.weighted();
  const bool in_space = k == 3;
  const std::size_t least = in_plane ? 4 : 12;  // in space fewer are inserted as fast
  const bool few = points.size() >= least && points.size() <= sixteen::kMostSites;
  if (!few || !(in_plane || in_space) || points.dimension() != k || !sixteen::possible()) return std::nullopt;
  tell(progress, 0, points.size());
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  hull.bring_to_front(order);
  std::optional<Mesh> mesh(Sites(points.dimension(), points.weighted(), hull.flat));
  mesh->sites.append(points, order, 0);
  if (!(in_plane ? wrap_few_in_plane(*mesh) : wrap_few_in_space(*mesh))) return std::nullopt;
  return mesh;
}

#else

std::optional<Mesh> wrap_few(PointsView /*points*/, const AffineHull& /*hull*/, const Progress& /*progress*/) {
  return std::nullopt;
}

#endif

}  // namespace delone
