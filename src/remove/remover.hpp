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
#include "mesh/incremental.hpp"

namespace delone {

template <int K>
class Remover {
  static constexpr Index kCorners = K + 1;
  static constexpr std::size_t kStride = 2 * std::size_t{kCorners};
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
    hole_->closed.resize(scratch_->cavity.size(), kNone);
    if (finite == mesh_->complex.live_count() - mesh_->complex.ghost_count()) return false;
    collect_hidden();
    find_cells(v, finite);
    make_room();
    if (may_return) remember_star();
    note_repeats();
    return true;
  }

  /// Carries out the plan. Cannot fail.
  void carry_out(VertexId v) {
    for (const VertexId h : hole_->asked) mesh_->hidden.remove(h);
    for (std::size_t b = 0; b < scratch_->cavity.size(); ++b) {
      const CellId c = complex_.cell(scratch_->cavity[b]);
      hole_->outside[b] = complex_.twin(scratch_->cavity[b]);
      scratch_->removed[b] = c;
    }
    for (const CellId c : scratch_->removed) complex_.destroy(c);
    complex_.forget(v);
    mesh_->vertex_count += hole_->revived.size();
    --mesh_->vertex_count;
    fill();
    if (!hole_->made.empty()) std::ranges::copy(scratch_->created, hole_->made.begin());
    settle_asked();
    mesh_->statistics.cells_created += scratch_->created.size();
  }

  /// Undoes what carry_out() did to v, if the plan was made for it and nothing has changed since. Cannot fail.
  /// @return what this changed; valid until the next change
  Edit bring_back(const VertexId& v) {
    for (const VertexId h : hole_->revived) complex_.forget(h);
    mesh_->vertex_count -= hole_->revived.size();
    ++mesh_->vertex_count;
    if (!hole_->asked.empty()) mesh_->hidden = {};
    for (const CellId c : hole_->made) complex_.destroy(c);
    hole_->cells.swap(hole_->star);
    scratch_->created.resize(new_count());
    fill();
    return {.gone = hole_->revived, .came = {&v, 1}, .removed = hole_->made, .created = scratch_->created};
  }

  /// What carry_out() changed; valid until the next change. @param v  what was removed, valid as long as the edit
  Edit edit(const VertexId& v) const {
    return {.gone = {&v, 1}, .came = hole_->revived, .removed = scratch_->removed, .created = scratch_->created};
  }

  // --- Moving in place ---

  /// The star of v, if it has no ghost cell and hides no site: into `removed`.
  bool collect_inner_star(VertexId v) {
    scratch_->reserve_cells(K, complex_.slot_count());
    if (collect_star(v) < scratch_->cavity.size()) return false;
    scratch_->removed.resize(scratch_->cavity.size());
    for (std::size_t i = 0; i < scratch_->removed.size(); ++i) {
      scratch_->removed[i] = complex_.cell(scratch_->cavity[i]);
      if (mesh_->hidden.first(scratch_->removed[i]) != kGhost) return false;
    }
    return true;
  }

  /// Whether the cells of the star, whose vertex has moved, are positive, and regular with their neighbours: they then
  /// fill the same hole, and heights are convex across each facet as they are elsewhere, so everywhere.
  bool star_is_regular() {
    for (const CellId c : scratch_->removed) {
      if constexpr (K > 3) scratch_->planes[raw(c) * Scratch::plane_size(K)] = std::numeric_limits<double>::quiet_NaN();
      if (kernel_.orient(complex_.vertices(c)) <= 0) return false;
    }
    for (const CellId c : scratch_->removed) {
      for (int i = 0; i <= K; ++i) {
        const FacetId across = complex_.twin(c, i);
        const VertexId w = complex_.vertex(across);
        if (w != kGhost && kernel_.conflict(complex_.vertices(c), w)) return false;
      }
    }
    return true;
  }

  Edit edit_in_place(const VertexId& v) const {
    return {.gone = {&v, 1}, .came = {&v, 1}, .removed = scratch_->removed, .created = scratch_->removed};
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
    const CellId start = complex_.incident_cell(v);
    star.make_room(1);
    star.push(complex_.facet(start, complex_.slot_of(start, v)));
    std::size_t finite = 0;
    if constexpr (K == 2) {
      // Round both ways at once: one way waits for memory while the other does, too.
      Refill back(scratch_->pending);
      FacetId last = star[0];
      FacetId first = star[0];
      const auto step = [&](FacetId f, int way) {
        const FacetId across = complex_.twin(complex_.cell(f), complex_.turned(complex_.slot(f), way));
        return complex_.facet(complex_.cell(across), complex_.turned(complex_.slot(across), way));
      };
      for (;;) {
        star.make_room(1);
        back.make_room(1);
        const FacetId ahead = step(last, 1);
        const FacetId behind = step(first, 2);
        fetch(last);
        fetch(first);
        if (ahead == first) break;
        star.push(last = ahead);
        if (behind == last) break;
        back.push(first = behind);
      }
      star.make_room(back.size());
      while (!back.empty()) star.push(back.pop());
      for (std::size_t i = 0; i < star.size(); ++i) finite += complex_.is_ghost(complex_.cell(star[i])) ? 0 : 1;
    } else {
      const auto mark = [&](std::size_t i, Scratch::Mark m) { scratch_->marks[raw(complex_.cell(star[i]))] = m; };
      try {
        mark(0, Scratch::Mark::conflicting);
        for (std::size_t next = 0; next < star.size(); ++next) {
          star.make_room(K);
          const CellId c = complex_.cell(star[next]);
          const int apex = complex_.slot(star[next]);
          finite += complex_.is_ghost(c) ? 0 : 1;
          for (int i = 0; i <= K; ++i) {
            const CellId across = complex_.cell(complex_.twin(c, i));
            if (i == apex || scratch_->marks[raw(across)] == Scratch::Mark::conflicting) continue;
            star.push(complex_.facet(across, complex_.slot_of(across, v)));
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

  /// Asks memory for what planning and filling will touch at a facet of the link.
  void fetch(FacetId inside) const {
    complex_.prefetch(complex_.cell(complex_.twin(inside)));
    const CellId c = complex_.cell(inside);
    const VertexId w = complex_.vertex(c, complex_.turned(complex_.slot(inside), 1));
    if (w == kGhost) return;
    __builtin_prefetch(kernel_.at(w));
    complex_.prefetch(w);
  }

  void collect_hidden() {
    if (!mesh_->hidden.kept()) return;
    for (const FacetId f : scratch_->cavity) {
      for (VertexId h = mesh_->hidden.first(complex_.cell(f)); h != kGhost; h = mesh_->hidden.next(h)) {
        hole_->asked.push_back(h);
      }
    }
    std::ranges::sort(hole_->asked, {}, [this](VertexId h) { return mesh_->sites.row(h); });
  }

  /// The finite vertices of the link. False when they are more than `most`.
  bool collect_link(VertexId v, std::size_t most) {
    auto& link = hole_->link;
    link.clear();
    for (const FacetId f : scratch_->cavity) {
      for (const VertexId w : complex_.vertices(complex_.cell(f))) {
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
    Cell cell = cell_at(f / kCorners);
    const auto i = f % kCorners;
    const auto j = i == 0 ? 1U : 0U;
    std::swap(cell[i], cell[j]);
    return {cell, static_cast<int>(j)};
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
    const Index first = new_cell(cell) * kCorners;
    for (int i = 0; i <= K; ++i) {
      const Index f = first + static_cast<Index>(i);
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
    auto& link = hole_->link;
    link.clear();
    for (const FacetId f : scratch_->cavity) {
      link.push_back(complex_.vertex(complex_.cell(f), complex_.turned(complex_.slot(f), 1)));
    }
    // What lies between the corners `first` and `last`, seen from the facet `base`, which is the edge between them.
    struct Part {
      std::uint8_t first, last;
      Index base;
    };
    std::array<Part, kWrapped> parts;
    std::size_t count = 1;
    parts[0] = {0, static_cast<std::uint8_t>(link.size() - 1), outside(link.size() - 1)};
    while (count > 0) {
      const Part part = parts[--count];
      const std::uint8_t apex = polygon_apex(part.first, part.last);
      const Index f = new_cell(triangle(part.first, apex, part.last)) * kCorners;
      join(f + 1, part.base);
      for (const Part side : {Part{part.first, apex, f + 2}, Part{apex, part.last, f}}) {
        if (side.last > side.first + 1) {
          parts[count++] = side;
        } else {
          join(side.base, outside(side.first));
        }
      }
    }
  }

  Cell triangle(std::size_t a, std::size_t b, std::size_t c) const requires(K == 2) {
    return {hole_->link[a], hole_->link[b], hole_->link[c]};
  }

  /// The corner between two others whose triangle with them is positive and conflicts with no other such corner.
  std::uint8_t polygon_apex(std::uint8_t first, std::uint8_t last) requires(K == 2) {
    auto apex = static_cast<std::uint8_t>(first + 1);
    if (last == first + 2) return apex;
    bool found = false;
    for (auto i = apex; i < last; ++i) {
      if (found && !kernel_.conflict(triangle(first, apex, last), hole_->link[i])) continue;
      if (kernel_.orient(triangle(first, i, last)) <= 0) continue;
      apex = i;
      found = true;
    }
    return apex;
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
        const Index facet = mine * kCorners + static_cast<Index>(i);
        const FacetId across = complex.twin(c, i);
        const Index other = number[raw(complex.cell(across))];
        if (other != kNone) {
          twin(facet) = other * kCorners + static_cast<Index>(complex.slot(across));
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
      CellId near = scratch_->created.front();
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

  // --- New cells, numbered from 0 on, as the complex holds cells: vertices, then twins ---
  // A facet is cell * (K + 1) + slot; the outside's facets are counted down from kNone - 1.

  static Index outside(std::size_t b) { return static_cast<Index>(kNone - 1 - b); }
  static std::size_t boundary(Index f) { return kNone - 1 - f; }
  bool is_outside(Index f) const { return boundary(f) < hole_->closed.size(); }
  Index new_count() const { return static_cast<Index>(hole_->cells.size() / kStride); }
  Index new_cell(const Cell& cell) {
    const Index number = new_count();
    Index* const ids = hole_->cells.extend(kStride);
    for (std::size_t i = 0; i < kCorners; ++i) ids[i] = raw(cell[i]);
    return number;
  }
  Cell cell_at(Index number) const {
    Cell cell;
    std::memcpy(cell.data(), hole_->cells.data() + number * kStride, sizeof cell);
    return cell;
  }
  Index& twin(Index f) { return hole_->cells[f / kCorners * kStride + kCorners + f % kCorners]; }
  bool is_closed(Index f) { return (is_outside(f) ? hole_->closed[boundary(f)] : twin(f)) != kNone; }
  void join(Index f, Index known) {
    twin(f) = known;
    (is_outside(known) ? hole_->closed[boundary(known)] : twin(known)) = f;
  }
  static bool has_ghost(const Cell& cell, int but) {
    for (int i = 0; i <= K; ++i) {
      if (i != but && cell[static_cast<std::size_t>(i)] == kGhost) return true;
    }
    return false;
  }

  /// Room for all that carry_out() makes.
  void make_room() {
    const std::size_t count = new_count();
    const std::size_t more = count - std::min<std::size_t>(count, scratch_->cavity.size());
    mesh_->complex.reserve_more(more, mesh_->sites.size());
    scratch_->created.resize(count);
    scratch_->removed.resize(scratch_->cavity.size());
    hole_->outside.resize(scratch_->cavity.size());
    const std::size_t slots = complex_.slot_count() + more;
    scratch_->reserve_cells(K, slots);
    if (mesh_->hidden.kept()) mesh_->hidden.reserve(mesh_->sites.size(), slots);
  }

  /// The star in the form of new cells, as it is before it goes.
  void remember_star() {
    const std::size_t count = scratch_->cavity.size();
    std::vector<std::pair<CellId, Index>> numbers;
    for (std::size_t b = 0; b < count; ++b) {
      numbers.emplace_back(complex_.cell(scratch_->cavity[b]), static_cast<Index>(b));
    }
    std::ranges::sort(numbers);
    hole_->star.resize(count * kStride);
    for (std::size_t b = 0; b < count; ++b) {
      const CellId c = complex_.cell(scratch_->cavity[b]);
      Index* const ids = hole_->star.data() + b * kStride;
      for (int i = 0; i <= K; ++i) {
        ids[i] = raw(complex_.vertex(c, i));
        const FacetId across = complex_.twin(c, i);
        const auto other =
            std::ranges::lower_bound(numbers, complex_.cell(across), {}, &std::pair<CellId, Index>::first);
        ids[static_cast<Index>(i) + kCorners] =
            i == complex_.slot(scratch_->cavity[b])
                ? outside(b)
                : other->second * kCorners + static_cast<Index>(complex_.slot(across));
      }
    }
    hole_->made.resize(new_count());
    scratch_->created.reserve(count);
    scratch_->removed.reserve(new_count());
    mesh_->complex.reserve_more(std::max<std::size_t>(count, new_count()), mesh_->sites.size());
  }

  void fill() {
    auto& created = scratch_->created;
    for (CellId& c : created) c = complex_.create();
    for (Index n = 0; n < created.size(); ++n) {
      const CellId c = created[n];
      complex_.set_vertices(c, cell_at(n));
      for (int i = 0; i <= K; ++i) {
        const Index across = twin(n * kCorners + static_cast<Index>(i));
        if (is_outside(across)) {
          complex_.link(complex_.facet(c, i), hole_->outside[boundary(across)]);
        } else {
          complex_.set_twin(c, i, complex_.facet(created[across / kCorners], static_cast<int>(across % kCorners)));
        }
      }
      complex_.settle(c);
      complex_.count_ghost(c);
      if constexpr (K > 3) scratch_->planes[raw(c) * Scratch::plane_size(K)] = std::numeric_limits<double>::quiet_NaN();
    }
  }

  Mesh* mesh_;
  ComplexView<K> complex_;
  Kernel<K> kernel_;
  Scratch* scratch_;
  Hole* hole_;
};

}  // namespace delone
