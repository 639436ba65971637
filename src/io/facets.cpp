#include "io/facets.hpp"

#include <algorithm>
#include <numeric>

namespace delone::io {
namespace {

/// Facets as positions cell * corners + i, sorted so that equal facets follow each other.
class FacetList {
 public:
  explicit FacetList(const CellTable& cells) : width_(static_cast<std::size_t>(cells.corners) - 1) {
    const std::size_t corners = width_ + 1;
    rows_.reserve(cells.vertices.size() * width_);
    for (std::size_t facet = 0; facet < cells.vertices.size(); ++facet) {
      const std::span<const Index> cell = cells[facet / corners];
      for (std::size_t i = 0; i < corners; ++i) {
        if (i != facet % corners) rows_.push_back(cell[i]);
      }
      std::sort(rows_.end() - static_cast<std::ptrdiff_t>(width_), rows_.end());
    }
    order_.resize(cells.vertices.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(
        order_, [this](std::size_t a, std::size_t b) { return std::ranges::lexicographical_compare(row(a), row(b)); });
  }

  std::span<const Index> row(std::size_t facet) const { return std::span(rows_).subspan(facet * width_, width_); }
  const std::vector<std::size_t>& order() const { return order_; }

 private:
  std::size_t width_;
  std::vector<Index> rows_;
  std::vector<std::size_t> order_;
};

}  // namespace

std::vector<Index> neighbours_of(const CellTable& cells) {
  if (cells.neighbours.size() == cells.vertices.size()) return cells.neighbours;
  std::vector<Index> neighbours(cells.vertices.size(), kNone);
  const auto corners = static_cast<std::size_t>(cells.corners);
  if (corners < 2) return neighbours;
  const FacetList facets(cells);
  const std::vector<std::size_t>& order = facets.order();
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    if (!std::ranges::equal(facets.row(order[k]), facets.row(order[k + 1]))) continue;
    neighbours[order[k]] = static_cast<Index>(order[k + 1] / corners);
    neighbours[order[k + 1]] = static_cast<Index>(order[k] / corners);
    ++k;
  }
  return neighbours;
}

std::vector<std::array<Index, 3>> boundary_triangles(const CellTable& cells) {
  // Opposite each vertex of a tetrahedron with positive determinant (b - a, c - a, d - a), seen from outside.
  constexpr std::array<std::array<std::size_t, 3>, 4> kOutward{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  const std::vector<Index> neighbours = neighbours_of(cells);
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t facet = 0; facet < neighbours.size(); ++facet) {
    if (neighbours[facet] != kNone) continue;
    const std::span<const Index> cell = cells[facet / 4];
    const auto& [a, b, c] = kOutward[facet % 4];
    triangles.push_back({cell[a], cell[b], cell[c]});
  }
  return triangles;
}

}  // namespace delone::io
