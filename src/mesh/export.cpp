#include "delone/mesh/export.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/groups.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/base/random.hpp"
#include "mesh/cospherical.hpp"

namespace delone {
namespace {

/// A cell under the names of its vertices, ascending; `odd` when sorting them took an odd number of swaps.
template <int Corners>
struct NamedCell {
  std::array<Index, Corners> names;
  CellId cell;
  bool odd;
};

/// Without branches, which nobody can predict.
template <std::size_t Corners>
bool sort_names(std::array<Index, Corners>& names) {
  bool odd = false;
  for (std::size_t sorted = 0; sorted + 1 < Corners; ++sorted) {
    for (std::size_t i = Corners - 1; i > sorted; --i) {
      const auto [less, more] = std::pair(std::min(names[i - 1], names[i]), std::max(names[i - 1], names[i]));
      odd ^= less != names[i - 1];
      names[i - 1] = less;
      names[i] = more;
    }
  }
  return odd;
}

/// Sorts cells by their names: a counting sort by the first name, then each small group.
template <int Corners>
void sort_cells(Buffer<NamedCell<Corners>>& cells, std::size_t name_count) {
  Buffer<std::size_t> place;  // where the next cell with this first name goes
  place.resize(name_count + 1, 0);
  for (const auto& cell : cells) ++place[cell.names[0] + std::size_t{1}];
  std::partial_sum(place.begin(), place.end(), place.begin());
  Buffer<NamedCell<Corners>> sorted(cells.size());
  for (const auto& cell : cells) sorted[place[cell.names[0]]++] = cell;
  cells.swap(sorted);
  auto* first = cells.begin();
  for (std::size_t name = 0; name < name_count; ++name) {
    auto* const last = cells.begin() + place[name];
    std::sort(first, last, [](const auto& a, const auto& b) { return a.names < b.names; });
    first = last;
  }
}

/// The finite cells under names given by name(vertex) < name_count, sorted.
template <int K, class Name>
Buffer<NamedCell<K + 1>> named_cells(const AnyTriangulation& t, std::size_t name_count, Name name) {
  const ConstComplexView<K> complex(t.complex());
  Buffer<NamedCell<K + 1>> cells;
  cells.reserve(t.cell_count());
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c) || complex.is_ghost(c)) continue;
    NamedCell<K + 1> cell{{}, c, false};
    for (int i = 0; i <= K; ++i) cell.names[static_cast<std::size_t>(i)] = name(complex.vertex(c, i));
    cell.odd = sort_names(cell.names);
    cells.push_back(cell);
  }
  sort_cells(cells, name_count);
  return cells;
}

/// The neighbours of the cells of a table, in which that of slot s stands at position[s]. Cells are taken by their
/// slots: there those that are neighbours are near each other.
template <int K>
std::vector<Index> neighbours_in(const CellTable& table, const AnyTriangulation& t, const Buffer<Index>& position) {
  const ConstComplexView<K> complex(t.complex());
  std::vector<Index> neighbours(table.vertices.size());
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    if (position[s] == kNone) continue;
    const CellId c{static_cast<Index>(s)};
    const std::size_t first = std::size_t{position[s]} * (K + 1);
    for (int i = 0; i <= K; ++i) {
      std::size_t at = first;
      while (table.vertices[at] != t.row(complex.vertex(c, i))) ++at;
      neighbours[at] = position[raw(complex.cell(complex.twin(c, i)))];
    }
  }
  return neighbours;
}

template <int K>
CellTable cells_of(const AnyTriangulation& t, bool with_neighbours) {
  const auto sorted = named_cells<K>(t, t.row_count(), [&](VertexId v) { return t.row(v); });
  CellTable table{.corners = K + 1, .vertices = {}, .neighbours = {}};
  table.vertices.reserve(sorted.size() * (K + 1));
  for (const auto& [names, cell, odd] : sorted) {
    auto rows = names;
    if constexpr (K >= 1) {
      rows[K - 1] = names[odd ? K : K - 1];
      rows[K] = names[odd ? K - 1 : K];
    }
    table.vertices.insert(table.vertices.end(), rows.begin(), rows.end());
  }
  if (with_neighbours) {
    Buffer<Index> position;
    position.resize(t.complex().slot_count(), kNone);
    for (std::size_t i = 0; i < sorted.size(); ++i) position[raw(sorted[i].cell)] = static_cast<Index>(i);
    table.neighbours = neighbours_in<K>(table, t, position);
  }
  return table;
}

template <int K>
std::vector<CellId> cell_ids_of(const AnyTriangulation& t) {
  std::vector<CellId> ids;
  for (const auto& named : named_cells<K>(t, t.row_count(), [&](VertexId v) { return t.row(v); })) {
    ids.push_back(named.cell);
  }
  return ids;
}

template <int K>
CellTable hull_facets_of(const AnyTriangulation& t) {
  const Complex& complex = t.complex();
  Buffer<NamedCell<K>> facets;
  facets.reserve(t.hull_facet_count());
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!complex.is_live(c) || !complex.is_ghost(c)) continue;
    NamedCell<K> facet{{}, c, false};
    std::size_t i = 0;
    for (int j = 0; j <= K; ++j) {
      if (complex.vertex(c, j) != kGhost) facet.names[i++] = t.row(complex.vertex(c, j));
    }
    // With the ghost outside and last the cell is positive (I3, I4); the normal goes first, past K - 1 edges.
    facet.odd = sort_names(facet.names) != (K % 2 == 0);
    facets.push_back(facet);
  }
  sort_cells(facets, t.row_count());
  CellTable table{.corners = K, .vertices = {}, .neighbours = {}};
  for (const auto& facet : facets) {
    auto rows = facet.names;
    if constexpr (K >= 2) {
      if (facet.odd) std::swap(rows[K - 1], rows[K - 2]);
    }
    table.vertices.insert(table.vertices.end(), rows.begin(), rows.end());
  }
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
  const auto coordinates = [&](VertexId v) { return std::span(sites.leading() + raw(v) * k, k); };
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
    for (const auto& cell : named_cells<k>(t, count, [&](VertexId v) { return ranks[raw(v)]; })) {
      for (const Index name : cell.names) feed(name);
    }
  });
  return hash;
}

}  // namespace delone
