// CGAL in the plane: range insertion, which sorts spatially; bare, with an index per vertex, and weighted; and its
// hierarchy [Dev97], with points inserted one by one in the given order.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <CGAL/Triangulation_hierarchy_vertex_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/version.h>

#include <memory>
#include <utility>

#include "bench/peer.hpp"

namespace delone::bench {

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<K>;
using Indexed = CGAL::Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<unsigned, K>>>;
using Hierarchy = CGAL::Triangulation_hierarchy_2<
    CGAL::Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_hierarchy_vertex_base_2<
                                          CGAL::Triangulation_vertex_base_2<K>>>>>;
using Regular = CGAL::Regular_triangulation_2<K>;

template <class T, class Points>
Run insert_range(const Points& points) {
  return measure(
      [&] {
        auto t = std::make_unique<T>();
        t->insert(points.begin(), points.end());
        return t;
      },
      [](const T& t, Run& run) {
        run.cells = t.number_of_faces();
        run.vertices = t.number_of_vertices();
      });
}

Run run_delaunay(PointsView view) {
  std::vector<K::Point_2> points;
  for (std::size_t i = 0; i < view.size(); ++i) points.emplace_back(view[i][0], view[i][1]);
  return insert_range<Delaunay>(points);
}

Run run_hierarchy(PointsView view) {
  std::vector<K::Point_2> points;
  for (std::size_t i = 0; i < view.size(); ++i) points.emplace_back(view[i][0], view[i][1]);
  return measure(
      [&] {
        auto t = std::make_unique<Hierarchy>();
        for (const K::Point_2& point : points) t->insert(point);
        return t;
      },
      [](const Hierarchy& t, Run& run) {
        run.cells = t.number_of_faces();
        run.vertices = t.number_of_vertices();
      });
}

template <std::size_t Share>
Run remove_vertices(PointsView view) {
  std::vector<K::Point_2> points;
  for (std::size_t i = 0; i < view.size(); ++i) points.emplace_back(view[i][0], view[i][1]);
  Delaunay t;
  t.insert(points.begin(), points.end());
  std::vector<Delaunay::Vertex_handle> vertices;
  for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v) vertices.push_back(v);
  return measure_removal(t, vertices, Share, [](const Delaunay& rest, Run& run) {
    run.cells = rest.number_of_faces();
    run.vertices = rest.number_of_vertices();
  });
}

Run run_indexed(PointsView view) {
  std::vector<std::pair<K::Point_2, unsigned>> points;
  for (std::size_t i = 0; i < view.size(); ++i)
    points.emplace_back(K::Point_2(view[i][0], view[i][1]), static_cast<unsigned>(i));
  return insert_range<Indexed>(points);
}

Run run_regular(PointsView view) {
  std::vector<K::Weighted_point_2> points;
  for (std::size_t i = 0; i < view.size(); ++i) points.emplace_back(K::Point_2(view[i][0], view[i][1]), view.weight(i));
  return insert_range<Regular>(points);
}

}  // namespace

std::vector<Peer> cgal_2d_peers() {
  const auto bare = [](int d, bool weighted) { return d == 2 && !weighted; };
  const auto with_weights = [](int d, bool weighted) { return d == 2 && weighted; };
  return {{"CGAL", CGAL_VERSION_STR, bare, run_delaunay},
          {"CGAL-remove-10", CGAL_VERSION_STR, bare, remove_vertices<10>},
          {"CGAL-remove-20", CGAL_VERSION_STR, bare, remove_vertices<20>},
          {"CGAL-indexed", CGAL_VERSION_STR, bare, run_indexed},
          {"CGAL-hierarchy", CGAL_VERSION_STR, bare, run_hierarchy},
          {"CGAL", CGAL_VERSION_STR, with_weights, run_regular}};
}

}  // namespace delone::bench
