// Cells as plain arrays of input rows, in the one order that files and hashes use.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone {

/// m cells of `corners` vertices each. Vertices are input rows, neighbours are positions in this table.
///
/// The documented order: within a cell the rows ascend, but for the last two, which are swapped where that is needed to
/// make the cell positively oriented; the cells themselves are sorted by their ascending rows. Equal input therefore
/// gives equal tables, whatever the method, the order of insertion or the number of threads.
struct CellTable {
  int corners = 0;
  std::vector<Index> vertices;    ///< size() x corners
  std::vector<Index> neighbours;  ///< the same shape, column i opposite vertex i, kNone outside; may be left empty

  std::size_t size() const { return corners == 0 ? 0 : vertices.size() / static_cast<std::size_t>(corners); }
  std::span<const Index> operator[](std::size_t cell) const {
    return std::span(vertices).subspan(cell * static_cast<std::size_t>(corners), static_cast<std::size_t>(corners));
  }
};

/// Polytopes with any number of vertices: cell c holds vertices[offsets[c]] to vertices[offsets[c + 1]], ascending
/// rows.
struct PolytopeTable {
  std::vector<std::size_t> offsets{0};
  std::vector<Index> vertices;

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const Index> operator[](std::size_t cell) const {
    return std::span(vertices).subspan(offsets[cell], offsets[cell + 1] - offsets[cell]);
  }
};

}  // namespace delone
