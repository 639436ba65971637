#include "delone/mesh/export.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/base/random.hpp"

namespace delone {
namespace {

/// A cell under the names of its vertices, ascending; `odd` when sorting them took an odd number of swaps.
template <int Corners>
struct NamedCell {
  std::array<Index, Corners> names;
  CellId cell;
  bool odd;
};

template <std::size_t Corners>
bool sort_names(std::array<Index, Corners>& names) {
  bool odd = false;
  for (std::size_t i = 1; i < Corners; ++i) {
    for (std::size_t j = i; j > 0 && names[j] < names[j - 1]; --j) {
      std::swap(names[j], names[j - 1]);
      odd = !odd;
    }
  }
  return odd;
}

/// Sorts cells by their names: a counting sort by the first name, then each small group.
template <int Corners>
void sort_cells(std::vector<NamedCell<Corners>>& cells, std::size_t name_count) {
  std::vector<std::size_t> start(name_count + 1, 0);
  for (const auto& cell : cells) ++start[cell.names[0] + std::size_t{1}];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<NamedCell<Corners>> sorted(cells.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (const auto& cell : cells) sorted[next[cell.names[0]]++] = cell;
  for (std::size_t name = 0; name < name_count; ++name) {
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(start[name]),
              sorted.begin() + static_cast<std::ptrdiff_t>(start[name + 1]),
              [](const auto& a, const auto& b) { return a.names < b.names; });
  }
  cells = std::move(sorted);
}

/// The finite cells under names given by name(vertex) < name_count, sorted.
template <int K, class Name>
std::vector<NamedCell<K + 1>> named_cells(const AnyTriangulation& t, std::size_t name_count, Name name) {
  const Complex& complex = t.complex();
  std::vector<NamedCell<K + 1>> cells;
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

template <int K>
CellTable cells_of(const AnyTriangulation& t) {
  const Complex& complex = t.complex();
  const auto sorted = named_cells<K>(t, t.row_count(), [&](VertexId v) { return t.row(v); });
  std::vector<Index> position(complex.slot_count(), kNone);
  for (std::size_t i = 0; i < sorted.size(); ++i) position[raw(sorted[i].cell)] = static_cast<Index>(i);
  CellTable table{.corners = K + 1, .vertices = {}, .neighbours = {}};
  table.vertices.reserve(sorted.size() * (K + 1));
  table.neighbours.reserve(sorted.size() * (K + 1));
  for (const auto& [names, cell, odd] : sorted) {
    auto rows = names;
    if constexpr (K >= 1) {
      if (odd) std::swap(rows[K], rows[K - 1]);
    }
    for (const Index row : rows) {
      int i = 0;
      while (complex.vertex(cell, i) != t.vertex(row)) ++i;
      table.vertices.push_back(row);
      table.neighbours.push_back(position[raw(complex.cell(complex.twin(cell, i)))]);
    }
  }
  return table;
}

template <int K>
CellTable hull_facets_of(const AnyTriangulation& t) {
  const Complex& complex = t.complex();
  std::vector<NamedCell<K>> facets;
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

/// Sets of cells that are one polytope, by union and find.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(Index a, Index b) { parent_[std::max(find(a), find(b))] = std::min(find(a), find(b)); }

 private:
  std::vector<Index> parent_;
};

template <int K>
bool on_common_orthosphere(const Kernel<K>& kernel, const Complex& complex, CellId c, VertexId apex) {
  typename Kernel<K>::Cell cell;
  for (int i = 0; i <= K; ++i) cell[static_cast<std::size_t>(i)] = complex.vertex(c, i);
  const int sign = kernel.filtered_conflict(cell, apex);
  return sign == 0 || (sign == Kernel<K>::kUnsure && kernel.slow_conflict_sign(cell, apex).sign == 0);
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

CellTable cells(const AnyTriangulation& t) {
  if (t.affine_dimension() < 0) return {};
  return with_dimension(t.affine_dimension(), [&](auto k) { return cells_of<k>(t); });
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
