#include "mesh/anew.hpp"

#include <utility>

#include "delone/base/stopwatch.hpp"
#include "delone/geometry/affine.hpp"
#include "mesh/triangulate.hpp"

namespace delone {

AnyTriangulation finished(Mesh mesh) {
  Stopwatch watch;
  mesh.complex.shrink();
  mesh.sites.shrink();
  mesh.scratch = {};
  mesh.statistics.finish_seconds = watch.lap();
  return AnyTriangulation(std::move(mesh));
}

AnyTriangulation triangulated(PointsView points, int threads, const Progress& progress) {
  return finished(triangulate_points(points, threads, progress));
}

NamedPoints points_of(const AnyTriangulation& t, std::vector<Index> rows) {
  const auto d = static_cast<std::size_t>(t.dimension());
  NamedPoints points{std::move(rows), {}, {}};
  points.coordinates.resize(points.rows.size() * d);
  points.weights.reserve(t.weighted() ? points.rows.size() : 0);
  for (std::size_t i = 0; i < points.rows.size(); ++i) {
    t.sites().copy_point(t.vertex(points.rows[i]), std::span(points.coordinates).subspan(i * d, d));
    if (t.weighted()) points.weights.push_back(t.weight(points.rows[i]));
  }
  return points;
}

AnyTriangulation triangulated_anew(const AnyTriangulation& t, const NamedPoints& points, std::size_t row_count,
                                   int threads, const Progress& progress) {
  AnyTriangulation anew =
      points.rows.empty()
          ? AnyTriangulation(t.dimension(), t.weighted())
          : triangulated(PointsView(points.coordinates, t.dimension(), points.weights), threads, progress);
  if (points.rows.size() < row_count) anew.mesh().rename_rows(points.rows, row_count);
  return anew;
}

bool leave_flat(const AnyTriangulation& t, PointsView points) {
  if (t.affine_dimension() == t.dimension()) return false;
  std::vector<double> all = spanning_points(t);
  all.insert(all.end(), points.coordinates().begin(), points.coordinates().end());
  return affine_dimension(PointsView(all, t.dimension())) > t.affine_dimension();
}

}  // namespace delone
