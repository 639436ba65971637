// Cells of the plane that were found by floats, and what proves that they are the triangulation.
#pragma once

#include <array>
#include <cstddef>

#include "delone/mesh/triangulation.hpp"
#include "geometry/sixteen_in_plane.hpp"

namespace delone {

#ifdef DELONE_SIXTEENS

/// The cells in the order in which they are found: each has a facet of one before, and there a corner that may be new.
/// The ghost is the vertex after the last site.
struct FoundCells {
  static constexpr std::size_t kMost = 2 * sixteen::kMostSites;

  explicit FoundCells(std::size_t sites) : ghost(static_cast<Index>(sites)) {}

  /// How many a triangulation has.
  std::size_t due() const { return 2 * std::size_t{ghost} - 2; }
  void glue(Index f, Index g) {
    twins[f] = g;
    twins[g] = f;
  }
  Index across(Index facet) const { return corners[twins[facet] / 4][twins[facet] % 4]; }

  Index ghost;
  std::size_t count = 0, met_count = 0;
  std::array<std::array<Index, 4>, kMost> corners;  // three, the ghost or a new one last; and nothing
  std::array<Index, 4 * kMost> twins;  // by facet: 4 to each cell; a facet itself where the twin is missing
  std::array<Index, 2 * kMost> met;    // one of each two that are glued, neither of which is the last of its cell
};

/// Fills the complex of a mesh with the cells. Whether they are the triangulation of all sites; if not, the complex is
/// to be thrown away. Taken for granted is what follows from how cells are found: twins are each other's and see the
/// same edge from its two sides; of each two, one is the last facet of its cell or in `met`; each site but the first
/// two of the first cell is somewhere the last corner.
bool prove(Mesh& mesh, const sixteen::InPlane& sites, const FoundCells& cells);

#endif

}  // namespace delone
