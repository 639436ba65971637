// The same points, triangulated by CGAL with exact predicates.
// Random points have one answer, so the cells must be the same. With cospherical points the two libraries may choose
// differently; the Delaunay polytopes (cells merged by common orthosphere) do not depend on that choice.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_face_base_2.h>
#include <CGAL/Regular_triangulation_vertex_base_2.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/mesh/export.hpp"

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rows = std::vector<std::size_t>;  // ascending
using Polytopes = std::multiset<Rows>;  // cells or merged cells, each as ascending rows

struct Sample {
  int dimension = 0;
  std::vector<double> coordinates;
  std::vector<double> weights;

  std::size_t size() const { return coordinates.size() / static_cast<std::size_t>(dimension); }
  double at(std::size_t row, std::size_t axis) const {
    return coordinates[row * static_cast<std::size_t>(dimension) + axis];
  }
  delone::PointsView view() const { return {coordinates, dimension, weights}; }
};

Sample sample(const std::string& kind, std::size_t n, int dimension, std::uint64_t seed, int bits = 0) {
  auto points = delone::io::generate(kind, n, dimension, seed, bits);
  return {points.dimension, std::move(points.coordinates), {}};
}

/// Weights from 0 to `largest`; in whole multiples of largest / steps when steps is positive.
Sample with_weights(Sample s, double largest, std::uint64_t seed, int steps = 0) {
  std::mt19937_64 random(seed);
  for (std::size_t row = 0; row < s.size(); ++row) {
    const double u = std::uniform_real_distribution<double>(0, 1)(random);
    s.weights.push_back(steps == 0 ? u * largest : static_cast<int>(u * (steps + 1)) * (largest / steps));
  }
  return s;
}

// One small description of each of CGAL's four triangulations: how to insert row `i`, walk over the finite cells, and
// ask exactly whether the vertex opposite a facet lies on the orthosphere of the cell.

struct Delaunay2 {
  using Vb = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, K>;
  using T = CGAL::Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<Vb>>;
  using Handle = T::Face_handle;
  static constexpr int kDimension = 2;
  static std::pair<K::Point_2, std::size_t> point(const Sample& s, std::size_t i) {
    return {{s.at(i, 0), s.at(i, 1)}, i};
  }
  static auto cells(const T& t) { return t.finite_face_handles(); }
  static bool on_sphere(const T& t, Handle c, T::Vertex_handle v) {
    return t.side_of_oriented_circle(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(), v->point(),
                                     false) == CGAL::ON_ORIENTED_BOUNDARY;
  }
};

struct Delaunay3 {
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, K>;
  using T = CGAL::Delaunay_triangulation_3<
      K, CGAL::Triangulation_data_structure_3<Vb, CGAL::Delaunay_triangulation_cell_base_3<K>>>;
  using Handle = T::Cell_handle;
  static constexpr int kDimension = 3;
  static std::pair<K::Point_3, std::size_t> point(const Sample& s, std::size_t i) {
    return {{s.at(i, 0), s.at(i, 1), s.at(i, 2)}, i};
  }
  static auto cells(const T& t) { return t.finite_cell_handles(); }
  static bool on_sphere(const T& t, Handle c, T::Vertex_handle v) {
    return t.geom_traits().side_of_oriented_sphere_3_object()(c->vertex(0)->point(), c->vertex(1)->point(),
                                                              c->vertex(2)->point(), c->vertex(3)->point(),
                                                              v->point()) == CGAL::ON_ORIENTED_BOUNDARY;
  }
};

struct Regular2 {
  using Vb = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, K, CGAL::Regular_triangulation_vertex_base_2<K>>;
  using T = CGAL::Regular_triangulation_2<
      K, CGAL::Triangulation_data_structure_2<Vb, CGAL::Regular_triangulation_face_base_2<K>>>;
  using Handle = T::Face_handle;
  static constexpr int kDimension = 2;
  static std::pair<K::Weighted_point_2, std::size_t> point(const Sample& s, std::size_t i) {
    return {K::Weighted_point_2(K::Point_2(s.at(i, 0), s.at(i, 1)), s.weights[i]), i};
  }
  static auto cells(const T& t) { return t.finite_face_handles(); }
  static bool on_sphere(const T& t, Handle c, T::Vertex_handle v) {
    return t.geom_traits().power_side_of_oriented_power_circle_2_object()(c->vertex(0)->point(), c->vertex(1)->point(),
                                                                          c->vertex(2)->point(),
                                                                          v->point()) == CGAL::ON_ORIENTED_BOUNDARY;
  }
};

struct Regular3 {
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, K, CGAL::Regular_triangulation_vertex_base_3<K>>;
  using T = CGAL::Regular_triangulation_3<
      K, CGAL::Triangulation_data_structure_3<Vb, CGAL::Regular_triangulation_cell_base_3<K>>>;
  using Handle = T::Cell_handle;
  static constexpr int kDimension = 3;
  static std::pair<K::Weighted_point_3, std::size_t> point(const Sample& s, std::size_t i) {
    return {K::Weighted_point_3(K::Point_3(s.at(i, 0), s.at(i, 1), s.at(i, 2)), s.weights[i]), i};
  }
  static auto cells(const T& t) { return t.finite_cell_handles(); }
  static bool on_sphere(const T& t, Handle c, T::Vertex_handle v) {
    return t.geom_traits().power_side_of_oriented_power_sphere_3_object()(c->vertex(0)->point(), c->vertex(1)->point(),
                                                                          c->vertex(2)->point(), c->vertex(3)->point(),
                                                                          v->point()) == CGAL::ON_ORIENTED_BOUNDARY;
  }
};

/// The row that stands for each position: the heaviest, and of those the lowest.
Rows distinct_rows(const Sample& s) {
  std::map<std::vector<double>, std::size_t> first;
  for (std::size_t row = 0; row < s.size(); ++row) {
    const auto p = s.view()[row];
    const auto [at, is_new] = first.try_emplace(std::vector<double>(p.begin(), p.end()), row);
    if (!is_new && s.view().weight(row) > s.view().weight(at->second)) at->second = row;
  }
  Rows rows;
  for (const auto& [position, row] : first) rows.push_back(row);
  return rows;
}

template <class Peer>
typename Peer::T triangulate_by_cgal(const Sample& s) {
  std::vector<decltype(Peer::point(s, 0))> points;
  for (const std::size_t row : distinct_rows(s)) points.push_back(Peer::point(s, row));
  typename Peer::T t;
  t.insert(points.begin(), points.end());
  return t;
}

/// CGAL's cells, or with `merged` the polytopes that neighbouring cells of one orthosphere form together.
template <class Peer>
Polytopes polytopes_by_cgal(const Sample& s, bool merged) {
  const auto t = triangulate_by_cgal<Peer>(s);
  using Handle = typename Peer::Handle;
  std::map<Handle, std::size_t> number;
  std::vector<Handle> cells;
  for (const Handle c : Peer::cells(t)) {
    number.emplace(c, cells.size());
    cells.push_back(c);
  }

  std::vector<std::size_t> parent(cells.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  for (std::size_t c = 0; merged && c < cells.size(); ++c)
    for (int i = 0; i <= Peer::kDimension; ++i) {
      const Handle across = cells[c]->neighbor(i);
      if (t.is_infinite(across)) continue;
      if (Peer::on_sphere(t, cells[c], across->vertex(across->index(cells[c]))))
        parent[root(c)] = root(number.at(across));
    }

  std::map<std::size_t, std::set<std::size_t>> corners;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (int i = 0; i <= Peer::kDimension; ++i) corners[root(c)].insert(cells[c]->vertex(i)->info());
  Polytopes result;
  for (const auto& [polytope, rows] : corners) result.emplace(rows.begin(), rows.end());
  return result;
}

template <class Table>
Polytopes polytopes_of(const Table& table) {
  Polytopes result;
  for (std::size_t c = 0; c < table.size(); ++c) {
    Rows rows(table[c].begin(), table[c].end());
    std::ranges::sort(rows);
    result.insert(std::move(rows));
  }
  return result;
}

void expect_same(const Polytopes& ours, const Polytopes& theirs, const std::string& what) {
  EXPECT_EQ(ours.size(), theirs.size()) << what;
  std::vector<Rows> only_ours, only_theirs;
  std::ranges::set_difference(ours, theirs, std::back_inserter(only_ours));
  std::ranges::set_difference(theirs, ours, std::back_inserter(only_theirs));
  if (!only_ours.empty())
    ADD_FAILURE() << what << ": only Delone has " << testing::PrintToString(only_ours.front()) << " and "
                  << only_ours.size() - 1 << " more";
  if (!only_theirs.empty())
    ADD_FAILURE() << what << ": only CGAL has " << testing::PrintToString(only_theirs.front()) << " and "
                  << only_theirs.size() - 1 << " more";
}

template <class Peer>
void expect_same_cells(const Sample& s, const std::string& what) {
  const auto ours = polytopes_of(delone::cells(delone::build(s.view())));
  ASSERT_FALSE(ours.empty()) << what;
  expect_same(ours, polytopes_by_cgal<Peer>(s, false), what);
}

template <class Peer>
void expect_same_merged_cells(const Sample& s, const std::string& what) {
  const auto ours = polytopes_of(delone::merged_cells(delone::build(s.view())));
  ASSERT_FALSE(ours.empty()) << what;
  expect_same(ours, polytopes_by_cgal<Peer>(s, true), what);
}

TEST(Cgal, has_the_same_triangles_on_random_points) {
  for (const char* kind : {"uniform", "gaussian", "clusters", "ellipse2", "parabola"})
    for (const unsigned seed : {1u, 2u, 3u})
      expect_same_cells<Delaunay2>(sample(kind, 3000, 2, seed), kind + (" " + std::to_string(seed)));
}

TEST(Cgal, has_the_same_tetrahedra_on_random_points) {
  for (const char* kind : {"uniform", "gaussian", "clusters", "sphere"})
    for (const unsigned seed : {1u, 2u, 3u})
      expect_same_cells<Delaunay3>(sample(kind, 1500, 3, seed), kind + (" " + std::to_string(seed)));
}

TEST(Cgal, has_the_same_weighted_triangles_on_random_points) {
  for (const double largest : {1e-5, 1e-3, 1e-1})  // hides next to none, some, most of 3000 points in the unit square
    for (const unsigned seed : {1u, 2u, 3u})
      expect_same_cells<Regular2>(with_weights(sample("uniform", 3000, 2, seed), largest, seed),
                                  "weights to " + std::to_string(largest) + ", seed " + std::to_string(seed));
}

TEST(Cgal, has_the_same_weighted_tetrahedra_on_random_points) {
  for (const double largest : {1e-4, 1e-2, 1e-1})
    for (const unsigned seed : {1u, 2u, 3u})
      expect_same_cells<Regular3>(with_weights(sample("uniform", 1500, 3, seed), largest, seed),
                                  "weights to " + std::to_string(largest) + ", seed " + std::to_string(seed));
}

TEST(Cgal, hides_the_same_points) {
  const Sample s = with_weights(sample("uniform", 3000, 3, 7), 0.05, 7);
  const auto theirs = triangulate_by_cgal<Regular3>(s);
  const auto ours = delone::build(s.view());
  EXPECT_GT(ours.hidden_count(), 100u);
  EXPECT_EQ(ours.hidden_count(), s.size() - theirs.number_of_vertices());
  for (const auto v : theirs.finite_vertex_handles())
    EXPECT_EQ(ours.status(static_cast<delone::Index>(v->info())).status, delone::Status::vertex) << "row " << v->info();
}

TEST(Cgal, has_the_same_polygons_where_points_are_cocircular) {
  expect_same_merged_cells<Delaunay2>(sample("lattice", 900, 2, 1), "lattice");
  for (const unsigned seed : {1u, 2u, 3u}) {
    const std::string name = ", seed " + std::to_string(seed);
    expect_same_merged_cells<Delaunay2>(sample("uniform", 2000, 2, seed, 5), "5 bits" + name);  // with duplicates
    expect_same_merged_cells<Delaunay2>(sample("circle", 2000, 2, seed, 8), "circle in 8 bits" + name);
  }
}

TEST(Cgal, has_the_same_polyhedra_where_points_are_cospherical) {
  expect_same_merged_cells<Delaunay3>(sample("lattice", 729, 3, 1), "lattice");
  for (const unsigned seed : {1u, 2u, 3u}) {
    const std::string name = ", seed " + std::to_string(seed);
    expect_same_merged_cells<Delaunay3>(sample("uniform", 1000, 3, seed, 3), "3 bits" + name);
    expect_same_merged_cells<Delaunay3>(sample("sphere", 1000, 3, seed, 5), "sphere in 5 bits" + name);
  }
}

// On integer points weights below 1 hide nothing: a point is 1 or more below the chord of any others, lifted.
TEST(Cgal, has_the_same_weighted_polytopes_where_points_are_cospherical) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const std::string name = "seed " + std::to_string(seed);
    expect_same_merged_cells<Regular2>(with_weights(sample("uniform", 1500, 2, seed, 5), 0.5, seed, 2), name);
    expect_same_merged_cells<Regular3>(with_weights(sample("uniform", 800, 3, seed, 3), 0.5, seed, 2), name);
  }
}

}  // namespace
