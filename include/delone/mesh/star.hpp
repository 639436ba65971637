// Fill a cavity with the star of a vertex, in any dimension: one new cell per facet of the cavity's boundary.
// Source: [For92] 4.3. New cells are linked to each other without a table of facets: the two new cells at a ridge of
// the boundary are found by turning about the ridge through the cells of the cavity, each ridge once.
//
// Departures, for speed: in 2D a ridge is a vertex, and in 3D an edge between two of the few vertices of the boundary;
// both are looked up instead of turned about.
//
// Cost: O(K * cells removed and created); cannot fail, since room has been made.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "delone/mesh/scratch.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

namespace star {

/// Links new cells by turning about each ridge of the boundary, through the cavity. The old cells are still there;
/// their boundary facets lead to the new cells.
template <int K>
void link_by_turning(ComplexView<K> complex, VertexId q, const Scratch& scratch) {
  for (std::size_t b = 0; b < scratch.boundary.size(); ++b) {
    for (int i = 0; i <= K; ++i) {
      if (i != scratch.boundary[b].apex) complex.set_twin(scratch.created[b], i, kNoFacet);
    }
  }
  for (std::size_t b = 0; b < scratch.boundary.size(); ++b) {
    const CellId fresh = scratch.created[b];
    complex.settle(fresh);
    const int apex = scratch.boundary[b].apex;
    for (int i = 0; i <= K; ++i) {
      if (i == apex || complex.twin(fresh, i) != kNoFacet) continue;
      // The ridge lacks slots `in` and `out` of each cell: enter through one facet, leave through the other.
      CellId c = scratch.boundary[b].inside;
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

/// 2D: the boundary is a cycle; the cell that starts at a vertex is the incident cell of that vertex, so the cell that
/// ends there finds its neighbour by it.
inline void link_cycle(ComplexView<2> complex, VertexId q, const Scratch& scratch) {
  constexpr std::array<int, 3> kNext{1, 2, 0};
  for (std::size_t b = 0; b < scratch.created.size(); ++b) {
    const int apex = scratch.boundary[b].apex;
    complex.set_incident(complex.vertex(scratch.created[b], kNext[static_cast<std::size_t>(apex)]), scratch.created[b]);
  }
  for (std::size_t b = 0; b < scratch.created.size(); ++b) {
    const int apex = scratch.boundary[b].apex;
    const int start = kNext[static_cast<std::size_t>(apex)];
    const int end = kNext[static_cast<std::size_t>(start)];
    const CellId next = complex.incident_cell(complex.vertex(scratch.created[b], end));
    // `next` has q, then its start, then its end, where the two cells touch along q and `end`.
    const int across = kNext[static_cast<std::size_t>(kNext[static_cast<std::size_t>(complex.slot_of(next, q))])];
    complex.link(complex.facet(scratch.created[b], start), complex.facet(next, across));
  }
  complex.set_incident(q, scratch.created.front());
}

/// 3D: every edge of the boundary is seen once in each direction; a table over the boundary's vertices, numbered as
/// they come, holds the facet at each. False when they are too many for the table.
inline bool link_by_edge_table(ComplexView<3> complex, VertexId q, Scratch& scratch) {
  // Corners of the facet opposite each slot, in the order that makes a shared edge run in opposite directions.
  constexpr std::array<std::array<int, 3>, 4> kFacet{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  auto& table = scratch.edges;
  const std::size_t count = scratch.created.size();
  if (count > 2 * EdgeTable::kVertices - 4) return false;  // a sphere of v vertices has 2 v - 4 triangles
  std::size_t members = 0;
  for (std::size_t b = 0; b < count; ++b) {
    const CellId fresh = scratch.created[b];
    const auto& corners = kFacet[static_cast<std::size_t>(scratch.boundary[b].apex)];
    std::array<std::size_t, 3> number;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = complex.vertex(fresh, corners[i]);
      std::uint16_t& known = table.number[static_cast<Index>(raw(v) + 1)];  // the ghost wraps round to 0
      if (known >= members || table.member[known] != v) {                   // numbers of earlier stars are not cleared
        known = static_cast<std::uint16_t>(members);
        table.member[members++] = v;
        complex.set_incident(v, fresh);
      }
      number[i] = known;
    }
    table.numbers[b] = number;
    for (std::size_t i = 0; i < 3; ++i) {
      table.facet[number[i]][number[(i + 1) % 3]] = complex.facet(fresh, corners[(i + 2) % 3]);
    }
  }
  for (std::size_t b = 0; b < count; ++b) {
    const auto& corners = kFacet[static_cast<std::size_t>(scratch.boundary[b].apex)];
    const auto& number = table.numbers[b];
    for (std::size_t i = 0; i < 3; ++i) {
      complex.set_twin(scratch.created[b], corners[(i + 2) % 3], table.facet[number[(i + 1) % 3]][number[i]]);
    }
  }
  complex.set_incident(q, scratch.created.front());
  return true;
}

}  // namespace star

/// Replaces the cavity in `scratch` by the star of q.
template <int K>
void fill_cavity(ComplexView<K> complex, VertexId q, Scratch& scratch) {
  auto& [marks, removed, spared, boundary, created, edges, planes] = scratch;
  for (std::size_t b = 0; b < boundary.size(); ++b) {
    const auto [inside, apex, outside] = boundary[b];
    const CellId fresh = complex.create();
    created[b] = fresh;
    auto vertices = complex.vertices(inside);
    vertices[static_cast<std::size_t>(apex)] = q;
    complex.set_vertices(fresh, vertices);
    complex.count_ghost(fresh);
    if constexpr (K > 3) planes[raw(fresh) * Scratch::plane_size(K)] = std::numeric_limits<double>::quiet_NaN();
    complex.link(complex.facet(fresh, apex), outside);
    complex.set_twin(inside, apex, complex.facet(fresh, apex));  // from the old boundary to the star, for turning
  }
  if constexpr (K == 2) {
    star::link_cycle(complex, q, scratch);
  } else if constexpr (K == 3) {
    if (!star::link_by_edge_table(complex, q, scratch)) star::link_by_turning(complex, q, scratch);
  } else {
    star::link_by_turning(complex, q, scratch);
  }
}

}  // namespace delone
