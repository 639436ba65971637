#include "delone/build/build.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "build/incremental.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/order/brio.hpp"

namespace delone {
namespace {

class Stopwatch {
 public:
  /// Seconds since the last call.
  double lap() {
    const auto now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace

AnyTriangulation build(PointsView points, const BuildOptions& options) {
  require_row_count(points.size(), points.dimension());
  require_finite(points);
  const ExactEnvironment environment;
  Stopwatch watch;

  const AffineHull hull = affine_hull(points);
  const auto k = static_cast<std::size_t>(std::max(hull.flat.dimension, 0));
  Mesh mesh(Sites(points.dimension(), points.weighted(), hull.flat));
  mesh.sites.reserve_more(points.size());
  mesh.sites.grow_rows(points.size());
  const auto append = [&](Index row) { mesh.sites.append(points[row], points.weight(row), row); };
  const std::span basis = std::span(hull.basis).first(points.empty() ? 0 : k + 1);
  for (const Index row : basis) append(row);
  for (const Index row : brio_order(points, std::span(hull.flat.axes).first(k))) {
    if (std::ranges::find(basis, row) == basis.end()) append(row);
  }
  mesh.statistics.order_seconds = watch.lap();

  insert_all(mesh, options.progress);
  mesh.statistics.insert_seconds = watch.lap();

  mesh.complex.shrink();
  mesh.sites.shrink();
  mesh.duplicates.shrink_to_fit();
  mesh.scratch = {};
  mesh.statistics.finish_seconds = watch.lap();
  return AnyTriangulation(std::move(mesh));
}

}  // namespace delone
