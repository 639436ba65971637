// One site into the complex: what inserting and moving share.
#pragma once

#include <functional>
#include <span>

#include "delone/mesh/edit.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

using Listener = std::function<void(const Edit&)>;

/// @throws InputError unless points of this dimension, with or without weights, fit to `t`, are finite, and ids suffice
void require_fit(const AnyTriangulation& t, PointsView points);
/// The same for one point.
void require_fit(const AnyTriangulation& t, std::span<const double> point, const double& weight);

/// Inserts site q, which is in no cell, starting from a live cell. On an exception nothing has changed.
Outcome insert_one(Mesh& mesh, VertexId q, CellId start, const Listener& on_edit);

Outcome outcome_of(Status status);

}  // namespace delone
