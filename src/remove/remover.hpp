// Remove a vertex: its star gives way to cells between the vertices of its link.
//
// The cells that fill the hole are the cells of the canonical triangulation of all that stays, so any exact way to find
// them will do. Two are here, for links of every size and in any dimension:
//   wrapping      for small links: on each open facet stands the vertex of the link, on the facet's inner side, whose
//                 cell has no other vertex of the link in conflict; where no vertex stands on that side, the ghost.
//                 Source: [For92] 4.6 (gift wrapping), within a hole. Cost: O(cells * link).
//   triangulating the vertices of the link, and the hidden sites of the star, by the incremental method. The cells in
//                 conflict with v fill the hole, ghost cells included; their boundary is the link. Insertion read
//                 backwards, cost as for building from the link: k log k in the plane.
// Removal is planned first, which may fail, and then carried out, which cannot.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "delone/mesh/cavity.hpp"
#include "delone/mesh/edit.hpp"
#include "delone/mesh/facet_table.hpp"
#include "delone/mesh/triangulation.hpp"
#include "delone/mesh/walk.hpp"
#include "mesh/triangulate.hpp"

namespace delone {

template <int K>
class Remover {
  static constexpr Index kCorners = K + 1;
  static constexpr Index kStride = 2 * kCorners;
  using Cell = typename Kernel<K>::Cell;

 public:
  explicit Remover(Mesh& mesh)
      : mesh_(&mesh), complex_(mesh.complex), kernel_(mesh.sites), scratch_(&mesh.scratch), hole_(&mesh.scratch.hole) {}
  ~Remover() { mesh_->statistics.predicates += kernel_.stats(); }
  Remover(const Remover&) = delete;
  Remover& operator=(const Remover&) = delete;

  /// Finds what will take the place of v's star. False when every finite cell is in the star: what stays may be flat,
  /// and is to be built anew. On an exception nothing has changed.
  /// @param may_return  keep what bring_back() needs
  bool plan(VertexId v, bool may_return) {
    scratch_->reserve_cells(K, complex_.slot_count());
    if (mesh_->hidden.kept()) mesh_->hidden.reserve(mesh_->sites.size(), complex_.slot_count());
    hole_->clear();
    const std::size_t finite = collect_star(v);
    if (finite == mesh_->complex.live_count() - mesh_->complex.ghost_count()) return false;
    look_around();
    collect_hidden();
    find_cells(v, finite);
    make_room();
    if (may_return) remember_star();
    if (!hole_->repeats.empty()) note_repeats();
    return true;
  }

  /// Carries out the plan. Cannot fail.
  void carry_out(VertexId v) {
    for (const VertexId h : hole_->asked) mesh_->hidden.remove(h);
    complex_.forget(v);
    mesh_->vertex_count += hole_->revived.size();
    --mesh_->vertex_count;
    trade_slots(hole_->gone, hole_->made);
    put(hole_->made, hole_->cells);
    for (std::size_t b = 0; b < hole_->gone.size(); ++b)
      complex_.set_twin(hole_->outside[b], FacetId{hole_->closed[b]});
    if (!hole_->asked.empty()) settle_asked();
    mesh_->statistics.cells_created += hole_->made.size();
  }

  /// Undoes what carry_out() did to v, if the plan was made for it and nothing has changed since. Cannot fail.
  /// @return what this changed; valid until the next change
  Edit bring_back(const VertexId& v) {
    for (const VertexId h : hole_->revived) complex_.forget(h);
    mesh_->vertex_count -= hole_->revived.size();
    ++mesh_->vertex_count;
    if (!hole_->asked.empty()) mesh_->hidden = {};
    trade_slots(hole_->made, hole_->gone);
    put(hole_->gone, hole_->star);
    for (std::size_t b = 0; b < hole_->gone.size(); ++b) {
      const CellId c = hole_->gone[b];
      complex_.set_twin(hole_->outside[b], complex_.facet(c, complex_.slot_of(c, v)));
    }
    return {.gone = hole_->revived, .came = {&v, 1}, .removed = hole_->made, .created = hole_->gone};
  }

  /// What carry_out() changed; valid until the next removal. @param v  what was removed, valid as long as the edit
  Edit edit(const VertexId& v) const {
    return {.gone = {&v, 1}, .came = hole_->revived, .removed = hole_->gone, .created = hole_->made};
  }

  // --- Moving in place ---

  /// The star of v, if it has no ghost cell and hides no site.
  bool collect_inner_star(VertexId v) {
    scratch_->reserve_cells(K, complex_.slot_count());
    if (collect_star(v) < scratch_->cavity.size()) return false;
    look_around();
    return std::ranges::all_of(hole_->gone, [this](CellId c) { return mesh_->hidden.first(c) == kGhost; });
  }

  /// Whether the cells of the star, whose vertex has moved, are positive, and regular with their neighbours: they then
  /// fill the same hole, and heights are convex across each facet as they are elsewhere, so everywhere.
  bool star_is_regular() {
    for (const CellId c : hole_->gone) {
      if constexpr (K > 3) scratch_->plane<K>(c) = {};
      if (kernel_.orient(complex_.vertices(c)) <= 0) return false;
    }
    for (const CellId c : hole_->gone) {
      for (int i = 0; i <= K; ++i) {
        const FacetId across = complex_.twin(c, i);
        const VertexId w = complex_.vertex(across);
        if (w != kGhost && kernel_.conflict(complex_.vertices(c), w)) return false;
      }
    }
    return true;
  }

  Edit edit_in_place(const VertexId& v) const {
    return {.gone = {&v, 1}, .came = {&v, 1}, .removed = hole_->gone, .created = hole_->gone};
  }

 private:
  /// Links of more vertices are triangulated. Figures: bench/DEAD_ENDS.md.
  static constexpr std::size_t kWrapped = K <= 2 ? 32 : (K == 3 ? 40 : 0);

  /// The new cells, in the way that suits the hole.
  void find_cells(VertexId v, std::size_t finite) {
    if (hole_->asked.empty()) {
      if constexpr (K == 2) {
        if (finite == scratch_->cavity.size() && finite <= kWrapped) return split_polygon();
      }
      if (collect_link(v, kWrapped)) return wrap({hole_->link.data(), hole_->link.size()});
    }
    collect_link(v, std::numeric_limits<std::size_t>::max());
    triangulate_link(v);
  }

  /// The cells at v, each by its facet opposite v, into scratch.cavity. @return how many are finite
  std::size_t collect_star(VertexId v) {
    Refill star(scratch_->cavity);
    std::size_t finite = 0;
    const auto take = [&](Refill<FacetId>& list, FacetId f) {
      list.push(f);
      finite += complex_.is_ghost(complex_.cell(f)) ? 0 : 1;
      return f;
    };
    const CellId start = complex_.incident_cell(v);
    star.make_room(1);
    FacetId last = take(star, complex_.facet(start, complex_.slot_of(start, v)));
    if constexpr (K == 2) {
      // Round both ways at once: one way waits for memory while the other does, too.
      Refill back(scratch_->boundary);
      FacetId first = last;
      const auto step = [&](FacetId f, int way) {
        const FacetId across = complex_.twin(complex_.cell(f), complex_.turned(complex_.slot(f), way));
        return complex_.facet(complex_.cell(across), complex_.turned(complex_.slot(across), way));
      };
      for (;;) {
        star.make_room(1);
        back.make_room(1);
        const FacetId ahead = step(last, 1);
        const FacetId behind = step(first, 2);
        fetch(last, 2);
        fetch(first, 1);
        if (ahead == first) break;
        last = take(star, ahead);
        if (behind == last) break;
        first = take(back, behind);
      }
      star.make_room(back.size());
      while (!back.empty()) star.push(back.pop());
    } else {
      const auto mark = [&](std::size_t i, Scratch::Mark m) { scratch_->marks[raw(complex_.cell(star[i]))] = m; };
      try {
        mark(0, Scratch::Mark::conflicting);
        for (std::size_t next = 0; next < star.size(); ++next) {
          star.make_room(K);
          const CellId c = complex_.cell(star[next]);
          const int apex = complex_.slot(star[next]);
          for (int i = 0; i <= K; ++i) {
            const CellId across = complex_.cell(complex_.twin(c, i));
            if (i == apex || scratch_->marks[raw(across)] == Scratch::Mark::conflicting) continue;
            take(star, complex_.facet(across, complex_.slot_of(across, v)));
            mark(star.size() - 1, Scratch::Mark::conflicting);
          }
        }
      } catch (...) {
        for (std::size_t i = 0; i < star.size(); ++i) mark(i, Scratch::Mark::none);
        throw;
      }
      for (std::size_t i = 0; i < star.size(); ++i) mark(i, Scratch::Mark::none);
    }
    return finite;
  }

  /// Asks memory for what planning and filling will touch at a facet of the link, and at the end of it that is new.
  void fetch(FacetId inside, int way) const {
    complex_.prefetch(complex_.cell(complex_.twin(inside)));
    const CellId c = complex_.cell(inside);
    const VertexId w = complex_.vertex(c, complex_.turned(complex_.slot(inside), way));
    if (w == kGhost) return;
    __builtin_prefetch(kernel_.at(w));
    complex_.prefetch(w);
  }

  /// Notes the cells that go, and what lies beyond them.
  void look_around() {
    const std::size_t count = scratch_->cavity.size();
    hole_->gone.resize(count);
    hole_->outside.resize(count);
    hole_->closed.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
      hole_->gone[b] = complex_.cell(scratch_->cavity[b]);
      hole_->outside[b] = complex_.twin(scratch_->cavity[b]);
    }
  }

  void collect_hidden() {
    if (!mesh_->hidden.kept()) return;
    for (const CellId c : hole_->gone) {
      for (VertexId h = mesh_->hidden.first(c); h != kGhost; h = mesh_->hidden.next(h)) {
        hole_->asked.push_back(h);
      }
    }
    std::ranges::sort(hole_->asked, {}, [this](VertexId h) { return mesh_->sites.row(h); });
  }

  /// The finite vertices of the link. False when they are more than `most`.
  bool collect_link(VertexId v, std::size_t most) {
    auto& link = hole_->link;
    link.clear();
    for (const CellId c : hole_->gone) {
      for (const VertexId w : complex_.vertices(c)) {
        if (w == v || w == kGhost) continue;
        if (most <= kWrapped && std::find(link.begin(), link.end(), w) != link.end()) continue;
        if (link.size() == most) return false;
        link.push_back(w);
      }
    }
    if (most > kWrapped) {
      std::ranges::sort(link);
      link.resize(static_cast<std::size_t>(std::unique(link.begin(), link.end()) - link.begin()));
    }
    return true;
  }

  // --- Wrapping ---

  /// Fills the hole facet by facet with cells whose apex is one of `apices`, or the ghost.
  void wrap(std::span<const VertexId> apices) {
    std::ranges::fill(hole_->closed, kNone);
    FacetTable<K> facets(hole_->table, 3 * scratch_->cavity.size());
    for (std::size_t b = 0; b < scratch_->cavity.size(); ++b) {
      const Cell cell = complex_.vertices(complex_.cell(scratch_->cavity[b]));
      const int apex = complex_.slot(scratch_->cavity[b]);
      facets[FacetTable<K>::key(cell, apex)] = outside(b);
      if (!has_ghost(cell, apex)) hole_->open.push_back(outside(b));
    }
    while (!hole_->open.empty()) {
      const Index f = hole_->open[hole_->open.size() - 1];
      hole_->open.resize(hole_->open.size() - 1);
      if (is_closed(f)) continue;
      auto [cell, apex] = seen_from_inside(f);
      if (!choose_apex(cell, apex, apices)) put_ghost(cell, apex);
      add(cell, facets);
    }
  }

  /// A cell that the facet's inner side would be in, and the slot of its apex, which is to be chosen.
  struct Half {
    Cell cell;
    int apex;
  };
  Half seen_from_inside(Index f) const {
    if (is_outside(f)) {
      const FacetId facet = scratch_->cavity[boundary(f)];
      return {complex_.vertices(complex_.cell(facet)), complex_.slot(facet)};
    }
    // The other side of a new cell's facet: two vertices trade their places.
    Cell cell = cell_at(cell_of(f));
    const int i = slot_of(f);
    const int j = i == 0 ? 1 : 0;
    std::swap(cell[static_cast<std::size_t>(i)], cell[static_cast<std::size_t>(j)]);
    return {cell, j};
  }

  bool choose_apex(Cell& cell, int apex, std::span<const VertexId> apices) {
    VertexId& chosen = cell[static_cast<std::size_t>(apex)];
    bool found = false;
    for (const VertexId w : apices) {
      if (std::find(cell.begin(), cell.end(), w) != cell.end()) continue;
      if (found && !kernel_.conflict(cell, w)) continue;
      if (kernel_.orient(cell, apex, kernel_.at(w)) <= 0) continue;
      chosen = w;
      found = true;
    }
    return found;
  }

  /// Beyond a facet of the hull; the ghost's place is the last slot (I4).
  static void put_ghost(Cell& cell, int apex) {
    cell[static_cast<std::size_t>(apex)] = kGhost;
    if constexpr (K >= 2) {
      if (apex == K) return;
      std::swap(cell[static_cast<std::size_t>(apex)], cell[K]);
      std::swap(cell[0], cell[1]);
    }
  }

  /// Adds a new cell and links it to what is known of its neighbours.
  void add(const Cell& cell, FacetTable<K>& facets) {
    const Index number = new_cell(cell);
    for (int i = 0; i <= K; ++i) {
      const Index f = new_facet(number, i);
      Index& known = facets[FacetTable<K>::key(cell, i)];
      if (known == kNone) {
        known = f;
        twin(f) = kNone;
        if (!has_ghost(cell, i)) hole_->open.push_back(f);
      } else {
        join(f, known);
      }
    }
  }

  // --- In the plane, inside the hull: the hole is a polygon, and each triangle splits what is left of it in two ---
  // No facet is looked up (figures: bench/DEAD_ENDS.md).

  void split_polygon() requires(K == 2) {
    const std::size_t corners = hole_->gone.size();
    hole_->link.resize(corners);
    for (std::size_t b = 0; b < corners; ++b) {
      const FacetId f = scratch_->cavity[b];
      hole_->link[b] = complex_.vertex(complex_.cell(f), complex_.turned(complex_.slot(f), 1));
    }
    hole_->made.resize(corners - 2);
    hole_->cells.resize((corners - 2) * kStride);
    // What lies between the corners `first` and `last`: the edge between them as seen from beyond, and where its twin
    // is to be noted.
    struct Part {
      std::uint8_t first, last;
      FacetId base;
      Index* twin;
    };
    std::array<Part, kWrapped> parts;
    std::size_t waiting = 0;
    const auto leave = [&](std::uint8_t first, std::uint8_t last, FacetId base, Index* twin) {
      if (last > first + 1) {
        parts[waiting++] = {first, last, base, twin};
      } else {
        *twin = raw(hole_->outside[first]);
        hole_->closed[first] = raw(base);
      }
    };
    leave(0, static_cast<std::uint8_t>(corners - 1), hole_->outside[corners - 1], &hole_->closed[corners - 1]);
    Index* ids = hole_->cells.data();
    for (std::size_t n = 0; waiting > 0; ++n, ids += kStride) {
      const auto [first, last, base, twin] = parts[--waiting];
      const CellId c = hole_->made[n] = hole_->gone[n];
      const VertexId* const link = hole_->link.data();
      const auto between = static_cast<std::size_t>(last - first - 1);
      const auto apex = static_cast<std::uint8_t>(
          first + 1 + kernel_.innermost(link[first], link[last], {link + first + 1, between}));
      const Cell cell{link[first], link[apex], link[last]};
      std::memcpy(ids, cell.data(), sizeof cell);
      ids[kCorners + 1] = raw(base);
      *twin = raw(complex_.facet(c, 1));
      leave(first, apex, complex_.facet(c, 2), &ids[kCorners + 2]);
      leave(apex, last, complex_.facet(c, 0), &ids[kCorners]);
    }
  }

  // --- Triangulating the link ---

  void triangulate_link(VertexId v) {
    std::vector<VertexId> names(hole_->link.begin(), hole_->link.end());
    names.insert(names.end(), hole_->asked.begin(), hole_->asked.end());
    Mesh small = triangulate_sites(mesh_->sites, names);
    if (small.complex.dimension() < K) return wrap({});  // all in one hyperplane: only the ghost is beyond
    revive(small, names);

    const auto row = static_cast<Index>(names.size());
    small.sites.append(point(v), mesh_->sites.weight(v), row);
    small.complex.reserve_more(0, small.sites.size());
    small.complex.grow_vertices(small.sites.size());
    ComplexView<K> complex(small.complex);
    Kernel<K> kernel(small.sites);
    small.scratch.reserve_cells(K, complex.slot_count());
    small.scratch.reserve_vertices(K, small.sites.size());
    const VertexId q = small.sites.vertex(row);
    WalkStats walked;
    const CellId start = walk(complex, kernel, kernel.at(q), complex.incident_cell(kGhost), walked);
    find_cavity(complex, kernel, q, start, small.scratch);
    mesh_->statistics.predicates += kernel.stats();
    copy_cavity(complex, small.scratch, [&](VertexId w) { return w == kGhost ? w : names[small.sites.row(w)]; });
  }

  /// The cells in conflict with v become the new cells.
  template <class Name>
  void copy_cavity(const ComplexView<K>& complex, const Scratch& conflict, const Name& name) {
    FacetTable<K> facets(hole_->table, scratch_->cavity.size());
    for (std::size_t b = 0; b < scratch_->cavity.size(); ++b) {
      const FacetId f = scratch_->cavity[b];
      facets[FacetTable<K>::key(complex_.vertices(complex_.cell(f)), complex_.slot(f))] = outside(b);
    }
    std::vector<Index> number(complex.slot_count(), kNone);
    for (const FacetId f : conflict.cavity) {
      Cell cell = complex.vertices(complex.cell(f));
      for (VertexId& w : cell) w = name(w);
      number[raw(complex.cell(f))] = new_cell(cell);
    }
    for (const FacetId f : conflict.cavity) {
      const CellId c = complex.cell(f);
      const Index mine = number[raw(c)];
      for (int i = 0; i <= K; ++i) {
        const Index facet = new_facet(mine, i);
        const FacetId across = complex.twin(c, i);
        const Index other = number[raw(complex.cell(across))];
        if (other != kNone) {
          twin(facet) = raw(complex_.facet(hole_->made[other], complex.slot(across)));
        } else {
          join(facet, facets[FacetTable<K>::key(cell_at(mine), i)]);
        }
      }
    }
  }

  /// Which of the asked sites will be vertices, and which repeat another of them.
  void revive(const Mesh& small, const std::vector<VertexId>& names) {
    for (std::size_t i = 0; i < hole_->asked.size(); ++i) {
      const VertexId site = small.sites.vertex(static_cast<Index>(hole_->link.size() + i));
      if (small.complex.incident_cell(site) != kNoCell) hole_->revived.push_back(hole_->asked[i]);
    }
    for (const auto& [vertex, row] : small.duplicates) {
      hole_->repeats.push_back({names[row], names[small.sites.row(vertex)]});
    }
  }

  /// The last step of a plan, since it shows: duplicates are told only where their vertex is in the complex.
  void note_repeats() {
    std::size_t done = 0;
    try {
      for (; done < hole_->repeats.size(); ++done) {
        const auto [site, vertex] = hole_->repeats[done];
        mesh_->duplicates.add(site, vertex, mesh_->sites.row(site));
      }
    } catch (...) {
      for (std::size_t i = 0; i < done; ++i) {
        const VertexId site = hole_->repeats[i].front();
        mesh_->duplicates.take(site, mesh_->sites.row(site));
      }
      throw;
    }
  }

  /// Asked sites that stay hidden learn which cell holds them now; those that repeat another one bring along what has
  /// repeated them.
  void settle_asked() {
    for (const auto& [site, vertex] : hole_->repeats) {
      while (!mesh_->duplicates.at(site).empty()) {
        const Duplicates::Entry entry = *mesh_->duplicates.at(site).begin();
        mesh_->duplicates.change(entry, mesh_->sites.vertex(entry.second), {vertex, entry.second});
      }
    }
    try {
      CellId near = hole_->made.front();
      for (const VertexId h : hole_->asked) {
        if (complex_.has_vertex(h) || mesh_->duplicates.vertex_of(h) != kGhost) continue;
        WalkStats walked;
        near = walk(complex_, kernel_, kernel_.at(h), near, walked);
        mesh_->hidden.add(h, near);
      }
    } catch (...) {  // memory ran out within a predicate: the next removal makes the lists anew
      mesh_->hidden = {};
    }
  }

  std::vector<double> point(VertexId v) const {
    std::vector<double> x(static_cast<std::size_t>(mesh_->sites.dimension()));
    mesh_->sites.copy_point(v, x);
    return x;
  }

  // --- New cells, numbered from 0 on, and what the complex will hold of them: vertices, then twins ---
  // A new facet is named by the place where the vertex opposite to it stands; the outside's facets are counted down
  // from kNone - 1.

  static Index new_facet(Index cell, int slot) { return cell * kStride + static_cast<Index>(slot); }
  static Index cell_of(Index f) { return f / kStride; }
  static int slot_of(Index f) { return static_cast<int>(f % kStride); }
  static Index outside(std::size_t b) { return static_cast<Index>(kNone - 1 - b); }
  static std::size_t boundary(Index f) { return kNone - 1 - f; }
  static bool is_outside(Index f) { return f > kNone / 2; }

  /// New cells take the slots of those that go first.
  Index new_cell(const Cell& cell) {
    const auto number = static_cast<Index>(hole_->made.size());
    if (number < hole_->gone.size()) {
      hole_->made.push_back(hole_->gone[number]);
    } else {
      spare_ = number == hole_->gone.size() ? complex_.upcoming() : complex_.upcoming_after(spare_);
      hole_->made.push_back(spare_);
    }
    std::memcpy(hole_->cells.extend(kStride), cell.data(), sizeof cell);
    return number;
  }
  Cell cell_at(Index number) const {
    Cell cell;
    std::memcpy(cell.data(), hole_->cells.data() + new_facet(number, 0), sizeof cell);
    return cell;
  }
  Index& twin(Index f) { return is_outside(f) ? hole_->closed[boundary(f)] : hole_->cells[f + kCorners]; }
  bool is_closed(Index f) { return twin(f) != kNone; }
  FacetId named(Index f) const {
    return is_outside(f) ? hole_->outside[boundary(f)] : complex_.facet(hole_->made[cell_of(f)], slot_of(f));
  }
  void join(Index f, Index known) {
    twin(f) = raw(named(known));
    twin(known) = raw(named(f));
  }
  static bool has_ghost(const Cell& cell, int but) {
    for (int i = 0; i <= K; ++i) {
      if (i != but && cell[static_cast<std::size_t>(i)] == kGhost) return true;
    }
    return false;
  }

  /// Room for all that carry_out() makes.
  void make_room() {
    const std::size_t count = hole_->made.size();
    const std::size_t more = count - std::min(count, hole_->gone.size());
    if (more > 0) mesh_->complex.reserve_more(more, mesh_->sites.size());
    const std::size_t slots = complex_.slot_count() + more;
    scratch_->reserve_cells(K, slots);
    if (mesh_->hidden.kept()) mesh_->hidden.reserve(mesh_->sites.size(), slots);
  }

  /// What the star's cells hold before they go.
  void remember_star() {
    for (const CellId c : hole_->gone) complex_.copy_ids(c, hole_->star.extend(kStride));
  }

  /// Takes slots for `coming` cells, the first of them in the slots of those that go: what is planned, and what undoes
  /// it.
  void trade_slots(const Buffer<CellId>& going, const Buffer<CellId>& coming) {
    for (const CellId c : going) complex_.discount_ghost(c);
    for (std::size_t n = coming.size(); n < going.size(); ++n) complex_.release(going[n]);
    for (std::size_t n = going.size(); n < coming.size(); ++n) complex_.create();
  }

  void put(const Buffer<CellId>& cells, const Buffer<Index>& ids) {
    for (std::size_t n = 0; n < cells.size(); ++n) {
      const CellId c = cells[n];
      complex_.set_ids(c, ids.data() + n * kStride);
      complex_.settle(c);
      complex_.count_ghost(c);
      if constexpr (K > 3) scratch_->plane<K>(c) = {};
    }
  }

  Mesh* mesh_;
  ComplexView<K> complex_;
  Kernel<K> kernel_;
  Scratch* scratch_;
  Hole* hole_;
  CellId spare_ = kNoCell;  // the last slot that is planned to be taken beside those of the cells that go
};

}  // namespace delone
