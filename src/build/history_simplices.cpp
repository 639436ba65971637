// Source: [For92] 4.4. When s takes the place of the cells in conflict with it, a (K + 1)-simplex stands on each of
// them, between the old lower hull and the new one, with s as its apex. All these simplices, from the first on, are the
// structure that is searched: from a simplex to its children, which are cells of a later hull, and to its siblings of
// the same apex. A simplex is known by its parent, the cell that it stands on, and is active for a query when the
// query's lifted point lies below that cell: then the query would have destroyed it.
//
// Departure from [For92] 4.4: the first simplex has the ghost in the place of its (d + 2)-nd site.
// Departure from [For92] 4.4: a sibling is entered when it is active, without asking first on which side of the face
// between the two the query lies. No more than the active simplices are entered either way, which is what theorem 4.3
// counts, and the one test that is left is the one for which a normal is stored.
#include "build/history_simplices.hpp"

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

template <int K>
class Simplices {
  using Cell = std::array<VertexId, K + 1>;
  static constexpr std::size_t kCorners = K + 1;

 public:
  explicit Simplices(Mesh& mesh) : mesh_(&mesh), complex_(mesh.complex), kernel_(mesh.sites), inserter_(mesh) {
    for (std::size_t s = 0; s < complex_.slot_count(); ++s) add(CellId{static_cast<Index>(s)});
    for (Index n = 0; n < kRoots; ++n) find_behind(n);
  }
  ~Simplices() { mesh_->statistics.predicates += kernel_.stats(); }
  Simplices(const Simplices&) = delete;
  Simplices& operator=(const Simplices&) = delete;

  void insert(VertexId s) {
    const CellId c = find(s);
    if (c == kNoCell) return;  // hidden
    inserter_.insert_at(s, c, [this](const Scratch& scratch) { stand_on_cavity(scratch); });
  }

 private:
  static constexpr Index kRoots = K + 2;

  /// A cell of some hull so far. While it is one of today's, `next` says only, for a ghost cell in the slot of the
  /// ghost, which finite cell has the same facet; from then on, for each facet, the parent of a sibling or a child: for
  /// that slot again a finite cell with this facet.
  struct Node {
    Cell vertices;
    Hyperplane<K> plane;
    std::array<Index, kCorners> next;
    CellId cell;    ///< of today, else kNoCell
    Index visited;  ///< the last search that came here
  };

  /// A cell of today that the lifted s lies below, or kNoCell.
  CellId find(VertexId s) {
    ++epoch_;
    open_.clear();
    for (Index n = kRoots; n-- > 0;) open_.push_back(n);
    while (!open_.empty()) {
      const Index n = open_[open_.size() - 1];
      open_.resize(open_.size() - 1);
      if (nodes_[n].visited == epoch_) continue;
      nodes_[n].visited = epoch_;
      ++mesh_->statistics.history_steps;
      if (!is_active(nodes_[n], s)) continue;
      if (nodes_[n].cell != kNoCell) return nodes_[n].cell;
      for (const Index next : nodes_[n].next) open_.push_back(next);
    }
    return kNoCell;
  }

  bool is_active(const Node& node, VertexId s) {
    return kernel_.conflict(kernel_.sight(node.plane, s), [&] {
      for (std::size_t i = 0; i < kCorners; ++i) {
        if (node.vertices[i] != kGhost) continue;
        Cell beyond = node.vertices;
        beyond[i] = s;
        if (const int side = kernel_.orient(beyond); side != 0) return side > 0;
        return kernel_.conflict(nodes_[node.next[i]].vertices, s);  // as beyond_facet: any cell at the facet does
      }
      return kernel_.conflict(node.vertices, s);
    });
  }

  void add(CellId c) {
    Node node{complex_.vertices(c), {}, {}, c, 0};
    if (K > 1) node.plane = kernel_.hyperplane(node.vertices);
    grown(node_of_, raw(c)) = next_id(nodes_.size());
    nodes_.push_back(node);
  }

  /// The finite cell on the facet of a ghost cell of today.
  void find_behind(Index n) {
    const CellId c = nodes_[n].cell;
    const int ghost = complex_.ghost_slot(c);
    if (ghost < 0) return;
    nodes_[n].next[static_cast<std::size_t>(ghost)] = node_of_[raw(complex_.cell(complex_.twin(c, ghost)))];
  }

  /// A simplex stands on each cell of the cavity: beyond a facet within the cavity there is a sibling, beyond one on
  /// its boundary a child.
  void stand_on_cavity(const Scratch& scratch) {
    for (const FacetId f : scratch.cavity) nodes_[node_of_[raw(complex_.cell(f))]].cell = kNoCell;
    const auto first_child = static_cast<Index>(nodes_.size());
    for (const FacetId f : scratch.cavity) {
      const CellId c = complex_.cell(f);
      for (int i = 0; i <= K; ++i) {
        const auto across = raw(complex_.cell(complex_.twin(c, i)));
        if (across < node_of_.size()) nodes_[node_of_[raw(c)]].next[static_cast<std::size_t>(i)] = node_of_[across];
      }
    }
    for (std::size_t b = 0; b < scratch.boundary.size(); ++b) {
      const FacetId inside = scratch.boundary[b];
      nodes_[node_of_[raw(complex_.cell(inside))]].next[static_cast<std::size_t>(complex_.slot(inside))] =
          static_cast<Index>(nodes_.size());
      add(scratch.created[b]);
    }
    for (Index n = first_child; n < nodes_.size(); ++n) find_behind(n);
  }

  Mesh* mesh_;
  ComplexView<K> complex_;
  Kernel<K> kernel_;
  Inserter<K> inserter_;
  Buffer<Node> nodes_;
  Buffer<Index> node_of_;  // per cell slot
  Buffer<Index> open_;
  Index epoch_ = 0;
};

}  // namespace

void build_by_history_simplices(Mesh& mesh, std::size_t count, const Progress& progress) {
  insert_one_by_one<Simplices>(mesh, count, progress);
}

}  // namespace delone
