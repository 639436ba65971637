#include "mesh/insert_one.hpp"

#include <algorithm>
#include <string>

#include "delone/base/dispatch.hpp"
#include "delone/mesh/inserter.hpp"

namespace delone {

void require_fit(const AnyTriangulation& t, PointsView points) {
  if (points.dimension() != t.dimension()) {
    throw InputError("points of " + std::to_string(points.dimension()) + " coordinates: expected " +
                     std::to_string(t.dimension()) + ", as the triangulation has");
  }
  if (!t.weighted() && std::ranges::any_of(points.weights(), [](double w) { return w != 0.0; })) {
    throw InputError("weights: the triangulation was made without any");
  }
  require_finite(points);
  require_row_count(t.sites().present_count() + points.size(), t.dimension());
  if (t.row_count() + points.size() >= kNone) {
    throw InputError("row " + std::to_string(t.row_count()) + ": ids of this build cannot name more rows");
  }
}

void require_fit(const AnyTriangulation& t, std::span<const double> point, const double& weight) {
  if (point.size() != static_cast<std::size_t>(t.dimension())) {
    throw InputError("a point of " + std::to_string(point.size()) + " coordinates: expected " +
                     std::to_string(t.dimension()));
  }
  require_fit(t, PointsView(point, t.dimension(), {&weight, 1}));
}

Outcome insert_one(Mesh& mesh, VertexId q, CellId start, const Listener& on_edit) {
  return with_dimension(mesh.complex.dimension(), [&](auto k) {
    Inserter<k> inserter(mesh);
    const Outcome outcome = inserter.insert(q, start);
    if (outcome == Outcome::inserted && on_edit) on_edit(inserter.edit());
    return outcome;
  });
}

Outcome outcome_of(Status status) {
  return status == Status::vertex ? Outcome::inserted
                                  : (status == Status::duplicate ? Outcome::duplicate : Outcome::hidden);
}

}  // namespace delone
