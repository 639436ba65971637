#include "delone/dual/voronoi.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/groups.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/geometry/exact_predicates.hpp"
#include "mesh/cospherical.hpp"

namespace delone {
namespace {

using Names = std::vector<Index>;

template <class F>
void for_live_cells(const Complex& complex, const F& f) {
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (complex.is_live(c)) f(c);
  }
}

int ghost_slot(const Complex& complex, CellId c) {
  for (int i = 0; i < complex.corners(); ++i) {
    if (complex.vertex(c, i) == kGhost) return i;
  }
  return -1;
}

std::vector<VertexId> finite_vertices(const Complex& complex, CellId c) {
  std::vector<VertexId> vertices;
  for (int i = 0; i < complex.corners(); ++i) {
    if (complex.vertex(c, i) != kGhost) vertices.push_back(complex.vertex(c, i));
  }
  return vertices;
}

/// Cells with one centre in one group, and ghosts with one ray from it.
template <int K>
Groups groups_of(const AnyTriangulation& t) {
  const Complex& complex = t.complex();
  Groups groups(complex.slot_count());
  if constexpr (K >= 1) {
    Kernel<K> kernel(t.sites());
    const auto inner = [&](CellId ghost) {
      return groups.find(raw(complex.cell(complex.twin(ghost, ghost_slot(complex, ghost)))));
    };
    for (const bool ghosts : {false, true}) {
      for_live_cells(complex, [&](CellId c) {
        if (complex.is_ghost(c) != ghosts) return;
        for (int i = 0; i <= K; ++i) {
          const FacetId across = complex.twin(c, i);
          const CellId d = complex.cell(across);
          if (raw(d) < raw(c) || complex.is_ghost(d) != ghosts) continue;
          const VertexId apex = complex.vertex(d, complex.slot(across));
          const bool one = ghosts ? K > 1 && inner(c) == inner(d) && on_common_hyperplane<K>(kernel, complex, c, apex)
                                  : on_common_orthosphere<K>(kernel, complex, c, apex);
          if (one) groups.unite(raw(c), raw(d));
        }
      });
    }
  }
  return groups;
}

/// Numbers groups of cells by the rows of their vertices, ascending.
/// @param dual  is filled with the numbers, plus `first`
/// @return      a cell of each group
std::vector<CellId> number_groups(const AnyTriangulation& t, Groups& groups, bool ghosts, Index first, Lists& sites,
                                  std::vector<Index>& dual) {
  const Complex& complex = t.complex();
  std::map<Index, Names> rows_of_group;
  for_live_cells(complex, [&](CellId c) {
    if (complex.is_ghost(c) != ghosts) return;
    Names& rows = rows_of_group[groups.find(raw(c))];
    for (const VertexId v : finite_vertices(complex, c)) rows.push_back(t.row(v));
  });
  std::vector<std::pair<Names, Index>> sorted;
  for (auto& [group, rows] : rows_of_group) {
    std::ranges::sort(rows);
    rows.erase(std::ranges::unique(rows).begin(), rows.end());
    sorted.emplace_back(std::move(rows), group);
  }
  std::ranges::sort(sorted);
  std::map<Index, Index> number;
  std::vector<CellId> cells;
  for (const auto& [rows, group] : sorted) {
    number[group] = first + static_cast<Index>(cells.size());
    cells.push_back(CellId{group});
    sites.push(rows);
  }
  for_live_cells(complex, [&](CellId c) {
    if (complex.is_ghost(c) == ghosts) dual[raw(c)] = number[groups.find(raw(c))];
  });
  return cells;
}

void push(std::vector<double>& to, const Vector& x, int dimension) {
  to.insert(to.end(), x.begin(), x.begin() + dimension);
}

}  // namespace

Diagram::Diagram(const AnyTriangulation& t, const DiagramOptions& options) : t_(&t), dimension_(t.dimension()) {
  const ExactEnvironment environment;
  const Complex& complex = t.complex();
  const int k = t.affine_dimension();
  if (k < 0) return;
  Groups groups = options.merged ? with_dimension(k, [&](auto dimension) { return groups_of<dimension>(t); })
                                 : Groups(complex.slot_count());
  dual_.assign(complex.slot_count(), kNone);
  vertex_cells_ = number_groups(t, groups, false, 0, vertex_sites_, dual_);
  for (const CellId c : vertex_cells_)
    push(vertices_, power_centre(t.sites(), finite_vertices(complex, c)), dimension_);
  if (k > 0) {
    const auto first = static_cast<Index>(vertex_count());
    for (const CellId ghost : number_groups(t, groups, true, first, ray_sites_, dual_)) {
      const FacetId inside = complex.twin(ghost, ghost_slot(complex, ghost));
      const CellId c = complex.cell(inside);
      ray_origins_.push_back(dual_[raw(c)]);
      push(ray_directions_,
           outward_normal(t.sites(), finite_vertices(complex, ghost), complex.vertex(c, complex.slot(inside))),
           dimension_);
    }
  }
  if (k < dimension_) directions_ = orthogonal_directions(t.sites(), finite_vertices(complex, vertex_cells_[0]));
}

std::vector<Rational> Diagram::exact_vertex(std::size_t vertex) const {
  return exact_power_centre(t_->sites(), finite_vertices(t_->complex(), vertex_cells_[vertex]));
}

/// Of all simplices of a dimension: which vertices and rays their duals have, each such list once, ascending, with the
/// rows of all simplices that have it.
std::vector<Names> Diagram::spans(int simplex_dimension, std::vector<Names>& sites) const {
  const Complex& complex = t_->complex();
  const auto corners = static_cast<std::size_t>(simplex_dimension) + 1;
  std::vector<Names> incidences;  // the rows of a simplex, then a vertex or ray of its dual
  for_live_cells(complex, [&](CellId c) {
    Names rows;
    for (const VertexId v : finite_vertices(complex, c)) rows.push_back(t_->row(v));
    if (rows.size() < corners) return;
    std::ranges::sort(rows);
    std::vector<bool> chosen(rows.size(), false);
    std::fill_n(chosen.begin(), corners, true);
    do {
      Names& simplex = incidences.emplace_back();
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (chosen[i]) simplex.push_back(rows[i]);
      }
      simplex.push_back(dual_[raw(c)]);
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
  });
  std::ranges::sort(incidences);
  incidences.erase(std::ranges::unique(incidences).begin(), incidences.end());
  std::map<Names, Names> rows_of_span;
  for (std::size_t begin = 0, end = 0; begin < incidences.size(); begin = end) {
    Names span;
    const auto same = [&](const Names& other) {
      return std::equal(other.begin(), other.end() - 1, incidences[begin].begin());
    };
    for (; end < incidences.size() && same(incidences[end]); ++end) span.push_back(incidences[end].back());
    Names& rows = rows_of_span[span];
    rows.insert(rows.end(), incidences[begin].begin(), incidences[begin].end() - 1);
  }
  std::vector<Names> all;
  for (auto& [span, rows] : rows_of_span) {
    std::ranges::sort(rows);
    rows.erase(std::ranges::unique(rows).begin(), rows.end());
    all.push_back(span);
    sites.push_back(std::move(rows));
  }
  return all;
}

/// A simplex whose dual is also that of a simplex of one dimension more lies inside a larger Delaunay face, and stands
/// for no face of its own; the others of its dimension are the parts of Delaunay faces.
DiagramFaces Diagram::faces(int dimension) const {
  DiagramFaces faces;
  faces.dimension = dimension;
  const int k = t_->affine_dimension();
  const int simplex = dimension_ - dimension;
  if (k < 0 || simplex < 0 || simplex > k) return faces;
  std::vector<Names> sites, ignored;
  const std::vector<Names> own = spans(simplex, sites);
  const std::vector<Names> larger = simplex < k ? spans(simplex + 1, ignored) : std::vector<Names>();
  std::vector<std::pair<Names, std::size_t>> order;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (!std::ranges::binary_search(larger, own[i])) order.emplace_back(sites[i], i);
  }
  std::ranges::sort(order);
  for (const auto& [rows, i] : order) {
    faces.sites.push(rows);
    faces.ends.push(own[i]);
  }
  if (dimension == least_dimension() + 2) order_polygons(faces);
  return faces;
}

/// Two ends of a polygon follow each other when an edge of the diagram joins them, or when both are rays.
void Diagram::order_polygons(DiagramFaces& polygons) const {
  struct Edge {
    std::pair<Index, Index> ends;
    std::size_t face;
  };
  std::vector<Edge> edges;
  const DiagramFaces all = faces(polygons.dimension - 1);
  for (std::size_t e = 0; e < all.size(); ++e) {
    if (all.ends[e].size() != 2) continue;  // a whole line
    edges.push_back({{all.ends[e][0], all.ends[e][1]}, e});
    edges.push_back({{all.ends[e][1], all.ends[e][0]}, e});
  }
  std::ranges::sort(edges, {}, &Edge::ends);
  const auto edge = [&](Index a, Index b) {
    const auto found = std::ranges::lower_bound(edges, std::pair(a, b), {}, &Edge::ends);
    return found != edges.end() && found->ends == std::pair(a, b) ? found->face : all.size();
  };
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const std::span<Index> ends =
        std::span(polygons.ends.values).subspan(polygons.ends.offsets[p], polygons.ends[p].size());
    // Ascending, so rays come last: the walk begins with one where there is one, else with the least vertex.
    if (ends.back() >= vertex_count()) std::ranges::rotate(ends, ends.end() - 1);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const auto follows = [&](Index x) { return edge(ends[i], x) != all.size(); };
      const auto next = std::find_if(ends.begin() + static_cast<std::ptrdiff_t>(i) + 1, ends.end(), follows);
      if (next != ends.end()) std::swap(ends[i + 1], *next);
    }
    if (dimension_ != 2 || ends.size() < 3) continue;
    // Counter-clockwise when the neighbours beyond two edges that follow each other turn left about the site.
    const Index site = polygons.sites[p][0];
    const auto beyond = [&](std::size_t i) {
      const std::span<const Index> both = all.sites[edge(ends[i], ends[i + 1])];
      return t_->point(both[0] == site ? both[1] : both[0]);
    };
    const std::vector<double> here = t_->point(site), first = beyond(0), second = beyond(1);
    if (slow_orient<2>({here.data(), first.data(), second.data()}).sign < 0)
      std::reverse(ends.begin() + (ends[0] >= vertex_count() ? 0 : 1), ends.end());
  }
}

Lists Diagram::cells() const {
  const DiagramFaces all = faces(dimension_);
  Lists cells;
  std::size_t next = 0;
  for (std::size_t row = 0; row < t_->row_count(); ++row) {
    const bool has = next < all.size() && all.sites[next][0] == row;
    cells.push(has ? all.ends[next] : std::span<const Index>());
    next += has ? 1 : 0;
  }
  return cells;
}

}  // namespace delone
