#include "delone/query/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/chunks.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/order/brio.hpp"
#include "query/nearest_search.hpp"

namespace delone {
namespace {

using query_detail::DuplicateRows;
using query_detail::NearestSearch;

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
    NearestSearch<k> search(t, query_detail::range_with(t.sites(), query), near);
    f(search);
  });
}

std::span<const int> axes_of(const AnyTriangulation& t) {
  return std::span(t.sites().flat().axes).first(static_cast<std::size_t>(std::max(t.affine_dimension(), 0)));
}

/// Calls answer(search, row of the query, its chunk) for every query, along a curve.
template <class Answer>
void search_along_curve(const AnyTriangulation& t, PointsView queries, const std::vector<Index>& order,
                        const QueryOptions& options, const Answer& answer) {
  const NumberRange range = query_detail::range_with(t.sites(), queries);
  with_dimension(t.affine_dimension(), [&](auto k) {
    for_chunks(
        order.size(), options.threads,
        [&](std::size_t begin, std::size_t end, std::size_t chunk) {
          constexpr std::size_t kAhead = 16;
          const ExactEnvironment environment;
          NearestSearch<k> search(t, range, kNoCell);
          for (std::size_t i = begin; i < end; ++i) {
            if (i + kAhead < end) __builtin_prefetch(queries[order[i + kAhead]].data());
            answer(search, order[i], chunk);
          }
        },
        options.progress);
  });
}

/// What one chunk of queries has found, in the order of the curve.
struct Found {
  std::vector<Index> rows;
  std::vector<double> squared_distances;
};

/// Puts the lists of chunks, which follow `order`, into the order of the queries.
NeighbourLists in_order_of_queries(const std::vector<Index>& order, const std::vector<std::size_t>& counts,
                                   const std::vector<Found>& found) {
  NeighbourLists lists;
  lists.offsets.resize(counts.size() + 1);
  for (std::size_t i = 0; i < counts.size(); ++i) lists.offsets[i + 1] = lists.offsets[i] + counts[i];
  lists.rows.resize(lists.offsets.back());
  lists.squared_distances.resize(lists.offsets.back());
  for (std::size_t chunk = 0; chunk < found.size(); ++chunk) {
    std::size_t from = 0;
    const std::size_t end = std::min(order.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; from += counts[order[i++]]) {
      const std::size_t to = lists.offsets[order[i]];
      std::copy_n(found[chunk].rows.begin() + static_cast<std::ptrdiff_t>(from), counts[order[i]],
                  lists.rows.begin() + static_cast<std::ptrdiff_t>(to));
      std::copy_n(found[chunk].squared_distances.begin() + static_cast<std::ptrdiff_t>(from), counts[order[i]],
                  lists.squared_distances.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
  return lists;
}

/// Calls list(search, query, duplicates, take) for every query.
template <class List>
NeighbourLists lists_along_curve(const AnyTriangulation& t, PointsView queries, const QueryOptions& options,
                                 const List& list) {
  const ExactEnvironment environment;
  query_detail::require_queries(t, queries);
  std::vector<std::size_t> counts(queries.size(), 0);
  if (t.affine_dimension() < 0) return in_order_of_queries({}, counts, {});
  const DuplicateRows duplicates(t.mesh());
  const std::vector<Index> order = curve_order(queries, axes_of(t), options.threads);
  std::vector<Found> found((queries.size() + kChunk - 1) / kChunk);
  search_along_curve(t, queries, order, options, [&](auto& search, Index query, std::size_t chunk) {
    Found& here = found[chunk];
    const std::size_t before = here.rows.size();
    list(search, queries[query], duplicates, [&here](Index row, double squared_distance) {
      here.rows.push_back(row);
      here.squared_distances.push_back(squared_distance);
    });
    counts[query] = here.rows.size() - before;
  });
  return in_order_of_queries(order, counts, found);
}

}  // namespace

Neighbour nearest(const AnyTriangulation& t, std::span<const double> q, CellId near) {
  Neighbour found;
  search_once(t, q, near, [&](auto& search) { found = search.nearest(q); });
  return found;
}

std::vector<Neighbour> nearest(const AnyTriangulation& t, std::span<const double> q, std::size_t k, CellId near) {
  std::vector<Neighbour> found;
  search_once(t, q, near, [&](auto& search) {
    search.nearest(q, k, DuplicateRows(t.mesh()), [&](Index row, double d) { found.push_back({row, d}); });
  });
  return found;
}

std::vector<Neighbour> within(const AnyTriangulation& t, std::span<const double> q, double radius, CellId near) {
  require_radius(radius);
  std::vector<Neighbour> found;
  search_once(t, q, near, [&](auto& search) {
    search.within(q, radius, DuplicateRows(t.mesh()), [&](Index row, double d) { found.push_back({row, d}); });
  });
  return found;
}

std::vector<Neighbour> nearest(const AnyTriangulation& t, PointsView queries, const QueryOptions& options) {
  const ExactEnvironment environment;
  query_detail::require_queries(t, queries);
  std::vector<Neighbour> found(queries.size());
  if (t.affine_dimension() < 0) return found;
  const std::vector<Index> order = curve_order(queries, axes_of(t), options.threads);
  search_along_curve(t, queries, order, options, [&](auto& search, Index query, std::size_t /*chunk*/) {
    found[query] = search.nearest(queries[query]);
  });
  return found;
}

NeighbourLists nearest(const AnyTriangulation& t, PointsView queries, std::size_t k, const QueryOptions& options) {
  return lists_along_curve(t, queries, options, [k](auto& search, auto q, const auto& duplicates, auto take) {
    search.nearest(q, k, duplicates, take);
  });
}

NeighbourLists within(const AnyTriangulation& t, PointsView queries, double radius, const QueryOptions& options) {
  require_radius(radius);
  return lists_along_curve(t, queries, options, [radius](auto& search, auto q, const auto& duplicates, auto take) {
    search.within(q, radius, duplicates, take);
  });
}

}  // namespace delone
