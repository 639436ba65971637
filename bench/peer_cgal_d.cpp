// CGAL's dD triangulations, with the dimension known to the compiler.
#include <CGAL/Delaunay_triangulation.h>
#include <CGAL/Epick_d.h>
#include <CGAL/version.h>

#include <memory>

#include "bench/peer.hpp"

namespace delone::bench {

namespace {

template <int D>
Run run_dimension(PointsView view) {
  using K = CGAL::Epick_d<CGAL::Dimension_tag<D>>;
  using T = CGAL::Delaunay_triangulation<K>;
  std::vector<typename K::Point_d> points;
  for (std::size_t i = 0; i < view.size(); ++i) points.emplace_back(view[i].begin(), view[i].end());
  return measure(
      [&] {
        auto t = std::make_unique<T>(D);
        t->insert(points.begin(), points.end());
        return t;
      },
      [](const T& t, Run& run) {
        run.cells = t.number_of_finite_full_cells();
        run.vertices = t.number_of_vertices();
      });
}

Run run(PointsView view) {
  if (view.dimension() == 4) return run_dimension<4>(view);
  return view.dimension() == 5 ? run_dimension<5>(view) : run_dimension<6>(view);
}

}  // namespace

std::vector<Peer> cgal_d_peers() {
  return {{"CGAL", CGAL_VERSION_STR, [](int d, bool weighted) { return d >= 4 && d <= 6 && !weighted; }, run}};
}

}  // namespace delone::bench
