// The conflict region of a vertex to be inserted, in any dimension.
// Source: [For92] 4.3 (incremental, beneath-beyond); the region is a ball (I5), so a search from one of its cells finds
// it. Cost: O(K * cells in it and around it); no allocation after warm-up.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "delone/geometry/kernel.hpp"
#include "delone/mesh/scratch.hpp"
#include "delone/mesh/walk.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

/// Whether inserting q destroys ghost cell c: when q lies beyond its facet; on the facet's hyperplane the finite cell
/// behind decides, so that no special case is left on the hull.
/// @param below  below(f): whether the lifted q lies below the hyperplane of finite cell f
template <int K, class Below>
[[gnu::noinline]] bool beyond_facet(const ComplexView<K>& complex, Kernel<K>& kernel, CellId c, VertexId q,
                                    const Below& below) {
  const int ghost = complex.ghost_slot(c);
  auto v = complex.vertices(c);
  v[static_cast<std::size_t>(ghost)] = q;
  if (const int side = kernel.orient(v); side != 0) return side > 0;
  return below(complex.cell(complex.twin(c, ghost)));
}

/// Whether inserting q destroys cell c.
template <int K, class Below>
[[gnu::always_inline]] inline bool in_conflict(const ComplexView<K>& complex, Kernel<K>& kernel, CellId c, VertexId q,
                                               const Below& below) {
  if (complex.is_ghost(c)) [[unlikely]]
    return beyond_facet(complex, kernel, c, q, below);
  return below(c);
}

template <int K>
bool in_conflict(const ComplexView<K>& complex, Kernel<K>& kernel, Scratch& scratch, CellId c, VertexId q);

/// How the hyperplane of c sees q, computed from coordinates, and then kept for the next test; as it was `seen` where
/// coordinates do not tell it, or the cell must stay as it is. So what was seen belongs to the hyperplane that is kept.
template <int K>
[[gnu::noinline]] Sight seen_anew(const ComplexView<K>& complex, const Kernel<K>& kernel, Scratch& scratch, CellId c,
                                  VertexId q, const Sight& seen) {
  if (!scratch.territory.holds(complex.vertices(c))) return seen;
  const Hyperplane<K> plane = kernel.hyperplane(complex.vertices(c));
  if (plane.tilt_error == 0.0) return seen;
  scratch.plane<K>(c) = plane;
  return kernel.sight(plane, q);
}

/// The same where the hyperplane that `scratch` keeps does not tell.
template <int K>
[[gnu::noinline]] bool in_conflict_in_doubt(const ComplexView<K>& complex, Kernel<K>& kernel, Scratch& scratch,
                                            CellId c, VertexId q, Sight& seen) {
  seen = seen_anew(complex, kernel, scratch, c, q, seen);
  return kernel.conflict(seen, [&] {
    if (!complex.is_ghost(c)) return kernel.conflict_in_doubt(complex.vertices(c), q);
    return beyond_facet(complex, kernel, c, q, [&](CellId f) { return in_conflict(complex, kernel, scratch, f, q); });
  });
}

/// The same above dimension 3, with the hyperplanes that `scratch` keeps.
/// @param seen  how the one of c sees q, which its neighbours in the star of q are computed from
template <int K>
[[gnu::always_inline]] inline bool in_conflict(const ComplexView<K>& complex, Kernel<K>& kernel, Scratch& scratch,
                                               CellId c, VertexId q, Sight& seen) {
  seen = kernel.sight(scratch.plane<K>(c), q);
  return kernel.conflict(seen, [&] { return in_conflict_in_doubt(complex, kernel, scratch, c, q, seen); });
}

/// The same in any dimension.
template <int K>
[[gnu::always_inline]] inline bool in_conflict(const ComplexView<K>& complex, Kernel<K>& kernel, Scratch& scratch,
                                               CellId c, VertexId q) {
  if constexpr (K <= 3) {
    const auto below = [&](CellId f) __attribute__((always_inline)) { return kernel.conflict(complex.vertices(f), q); };
    return in_conflict(complex, kernel, c, q, below);
  } else {
    Sight seen;
    return in_conflict(complex, kernel, scratch, c, q, seen);
  }
}

/// Above 3D, a walk down to a cell that is surely in conflict with q: the next cell is the one around whose hyperplane
/// sees q lowest, as far as doubles tell. Where none is known to see it lower it ends, close to q. It never circles.
/// @param start  any live cell with a site of the scratch's territory, in which the walk stays
template <int K>
CellId descend(const ComplexView<K>& complex, const Kernel<K>& kernel, Scratch& scratch, VertexId q, CellId start,
               WalkStats& stats) {
  const Territory territory = scratch.territory;
  const auto sight = [&](CellId c) { return kernel.sight(scratch.plane<K>(c), q); };
  CellId c = start;
  for (Sight lowest = sight(c); !lowest.surely_below(); ++stats.steps) {
    int way = complex.ghost_slot(c);  // only at the start
    if (way >= 0) {
      lowest = sight(complex.cell(complex.twin(c, way)));
    } else {
      const auto v = complex.vertices(c);
      for (int i = 0; i <= K; ++i) {
        if (!territory.whole() && !territory.touches(v, i)) continue;  // others may be at work behind it
        const CellId across = complex.cell(complex.twin(c, i));
        const Sight seen = sight(across);
        // Heights of ghosts have a unit of their own. An unknown hyperplane sees all at height 0, without error.
        if (complex.is_ghost(across) ? !seen.surely_below() : !(seen.value < lowest.value && seen.bound != 0.0))
          continue;
        way = i;
        lowest = seen;
        if (lowest.surely_below()) break;
      }
    }
    if (way < 0) break;
    c = complex.cell(complex.twin(c, way));
  }
  return c;
}

/// Keeps the hyperplanes of the star of q just made, whose cavity is still there.
template <int K>
void keep_hyperplanes(const ComplexView<K>& complex, const Kernel<K>& kernel, VertexId q, Scratch& scratch) {
  for (std::size_t b = 0; b < scratch.boundary.size(); ++b) {
    const FacetId inside = scratch.boundary[b];
    const CellId fresh = scratch.created[b];
    const CellId outside = complex.cell(complex.twin(fresh, complex.slot(inside)));
    const auto& [in, out] = scratch.sights[b];
    scratch.plane<K>(fresh) =
        kernel.hyperplane(scratch.plane<K>(complex.cell(inside)), in, scratch.plane<K>(outside), out, q);
  }
}

/// Whether a search marks the cells that it finds: where it may come to one again.
template <int K>
bool marks_cells(const Kernel<K>& kernel) {
  return K != 2 || kernel.weighted();
}

/// A facet to whose other side a search in breadth comes.
struct Candidate {
  FacetId inside, outside;
  Index from;  ///< the number of the cell inside in the cavity
};

/// Lists what is across the facets of a cell of the cavity, its number `from`, but for cells known to be in conflict,
/// and asks memory for what their tests will read. Returns the end of the list, which has room for K + 1 more.
template <int K>
[[gnu::always_inline]] inline Candidate* list_neighbours(const ComplexView<K>& complex, const Scratch& scratch,
                                                         CellId c, std::size_t from, Candidate* end) {
  for (int i = 0; i <= K; ++i) {
    const FacetId outside = complex.twin(c, i);
    const CellId across = complex.cell(outside);
    *end = {complex.facet(c, i), outside, static_cast<Index>(from)};
    end += scratch.marks.data()[raw(across)] == Scratch::Mark::conflicting ? 0 : 1;
    if constexpr (K > 3) {
      const std::byte* const plane = scratch.planes.data() + raw(across) * Scratch::plane_size(K);
      __builtin_prefetch(plane);
      __builtin_prefetch(plane + Scratch::plane_size(K) - 1);  // half of them or more lie across two lines
    } else {
      complex.prefetch(across);
    }
  }
  return end;
}

/// find_cavity() by a search in breadth: the list is the queue. The neighbours of some cells in turn that are not yet
/// known to be in conflict are listed first, then tested all, and no branch depends on the outcome of a test or on the
/// number of neighbours of one cell: nobody can predict either. A cell may be listed by several of these cells.
template <int K>
bool find_cavity_in_breadth(ComplexView<K> complex, Kernel<K>& kernel, VertexId q, CellId start, Scratch& scratch) {
  constexpr std::size_t kTogether = 16;  // fewer: more wrong guesses; more: more cells are tested twice
  std::array<Candidate, kTogether*(K + 1) + 1> candidates;
  [[maybe_unused]] std::array<Sight, K <= 3 ? 1 : candidates.size()> outside_sights;  // of theirs
  Refill cavity(scratch.cavity);
  Refill boundary(scratch.boundary);
  Refill sights(scratch.sights);                // of the two cells at a facet of the boundary
  Refill inside_sights(scratch.inside_sights);  // of those in the cavity
  Scratch::Mark* const marks = scratch.marks.data();
  const Territory territory = scratch.territory;
  cavity.make_room(1);
  cavity.push(complex.facet(start, 0));
  marks[raw(start)] = Scratch::Mark::conflicting;
  if constexpr (K == 3) scratch.numbers.begin(complex.vertices(start));
  if constexpr (K > 3) {
    Sight seen = kernel.sight(scratch.plane<K>(start), q);
    if (!(std::abs(seen.value) > seen.bound)) seen = seen_anew(complex, kernel, scratch, start, q, seen);
    inside_sights.make_room(1);
    inside_sights.push(seen);
  }
  for (std::size_t next = 0; next < cavity.size();) {
    Candidate* end = candidates.data();
    for (const std::size_t last = std::min(cavity.size(), next + kTogether); next < last; ++next) {
      if constexpr (K == 3) scratch.numbers.add(complex.vertex(cavity[next]), next);
      end = list_neighbours(complex, scratch, complex.cell(cavity[next]), next, end);
    }
    const auto count = static_cast<std::size_t>(end - candidates.data());
    cavity.make_room(count);
    boundary.make_room(count);
    if constexpr (K > 3) {
      inside_sights.make_room(count);
      sights.make_room(count);
      for (std::size_t i = 0; i < count; ++i) {
        const CellId across = complex.cell(candidates[i].outside);
        complex.prefetch(across);
        outside_sights[i] = kernel.sight(scratch.plane<K>(across), q);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto [inside, outside, from] = candidates[i];
      const CellId across = complex.cell(outside);
      const bool known = marks[raw(across)] == Scratch::Mark::conflicting;
      bool conflicting = false;
      if constexpr (K <= 3) {
        conflicting = known || in_conflict(complex, kernel, scratch, across, q);
      } else {
        Sight& seen = outside_sights[i];
        conflicting =
            kernel.conflict(seen, [&] { return known || in_conflict(complex, kernel, scratch, across, q, seen); });
      }
      conflicting |= known;
      if constexpr (K > 3) {
        inside_sights.push_if(conflicting != known, outside_sights[i]);
        sights.push_if(!conflicting, {inside_sights[from], outside_sights[i]});
      }
      if (!territory.whole() && !territory.holds(complex.vertex(outside))) [[unlikely]] {
        if (conflicting) return false;
      } else {
        marks[raw(across)] = static_cast<Scratch::Mark>(conflicting);
      }
      cavity.push_if(conflicting != known, outside);
      boundary.push_if(!conflicting, inside);
    }
  }
  return true;
}

/// The same in 3D with the tests of a cell's four neighbours side by side, on processors that can (x86-64 with AVX2 and
/// FMA). Elsewhere it does nothing; so where the sites lie in a flat of more dimensions.
std::optional<bool> find_cavity_by_fours(ComplexView<3> complex, Kernel<3>& kernel, VertexId q, CellId start,
                                         Scratch& scratch);

/// Finds all cells in conflict with q, from one of them, into `scratch`. Changes nothing else; on std::bad_alloc every
/// marked cell is listed, and where a cell would go that the territory does not hold: then the answer is false.
template <int K>
bool find_cavity(ComplexView<K> complex, Kernel<K>& kernel, VertexId q, CellId start, Scratch& scratch) {
  if constexpr (K == 3) {
    if (const auto found = find_cavity_by_fours(complex, kernel, q, start, scratch)) return *found;
  }
  return find_cavity_in_breadth(complex, kernel, q, start, scratch);
}

/// In 2D depth first, the edges of a cell in turning order: this lists the boundary as the cycle that it is (cells are
/// crossed along a tree, and what is not crossed hangs from the boundary by one vertex). What q sees of a vertex goes
/// along with the search. Without weights the cavity has no vertex inside, so no cell is reached twice, and none is
/// marked.
template <>
inline bool find_cavity(ComplexView<2> complex, Kernel<2>& kernel, VertexId q, CellId start, Scratch& scratch) {
  Refill cavity(scratch.cavity);
  Refill fronts(scratch.fronts);
  Refill boundary(scratch.boundary);
  Scratch::Mark* const marks = scratch.marks.data();
  const bool marking = marks_cells<2>(kernel);
  // The front before an edge whose ends nobody has seen; before a ghost cell nobody needs to.
  const auto front_before = [&](FacetId outside) {
    const CellId c = complex.cell(outside);
    if (complex.is_ghost(c)) return Front{outside, {}, {}, 0.0};
    const Ray left = kernel.ray(complex.vertex(c, complex.turned(complex.slot(outside), 1)), q);
    const Ray right = kernel.ray(complex.vertex(c, complex.turned(complex.slot(outside), 2)), q);
    return Front{outside, left, right, left.turn(right)};
  };
  cavity.make_room(1);
  cavity.push(complex.facet(start, 0));
  if (marking) marks[raw(start)] = Scratch::Mark::conflicting;
  fronts.make_room(2);
  Front front;
  if (complex.is_ghost(start)) {
    fronts.push(front_before(complex.twin(start, 2)));
    fronts.push(front_before(complex.twin(start, 1)));
    front = front_before(complex.twin(start, 0));
  } else {
    const Ray a = kernel.ray(complex.vertex(start, 0), q);
    const Ray b = kernel.ray(complex.vertex(start, 1), q);
    const Ray c = kernel.ray(complex.vertex(start, 2), q);
    fronts.push({complex.twin(start, 2), b, a, b.turn(a)});
    fronts.push({complex.twin(start, 1), a, c, a.turn(c)});
    front = {complex.twin(start, 0), c, b, c.turn(b)};
  }
  for (;;) {
    const CellId c = complex.cell(front.outside);
    const int entry = complex.slot(front.outside);
    const bool ghost = complex.is_ghost(c);
    Ray middle{};
    double left_turn = 0.0;
    double right_turn = 0.0;
    bool known = false;
    bool conflicting = false;
    if (marking) known = marks[raw(c)] == Scratch::Mark::conflicting;
    if (known || ghost) [[unlikely]] {
      conflicting = !known && in_conflict(complex, kernel, scratch, c, q);
    } else {
      middle = kernel.ray(complex.vertex(c, entry), q);
      left_turn = front.left.turn(middle);
      right_turn = middle.turn(front.right);
      conflicting = kernel.conflict(middle, front.left, front.right, -left_turn, front.turn, -right_turn, q,
                                    [&] { return complex.vertices(c); });
    }
    if (conflicting) {
      if (!scratch.territory.holds(complex.vertex(front.outside))) return false;
      cavity.make_room(1);
      fronts.make_room(1);
      cavity.push(front.outside);
      if (marking) marks[raw(c)] = Scratch::Mark::conflicting;
      const FacetId beyond_left = complex.twin(c, complex.turned(entry, 2));
      const FacetId beyond_right = complex.twin(c, complex.turned(entry, 1));
      complex.prefetch(complex.cell(beyond_left));
      if (ghost) [[unlikely]] {
        fronts.push(front_before(beyond_left));
        front = front_before(beyond_right);
      } else {
        fronts.push({beyond_left, front.left, middle, left_turn});
        front = {beyond_right, middle, front.right, right_turn};
      }
    } else {
      boundary.make_room(1);
      boundary.push_if(!known, complex.twin(c, entry));
      if (fronts.empty()) return true;
      front = fronts.pop();
    }
  }
}

}  // namespace delone
