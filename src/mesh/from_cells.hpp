// Finite cells become a complex: ghost cells close the hull.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "delone/mesh/triangulation.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

/// The ghost cell on the facet of a finite cell opposite slot i: seen from outside the facet turns over (I3), by one
/// swap, which also takes the ghost to the last slot (I4).
template <int K>
std::array<VertexId, K + 1> outside_of(std::array<VertexId, K + 1> cell, int i) {
  cell[static_cast<std::size_t>(i)] = kGhost;
  if (K >= 2 && i == K) {
    std::swap(cell[0], cell[1]);
  } else {
    std::swap(cell[static_cast<std::size_t>(i)], cell[static_cast<std::size_t>(K == 1 ? 1 - i : K)]);
  }
  return cell;
}

/// Makes a ghost cell on each facet that has no twin yet. All cells so far are finite, none is dead, and those around a
/// ridge of the hull are linked. Cost: O(K * facets), and O(1) for each cell at each ridge of the hull.
template <int K>
void close_hull(Mesh& mesh) {
  ComplexView<K> complex(mesh.complex);
  const std::size_t finite = complex.slot_count();
  std::size_t open = 0;
  const auto for_open = [&](const auto& f) {
    for (std::size_t s = 0; s < finite; ++s) {
      for (int i = 0; i <= K; ++i) {
        if (complex.twin(CellId{static_cast<Index>(s)}, i) == kNoFacet) f(CellId{static_cast<Index>(s)}, i);
      }
    }
  };
  for_open([&](CellId, int) { ++open; });
  mesh.complex.reserve_more(open, mesh.sites.size());
  for_open([&](CellId c, int i) {
    const CellId ghost = complex.create();
    complex.set_vertices(ghost, outside_of<K>(complex.vertices(c), i));
    complex.count_ghost(ghost);
    complex.settle(ghost);
    complex.link(complex.facet(c, i), complex.facet(ghost, complex.ghost_slot(ghost)));
  });
  for (std::size_t s = finite; s < complex.slot_count(); ++s) {
    const CellId ghost{static_cast<Index>(s)};
    const FacetId inside = complex.twin(ghost, complex.ghost_slot(ghost));
    for (int j = 0; j <= K; ++j) {
      if (j == complex.slot(inside)) continue;
      CellId c = complex.cell(inside);
      int entered = complex.slot(inside);
      int leave = j;
      FacetId across = complex.twin(c, leave);
      while (!complex.is_ghost(complex.cell(across))) {  // turn about the ridge
        leave = complex.slot_of(complex.cell(across), complex.vertex(c, entered));
        entered = complex.slot(across);
        c = complex.cell(across);
        across = complex.twin(c, leave);
      }
      const CellId next = complex.cell(across);
      const VertexId dropped = complex.vertex(complex.cell(inside), j);
      complex.set_twin(ghost, complex.slot_of(ghost, dropped),
                       complex.facet(next, complex.slot_of(next, complex.vertex(c, entered))));
    }
  }
  mesh.statistics.cells_created += open;
}

}  // namespace delone
