#include "delone/query/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "delone/base/arithmetic.hpp"
#include "delone/base/dispatch.hpp"
#include "query/along_curve.hpp"
#include "query/nearest_search.hpp"

namespace delone {
namespace {

using query_detail::NearestSearch;

/// A few hundred kilobytes in 3D: they stay in the cache of a core.
constexpr std::size_t kKeptInBatch = 1024;

void require_radius(double radius) {
  if (!(radius >= 0.0) || !std::isfinite(radius)) {
    throw InputError("radius " + std::to_string(radius) + ": expected a finite number that is not negative");
  }
}

/// Calls f(search) for one query, unless there are no vertices.
template <class F>
void search_once(const AnyTriangulation& t, std::span<const double> q, CellId near, F f) {
  const ExactEnvironment environment;
  const PointsView query = query_detail::require_query(t, q);
  if (t.affine_dimension() < 0) return;
  with_dimension(t.affine_dimension(), [&](auto k) {
    NearestSearch<k> search(t, query_detail::range_with(t.sites(), query), near, 1);
    f(search);
  });
}

/// Calls answer(search, row of the query, its chunk) for every query, along a curve.
template <class Answer>
void search_along_curve(const AnyTriangulation& t, PointsView queries, std::span<const Index> order,
                        const QueryOptions& options, const Answer& answer) {
  const NumberRange range = query_detail::range_with(t.sites(), queries);
  with_dimension(t.affine_dimension(), [&](auto k) {
    const auto make_search = [&] { return NearestSearch<k>(t, range, kNoCell, kKeptInBatch); };
    query_detail::for_queries(queries, order, options, make_search, answer);
  });
}

/// Puts the lists of chunks, which follow `order`, into the order of the queries.
NeighbourLists in_order_of_queries(std::span<const Index> order, const std::vector<std::size_t>& counts,
                                   const std::vector<std::vector<Neighbour>>& found) {
  NeighbourLists lists;
  lists.offsets.resize(counts.size() + 1);
  for (std::size_t i = 0; i < counts.size(); ++i) lists.offsets[i + 1] = lists.offsets[i] + counts[i];
  lists.rows.resize(lists.offsets.back());
  lists.squared_distances.resize(lists.offsets.back());
  for (std::size_t chunk = 0; chunk < found.size(); ++chunk) {
    auto next = found[chunk].begin();
    const std::size_t end = std::min(order.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      for (std::size_t to = lists.offsets[order[i]]; to < lists.offsets[order[i] + std::size_t{1}]; ++to, ++next) {
        lists.rows[to] = next->row;
        lists.squared_distances[to] = next->squared_distance;
      }
    }
  }
  return lists;
}

/// Calls list(search, query, duplicates) for every query.
template <class List>
NeighbourLists lists_along_curve(const AnyTriangulation& t, PointsView queries, const QueryOptions& options,
                                 const List& list) {
  const ExactEnvironment environment;
  query_detail::require_queries(t, queries);
  std::vector<std::size_t> counts(queries.size(), 0);
  if (t.affine_dimension() < 0) return in_order_of_queries({}, counts, {});
  const Duplicates& duplicates = t.mesh().duplicates;
  const Buffer<Index> order = query_detail::order_of_queries(t, queries, options);
  std::vector<std::vector<Neighbour>> found((queries.size() + kChunk - 1) / kChunk);
  search_along_curve(t, queries, order, options, [&](auto& search, Index query, std::size_t chunk) {
    const std::span<const Neighbour> neighbours = list(search, queries[query], duplicates);
    found[chunk].insert(found[chunk].end(), neighbours.begin(), neighbours.end());
    counts[query] = neighbours.size();
  });
  return in_order_of_queries(order, counts, found);
}

std::vector<Neighbour> copied(std::span<const Neighbour> found) { return {found.begin(), found.end()}; }

}  // namespace

Neighbour nearest(const AnyTriangulation& t, std::span<const double> q, CellId near) {
  Neighbour found;
  search_once(t, q, near, [&](auto& search) { found = search.nearest(q); });
  return found;
}

std::vector<Neighbour> nearest(const AnyTriangulation& t, std::span<const double> q, std::size_t k, CellId near) {
  std::vector<Neighbour> found;
  search_once(t, q, near, [&](auto& search) { found = copied(search.nearest(q, k, t.mesh().duplicates)); });
  return found;
}

std::vector<Neighbour> within(const AnyTriangulation& t, std::span<const double> q, double radius, CellId near) {
  require_radius(radius);
  std::vector<Neighbour> found;
  search_once(t, q, near, [&](auto& search) { found = copied(search.within(q, radius, t.mesh().duplicates)); });
  return found;
}

std::vector<Neighbour> nearest(const AnyTriangulation& t, PointsView queries, const QueryOptions& options) {
  const ExactEnvironment environment;
  query_detail::require_queries(t, queries);
  std::vector<Neighbour> found(queries.size());
  if (t.affine_dimension() < 0) return found;
  const Buffer<Index> order = query_detail::order_of_queries(t, queries, options);
  search_along_curve(t, queries, order, options, [&](auto& search, Index query, std::size_t /*chunk*/) {
    found[query] = search.nearest(queries[query]);
  });
  return found;
}

NeighbourLists nearest(const AnyTriangulation& t, PointsView queries, std::size_t k, const QueryOptions& options) {
  return lists_along_curve(t, queries, options, [k](auto& search, auto q, const auto& duplicates) {
    return search.nearest(q, k, duplicates);
  });
}

NeighbourLists within(const AnyTriangulation& t, PointsView queries, double radius, const QueryOptions& options) {
  require_radius(radius);
  return lists_along_curve(t, queries, options, [radius](auto& search, auto q, const auto& duplicates) {
    return search.within(q, radius, duplicates);
  });
}

}  // namespace delone
