// What locators share: a triangulation seen for reading only, and a query in the coordinates that it keeps.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"
#include "delone/geometry/sites.hpp"
#include "delone/locate/locator.hpp"
#include "delone/mesh/triangulation.hpp"
#include "delone/mesh/walk.hpp"

namespace delone {

inline bool is_vertex(const AnyTriangulation& t, VertexId v) { return t.complex().incident_cell(v) != kNoCell; }

/// A live cell wherever it is, kNoCell when there is none.
inline CellId any_cell(const AnyTriangulation& t) { return t.complex().incident_cell(kGhost); }

/// A live cell at v; any other when v is not a vertex.
inline CellId cell_at(const AnyTriangulation& t, VertexId v) {
  if (v == kGhost || raw(v) >= t.complex().vertex_slots()) return any_cell(t);
  const CellId c = t.complex().incident_cell(v);
  return c == kNoCell ? any_cell(t) : c;
}

/// @throws InputError
inline void require_query(const AnyTriangulation& t, std::span<const double> q) {
  if (q.size() != static_cast<std::size_t>(t.dimension())) {
    throw InputError("a query of " + std::to_string(q.size()) + " coordinates: expected " +
                     std::to_string(t.dimension()));
  }
  require_finite(PointsView(q, t.dimension()));
}

/// Calls f(v) for every vertex.
template <class F>
void for_each_vertex(const AnyTriangulation& t, F&& f) {
  for (std::size_t i = 0; i < t.complex().vertex_slots(); ++i) {
    const VertexId v{static_cast<Index>(i)};
    if (is_vertex(t, v)) f(v);
  }
}

/// From v to q on all axes of the input, rounded; infinite when it overflows.
inline double squared_distance(const Sites& sites, VertexId v, std::span<const double> q) {
  double sum = 0.0;
  if (sites.flat().dimension == sites.dimension()) {
    const double* x = sites.at(v);
    for (std::size_t j = 0; j < q.size(); ++j) sum += (x[j] - q[j]) * (x[j] - q[j]);
  } else {
    for (std::size_t j = 0; j < q.size(); ++j) {
      const double d = sites.coordinate(v, static_cast<int>(j)) - q[j];
      sum += d * d;
    }
  }
  return sum;
}

using PointCopy = std::array<double, kMaxDimension>;

/// The D coordinates of v in the user's axes; the rest is 0.
inline PointCopy coordinates_of(const Sites& sites, VertexId v) {
  PointCopy x{};
  for (int axis = 0; axis < sites.dimension(); ++axis) x[static_cast<std::size_t>(axis)] = sites.coordinate(v, axis);
  return x;
}

/// The K coordinates of q that a triangulation orients by, and the range of numbers with it.
struct Query {
  Query(const AnyTriangulation& t, std::span<const double> q) : range(t.sites().range()) {
    const Flat& flat = t.sites().flat();
    for (int i = 0; i < flat.dimension; ++i) {
      leading[static_cast<std::size_t>(i)] = q[static_cast<std::size_t>(flat.axes[static_cast<std::size_t>(i)])];
    }
    range.include(q);
  }

  PointCopy leading{};
  NumberRange range;
};

}  // namespace delone
