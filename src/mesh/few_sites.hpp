// The triangulations of two and of three sites of the plane, as tables.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delone/base/ids.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

/// The cells of a triangulation of N sites that stand in a list, those of the hull first and counter-clockwise. The
/// first cells are the ghost cells, on the edges that leave the first, the second and so on.
template <std::size_t N>
struct CellsOfFew {
  static constexpr std::size_t kCount = 2 * N - 2;
  using Row = std::array<std::uint8_t, 3>;

  std::array<Row, kCount> corners;  ///< places in the list; N is the ghost
  std::array<Row, kCount> twins;    ///< the facets they would be if the first cell were number 0

  explicit constexpr CellsOfFew(const std::array<Row, kCount>& corners_of_cells) : corners(corners_of_cells), twins() {
    for (std::size_t c = 0; c < kCount; ++c) {
      for (std::size_t i = 0; i < 3; ++i) twins[c][i] = across(corners[c][(i + 1) % 3], corners[c][(i + 2) % 3]);
    }
  }

 private:
  /// The facet on the other side of the edge that leads from one place to another.
  constexpr std::uint8_t across(std::uint8_t from, std::uint8_t to) const {
    for (std::size_t i = 0;; ++i) {
      const Row& cell = corners[i / 3];
      if (cell[(i + 1) % 3] != to || cell[(i + 2) % 3] != from) continue;
      return static_cast<std::uint8_t>(
          raw(ComplexView<2>::facet(CellId{static_cast<Index>(i / 3)}, static_cast<int>(i % 3))));
    }
  }
};

inline constexpr CellsOfFew<2> kCellsOfTwo({{{1, 0, 2}, {0, 1, 2}}});
inline constexpr CellsOfFew<3> kCellsOfThree({{{1, 0, 3}, {2, 1, 3}, {0, 2, 3}, {0, 1, 2}}});

}  // namespace delone
