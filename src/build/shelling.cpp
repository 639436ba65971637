// Source: [Sei86] (Seidel's convex hulls by shelling), named in [For92] 4.6 and [ES96] 3 and 10.
//
// A point p sinks from far above along the vertical line through a point o, and crosses the hyperplanes of the lifted
// hull one by one, first that of the cell that contains o. At all times the cells whose hyperplanes are above p are
// those that p is in conflict with: they fill a ball that is star-shaped as o sees it, and every facet of its boundary,
// the horizon, faces o. That order of the cells is a shelling: each new cell touches the ball in whole facets, those
// that o is beyond.
//
// With p as a site, the horizon carries the star of p, and the next cell comes when that star is no longer regular:
//   across a ridge of the horizon, when p crosses the hyperplane of the cell that the two facets there span, if that
//   lies outside, in a notch of the horizon;
//   across a facet of the horizon, when p crosses the hyperplane of the cell beyond. Where that cell touches the ball
//   in more facets, these span it, and the first case has seen it. If not, its apex is a new site v, and it is the
//   first cell with v in the order: of all hyperplanes through the lifted v, and below all lifted sites, the one that
//   is highest at o. That is a linear program, and can be solved beforehand. A site without solution is hidden.
// So each step takes the earliest of what is known, and no cell is ever looked for.
//
// The complex is closed at all times: a ghost cell stands on each facet of the horizon, and ghost cells are neighbours
// across its ridges. What is left of them at the end closes the hull.
//
// Departure: a linear program is solved by exchanging sites (mesh/first_cell.hpp), where the tree finds a site in
// conflict (mesh/site_tree.hpp); [Sei86] goes through all sites, which costs n^2 in all.
// Departure: o is a point infinitely near site 0 (mesh/crossing.hpp), so that it lies in no hyperplane of sites
// whatever they are, and needs no luck.
#include "build/shelling.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/tell_every.hpp"
#include "delone/base/assert.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/facet_table.hpp"
#include "delone/topology/complex.hpp"
#include "mesh/crossing.hpp"
#include "mesh/first_cell.hpp"
#include "mesh/from_cells.hpp"
#include "mesh/history.hpp"
#include "mesh/site_tree.hpp"

namespace delone {
namespace {

template <int K>
class Sheller {
  using Cell = typename Kernel<K>::Cell;
  static constexpr std::size_t kCorners = K + 1;

 public:
  Sheller(Mesh& mesh, std::size_t count)
      : mesh_(&mesh),
        count_(count),
        complex_(mesh.complex),
        kernel_(mesh.sites),
        tree_(mesh.sites, count),
        order_(tree_, kernel_),
        awaited_(table_, count) {}
  ~Sheller() { mesh_->statistics.predicates += kernel_.stats(); }
  Sheller(const Sheller&) = delete;
  Sheller& operator=(const Sheller&) = delete;

  void shell(const Progress& progress) {
    Sinker<K> sinker(tree_, kernel_);
    const Cell first = sinker.first_cell();
    for (std::size_t i = 0; i < count_; ++i) {
      tell_every(insertions_a_call(K), progress, i, 2 * count_);
      const VertexId v = tree_.in_order()[i];
      if (std::ranges::find(first, v) == first.end()) await(first, v, sinker);
    }
    begin(first);
    for (std::size_t step = 1; !queue_.empty(); ++step) {
      tell_every(insertions_a_call(K), progress, step, 2 * step * count_ / (count_ + mesh_->vertex_count));
      const Index next = pop();
      if (is_due(events_[next])) take(events_[next].crossing.cell, events_[next].ghost);
      release(next);
    }
    for (const CellId ghost : retired_) complex_.release(ghost);
  }

 private:
  /// A cell that may come. It stands on a ghost cell, in whose slots it has its vertices, the apex in that of the
  /// ghost.
  struct Event {
    Crossing<K> crossing;
    CellId ghost;
  };

  /// Finds the first cell with v in the order; it waits for its facet opposite v to join the horizon. In the first cell
  /// v takes the place of the vertex opposite the facet by which the ray from v through o leaves it.
  void await(const Cell& first, VertexId v, Sinker<K>& sinker) {
    Cell cell = first;
    const int slot = slot_for(kernel_, cell, v, -1);
    if (slot < 0) return;  // not reached: o lies in one of the simplices that v makes
    cell[static_cast<std::size_t>(slot)] = v;
    if (!sinker.sink(cell, slot)) return;  // v is hidden
    Index& known = awaited_[FacetTable<K>::key(cell, slot)];
    DELONE_ASSERT(known == kNone, "I2 one cell is beyond a facet");
    known = raw(v);
  }

  void begin(const Cell& first) {
    mesh_->complex.reserve_more(1, mesh_->sites.size());
    const CellId c = complex_.create();
    complex_.set_vertices(c, first);
    for (int i = 0; i <= K; ++i) complex_.set_twin(c, i, kNoFacet);
    complex_.settle(c);
    close_hull<K>(*mesh_);
    mesh_->vertex_count = kCorners;
    ++mesh_->statistics.cells_created;
    for (int i = 0; i <= K; ++i) expect_site(complex_.cell(complex_.twin(c, i)));
  }

  // --- What is known of cells to come ---

  /// The cell on a facet that has joined the horizon, and a site that awaits this.
  void expect_site(CellId ghost) {
    const Cell cell = complex_.vertices(ghost);
    const int slot = complex_.slot_of(ghost, kGhost);
    if (const Index v = awaited_.at(FacetTable<K>::key(cell, slot)); v != kNone) expect(ghost, VertexId{v});
  }

  /// The cell that two facets of the horizon span, if it lies outside. @param ridge  a facet of two ghost cells
  void expect_between(FacetId ridge) {
    const CellId ghost = complex_.cell(ridge);
    const VertexId apex = complex_.vertex(complex_.twin(ridge));
    Cell cell = complex_.vertices(ghost);
    cell[static_cast<std::size_t>(complex_.slot_of(ghost, kGhost))] = apex;
    if (kernel_.orient(cell) > 0) expect(ghost, apex);
  }

  void expect(CellId ghost, VertexId apex) {
    Cell cell = complex_.vertices(ghost);
    cell[static_cast<std::size_t>(complex_.slot_of(ghost, kGhost))] = apex;
    Event event{order_.crossing(cell), ghost};
    if (unused_.empty()) {
      unused_.push_back(static_cast<Index>(events_.size()));
      events_.emplace_back();
    }
    const Index place = unused_.back();
    unused_.pop_back();
    events_[place] = std::move(event);
    queue_.push_back(place);
    std::ranges::push_heap(queue_, later());
  }

  /// The queue's top is what no other one comes before.
  auto later() {
    return [this](Index a, Index b) { return order_.before(events_[b].crossing, events_[a].crossing); };
  }

  Index pop() {
    std::ranges::pop_heap(queue_, later());
    const Index next = queue_.back();
    queue_.pop_back();
    return next;
  }
  void release(Index event) {
    events_[event].crossing.exact.reset();
    unused_.push_back(event);
  }

  /// Whether the facets that span the cell are still on the horizon; if not, the cell has come.
  bool is_due(const Event& event) const {
    if (!complex_.is_live(event.ghost) || !complex_.is_ghost(event.ghost)) return false;
    Cell cell = complex_.vertices(event.ghost);
    VertexId& apex = cell[static_cast<std::size_t>(complex_.slot_of(event.ghost, kGhost))];
    apex = event.crossing.cell[static_cast<std::size_t>(complex_.slot_of(event.ghost, kGhost))];
    return cell == event.crossing.cell;
  }

  // --- The next cell ---

  /// The ghost cells on facets of the new cell, by its slots: they give way.
  std::array<CellId, kCorners> touched(const Cell& cell, CellId on) {
    const int apex = complex_.slot_of(on, kGhost);
    std::array<CellId, kCorners> gone;
    for (int i = 0; i <= K; ++i) {
      const FacetId across = complex_.twin(on, i);
      const bool on_horizon = i == apex || complex_.vertex(across) == cell[static_cast<std::size_t>(apex)];
      gone[static_cast<std::size_t>(i)] = !on_horizon ? kNoCell : (i == apex ? on : complex_.cell(across));
      DELONE_ASSERT(on_horizon == (History<K>::side_of_origin(kernel_, kernel_.at(cell), i) < 0),
                    "a new cell touches the ball in those facets that o is beyond");
    }
    return gone;
  }

  /// Adds a cell, which stands on a ghost cell. Its facets that o is beyond leave the horizon, the others join it.
  void take(Cell cell, CellId on) {
    const auto gone = touched(cell, on);
    mesh_->complex.reserve_more(kCorners + 1, mesh_->sites.size());
    std::array<FacetId, kCorners> inside;
    std::array<std::array<FacetId, kCorners>, kCorners>
        around;  // of a leaving facet i and a joining j, across the ridge
    for (std::size_t i = 0; i < kCorners; ++i) {
      if (gone[i] == kNoCell) continue;
      inside[i] = complex_.twin(gone[i], complex_.slot_of(gone[i], kGhost));
      for (std::size_t j = 0; j < kCorners; ++j) {
        if (gone[j] == kNoCell) around[i][j] = complex_.twin(gone[i], complex_.slot_of(gone[i], cell[j]));
      }
    }
    const CellId c = complex_.create();
    complex_.set_vertices(c, cell);
    for (const CellId ghost : gone) {
      if (ghost != kNoCell) retire(ghost);
    }
    for (const VertexId v : cell) mesh_->vertex_count += complex_.has_vertex(v) ? 0 : 1;
    complex_.settle(c);
    ++mesh_->statistics.cells_created;
    std::array<CellId, kCorners> fresh;
    for (std::size_t i = 0; i < kCorners; ++i) {
      fresh[i] = gone[i] == kNoCell ? ghost_on(c, static_cast<int>(i)) : kNoCell;
      if (gone[i] != kNoCell) complex_.link(complex_.facet(c, static_cast<int>(i)), inside[i]);
    }
    for (std::size_t i = 0; i < kCorners; ++i) {
      for (std::size_t j = 0; j < kCorners; ++j) {
        if (i == j || fresh[j] == kNoCell) continue;
        const FacetId ridge = complex_.facet(fresh[j], complex_.slot_of(fresh[j], cell[i]));
        if (fresh[i] == kNoCell) {
          complex_.link(ridge, around[i][j]);
          expect_between(ridge);
        } else {
          complex_.set_twin(ridge, complex_.facet(fresh[i], complex_.slot_of(fresh[i], cell[j])));
        }
      }
    }
    for (const CellId ghost : fresh) {
      if (ghost != kNoCell) expect_site(ghost);
    }
  }

  /// Ghost cells that leave wait for new facets of the horizon: so the ids of finite cells ascend as they come.
  void retire(CellId ghost) {
    complex_.discount_ghost(ghost);
    complex_.set_vertex(ghost, complex_.slot_of(ghost, kGhost),
                        VertexId{0});  // no ghost cell, so no event is due on it
    retired_.push_back(ghost);
  }
  CellId new_ghost() {
    if (retired_.empty()) return complex_.create();
    const CellId ghost = retired_.back();
    retired_.pop_back();
    return ghost;
  }

  CellId ghost_on(CellId c, int i) {
    const CellId ghost = new_ghost();
    complex_.set_vertices(ghost, outside_of<K>(complex_.vertices(c), i));
    complex_.count_ghost(ghost);
    complex_.settle(ghost);
    complex_.link(complex_.facet(c, i), complex_.facet(ghost, complex_.slot_of(ghost, kGhost)));
    ++mesh_->statistics.cells_created;
    return ghost;
  }

  Mesh* mesh_;
  std::size_t count_;
  ComplexView<K> complex_;
  Kernel<K> kernel_;
  SiteTree<K> tree_;
  CrossingOrder<K> order_;
  Buffer<Index> table_;
  FacetTable<K> awaited_;  // per facet the site that comes with the cell beyond it
  std::vector<Event> events_;
  std::vector<Index> unused_;  // places among these
  std::vector<Index> queue_;   // a heap of them
  std::vector<CellId> retired_;
};

}  // namespace

void build_by_shelling(Mesh& mesh, std::size_t count, const Progress& progress) {
  mesh.complex.reserve_more(0, mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension<1>(mesh.complex.dimension(), [&](auto dimension) { Sheller<dimension>(mesh, count).shell(progress); });
}

}  // namespace delone
