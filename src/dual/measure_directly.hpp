// Cells of a diagram within a convex region, measured without being written down.
#pragma once

#include <vector>

#include "delone/dual/clip.hpp"
#include "delone/mesh/triangulation.hpp"
#include "dual/frame.hpp"
#include "dual/measure_table.hpp"

namespace delone::dual_detail {

/// Measures most cells of a triangulation of full dimension, 2 or 3: in the plane those that lie in the region, in
/// space those whose corners are all near it. Returns the sites of the others.
/// @throws Cancelled; std::bad_alloc
std::vector<VertexId> measure_in_plane(const AnyTriangulation& t, const Frame& frame, const ClipOptions& options,
                                       MeasureTable& table);
std::vector<VertexId> measure_in_space(const AnyTriangulation& t, const Frame& frame, const ClipOptions& options,
                                       MeasureTable& table);

inline std::vector<VertexId> measure_directly(const AnyTriangulation& t, const Frame& frame, const ClipOptions& options,
                                              MeasureTable& table) {
  return t.dimension() == 2 ? measure_in_plane(t, frame, options, table) : measure_in_space(t, frame, options, table);
}

}  // namespace delone::dual_detail
