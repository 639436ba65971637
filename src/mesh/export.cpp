#include "delone/mesh/export.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/groups.hpp"
#include "base/huge_pages.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/base/random.hpp"
#include "mesh/cospherical.hpp"

namespace delone {
namespace {

/// A cell under the names of its vertices: ascending, but for the last two, which change places where the orientation
/// asks for it.
template <std::size_t Corners>
struct NamedCell {
  std::array<Index, Corners> names;
  CellId cell;
};
/// The same, where nobody asks which cell it is: what is sorted is smaller.
template <std::size_t Corners>
struct Names {
  std::array<Index, Corners> names;
};

/// Exchanges two names where a condition, 0 or 1, holds. Without a branch, here and below: nobody can predict it.
inline void exchange(Index& a, Index& b, Index condition) {
  const Index difference = (a ^ b) & (0 - condition);
  a ^= difference;
  b ^= difference;
}
template <std::size_t Corners>
void exchange_last(std::array<Index, Corners>& names, Index condition) {
  if constexpr (Corners >= 2) exchange(names[Corners - 2], names[Corners - 1], condition);
}
template <std::size_t Corners>
std::array<Index, Corners> ascending(std::array<Index, Corners> names) {
  if constexpr (Corners >= 2) exchange_last(names, names[Corners - 1] < names[Corners - 2] ? 1 : 0);
  return names;
}

/// @return 1 if it took an odd number of swaps, else 0
template <std::size_t Corners>
Index sort_names(std::array<Index, Corners>& names) {
  Index odd = 0;
  for (std::size_t sorted = 0; sorted + 1 < Corners; ++sorted) {
    for (std::size_t i = Corners - 1; i > sorted; --i) {
      const Index swapped = names[i] < names[i - 1] ? 1 : 0;
      exchange(names[i - 1], names[i], swapped);
      odd ^= swapped;
    }
  }
  return odd;
}

/// Gives cells to visit(cell) in the order of their names, which are below name_count: a counting sort by the first
/// name, then each small group.
template <class Cell, class Visit>
void visit_sorted(const Buffer<Cell>& cells, std::size_t name_count, Visit&& visit) {
  const auto first_name = [](const Cell& cell) { return ascending(cell.names)[0]; };
  Buffer<Index> place;  // where the next cell with this first name goes
  place.resize(name_count + 1, 0);
  for (const Cell& cell : cells) ++place[first_name(cell) + std::size_t{1}];
  std::partial_sum(place.begin(), place.end(), place.begin());
  Buffer<Cell> sorted(cells.size());
  for (const Cell& cell : cells) sorted[place[first_name(cell)]++] = cell;
  auto* first = sorted.begin();
  for (std::size_t name = 0; name < name_count; ++name) {
    auto* const last = sorted.begin() + place[name];
    std::sort(first, last, [](const Cell& a, const Cell& b) { return ascending(a.names) < ascending(b.names); });
    for (; first != last; ++first) visit(*first);
  }
}

/// Gives the finite cells to visit(cell), under names given by name(vertex) < name_count, in their order.
/// @tparam Cell  NamedCell or Names
template <template <std::size_t> class Cell, int K, class Name, class Visit>
void visit_cells(const AnyTriangulation& t, std::size_t name_count, const Name& name, Visit&& visit) {
  const ConstComplexView<K> complex(t.complex());
  Buffer<Cell<K + 1>> cells;
  cells.reserve(t.cell_count());
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c) || complex.is_ghost(c)) continue;
    Cell<K + 1> cell;
    for (int i = 0; i <= K; ++i) cell.names[static_cast<std::size_t>(i)] = name(complex.vertex(c, i));
    exchange_last(cell.names, sort_names(cell.names));
    if constexpr (requires { cell.cell; }) cell.cell = c;
    cells.push_back(cell);
  }
  visit_sorted(cells, name_count, visit);
}

/// The neighbours of the cells of a table, in which that of slot s stands at position[s]. Cells are taken by their
/// slots: there those that are neighbours are near each other.
template <int K>
std::vector<Index> neighbours_in(const CellTable& table, const AnyTriangulation& t, const Buffer<Index>& position) {
  const ConstComplexView<K> complex(t.complex());
  constexpr std::size_t kAhead = 16;
  std::vector<Index> neighbours;
  reserve_large(neighbours, table.vertices.size());
  neighbours.resize(table.vertices.size());
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    if (s + kAhead < complex.slot_count() && position[s + kAhead] != kNone) {
      __builtin_prefetch(table.vertices.data() + std::size_t{position[s + kAhead]} * (K + 1));
      __builtin_prefetch(neighbours.data() + std::size_t{position[s + kAhead]} * (K + 1), 1);
    }
    if (position[s] == kNone) continue;
    const CellId c{static_cast<Index>(s)};
    const std::size_t first = std::size_t{position[s]} * (K + 1);
    for (int i = 0; i <= K; ++i) {
      const Index row = t.row(complex.vertex(c, i));
      std::size_t at = 0;
      for (std::size_t j = 1; j <= K; ++j) at = table.vertices[first + j] == row ? j : at;
      neighbours[first + at] = position[raw(complex.cell(complex.twin(c, i)))];
    }
  }
  return neighbours;
}

template <int K>
CellTable cells_of(const AnyTriangulation& t, bool with_neighbours) {
  CellTable table{.corners = K + 1, .vertices = {}, .neighbours = {}};
  reserve_large(table.vertices, t.cell_count() * (K + 1));
  table.vertices.resize(t.cell_count() * (K + 1));
  const auto row = [&](VertexId v) { return t.row(v); };
  auto add = [to = table.vertices.begin()](const auto& cell) mutable { to = std::ranges::copy(cell.names, to).out; };
  if (!with_neighbours) {
    visit_cells<Names, K>(t, t.row_count(), row, add);
    return table;
  }
  Buffer<Index> position;
  position.resize(t.complex().slot_count(), kNone);
  Index count = 0;
  visit_cells<NamedCell, K>(t, t.row_count(), row, [&](const auto& cell) {
    add(cell);
    position[raw(cell.cell)] = count++;
  });
  table.neighbours = neighbours_in<K>(table, t, position);
  return table;
}

template <int K>
std::vector<CellId> cell_ids_of(const AnyTriangulation& t) {
  std::vector<CellId> ids;
  ids.reserve(t.cell_count());
  const auto row = [&](VertexId v) { return t.row(v); };
  visit_cells<NamedCell, K>(t, t.row_count(), row, [&](const auto& cell) { ids.push_back(cell.cell); });
  return ids;
}

template <int K>
CellTable hull_facets_of(const AnyTriangulation& t) {
  const Complex& complex = t.complex();
  Buffer<Names<K>> facets;
  facets.reserve(t.hull_facet_count());
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c) || !complex.is_ghost(c)) continue;
    Names<K> facet{};
    std::size_t i = 0;
    for (int j = 0; j <= K; ++j) {
      if (complex.vertex(c, j) != kGhost) facet.names[i++] = t.row(complex.vertex(c, j));
    }
    // With the ghost outside and last the cell is positive (I3, I4); the normal goes first, past K - 1 edges.
    exchange_last(facet.names, sort_names(facet.names) ^ (K % 2 == 0 ? 1 : 0));
    facets.push_back(facet);
  }
  CellTable table{.corners = K, .vertices = {}, .neighbours = {}};
  visit_sorted(facets, t.row_count(), [&](const Names<K>& facet) {
    table.vertices.insert(table.vertices.end(), facet.names.begin(), facet.names.end());
  });
  return table;
}

template <int K>
std::vector<std::vector<Index>> polytopes_of(const AnyTriangulation& t) {
  const Complex& complex = t.complex();
  Groups groups(complex.slot_count());
  if constexpr (K >= 1) {
    const Kernel<K> kernel(t.sites());
    for (std::size_t s = 0; s < complex.slot_count(); ++s) {
      const CellId c{static_cast<Index>(s)};
      if (!complex.is_live(c) || complex.is_ghost(c)) continue;
      for (int i = 0; i <= K; ++i) {
        const FacetId across = complex.twin(c, i);
        const CellId d = complex.cell(across);
        if (raw(d) < raw(c) || complex.is_ghost(d)) continue;
        if (on_common_orthosphere<K>(kernel, complex, c, complex.vertex(d, complex.slot(across)))) {
          groups.unite(raw(c), raw(d));
        }
      }
    }
  }
  std::vector<std::vector<Index>> rows_of_group(complex.slot_count());
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c) || complex.is_ghost(c)) continue;
    auto& rows = rows_of_group[groups.find(raw(c))];
    for (int i = 0; i <= K; ++i) rows.push_back(t.row(complex.vertex(c, i)));
  }
  std::erase_if(rows_of_group, [](const auto& rows) { return rows.empty(); });
  for (auto& rows : rows_of_group) {
    std::ranges::sort(rows);
    rows.erase(std::ranges::unique(rows).begin(), rows.end());
  }
  std::ranges::sort(rows_of_group);
  return rows_of_group;
}

/// Rank of every site among the distinct points in lexicographic order; and how many distinct points there are.
std::pair<std::vector<Index>, std::size_t> lexicographic_ranks(const Sites& sites) {
  std::vector<VertexId> order;
  order.reserve(sites.present_count());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (const VertexId v{static_cast<Index>(i)}; !sites.is_empty(v)) order.push_back(v);
  }
  const auto k = static_cast<std::size_t>(std::max(sites.flat().dimension, 0));  // these axes come first (Flat)
  const auto coordinates = [&](VertexId v) { return std::span(sites.at(v), k); };
  std::ranges::sort(order, [&](VertexId a, VertexId b) {
    return std::ranges::lexicographical_compare(coordinates(a), coordinates(b));
  });
  std::vector<Index> rank(sites.size());
  std::size_t distinct = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || !std::ranges::equal(coordinates(order[i - 1]), coordinates(order[i]))) ++distinct;
    rank[raw(order[i])] = static_cast<Index>(distinct - 1);
  }
  return {std::move(rank), distinct};
}

}  // namespace

CellTable cells(const AnyTriangulation& t, bool with_neighbours) {
  if (t.affine_dimension() < 0) return {};
  return with_dimension(t.affine_dimension(), [&](auto k) { return cells_of<k>(t, with_neighbours); });
}

std::vector<CellId> cell_ids(const AnyTriangulation& t) {
  if (t.affine_dimension() < 0) return {};
  return with_dimension(t.affine_dimension(), [&](auto k) { return cell_ids_of<k>(t); });
}

CellTable hull_facets(const AnyTriangulation& t) {
  if (t.affine_dimension() < 1) return {};
  return with_dimension<1>(t.affine_dimension(), [&](auto k) { return hull_facets_of<k>(t); });
}

PolytopeTable merged_cells(const AnyTriangulation& t) {
  const ExactEnvironment environment;
  PolytopeTable table;
  if (t.affine_dimension() < 0) return table;
  for (const auto& rows : with_dimension(t.affine_dimension(), [&](auto k) { return polytopes_of<k>(t); })) {
    table.vertices.insert(table.vertices.end(), rows.begin(), rows.end());
    table.offsets.push_back(table.vertices.size());
  }
  return table;
}

std::uint64_t canonical_hash(const AnyTriangulation& t) {
  const ExactEnvironment environment;
  const auto [rank, distinct] = lexicographic_ranks(t.sites());
  std::uint64_t hash = 0;
  const auto feed = [&hash](std::uint64_t word) { hash = mix(hash ^ word); };
  feed(static_cast<std::uint64_t>(t.dimension()));
  feed(static_cast<std::uint64_t>(static_cast<std::int64_t>(t.affine_dimension())));
  feed(distinct);
  feed(t.cell_count());
  if (t.affine_dimension() < 0) return hash;
  with_dimension(t.affine_dimension(), [&, &ranks = rank, count = distinct](auto k) {
    const auto rank_of = [&](VertexId v) { return ranks[raw(v)]; };
    visit_cells<Names, k>(t, count, rank_of, [&](const auto& cell) {
      for (const Index name : ascending(cell.names)) feed(name);
    });
  });
  return hash;
}

}  // namespace delone
