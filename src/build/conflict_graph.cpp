// Source: [For92] 4.4 and [GKS92] 1, both after [CS89]: between cells of today and sites still to come there is an arc
// wherever the site would destroy the cell. So nothing is searched when a site's turn comes; the work is in giving new
// cells their arcs. A site in conflict with a new cell was in conflict with one of the two cells at the facet that the
// new one stands on: if the lifted site is below the new hyperplane, it is below one of two that bend upwards from it.
//
// Departure from [For92] 4.4: arcs lead to cells, not to ridges of the hull; a cell in conflict has at most K + 1 of
// these. A site's arcs are its whole cavity; the engine's search, which lists the cavity's boundary in the order that
// filling it wants, goes through the same cells again.
#include "build/conflict_graph.hpp"

#include <array>
#include <cstddef>

#include "base/grown.hpp"
#include "delone/base/buffer.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/cavity.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/topology/complex.hpp"
#include "mesh/one_by_one.hpp"

namespace delone {
namespace {

/// Arcs in two lists each: those of a site, linked both ways, and those of a cell.
class Arcs {
 public:
  explicit Arcs(std::size_t sites) { first_of_site_.resize(sites, kNone); }

  /// A cell in conflict with the site, or kNoCell.
  CellId cell_of(VertexId site) const {
    const Index arc = first_of_site_[raw(site)];
    return arc == kNone ? kNoCell : arcs_[arc].cell;
  }
  /// Calls visit(site) for every site in conflict with a cell.
  template <class Visit>
  void for_sites(CellId c, const Visit& visit) const {
    for (Index a = first_of(c); a != kNone; a = arcs_[a].next_of_cell) visit(arcs_[a].site);
  }
  /// Makes room for arcs of cells below `slots`.
  void grow(std::size_t slots) { grown(first_of_cell_, slots, kNone); }
  void add(VertexId site, CellId c) {
    Index a = free_;
    if (a != kNone) {
      free_ = arcs_[a].next_of_cell;
    } else {
      a = next_id(arcs_.size());
      arcs_.push_back({});
    }
    Index& first = first_of_site_[raw(site)];
    if (first != kNone) arcs_[first].last_of_site = a;
    arcs_[a] = {site, c, first_of_cell_[raw(c)], kNone, first};
    first = first_of_cell_[raw(c)] = a;
  }
  /// Removes all arcs of a cell.
  void drop(CellId c) {
    Index a = first_of(c);
    first_of_cell_[raw(c)] = kNone;
    while (a != kNone) {
      Arc& arc = arcs_[a];
      (arc.last_of_site == kNone ? first_of_site_[raw(arc.site)] : arcs_[arc.last_of_site].next_of_site) =
          arc.next_of_site;
      if (arc.next_of_site != kNone) arcs_[arc.next_of_site].last_of_site = arc.last_of_site;
      const Index next = arc.next_of_cell;
      arc.next_of_cell = free_;
      free_ = a;
      a = next;
    }
  }

 private:
  struct Arc {
    VertexId site;
    CellId cell;
    Index next_of_cell, last_of_site, next_of_site;
  };

  Index first_of(CellId c) const { return first_of_cell_[raw(c)]; }

  Buffer<Arc> arcs_;
  Buffer<Index> first_of_site_, first_of_cell_;
  Index free_ = kNone;  // the first of a list by next_of_cell
};

template <int K>
class ConflictGraph {
 public:
  /// Of sites 0 to count - 1 and the first cells.
  ConflictGraph(Mesh& mesh, std::size_t count)
      : mesh_(&mesh), complex_(mesh.complex), kernel_(mesh.sites), inserter_(mesh), arcs_(count) {
    seen_.resize(count, kNoCell);
    arcs_.grow(complex_.slot_count());
    mesh.scratch.reserve_cells(K, complex_.slot_count());
    for (std::size_t s = K + 1; s < count; ++s) {
      for (std::size_t c = 0; c < complex_.slot_count(); ++c) {
        connect(VertexId{static_cast<Index>(s)}, CellId{static_cast<Index>(c)});
      }
    }
  }
  ~ConflictGraph() { mesh_->statistics.predicates += kernel_.stats(); }
  ConflictGraph(const ConflictGraph&) = delete;
  ConflictGraph& operator=(const ConflictGraph&) = delete;

  void insert(VertexId s) {
    const CellId c = arcs_.cell_of(s);
    if (c == kNoCell) return;  // hidden
    inserter_.insert_at(s, c, [this, s](const Scratch& scratch) { hand_over(scratch, s); });
  }

 private:
  void connect(VertexId s, CellId c) {
    ++mesh_->statistics.history_steps;
    if (in_conflict(complex_, kernel_, mesh_->scratch, c, s)) arcs_.add(s, c);
  }

  /// The new cells get their arcs from the cells at their facets, and those of the cavity lose theirs.
  void hand_over(const Scratch& scratch, VertexId inserted) {
    arcs_.grow(complex_.slot_count());
    for (std::size_t b = 0; b < scratch.boundary.size(); ++b) {
      const CellId fresh = scratch.created[b];
      const CellId inside = complex_.cell(scratch.boundary[b]);
      const CellId outside = complex_.cell(complex_.twin(fresh, complex_.slot(scratch.boundary[b])));
      asked_.clear();
      for (const CellId old : {inside, outside}) {
        arcs_.for_sites(old, [&](VertexId s) {
          if (s != inserted && seen_[raw(s)] != fresh) asked_.push_back(s);
          seen_[raw(s)] = fresh;
        });
      }
      for (const VertexId s : asked_) {
        connect(s, fresh);
        seen_[raw(s)] = kNoCell;  // the slot of the cell may be used again
      }
    }
    for (const FacetId f : scratch.cavity) arcs_.drop(complex_.cell(f));
  }

  Mesh* mesh_;
  ComplexView<K> complex_;
  Kernel<K> kernel_;
  Inserter<K> inserter_;
  Arcs arcs_;
  Buffer<CellId> seen_;     // per site the new cell that it has been listed for
  Buffer<VertexId> asked_;  // the sites listed for one
};

}  // namespace

void build_by_conflict_graph(Mesh& mesh, std::size_t count, const Progress& progress) {
  insert_one_by_one<ConflictGraph>(mesh, count, progress, count);
}

}  // namespace delone
