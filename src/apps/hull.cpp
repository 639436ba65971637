// Source: [GKS92] 4.1. Points are inserted in random order. A point beyond a facet takes the place of all facets that
// it lies beyond, and is joined to their horizon; facets of the past are kept, each with the facets that it led to, and
// lead the way from the first simplex to a facet of today that a point lies beyond.
//
// Departure from [GKS92] 4.1: one hull, not a lower and an upper one; so vertical facets are none of its concern. A
// facet that goes has for each of its ridges a successor: the new facet there, or the facet across, which goes, too.
// Departure from [GKS92] 4.1: points in general position are not assumed. The first hull takes a point for beyond a
// facet only when it strictly is, and then has points that are no corners, since they came early: points within a face
// or an edge. A vertex is one of these when another vertex of its star lies on all hyperplanes that it lies on, for
// then the least face that holds it is more than itself. The corners alone are then inserted again, each pulled
// outwards by an infinitesimal, as geometry/perturb.hpp does with heights; so faces are divided in one way only.
#include "delone/apps/hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/groups.hpp"
#include "base/grown.hpp"
#include "base/tell_every.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/geometry/perturb.hpp"
#include "delone/mesh/scratch.hpp"
#include "delone/mesh/star.hpp"
#include "delone/topology/complex.hpp"
#include "mesh/distinct.hpp"

namespace delone {
namespace {

/// The hull of sites that span dimension D >= 2, as a complex of dimension D - 1 without a ghost. A facet is oriented
/// so that the simplex of it and a point beyond is positive.
template <int D>
class Hull {
  static constexpr int K = D - 1;
  using View = ComplexView<K>;
  static constexpr std::size_t kCorners = D;

 public:
  using Facet = std::array<VertexId, kCorners>;

  /// @param ties_pull  a point in the hyperplane of a facet may take its place, as if all were pulled outwards
  Hull(const Sites& sites, bool ties_pull)
      : sites_(&sites), kernel_(sites), ties_pull_(ties_pull), complex_(K), view_(complex_) {}

  /// @param ids  sites at different places; the first D + 1 span space
  void insert_all(std::span<const VertexId> ids, const Progress& progress) {
    complex_.reserve_more(kCorners + 1, sites_->size());
    complex_.grow_vertices(sites_->size());
    make_simplex(ids);
    for (std::size_t i = D + 1; i < ids.size(); ++i) {
      tell_every(insertions_a_call(D), progress, i, ids.size());
      if (const CellId f = find(ids[i]); f != kNoCell) replace_visible(ids[i], f);
    }
  }

  const Complex& complex() const { return complex_; }
  View view() const { return view_; }
  std::vector<CellId> facets() const {
    std::vector<CellId> live;
    for (std::size_t s = 0; s < view_.slot_count(); ++s) {
      if (view_.is_live(CellId{static_cast<Index>(s)})) live.push_back(CellId{static_cast<Index>(s)});
    }
    return live;
  }
  int side(const Facet& facet, VertexId q) {
    typename Kernel<D>::Cell simplex;
    std::ranges::copy(facet, simplex.begin());
    simplex[D] = q;
    return kernel_.orient(simplex);
  }
  /// Whether a facet and the one across from slot i lie in one hyperplane.
  bool is_flat(CellId f, int i) { return side(view_.vertices(f), view_.vertex(view_.twin(f, i))) == 0; }
  /// Whether v is a corner, and not within a larger face.
  bool is_corner(VertexId v) {
    const std::vector<CellId> star = star_of(v);
    for (const CellId f : star) {
      for (const VertexId w : view_.vertices(f)) {
        const auto holds_w = [&](CellId g) { return side(view_.vertices(g), w) == 0; };
        if (w != v && std::ranges::all_of(star, holds_w)) return false;
      }
    }
    return true;
  }

 private:
  struct Node {
    Facet vertices;
    std::array<Index, kCorners> next;  ///< per ridge, once the facet has gone
    CellId facet;                      ///< of today, else kNoCell
    Index visited;                     ///< the last search that came here
  };

  void make_simplex(std::span<const VertexId> ids) {
    std::array<CellId, D + 1> facet;
    for (std::size_t i = 0; i <= D; ++i) {
      Facet vertices;
      for (std::size_t j = 0, place = 0; j <= D; ++j) {
        if (j != i) vertices[place++] = ids[j];
      }
      if (side(vertices, ids[i]) > 0) std::swap(vertices[0], vertices[1]);
      basis_[i] = ids[i];
      facet[i] = add_facet(vertices);
      for (std::size_t j = 0; j < i; ++j) {
        view_.link(view_.facet(facet[i], view_.slot_of(facet[i], ids[j])),
                   view_.facet(facet[j], view_.slot_of(facet[j], ids[i])));
      }
    }
  }

  CellId add_facet(const Facet& vertices) {
    const CellId f = view_.create();
    view_.set_vertices(f, vertices);
    view_.settle(f);
    note(f);
    return f;
  }
  void note(CellId f) {
    grown(node_of_, raw(f)) = next_id(nodes_.size());
    nodes_.push_back({view_.vertices(f), {}, f, 0});
  }

  bool is_beyond(const Facet& facet, VertexId q) {
    if (const int s = side(facet, q); s != 0 || !ties_pull_) return s > 0;
    return wins_tie(facet, q);
  }

  /// As perturbed_conflict, with the barycentric coordinates of q within the hyperplane: seen from a site off it.
  bool wins_tie(const Facet& facet, VertexId q) {
    VertexId off = basis_[0];
    for (const VertexId b : basis_) off = side(facet, off) == 0 ? b : off;
    const int orientation = side(facet, off);
    return perturbed_conflict<kCorners - 1>(
        facet, q, [this](VertexId a, VertexId b) { return kernel_.before(a, b); },
        [&](const Facet& replaced) { return side(replaced, off) * orientation; });
  }

  /// A facet of today that q lies beyond, or kNoCell.
  CellId find(VertexId q) {
    ++epoch_;
    open_.clear();
    for (Index n = 0; n <= D; ++n) open_.push_back(n);
    while (!open_.empty()) {
      Node& node = nodes_[open_[open_.size() - 1]];
      open_.resize(open_.size() - 1);
      if (node.visited == epoch_) continue;
      node.visited = epoch_;
      if (!is_beyond(node.vertices, q)) continue;
      if (node.facet != kNoCell) return node.facet;
      for (const Index next : node.next) open_.push_back(next);
    }
    return kNoCell;
  }

  /// Lists the facets that q lies beyond, from one of them, and their horizon.
  void search(VertexId q, CellId first) {
    scratch_.reserve_cells(0, view_.slot_count());
    scratch_.cavity.clear();
    scratch_.boundary.clear();
    const auto take = [&](FacetId f) {
      scratch_.cavity.push_back(f);
      scratch_.marks[raw(view_.cell(f))] = Scratch::Mark::conflicting;
    };
    take(view_.facet(first, 0));
    for (std::size_t next = 0; next < scratch_.cavity.size(); ++next) {
      const CellId f = view_.cell(scratch_.cavity[next]);
      for (int i = 0; i <= K; ++i) {
        const FacetId across = view_.twin(f, i);
        const CellId g = view_.cell(across);
        if (scratch_.marks[raw(g)] == Scratch::Mark::conflicting) continue;
        if (is_beyond(view_.vertices(g), q)) {
          take(across);
        } else {
          scratch_.boundary.push_back(view_.facet(f, i));
        }
      }
    }
  }

  void replace_visible(VertexId q, CellId first) {
    search(q, first);
    complex_.reserve_more(scratch_.boundary.size(), sites_->size());
    scratch_.prepare_star(0, view_.slot_count() + scratch_.boundary.size());
    for (const FacetId f : scratch_.cavity) {
      Node& node = nodes_[node_of_[raw(view_.cell(f))]];
      node.facet = kNoCell;
      for (int i = 0; i <= K; ++i) {
        node.next[static_cast<std::size_t>(i)] = node_of_[raw(view_.cell(view_.twin(view_.cell(f), i)))];
      }
    }
    for (std::size_t b = 0; b < scratch_.boundary.size(); ++b) {
      const FacetId inside = scratch_.boundary[b];
      const CellId fresh = view_.create();
      scratch_.created[b] = fresh;
      view_.set_vertices(fresh, view_.vertices(view_.cell(inside)));
      view_.set_vertex(fresh, view_.slot(inside), q);
      view_.link(view_.facet(fresh, view_.slot(inside)), view_.twin(inside));
    }
    star::link_by_turning(view_, q, scratch_);
    for (std::size_t b = 0; b < scratch_.boundary.size(); ++b) {
      const FacetId inside = scratch_.boundary[b];
      nodes_[node_of_[raw(view_.cell(inside))]].next[static_cast<std::size_t>(view_.slot(inside))] =
          static_cast<Index>(nodes_.size());
      note(scratch_.created[b]);
    }
    for (const FacetId f : scratch_.cavity) {
      scratch_.marks[raw(view_.cell(f))] = Scratch::Mark::none;
      view_.release(view_.cell(f));
    }
  }

  std::vector<CellId> star_of(VertexId v) {
    ++epoch_;
    std::vector<CellId> star;
    const auto take = [&](CellId f) {
      if (std::exchange(nodes_[node_of_[raw(f)]].visited, epoch_) != epoch_) star.push_back(f);
    };
    take(view_.incident_cell(v));
    for (std::size_t next = 0; next < star.size(); ++next) {
      for (int i = 0; i <= K; ++i) {
        if (view_.vertex(star[next], i) != v) take(view_.cell(view_.twin(star[next], i)));
      }
    }
    return star;
  }

  const Sites* sites_;
  Kernel<D> kernel_;
  bool ties_pull_;
  Complex complex_;
  View view_;
  std::array<VertexId, D + 1> basis_{};
  Scratch scratch_;
  Buffer<Node> nodes_;
  Buffer<Index> node_of_;  // per facet slot
  Buffer<Index> open_;
  Index epoch_ = 0;
};

/// Some sites, the first of which span space.
std::vector<VertexId> spanning_first(const Sites& sites, std::vector<VertexId> ids) {
  const auto d = static_cast<std::size_t>(sites.dimension());
  std::vector<double> coordinates(ids.size() * d);
  for (std::size_t i = 0; i < ids.size(); ++i) sites.copy_point(ids[i], std::span(coordinates).subspan(i * d, d));
  const AffineHull hull = affine_hull(PointsView(coordinates, sites.dimension()));
  auto place = ids.begin();
  for (const Index found : std::span(hull.basis).first(static_cast<std::size_t>(hull.flat.dimension) + 1)) {
    std::rotate(place++, ids.begin() + found, ids.begin() + found + 1);
  }
  return ids;
}

/// The volume of the simplex with these corners, of any dimension up to that of the points.
double simplex_volume(PointsView points, std::span<const Index> rows) {
  const auto d = static_cast<std::size_t>(points.dimension());
  std::vector<std::array<double, kMaxDimension>> edges;  // made orthogonal one after the other
  double volume = 1;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::array<double, kMaxDimension> edge{};
    for (std::size_t j = 0; j < d; ++j) edge[j] = points[rows[i]][j] - points[rows[0]][j];
    for (const auto& other : edges) {
      const double share = std::inner_product(edge.begin(), edge.end(), other.begin(), 0.0);
      for (std::size_t j = 0; j < d; ++j) edge[j] -= share * other[j];
    }
    double length = 0;
    for (const double x : edge) length = std::hypot(length, x);
    volume *= length / static_cast<double>(i);
    if (length == 0) return 0;
    for (double& x : edge) x /= length;
    edges.push_back(edge);
  }
  return volume;
}

void measure(PointsView points, ConvexHull& hull) {
  const Index apex = hull.corners.front();  // simplices on all facets but those at one corner fill the hull
  std::vector<Index> simplex;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    hull.area += simplex_volume(points, hull.facets[f]);
    if (std::ranges::find(hull.facets[f], apex) != hull.facets[f].end()) continue;
    simplex.assign(1, apex);
    simplex.insert(simplex.end(), hull.facets[f].begin(), hull.facets[f].end());
    hull.volume += simplex_volume(points, simplex);
  }
}

/// Rows of a facet ascending, the last two exchanged where its orientation asks for it (see hull_facets).
template <int D>
std::array<Index, D> named(const Sites& sites, const typename Hull<D>::Facet& facet) {
  std::array<Index, D> rows;
  for (std::size_t i = 0; i < D; ++i) rows[i] = sites.row(facet[i]);
  bool odd = D % 2 == 0;  // the normal goes first, past D - 1 edges
  for (std::size_t i = 1; i < D; ++i) {
    for (std::size_t j = i; j > 0 && rows[j] < rows[j - 1]; --j) {
      std::swap(rows[j], rows[j - 1]);
      odd = !odd;
    }
  }
  if (odd) std::swap(rows[D - 1], rows[D - 2]);
  return rows;
}

template <int D>
void tabulate(Hull<D>& of, const Sites& sites, ConvexHull& hull) {
  const std::vector<CellId> facets = of.facets();
  std::vector<std::array<Index, D>> rows;
  Groups groups(of.view().slot_count());
  for (const CellId f : facets) {
    rows.push_back(named<D>(sites, of.view().vertices(f)));
    for (int i = 0; i < D; ++i) {
      const CellId across = of.view().cell(of.view().twin(f, i));
      if (raw(f) < raw(across) && of.is_flat(f, i)) groups.unite(raw(f), raw(across));
    }
  }
  std::vector<std::pair<Index, Index>> members;  // group, corner
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (const Index row : rows[f]) members.emplace_back(groups.find(raw(facets[f])), row);
  }
  std::ranges::sort(members);
  members.erase(std::unique(members.begin(), members.end()), members.end());
  std::vector<std::vector<Index>> faces;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (i == 0 || members[i].first != members[i - 1].first) faces.emplace_back();
    faces.back().push_back(members[i].second);
  }
  std::ranges::sort(faces);
  for (const auto& face : faces) {
    hull.faces.vertices.insert(hull.faces.vertices.end(), face.begin(), face.end());
    hull.faces.offsets.push_back(hull.faces.vertices.size());
    hull.corners.insert(hull.corners.end(), face.begin(), face.end());
  }
  std::ranges::sort(rows, [](auto a, auto b) {
    std::ranges::sort(a);
    std::ranges::sort(b);
    return a < b;
  });
  hull.facets.corners = D;
  for (const auto& facet : rows) hull.facets.vertices.insert(hull.facets.vertices.end(), facet.begin(), facet.end());
  std::ranges::sort(hull.corners);
  hull.corners.erase(std::unique(hull.corners.begin(), hull.corners.end()), hull.corners.end());
}

template <int D>
void find_hull(const Sites& sites, std::size_t count, const Progress& progress, ConvexHull& hull) {
  std::vector<VertexId> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = VertexId{static_cast<Index>(i)};
  Hull<D> all(sites, false);
  all.insert_all(ids, progress);
  bool general = true;
  for (const CellId f : all.facets()) {
    for (int i = 0; i < D && general; ++i) general = !all.is_flat(f, i);
  }
  if (general) return tabulate(all, sites, hull);
  const auto is_no_corner = [&](VertexId v) {
    return all.view().incident_cell(v) == kNoCell || !all.view().is_live(all.view().incident_cell(v)) ||
           !all.view().has(all.view().incident_cell(v), v) || !all.is_corner(v);
  };
  std::erase_if(ids, is_no_corner);
  Hull<D> corners(sites, true);
  corners.insert_all(spanning_first(sites, std::move(ids)), progress);
  tabulate(corners, sites, hull);
}

/// The two ends of points on a line.
void find_ends(const Sites& sites, std::size_t count, ConvexHull& hull) {
  const Kernel<1> kernel(sites);
  VertexId least{0};
  VertexId most{0};
  for (std::size_t i = 1; i < count; ++i) {
    const VertexId v{static_cast<Index>(i)};
    if (kernel.before(v, least)) least = v;
    if (kernel.before(most, v)) most = v;
  }
  hull.corners = {sites.row(least), sites.row(most)};
  std::ranges::sort(hull.corners);
  hull.facets = {.corners = 1, .vertices = hull.corners, .neighbours = {}};
  hull.faces = {.offsets = {0, 1, 2}, .vertices = hull.corners};
}

}  // namespace

ConvexHull convex_hull(PointsView points, const HullOptions& options) {
  require_row_count(points.size(), points.dimension());
  require_finite(points);
  const ExactEnvironment environment;
  const PointsView places(points.coordinates(), points.dimension());  // weights do not matter
  ConvexHull hull;
  hull.affine_dimension = affine_dimension(places);
  if (hull.affine_dimension < 1) {
    if (hull.affine_dimension == 0) hull.corners = {0};
    return hull;
  }
  const DistinctSites sites = distinct_sites(places, Order::random, options.seed, options.threads);
  if (hull.affine_dimension == 1) {
    find_ends(sites.mesh.sites, sites.count, hull);
  } else {
    with_dimension<2>(hull.affine_dimension, [&](auto dimension) {
      find_hull<dimension>(sites.mesh.sites, sites.count, options.progress, hull);
    });
  }
  measure(places, hull);
  return hull;
}

}  // namespace delone
