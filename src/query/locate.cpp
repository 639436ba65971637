#include "delone/query/locate.hpp"

#include <cstddef>

#include "delone/base/arithmetic.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/geometry/affine.hpp"
#include "query/along_curve.hpp"
#include "query/cell_finder.hpp"

namespace delone {
namespace {

using query_detail::CellFinder;
using query_detail::Placed;

void insert_sorted(Location& location, Index row) {
  std::size_t at = location.row_count++;
  for (; at > 0 && location.corners[at - 1] > row; --at) location.corners[at] = location.corners[at - 1];
  location.corners[at] = row;
}

/// One thread each. Every query starts where the one before has ended.
template <int K>
class Locating {
 public:
  Locating(const AnyTriangulation& t, const NumberRange& range, CellId near)
      : t_(&t), finder_(t, range), near_(near), spanning_(flat() ? spanning_points(t) : std::vector<double>()) {}

  Location operator()(std::span<const double> q) {
    if (flat() && off_the_flat(q)) return {};
    const Placed placed = t_->sites().placed(q);
    near_ = finder_.find(placed, near_);
    if (finder_.complex().is_ghost(near_)) return {.cell = near_};
    return finder_.with_kernel(placed, [&](auto& kernel) { return face_of(near_, placed, kernel); });
  }

 private:
  bool flat() const { return t_->affine_dimension() < t_->dimension(); }

  bool off_the_flat(std::span<const double> q) {
    const std::size_t held = spanning_.size();
    spanning_.insert(spanning_.end(), q.begin(), q.end());
    const bool off = affine_dimension(PointsView(spanning_, t_->dimension())) > K;
    spanning_.resize(held);
    return off;
  }

  /// The closed cell c contains q: the corners of the face are those whose barycentric coordinate is not 0.
  Location face_of(CellId c, const Placed& q, Kernel<K>& kernel) const {
    const auto vertices = finder_.complex().vertices(c);
    Location location{.place = Place::face, .cell = c};
    for (int i = 0; i <= K; ++i) {
      if (kernel.orient(vertices, i, q.data()) == 0) continue;
      insert_sorted(location, t_->row(vertices[static_cast<std::size_t>(i)]));
    }
    if (location.row_count == 1) location.place = Place::vertex;
    if (location.row_count == K + 1) location.place = Place::cell;
    return location;
  }

  const AnyTriangulation* t_;
  CellFinder<K> finder_;
  CellId near_;
  std::vector<double> spanning_;
};

/// All sites stand at one place: the one vertex is there, or nothing.
template <>
class Locating<0> {
 public:
  Locating(const AnyTriangulation& t, const NumberRange& /*range*/, CellId /*near*/) : t_(&t) {
    const ConstComplexView<0> complex(t.complex());
    cell_ = complex.cell(complex.twin(complex.incident_cell(kGhost), 0));
    vertex_ = complex.vertex(cell_, 0);
  }

  Location operator()(std::span<const double> q) const {
    for (std::size_t axis = 0; axis < q.size(); ++axis) {
      if (q[axis] != t_->sites().coordinate(vertex_, static_cast<int>(axis))) return {};
    }
    return {.place = Place::vertex, .row_count = 1, .cell = cell_, .corners = {t_->row(vertex_)}};
  }

 private:
  const AnyTriangulation* t_;
  CellId cell_;
  VertexId vertex_;
};

}  // namespace

Location locate(const AnyTriangulation& t, std::span<const double> q, CellId near) {
  const ExactEnvironment environment;
  const PointsView query = query_detail::require_query(t, q);
  if (t.affine_dimension() < 0) return {};
  return with_dimension(t.affine_dimension(),
                        [&](auto k) { return Locating<k>(t, query_detail::range_with(t.sites(), query), near)(q); });
}

std::vector<Location> locate(const AnyTriangulation& t, PointsView queries, const QueryOptions& options) {
  const ExactEnvironment environment;
  query_detail::require_queries(t, queries);
  std::vector<Location> found(queries.size());
  if (t.affine_dimension() < 0) return found;
  const Buffer<Index> order = query_detail::order_of_queries(t, queries, options);
  const NumberRange range = query_detail::range_with(t.sites(), queries);
  with_dimension(t.affine_dimension(), [&](auto k) {
    query_detail::for_queries(
        queries, order, options, [&] { return Locating<k>(t, range, kNoCell); },
        [&](auto& locating, Index query, std::size_t /*chunk*/) { found[query] = locating(queries[query]); });
  });
  return found;
}

}  // namespace delone
