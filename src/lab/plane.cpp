#include "lab/plane.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "delone/base/random.hpp"
#include "mesh/edge_flips.hpp"

namespace delone::lab {
namespace {

using View = ComplexView<2>;

VertexId site(Index row) { return VertexId{row}; }

/// An edge as one of its triangles has it.
struct Side {
  Index low, high;
  FacetId facet;
};

std::vector<Side> sorted_sides(View complex) {
  std::vector<Side> sides;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] =
          std::minmax({raw(complex.vertex(c, View::turned(i, 1))), raw(complex.vertex(c, View::turned(i, 2)))});
      sides.push_back({low, high, View::facet(c, i)});
    }
  }
  std::ranges::sort(sides,
                    [](const Side& a, const Side& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
  return sides;
}

/// Ghost cells outside the edges of `hull`, each seen from its triangle; linked to these and to each other.
void close(View complex, std::span<const FacetId> hull, std::size_t site_count) {
  std::vector<CellId> ghost_from(site_count, kNoCell);
  std::vector<CellId> ghosts;
  for (const FacetId f : hull) {
    const CellId c = View::cell(f);
    const CellId ghost = complex.create();
    const VertexId from = complex.vertex(c, View::turned(View::slot(f), 2));
    complex.set_vertices(ghost, {from, complex.vertex(c, View::turned(View::slot(f), 1)), kGhost});
    complex.link(View::facet(ghost, 2), f);
    ghost_from[raw(from)] = ghost;
    ghosts.push_back(ghost);
  }
  for (const CellId ghost : ghosts) {
    complex.link(View::facet(ghost, 0), View::facet(ghost_from[raw(complex.vertex(ghost, 1))], 1));
    complex.settle(ghost);
    complex.count_ghost(ghost);
  }
}

FacetId random_facet(View complex, std::uint64_t number) {
  const std::uint64_t place = number % (3 * complex.slot_count());
  return View::facet(CellId{static_cast<Index>(place / 3)}, static_cast<int>(place % 3));
}

}  // namespace

Mesh closed_mesh(PointsView points, std::span<const Triangle> triangles) {
  std::vector<Index> rows(points.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  Sites sites(2, points.weighted(), Flat{.dimension = 2, .axes = {0, 1}});
  sites.append(points, rows, 0);
  Mesh mesh(std::move(sites));
  mesh.complex.reserve_more(2 * triangles.size() + 2, points.size());
  mesh.complex.grow_vertices(points.size());
  View complex(mesh.complex);
  for (const auto& [a, b, c] : triangles) {
    const CellId cell = complex.create();
    complex.set_vertices(cell, {site(a), site(b), site(c)});
    complex.settle(cell);
  }
  std::vector<FacetId> hull;
  const std::vector<Side> sides = sorted_sides(complex);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool paired = i + 1 < sides.size() && sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high;
    if (paired) {
      complex.link(sides[i].facet, sides[i + 1].facet);
      ++i;
    } else {
      hull.push_back(sides[i].facet);
    }
  }
  close(complex, hull, points.size());
  for (const Index row : rows) mesh.vertex_count += complex.has_vertex(site(row)) ? 1U : 0U;
  return mesh;
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  const ConstComplexView<2> complex(mesh.complex);
  std::vector<Triangle> triangles;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (complex.is_ghost(c)) continue;
    triangles.push_back({raw(complex.vertex(c, 0)), raw(complex.vertex(c, 1)), raw(complex.vertex(c, 2))});
  }
  return triangles;
}

std::vector<Triangle> sorted_triangles(PointsView points) {
  const Mesh mesh = closed_mesh(points, {});
  Kernel<2> kernel(mesh.sites);
  std::vector<Index> rows(points.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  std::ranges::sort(rows, [&](Index a, Index b) { return kernel.before(site(a), site(b)); });
  std::vector<Triangle> triangles;
  std::vector<Index> lower, upper;  // the hull from the first site to the last, on both sides
  for (const Index p : rows) {
    const auto sees = [&](Index a, Index b) { return kernel.orient({site(a), site(b), site(p)}); };
    while (lower.size() > 1 && sees(lower[lower.size() - 2], lower.back()) < 0) {
      triangles.push_back({lower.back(), lower[lower.size() - 2], p});
      lower.pop_back();
    }
    while (upper.size() > 1 && sees(upper[upper.size() - 2], upper.back()) > 0) {
      triangles.push_back({upper[upper.size() - 2], upper.back(), p});
      upper.pop_back();
    }
    lower.push_back(p);
    upper.push_back(p);
  }
  return triangles;
}

bool is_flippable(View complex, Kernel<2>& kernel, FacetId f) {
  const CellId c = View::cell(f), d = View::cell(complex.twin(f));
  if (complex.is_ghost(c) || complex.is_ghost(d)) return false;
  const VertexId p = complex.vertex(f), q = complex.vertex(complex.twin(f));
  const VertexId a = complex.vertex(c, View::turned(View::slot(f), 1));
  const VertexId b = complex.vertex(c, View::turned(View::slot(f), 2));
  return kernel.orient({a, q, p}) > 0 && kernel.orient({b, p, q}) > 0;
}

bool is_locally_non_regular(View complex, Kernel<2>& kernel, FacetId f) {
  const CellId c = View::cell(f), d = View::cell(complex.twin(f));
  if (complex.is_ghost(c) || complex.is_ghost(d)) return false;
  return kernel.conflict(complex.vertices(c), complex.vertex(complex.twin(f)));
}

void flip_at_random(Mesh& mesh, std::size_t count, std::uint64_t seed) {
  const View complex(mesh.complex);
  Kernel<2> kernel(mesh.sites);
  const std::size_t most_attempts = 100 * count + 1000;
  for (std::size_t flips = 0, i = 0; flips < count && i < most_attempts; ++i) {
    const FacetId f = random_facet(complex, mix(mix(seed) + i));
    if (!is_flippable(complex, kernel, f)) continue;
    flip_edge(complex, View::cell(f), View::slot(f));
    ++flips;
  }
}

std::uint64_t make_delaunay(Mesh& mesh, Discipline discipline, std::uint64_t seed) {
  const View complex(mesh.complex);
  Kernel<2> kernel(mesh.sites);
  Buffer<FacetId> open;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    for (int i = 0; i < 3; ++i) {
      if (View::facet(c, i) < complex.twin(c, i)) open.push_back(View::facet(c, i));
    }
  }
  if (discipline == Discipline::queue) return flip_until_delaunay(complex, kernel, std::move(open), {});
  std::uint64_t flips = 0;
  for (std::uint64_t step = 0; !open.empty(); ++step) {
    const std::size_t last = open.size() - 1;
    if (discipline == Discipline::random) std::swap(open[mix(mix(seed) + step) % open.size()], open[last]);
    const FacetId f = open[last];
    open.resize(last);
    if (!is_locally_non_regular(complex, kernel, f)) continue;
    const CellId c = View::cell(f), d = View::cell(complex.twin(f));
    flip_edge(complex, c, View::slot(f));
    ++flips;
    for (const CellId changed : {c, d}) {
      for (const int outer : {1, 2}) open.push_back(View::facet(changed, outer));
    }
  }
  return flips;
}

}  // namespace delone::lab
