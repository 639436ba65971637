// Insert vertices one after the other: locate, find the cavity, fill it with the star.
// Source: [For92] 4.3; redundant points as in [ES96] 2.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "delone/mesh/cavity.hpp"
#include "delone/mesh/edit.hpp"
#include "delone/mesh/star.hpp"
#include "delone/mesh/triangulation.hpp"
#include "delone/mesh/walk.hpp"

namespace delone {

/// What to do with site q that stands at the place of vertex v: nothing when q is heavier and must be inserted. Of
/// equal points the one with the lowest row is the vertex, whichever came first.
inline std::optional<Outcome> meet_at_same_place(Mesh& mesh, VertexId q, VertexId v) {
  const double wq = mesh.sites.weight(q);
  const double wv = mesh.sites.weight(v);
  if (wq > wv) return std::nullopt;
  if (wq < wv) return Outcome::hidden;
  mesh.duplicates.add(q, v, std::max(mesh.sites.row(q), mesh.sites.row(v)));
  if (mesh.sites.row(q) < mesh.sites.row(v)) mesh.sites.swap_rows(q, v);
  return Outcome::duplicate;
}

/// Sees the mesh with its dimension K >= 1 as a constant. Sites are appended before it is made, and stay where they
/// are.
template <int K>
class Inserter {
 public:
  explicit Inserter(Mesh& mesh) : mesh_(&mesh), complex_(mesh.complex), kernel_(mesh.sites), scratch_(&mesh.scratch) {}
  ~Inserter() { mesh_->statistics.predicates += kernel_.stats(); }
  Inserter(const Inserter&) = delete;
  Inserter& operator=(const Inserter&) = delete;

  /// Inserts site q, which is in no cell yet, starting the walk from the live cell `start`.
  /// On std::bad_alloc the mesh is as it was. Cost: the walk, then O(K * cells changed).
  Outcome insert(VertexId q, CellId start) { return *try_insert(q, start); }

  /// The same where the scratch's territory has a vertex of `start`. Nothing, and the mesh is as it was, when the walk
  /// or the cavity would leave it.
  std::optional<Outcome> try_insert(VertexId q, CellId start) {
    reserve();
    WalkStats walked;
    const CellId c = locate(q, start, walked);
    mesh_->statistics.walk_steps += walked.steps;
    mesh_->statistics.walk_fallbacks += walked.fallbacks;
    last_ = c;
    if (c == kNoCell) return std::nullopt;
    if (!scratch_->territory.whole() && !scratch_->territory.holds(complex_.vertices(c))) return std::nullopt;
    if (const VertexId v = vertex_at_place_of(q, c); v != kGhost) {
      if (const auto outcome = meet_at_same_place(*mesh_, q, v)) {
        if (*outcome == Outcome::hidden) hide(q, c);
        return *outcome;
      }
    } else if (mesh_->sites.weighted() && !in_conflict(complex_, kernel_, *scratch_, c, q)) {
      hide(q, c);  // without weights a point inside a cell is inside its circumscribing ball
      return Outcome::hidden;
    }
    if (!replace_cavity(q, c, [](const Scratch&) {})) return std::nullopt;
    return Outcome::inserted;
  }

  /// Inserts site q, which is known to be in conflict with the live cell c, and to stand at no vertex's place.
  /// @param watch  called with the scratch when both the cavity and its star are there; if it throws, the mesh is
  /// spoilt
  template <class Watch>
  void insert_at(VertexId q, CellId c, const Watch& watch) {
    reserve();
    replace_cavity(q, c, watch);
  }

  /// A live cell close to the last insertion; after a failed trial the one where its walk ended, or kNoCell.
  CellId last_cell() const { return last_; }
  /// What the last insertion changed, if its outcome was `inserted`; valid until the next.
  /// Cannot fail: room has been made.
  Edit edit() {
    auto& removed = scratch_->removed;
    removed.resize(scratch_->cavity.size());
    for (std::size_t i = 0; i < removed.size(); ++i) removed[i] = complex_.cell(scratch_->cavity[i]);
    return {.gone = scratch_->swallowed, .came = {&came_, 1}, .removed = removed, .created = scratch_->created};
  }

 private:
  void reserve() {
    scratch_->reserve_cells(K, complex_.slot_count());
    scratch_->reserve_vertices(K, mesh_->sites.size());
    if (mesh_->hidden.kept()) mesh_->hidden.reserve(mesh_->sites.size(), complex_.slot_count());
  }

  /// A cell in conflict with q, or the one that contains it; kNoCell where the way would leave the territory.
  CellId locate(VertexId q, CellId start, WalkStats& walked) {
    if constexpr (K > 3) {
      const CellId end = descend(complex_, kernel_, *scratch_, q, start, walked);
      if (kernel_.sight(scratch_->plane<K>(end), q).surely_below()) return end;
      if (!complex_.is_ghost(start)) start = end;  // else q may lie outside, too, not far along the hull
    }
    return walk(complex_, kernel_, kernel_.at(q), start, walked, scratch_->territory);
  }

  VertexId vertex_at_place_of(VertexId q, CellId c) const {
    for (const VertexId v : complex_.vertices(c)) {
      if (v != kGhost && kernel_.same_place(v, q)) return v;
    }
    return kGhost;
  }

  template <class Watch>
  bool replace_cavity(VertexId q, CellId start, const Watch& watch) {
    try {
      if (!find_cavity(complex_, kernel_, q, start, *scratch_)) {
        clean_marks();
        return false;
      }
      mesh_->complex.reserve_more(scratch_->boundary.size(), mesh_->sites.size());
      scratch_->prepare_star(K, mesh_->complex.slot_count_with(scratch_->boundary.size()));
      if (mesh_->sites.weighted()) reserve_hidden();
    } catch (...) {
      clean_marks();
      throw;
    }
    if (mesh_->hidden.kept()) displace_hidden();  // from here on nothing fails
    fill_cavity(complex_, q, *scratch_);
    if constexpr (K > 3) keep_hyperplanes(complex_, kernel_, q, *scratch_);
    watch(*scratch_);
    came_ = q;
    ++mesh_->vertex_count;
    if (mesh_->sites.weighted()) hide_swallowed_vertices();
    const bool marked = marks_cells(kernel_);
    for (const FacetId f : scratch_->cavity) {  // which is clean_marks(), too, in one loop
      complex_.destroy(complex_.cell(f));
      if (marked) scratch_->marks[raw(complex_.cell(f))] = Scratch::Mark::none;
    }
    if (mesh_->hidden.kept()) place_hidden();
    mesh_->statistics.cells_created += scratch_->created.size();
    const CellId outside = complex_.incident_cell(kGhost);
    last_ = outside != kNoCell && complex_.has(outside, q)
                ? outside
                : scratch_->created.front();  // the next may lie outside, too
    return true;
  }

  void clean_marks() {
    if (!marks_cells(kernel_)) return;
    for (const FacetId f : scratch_->cavity) scratch_->marks[raw(complex_.cell(f))] = Scratch::Mark::none;
  }

  void hide(VertexId v, CellId c) {
    if (mesh_->hidden.kept()) mesh_->hidden.add(v, c);
  }

  /// Room for all that the new vertex may hide or displace.
  void reserve_hidden() {
    scratch_->swallowed.reserve(scratch_->cavity.size() + K);  // a ball has no more vertices
    if (!mesh_->hidden.kept()) return;
    mesh_->hidden.reserve(mesh_->sites.size(), complex_.slot_count() + scratch_->boundary.size());
    std::size_t count = 0;
    for (const FacetId f : scratch_->cavity) {
      for (VertexId v = mesh_->hidden.first(complex_.cell(f)); v != kGhost; v = mesh_->hidden.next(v)) ++count;
    }
    scratch_->displaced.reserve(count);
  }
  void displace_hidden() {
    scratch_->displaced.clear();
    for (const FacetId f : scratch_->cavity) {
      for (VertexId v; (v = mesh_->hidden.first(complex_.cell(f))) != kGhost;) {
        mesh_->hidden.remove(v);
        scratch_->displaced.push_back(v);
      }
    }
  }
  /// When memory runs out within a predicate, the lists are given up: the next removal makes them anew.
  void place_hidden() try {
    CellId near = scratch_->created.front();
    for (const Buffer<VertexId>* sites : {&scratch_->displaced, &scratch_->swallowed}) {
      for (const VertexId v : *sites) {
        WalkStats walked;
        near = walk(complex_, kernel_, kernel_.at(v), near, walked);
        mesh_->hidden.add(v, near);
      }
    }
  } catch (...) {
    mesh_->hidden = {};
  }

  /// Vertices whose whole star lay in the cavity have become redundant. Each vertex of the cavity is one of the first
  /// cell, or lies opposite the facet by which the search entered another.
  void hide_swallowed_vertices() {
    scratch_->swallowed.clear();
    for (const VertexId v : complex_.vertices(complex_.cell(scratch_->cavity.front()))) hide_if_swallowed(v);
    for (const FacetId f : scratch_->cavity) hide_if_swallowed(complex_.vertex(f));
  }
  void hide_if_swallowed(VertexId v) {
    if (v == kGhost || !complex_.has_vertex(v)) return;
    if (scratch_->marks[raw(complex_.incident_cell(v))] != Scratch::Mark::conflicting) return;
    complex_.forget(v);
    --mesh_->vertex_count;
    scratch_->swallowed.push_back(v);  // there is room
  }

  Mesh* mesh_;
  ComplexView<K> complex_;
  Kernel<K> kernel_;
  Scratch* scratch_;
  CellId last_ = kNoCell;
  VertexId came_ = kGhost;
};

/// Where all sites stand at one place the heaviest is the vertex, and there is nothing to search.
template <>
class Inserter<0> {
 public:
  explicit Inserter(Mesh& mesh) : mesh_(&mesh), complex_(mesh.complex) {}

  Outcome insert(VertexId q, CellId /*start*/) {
    const CellId c = complex_.cell(complex_.twin(mesh_->complex.incident_cell(kGhost), 0));
    const VertexId v = complex_.vertex(c, 0);
    if (const auto outcome = meet_at_same_place(*mesh_, q, v)) return *outcome;
    complex_.forget(v);
    complex_.set_vertex(c, 0, q);
    complex_.settle(c);
    return Outcome::inserted;
  }
  CellId last_cell() const { return mesh_->complex.incident_cell(kGhost); }
  Edit edit() const { return {.rebuilt = true}; }

 private:
  Mesh* mesh_;
  ComplexView<0> complex_;
};

/// Makes the first cells of an empty complex: a simplex of sites, positively oriented, and a ghost cell on each of its
/// facets. Room has been reserved.
template <int K>
void make_first_cells(Mesh& mesh, std::array<VertexId, K + 1> simplex) {
  ComplexView<K> complex(mesh.complex);
  if constexpr (K >= 1) {
    if (Kernel<K>(mesh.sites).orient(simplex) < 0) std::swap(simplex[0], simplex[1]);
  }
  const auto make = [&](const std::array<VertexId, K + 1>& vertices) {
    const CellId c = complex.create();
    for (int i = 0; i <= K; ++i) complex.set_vertex(c, i, vertices[static_cast<std::size_t>(i)]);
    complex.settle(c);
    complex.count_ghost(c);
    return c;
  };
  const CellId finite = make(simplex);
  std::array<CellId, K + 1> ghosts;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    auto vertices = simplex;
    vertices[i] = kGhost;
    // Seen from outside the facet turns over (I3): one swap, which also takes the ghost to the last slot (I4).
    if constexpr (K >= 1) {
      if (K == 1 || i != K) {
        std::swap(vertices[i], vertices[K == 1 ? 1 - i : K]);
      } else {
        std::swap(vertices[0], vertices[1]);
      }
    }
    ghosts[i] = make(vertices);
    complex.link(complex.facet(finite, static_cast<int>(i)),
                 complex.facet(ghosts[i], complex.slot_of(ghosts[i], kGhost)));
    for (std::size_t j = 0; j < i; ++j) {
      complex.link(complex.facet(ghosts[i], complex.slot_of(ghosts[i], simplex[j])),
                   complex.facet(ghosts[j], complex.slot_of(ghosts[j], simplex[i])));
    }
  }
  mesh.vertex_count = K + 1;
}

/// The same with sites 0 to K.
template <int K>
void make_first_cells(Mesh& mesh) {
  std::array<VertexId, K + 1> simplex;
  for (std::size_t i = 0; i < simplex.size(); ++i) simplex[i] = VertexId{static_cast<Index>(i)};
  make_first_cells<K>(mesh, simplex);
}

}  // namespace delone
