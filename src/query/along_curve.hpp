// Many queries: in the order of a curve through space, in chunks of fixed size that threads share out. Every chunk
// begins anew, so that nothing depends on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "base/chunks.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/mesh/triangulation.hpp"
#include "delone/order/brio.hpp"
#include "delone/query/options.hpp"

namespace delone::query_detail {

inline Buffer<Index> order_of_queries(const AnyTriangulation& t, PointsView queries, const QueryOptions& options) {
  const auto k = static_cast<std::size_t>(std::max(t.affine_dimension(), 0));
  return curve_order(queries, std::span(t.sites().flat().axes).first(k), options.threads);
}

/// Calls answer(search, query, chunk) for all queries in order, with a search of its own for every chunk.
template <class MakeSearch, class Answer>
void for_queries(PointsView queries, std::span<const Index> order, const QueryOptions& options,
                 const MakeSearch& make_search, const Answer& answer) {
  const auto work = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    constexpr std::size_t kAhead = 16;
    const ExactEnvironment environment;  // modes belong to threads
    auto search = make_search();
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kAhead < end) __builtin_prefetch(queries[order[i + kAhead]].data());
      answer(search, order[i], chunk);
    }
  };
  for_chunks(order.size(), options.threads, work, options.progress);
}

}  // namespace delone::query_detail
