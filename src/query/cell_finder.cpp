#include "query/cell_finder.hpp"

#include <string>

namespace delone::query_detail {

void require_queries(const AnyTriangulation& t, PointsView queries) {
  if (queries.dimension() != t.dimension()) {
    throw InputError("queries of " + std::to_string(queries.dimension()) + " coordinates: expected " +
                     std::to_string(t.dimension()) + ", as the triangulation has");
  }
  require_finite(PointsView(queries.coordinates(), queries.dimension()));
}

PointsView require_query(const AnyTriangulation& t, std::span<const double> q) {
  if (q.size() != static_cast<std::size_t>(t.dimension())) {
    throw InputError("a point of " + std::to_string(q.size()) + " coordinates: expected " +
                     std::to_string(t.dimension()));
  }
  const PointsView one(q, t.dimension());
  require_finite(one);
  return one;
}

NumberRange range_with(const Sites& sites, PointsView queries) {
  NumberRange range = sites.range();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto q = queries[i];
    if (std::ranges::all_of(q, [](double x) { return std::abs(x) < filter::kLargest; })) range.include(q);
  }
  return range;
}

}  // namespace delone::query_detail
