// Source: [For92] 4.6, gift wrapping of the lifted sites.
//
// A facet of which one side is done gets the cell beyond it: its apex is the site strictly beyond whose cell no other
// site strictly beyond is in conflict with. The hyperplanes through a lifted facet are ordered by their slope across
// it, so a site in conflict with the best cell so far is better, and one that was not never will be: one search finds
// the apex, and the ball outside of which it need not look shrinks on the way. Where no site is strictly beyond, the
// facet is one of the hull. The kernel breaks all ties, so cospherical sites need no care.
//
// Departure: in place of Dwyer's buckets there is a tree of boxes (mesh/site_tree.hpp), since a grid serves uniform
// sites only, and hardly in higher dimensions. It passes over boxes on the wrong side of the facet, too; without that,
// what is nearest to a long facet is mostly behind it.
// Departure: the first facets are those of a cell that is found by exchanging vertices (mesh/first_cell.hpp), so the
// hull needs no special start.
//
// Where very many sites are close to one sphere, all of them are close to the balls of all cells: then each search
// looks at each site, as in plain gift wrapping, at a cost of sites times cells.
#include "build/gift_wrap.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/tell_every.hpp"
#include "delone/base/assert.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/facet_table.hpp"
#include "delone/topology/complex.hpp"
#include "mesh/first_cell.hpp"
#include "mesh/from_cells.hpp"
#include "mesh/site_tree.hpp"

namespace delone {
namespace {

/// A query of the tree: the apex of the cell beyond a facet.
template <int K>
class BeyondQuery {
  using Cell = typename Kernel<K>::Cell;

 public:
  BeyondQuery(const SiteTree<K>& tree, Kernel<K>& kernel, const Cell& cell, int slot)
      : tree_(tree), kernel_(kernel), cell_(outside_of<K>(cell, slot)), wall_(tree.wall(cell, slot)) {
    for (std::size_t i = 0; i < cell_.size(); ++i) {
      if (cell_[i] == kGhost) {
        apex_ = i;
      } else {
        for (std::size_t j = 0; j < K; ++j) middle_[j] += tree.x(cell_[i], j) / K;
      }
    }
  }

  bool found() const { return cell_[apex_] != kGhost; }
  const Cell& cell() const { return cell_; }

  double rank(std::size_t box) const {
    if (tree_.clearance(wall_, box).is_certain()) return SiteTree<K>::kNever;
    if (!found()) return tree_.squared_distance(middle_, box);
    const auto clearance = tree_.clearance(ball_, box);
    return clearance.is_certain() ? SiteTree<K>::kNever : tree_.limited(clearance.least);
  }

  bool visit(VertexId v) {
    if (std::ranges::find(cell_, v) != cell_.end() || !is_beyond(v)) return false;
    if (found() && !in_conflict(tree_, kernel_, ball_, cell_, v)) return false;
    cell_[apex_] = v;
    ball_ = tree_.plane(cell_);
    return false;
  }

 private:
  bool is_beyond(VertexId v) {
    if (const int side = tree_.clearance(wall_, v).sign(); side != 0) [[likely]]
      return side < 0;
    Cell with = cell_;
    with[apex_] = v;
    return kernel_.orient(with) > 0;
  }

  const SiteTree<K>& tree_;
  Kernel<K>& kernel_;
  Cell cell_;  // the ghost cell on the facet, then the best cell so far
  std::size_t apex_ = 0;
  std::array<double, K> middle_{};  // of the facet
  Plane<K> wall_;
  Plane<K> ball_;
};

template <int K>
class Wrapper {
  using Cell = typename Kernel<K>::Cell;

 public:
  Wrapper(Mesh& mesh, std::size_t count)
      : mesh_(&mesh),
        count_(count),
        complex_(mesh.complex),
        kernel_(mesh.sites),
        tree_(mesh.sites, count),
        facets_(table_, count) {}
  ~Wrapper() { mesh_->statistics.predicates += kernel_.stats(); }
  Wrapper(const Wrapper&) = delete;
  Wrapper& operator=(const Wrapper&) = delete;

  void wrap(const Progress& progress) {
    add(Sinker<K>(tree_, kernel_).first_cell());
    for (std::size_t step = 1; !open_.empty(); ++step) {
      tell_every(insertions_a_call(K), progress, step,
                 step * count_ / mesh_->vertex_count);  // the share of the sites that are reached
      const FacetId f = open_[open_.size() - 1];
      open_.resize(open_.size() - 1);
      if (complex_.twin(f) != kNoFacet) continue;
      BeyondQuery<K> query(tree_, kernel_, complex_.vertices(complex_.cell(f)), complex_.slot(f));
      tree_.search(query);
      if (query.found()) add(query.cell());
    }
    close_hull<K>(*mesh_);
  }

 private:
  /// Adds a cell and links it to those of its neighbours that are there.
  void add(const Cell& cell) {
    mesh_->complex.reserve_more(1, mesh_->sites.size());
    const CellId c = complex_.create();
    complex_.set_vertices(c, cell);
    for (int i = 0; i <= K; ++i) {
      const FacetId f = complex_.facet(c, i);
      Index& known = facets_[FacetTable<K>::key(cell, i)];
      if (known == kNone) {
        known = raw(f);
        complex_.set_twin(f, kNoFacet);
        open_.push_back(f);
      } else {
        DELONE_ASSERT(complex_.twin(FacetId{known}) == kNoFacet, "I6 cells cover space once");
        complex_.link(f, FacetId{known});
      }
    }
    for (const VertexId v : cell) mesh_->vertex_count += complex_.has_vertex(v) ? 0 : 1;
    complex_.settle(c);
    ++mesh_->statistics.cells_created;
  }

  Mesh* mesh_;
  std::size_t count_;
  ComplexView<K> complex_;
  Kernel<K> kernel_;
  SiteTree<K> tree_;
  Buffer<Index> table_;
  FacetTable<K> facets_;
  Buffer<FacetId> open_;  // of these some have got a twin since
};

}  // namespace

void build_by_gift_wrapping(Mesh& mesh, std::size_t count, const Progress& progress) {
  mesh.complex.reserve_more(0, mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension<1>(mesh.complex.dimension(), [&](auto dimension) { Wrapper<dimension>(mesh, count).wrap(progress); });
}

}  // namespace delone
