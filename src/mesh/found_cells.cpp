// The cells are the triangulation of all n sites if
//   * facets are glued two by two, triangles are positively oriented, and the hull is convex and goes round once: then
//     a point is in as many triangles as times that the hull winds about it, which is one or none;
//   * there are 2n - 2 of them, as many as any triangulation of n sites has: so no site is missing;
//   * none is in conflict with the vertex across any of its facets [For92 2].
// Doubles decide nearly all of this, with a bound; what remains is left to the kernel.
#include "mesh/found_cells.hpp"

#include "delone/geometry/kernel.hpp"
#include "delone/mesh/cavity.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

#ifdef DELONE_SIXTEENS

namespace {

using sixteen::InPlane;

class Prover {
 public:
  Prover(Mesh& mesh, const InPlane& sites, const FoundCells& cells)
      : mesh_(mesh), sites_(sites), cells_(cells), complex_(mesh.complex), kernel_(mesh.sites) {}
  ~Prover() { mesh_.statistics.predicates += kernel_.stats(); }
  Prover(const Prover&) = delete;
  Prover& operator=(const Prover&) = delete;

  DELONE_BY_SIXTEENS bool prove() {
    if (cells_.count != cells_.due()) return false;
    fill();
    mesh_.vertex_count = mesh_.sites.size();
    mesh_.statistics.cells_created += cells_.count;
    kernel_.count_filtered(3 * cells_.count / 2);
    return is_closed_ && is_oriented_ && summits_ == 1 && no_conflict();
  }

 private:
  DELONE_BY_SIXTEENS void fill() {
    mesh_.complex.reserve_more(cells_.due(), mesh_.sites.size());
    mesh_.complex.grow_vertices(mesh_.sites.size());
    complex_.create_row(cells_.due());
    for (Index i = 0; i < cells_.due(); ++i) {
      const CellId c{i};
      const auto& [a, b, end, none] = cells_.corners[i];
      const Index* const twins = &cells_.twins[std::size_t{4} * i];
      is_closed_ &= twins[0] != 4 * i && twins[1] != 4 * i + 1 && twins[2] != 4 * i + 2;
      const bool ghost = end == cells_.ghost;
      const std::array<Index, 3> vertices{a, b, ghost ? raw(kGhost) : end};
      for (int k = 0; k < 3; ++k) {  // not all at once: what is put together from parts waits for each
        complex_.set_vertex(c, k, VertexId{vertices[static_cast<std::size_t>(k)]});
        complex_.set_twin(c, k, FacetId{twins[k]});
      }
      if (ghost) {
        planes_[i] = sites_.wall(a, b);
        complex_.count_ghosts(1, c);
        if (rises(i) && !rises(twins[0] / 4)) ++summits_;
      } else {
        planes_[i] = sites_.plane(a, b, end);
        complex_.set_incident(VertexId{end}, c);
        is_oriented_ &= InPlane::orientation(planes_[i]) > InPlane::kBound;
      }
    }
    for (int i = 0; i < 2; ++i) complex_.set_incident(complex_.vertex(CellId{0}, i), CellId{0});
  }
  /// Whether an edge of the hull does.
  bool rises(Index ghost_cell) const {
    const auto& [a, b, end, none] = cells_.corners[ghost_cell];
    return kernel_.before(VertexId{a}, VertexId{b});
  }
  /// Whether no cell is in conflict with the vertex across any of its facets.
  DELONE_BY_SIXTEENS bool no_conflict() {
    bool sure = true;  // one of two facets that are glued is enough
    for (Index c = 0; c < cells_.due(); ++c) sure &= surely_none(4 * c + 2);
    for (std::size_t i = 0; i < cells_.met_count; ++i) sure &= surely_none(cells_.met[i]);
    if (sure) return true;
    for (Index f = 0; f < 4 * cells_.due(); ++f) {
      if (f % 4 != 3 && !surely_none(f) && is_in_conflict(f)) return false;
    }
    return true;
  }
  /// Whether doubles tell that there is no conflict across a facet; and whether there is one.
  DELONE_INLINE_BY_SIXTEENS bool surely_none(Index f) const {
    return sites_.height(planes_[f / 4], cells_.across(f)) > InPlane::kBound;
  }
  bool is_in_conflict(Index f) {
    const VertexId v{cells_.across(f)};
    const auto below = [&](CellId finite) { return kernel_.conflict(complex_.vertices(finite), v); };
    return in_conflict(complex_, kernel_, CellId{f / 4}, v, below);
  }

  Mesh& mesh_;
  const InPlane& sites_;
  const FoundCells& cells_;
  ComplexView<2> complex_;
  Kernel<2> kernel_;
  bool is_closed_ = true, is_oriented_ = true;
  int summits_ = 0;                                       ///< edges of the hull that rise before one that falls
  std::array<InPlane::Plane, FoundCells::kMost> planes_;  // by cell
};

}  // namespace

bool prove(Mesh& mesh, const sixteen::InPlane& sites, const FoundCells& cells) {
  return Prover(mesh, sites, cells).prove();
}

#endif

}  // namespace delone
