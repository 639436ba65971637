// CGAL in space: range insertion, which sorts spatially; Delaunay and regular, both with the default (compact)
// location.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/version.h>

#include <memory>

#include "bench/peer.hpp"

namespace delone::bench {

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class T, class Points>
Run insert_range(const Points& points) {
  return measure([&] { return std::make_unique<T>(points.begin(), points.end()); },
                 [](const T& t, Run& run) {
                   run.cells = t.number_of_finite_cells();
                   run.vertices = t.number_of_vertices();
                 });
}

Run run_delaunay(PointsView view) {
  std::vector<K::Point_3> points;
  for (std::size_t i = 0; i < view.size(); ++i) points.emplace_back(view[i][0], view[i][1], view[i][2]);
  return insert_range<CGAL::Delaunay_triangulation_3<K>>(points);
}

template <std::size_t Share>
Run remove_vertices(PointsView view) {
  using Delaunay = CGAL::Delaunay_triangulation_3<K>;
  std::vector<K::Point_3> points;
  for (std::size_t i = 0; i < view.size(); ++i) points.emplace_back(view[i][0], view[i][1], view[i][2]);
  Delaunay t(points.begin(), points.end());
  std::vector<Delaunay::Vertex_handle> vertices;
  for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v) vertices.push_back(v);
  return measure_removal(t, vertices, Share, [](const Delaunay& rest, Run& run) {
    run.cells = rest.number_of_finite_cells();
    run.vertices = rest.number_of_vertices();
  });
}

Run run_regular(PointsView view) {
  std::vector<K::Weighted_point_3> points;
  for (std::size_t i = 0; i < view.size(); ++i)
    points.emplace_back(K::Point_3(view[i][0], view[i][1], view[i][2]), view.weight(i));
  return insert_range<CGAL::Regular_triangulation_3<K>>(points);
}

}  // namespace

std::vector<Peer> cgal_3d_peers() {
  const auto bare = [](int d, bool weighted) { return d == 3 && !weighted; };
  return {{"CGAL", CGAL_VERSION_STR, bare, run_delaunay},
          {"CGAL-remove-10", CGAL_VERSION_STR, bare, remove_vertices<10>},
          {"CGAL-remove-20", CGAL_VERSION_STR, bare, remove_vertices<20>},
          {"CGAL", CGAL_VERSION_STR, [](int d, bool weighted) { return d == 3 && weighted; }, run_regular}};
}

}  // namespace delone::bench
