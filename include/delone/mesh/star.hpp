// Fill a cavity with the star of a vertex, in any dimension: one new cell per facet of the cavity's boundary.
// Source: [For92] 4.3. New cells are linked to each other without a table of facets: the two new cells at a ridge of
// the boundary are found by turning about the ridge through the cells of the cavity, each ridge once.
//
// Departures, for speed: in 2D the boundary is listed as a cycle, so each new cell meets the next; in 3D a ridge is an
// edge between two of the few vertices of the boundary, and is looked up; above, ridges are looked up by name. By
// turning alone insertion takes 1.3 times as long in 2D and 1.5 times in 3D (bench/DEAD_ENDS.md).
//
// Cost: O(K * cells removed and created); cannot fail, since room has been made.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "delone/mesh/scratch.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

namespace star {

/// The new cell on a facet of the boundary, seen from inside; linked to the cell outside, and to no other yet.
template <int K>
[[gnu::always_inline]] inline CellId make_cell(ComplexView<K> complex, VertexId q, FacetId inside) {
  const CellId old = complex.cell(inside);
  const int apex = complex.slot(inside);
  const CellId fresh = complex.create();
  complex.set_vertices(fresh, complex.vertices(old));
  complex.set_vertex(fresh, apex, q);
  const FacetId outside = complex.twin(old, apex);
  complex.set_twin(fresh, apex, outside);
  complex.set_twin(outside, complex.facet(fresh, apex));
  const int ghost = complex.ghost_slot(old);  // of the old cell: ids just written would be waited for
  if (ghost >= 0 && ghost != apex) complex.count_ghosts(1, fresh);
  return fresh;
}

/// Links new cells by turning about each ridge of the boundary, through the cavity. The old cells are still there.
template <int K>
void link_by_turning(ComplexView<K> complex, VertexId q, const Scratch& scratch) {
  for (std::size_t b = 0; b < scratch.boundary.size(); ++b) {
    const FacetId inside = scratch.boundary[b];
    for (int i = 0; i <= K; ++i) complex.set_twin(scratch.created[b], i, kNoFacet);
    const FacetId base = complex.facet(scratch.created[b], complex.slot(inside));
    complex.set_twin(base, complex.twin(inside));
    complex.set_twin(inside, base);  // a turn that leaves the cavity arrives in the star
  }
  for (std::size_t b = 0; b < scratch.boundary.size(); ++b) {
    const CellId fresh = scratch.created[b];
    complex.settle(fresh);
    const FacetId inside = scratch.boundary[b];
    const int apex = complex.slot(inside);
    for (int i = 0; i <= K; ++i) {
      if (i == apex || complex.twin(fresh, i) != kNoFacet) continue;
      // The ridge lacks slots `in` and `out` of each cell: enter through one facet, leave through the other.
      CellId c = complex.cell(inside);
      int in = apex;
      int out = i;
      FacetId across = complex.twin(c, out);
      while (scratch.marks[raw(complex.cell(across))] ==
             Scratch::Mark::conflicting) {  // ends: the cavity is a ball (I5)
        const VertexId behind = complex.vertex(c, in);
        c = complex.cell(across);
        in = complex.slot(across);
        out = complex.slot_of(c, behind);
        across = complex.twin(c, out);
      }
      complex.link(complex.facet(fresh, i), complex.facet(complex.cell(across), in));
    }
  }
  complex.set_incident(q, scratch.created.front());
}

/// 3D: every edge of the boundary is seen once in each direction; a table over the numbers that the search gave its
/// vertices holds the facet at each.
inline void fill_by_edge_table(ComplexView<3> complex, VertexId q, Scratch& scratch) {
  // Corners of the facet opposite each slot, in the order that makes a shared edge run in opposite directions.
  static constexpr std::array<std::array<int, 3>, 4> kFacet{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  EdgeTable& table = scratch.edges.front();
  const std::size_t count = scratch.created.size();
  CellId* const created = scratch.created.data();
  const FacetId* const boundary = scratch.boundary.data();
  for (std::size_t b = 0; b < count; ++b) {
    const CellId old = complex.cell(boundary[b]);
    const int apex = complex.slot(boundary[b]);
    const CellId fresh = created[b] = make_cell(complex, q, boundary[b]);
    const auto& corners = kFacet[static_cast<std::size_t>(apex)];
    std::array<Index, 3> number;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = complex.vertex(old, corners[i]);
      number[i] = scratch.numbers.of(v);
      complex.set_incident(v, fresh);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      table.facets[EdgeTable::place(number[i], number[next])] = complex.facet(fresh, corners[(i + 2) % 3]);
      table.twin_places[b][i] = EdgeTable::place(number[next], number[i]);
    }
  }
  for (std::size_t b = 0; b < count; ++b) {
    const auto& corners = kFacet[static_cast<std::size_t>(complex.slot(boundary[b]))];
    for (std::size_t i = 0; i < 3; ++i)
      complex.set_twin(created[b], corners[(i + 2) % 3], table.facets[table.twin_places[b][i]]);
  }
  complex.set_incident(q, created[0]);
}

/// Spreads vertices over all numbers: the sum of the names of a ridge's vertices is a name of the ridge.
inline std::uint64_t name(VertexId v) {
  std::uint64_t x = (std::uint64_t{raw(v)} + 1) * 0x9E37'79B9'7F4A'7C15U;
  x ^= x >> 32;
  return x * 0xD6E8'FEB8'6659'FD93U;
}

/// A bit for each place of a bucket with this key or none, so that the lowest is the key's.
inline unsigned places_for(const RidgeTable::Bucket& bucket, std::uint32_t key) {
#ifdef __SSE2__
  const __m128i keys = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bucket.keys.data()));
  // Written out: of the compiler's own vectors AVX-512 makes masks and vectors again.
  const __m128i is_key = _mm_cmpeq_epi32(keys, _mm_set1_epi32(static_cast<int>(key)));
  const __m128i is_free = _mm_cmpeq_epi32(keys, _mm_setzero_si128());
  return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(_mm_or_si128(is_key, is_free))));
#else
  using Keys = std::uint32_t __attribute__((vector_size(sizeof bucket.keys)));
  Keys keys;
  std::memcpy(&keys, bucket.keys.data(), sizeof keys);
  const auto bits = ((keys == key) | (keys == 0)) & Keys{1, 2, 4, 8};
  return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

/// Above 3D: a table of ridges by their names holds the last facet met at each, of which there are two. Names are not
/// compared with vertices: if two ridges had one name, there would be fewer names than ridges, and only then is the
/// answer false, with all cells made, but some linked wrongly. Whether a facet is the first or the second at its ridge
/// steers no branch: the first is linked to itself until the second comes.
template <int K>
bool fill_by_ridge_table(ComplexView<K> complex, VertexId q, Scratch& scratch) {
  RidgeTable::Bucket* const buckets = scratch.ridges.buckets.data();
  const std::size_t mask = scratch.ridges.buckets.size() - 1;
  const int shift = 64 - std::popcount(mask);
  std::memset(buckets, 0, (mask + 1) * sizeof *buckets);
  CellId* const created = scratch.created.data();
  const FacetId* const boundary = scratch.boundary.data();
  const std::size_t count = scratch.created.size();
  std::size_t ridges = 0;
  for (std::size_t b = 0; b < count; ++b) {
    const int apex = complex.slot(boundary[b]);
    const CellId fresh = created[b] = make_cell(complex, q, boundary[b]);
    std::array<std::uint64_t, K + 1> names;
    std::uint64_t sum = 0;
    for (int i = 0; i <= K; ++i) sum += names[static_cast<std::size_t>(i)] = name(complex.vertex(fresh, i));
    for (int i = 1; i <= K; ++i) {
      const int slot = complex.turned(apex, i);
      complex.set_incident(complex.vertex(fresh, slot), fresh);
      const std::uint64_t ridge = sum - names[static_cast<std::size_t>(slot)];
      const std::uint32_t key = static_cast<std::uint32_t>(ridge) | 1;
      std::size_t place = ridge >> shift;
      while (places_for(buckets[place], key) == 0) [[unlikely]] place = (place + 1) & mask;
      RidgeTable::Bucket& bucket = buckets[place];
      const auto e = static_cast<std::size_t>(std::countr_zero(places_for(bucket, key)));
      const bool first = bucket.keys[e] == 0;
      const FacetId facet = complex.facet(fresh, slot);
      const FacetId other{raw(bucket.facets[e]) | (raw(facet) & (Index{0} - Index{first}))};  // a free place holds 0
      complex.set_twin(fresh, slot, other);
      complex.set_twin(other, facet);
      bucket.keys[e] = key;
      bucket.facets[e] = facet;
      ridges += first ? 1 : 0;
    }
  }
  complex.set_incident(q, created[0]);
  return 2 * ridges == count * K;
}

}  // namespace star

/// Replaces the cavity in `scratch` by the star of q.
template <int K>
void fill_cavity(ComplexView<K> complex, VertexId q, Scratch& scratch) {
  if constexpr (K == 3) {  // a ball of c cells has at most 2 c + 2 facets
    if (scratch.cavity.size() + 3 <= EdgeTable::kNumbers) return star::fill_by_edge_table(complex, q, scratch);
  }
  if constexpr (K > 3) {
    if (star::fill_by_ridge_table(complex, q, scratch)) return;
  } else {
    for (std::size_t b = 0; b < scratch.boundary.size(); ++b)
      scratch.created[b] = star::make_cell(complex, q, scratch.boundary[b]);
  }
  star::link_by_turning(complex, q, scratch);
}

/// 2D: the boundary is a cycle, and listed as one. The new cell at its edge from u to w meets the next one along q and
/// w.
template <>
inline void fill_cavity(ComplexView<2> complex, VertexId q, Scratch& scratch) {
  for (CellId& fresh : scratch.created) fresh = complex.create();
  CellId last = scratch.created.end()[-1];
  int slot_to_next = complex.turned(complex.slot(scratch.boundary.end()[-1]), 1);
  for (std::size_t b = 0; b < scratch.created.size(); ++b) {
    const FacetId inside = scratch.boundary[b];
    const CellId fresh = scratch.created[b];
    const CellId old = complex.cell(inside);
    const FacetId outside = complex.twin(inside);
    const int apex = complex.slot(inside);
    const int u = complex.turned(apex, 1);
    const int w = complex.turned(apex, 2);
    complex.set_vertex(fresh, apex, q);
    complex.set_vertex(fresh, u, complex.vertex(old, u));
    complex.set_vertex(fresh, w, complex.vertex(old, w));
    complex.set_twin(fresh, apex, outside);
    complex.set_twin(outside, complex.facet(fresh, apex));
    complex.set_twin(fresh, w, complex.facet(last, slot_to_next));
    complex.set_twin(last, slot_to_next, complex.facet(fresh, w));
    complex.count_ghost(fresh);
    complex.set_incident(complex.vertex(fresh, u), fresh);
    last = fresh;
    slot_to_next = u;
  }
  complex.set_incident(q, scratch.created.front());
}

}  // namespace delone
