// Source: [For92] 4.2: the sites are added from left to right, each seen by a chain of hull edges that begins at the
// site before it; then a queue of edges is flipped until all are locally Delaunay. The number of flips is told: it is
// what the method costs.
#include "build/lawson.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "delone/geometry/kernel.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/topology/complex.hpp"
#include "mesh/edge_flips.hpp"

namespace delone {
namespace {

/// Adds sites beyond the hull, without a thought about circles. A ghost cell (a, b, ghost) stands outside hull edge ab;
/// the one after it, across the facet opposite a, begins at b.
class Sweeper {
  using View = ComplexView<2>;

 public:
  Sweeper(Mesh& mesh, Kernel<2>& kernel) : mesh_(&mesh), complex_(mesh.complex), kernel_(&kernel) {}

  /// @param seen  a hull vertex with a hull edge that p lies strictly beyond
  void add(VertexId p, VertexId seen) {
    CellId first = ghost_before(seen);
    if (!beyond(first, p)) first = after(first);
    CellId last = first;
    while (beyond(before(first), p)) first = before(first);
    while (beyond(after(last), p)) last = after(last);
    const VertexId a = complex_.vertex(first, 0);
    const VertexId b = complex_.vertex(last, 1);
    const CellId left = before(first);
    const CellId right = after(last);
    for (CellId c = first;; c = View::cell(complex_.twin(c, 0))) {  // the ghost gives way to p
      complex_.discount_ghost(c);
      complex_.set_vertex(c, 2, p);
      complex_.settle(c);
      if (c == last) break;
    }
    const CellId to_p = make_ghost(a, p);
    const CellId from_p = make_ghost(p, b);
    complex_.link(View::facet(to_p, 2), View::facet(first, 1));
    complex_.link(View::facet(from_p, 2), View::facet(last, 0));
    complex_.link(View::facet(to_p, 0), View::facet(from_p, 1));
    complex_.link(View::facet(to_p, 1), View::facet(left, 0));
    complex_.link(View::facet(from_p, 0), View::facet(right, 1));
    ++mesh_->vertex_count;
    newest_ = p;
    newest_ghost_ = to_p;
  }

 private:
  CellId after(CellId ghost) const { return View::cell(complex_.twin(ghost, 0)); }
  CellId before(CellId ghost) const { return View::cell(complex_.twin(ghost, 1)); }
  bool beyond(CellId ghost, VertexId p) {
    return kernel_->orient({complex_.vertex(ghost, 0), complex_.vertex(ghost, 1), p}) > 0;
  }
  /// The ghost cell on the hull edge that ends at v.
  CellId ghost_before(VertexId v) const {
    if (v == newest_) return newest_ghost_;
    CellId c = complex_.incident_cell(kGhost);
    while (complex_.vertex(c, 1) != v) c = after(c);
    return c;
  }
  CellId make_ghost(VertexId a, VertexId b) {
    const CellId c = complex_.create();
    complex_.set_vertices(c, {a, b, kGhost});
    complex_.count_ghost(c);
    complex_.settle(c);
    return c;
  }

  Mesh* mesh_;
  View complex_;
  Kernel<2>* kernel_;
  VertexId newest_ = kGhost;
  CellId newest_ghost_ = kNoCell;
};

}  // namespace

void build_by_lawson(Mesh& mesh, std::size_t count, const Progress& progress) {
  Kernel<2> kernel(mesh.sites);
  std::vector<VertexId> sites(count);
  for (std::size_t i = 0; i < count; ++i) sites[i] = VertexId{static_cast<Index>(i)};
  std::ranges::sort(sites, [&](VertexId a, VertexId b) { return kernel.before(a, b); });
  mesh.complex.reserve_more(2 * count + 2, mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());

  // The first sites may stand on one line: the first one off it comes before all but two of them.
  std::size_t off = 2;
  while (kernel.orient({sites[0], sites[1], sites[off]}) == 0) ++off;
  make_first_cells<2>(mesh, {sites[0], sites[1], sites[off]});
  Sweeper sweeper(mesh, kernel);
  for (std::size_t i = 2; i < off; ++i) sweeper.add(sites[i], sites[i - 1]);
  for (std::size_t i = off + 1; i < count; ++i) sweeper.add(sites[i], sites[i - 1]);

  const ComplexView<2> complex(mesh.complex);
  Buffer<FacetId> edges;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    for (int i = 0; i < 3; ++i) {
      if (complex.facet(c, i) < complex.twin(c, i)) edges.push_back(complex.facet(c, i));
    }
  }
  mesh.statistics.flips = flip_until_delaunay(complex, kernel, std::move(edges), progress);
  mesh.statistics.cells_created = mesh.complex.live_count() - mesh.complex.ghost_count() + 2 * mesh.statistics.flips;
  mesh.statistics.predicates += kernel.stats();
}

}  // namespace delone
