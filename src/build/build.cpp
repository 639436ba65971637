#include "delone/build/build.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "delone/base/arithmetic.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/order/brio.hpp"
#include "mesh/incremental.hpp"

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

/// Moves `rows` to the front, which become the first simplex, and leaves the others in their order.
void bring_to_front(std::vector<Index>& order, std::span<const Index> rows) {
  auto kept = order.end();
  for (auto i = order.end(); i != order.begin();) {
    if (std::ranges::find(rows, *--i) == rows.end()) *--kept = *i;
  }
  std::ranges::copy(rows, order.begin());
}

}  // namespace

AnyTriangulation build(PointsView points, const BuildOptions& options) {
  require_row_count(points.size(), points.dimension());
  require_finite(points);
  const ExactEnvironment environment;
  Stopwatch watch;

  const AffineHull hull = affine_hull(points);
  Mesh mesh(Sites(points.dimension(), points.weighted(), hull.flat));
  const std::span axes = std::span(hull.flat.axes).first(static_cast<std::size_t>(std::max(hull.flat.dimension, 0)));
  const std::span basis = std::span(hull.basis).first(points.empty() ? 0 : axes.size() + 1);
  std::vector<Index> order = brio_order(points, axes, options.threads);
  bring_to_front(order, basis);
  mesh.sites.append(points, order, 0);
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
