// Add points to a triangulation that exists: one, or a batch that is ordered first.
#pragma once

#include <functional>
#include <span>

#include "delone/base/ids.hpp"
#include "delone/build/build.hpp"
#include "delone/geometry/points.hpp"
#include "delone/mesh/edit.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

struct Inserted {
  Index row;  ///< the new point's row: the number of rows before
  Outcome outcome;
};

struct InsertOptions {
  CellId near = kNoCell;                               ///< a live cell from which to walk; a near one is fast
  std::function<void(const Edit&)> on_edit = nullptr;  ///< hears of the change after it is made; must not throw
};

/// Inserts one point. A point that leaves the flat of all points before changes every cell: the triangulation is then
/// built anew, which is as fast as anything.
/// @param weight  must be 0 in a triangulation without weights
/// @throws InputError for a wrong number of coordinates, NaN, infinity; std::bad_alloc. Then `t` is as it was.
/// Cost: the walk and the star of the point.
Inserted insert(AnyTriangulation& t, std::span<const double> point, double weight = 0.0,
                const InsertOptions& options = {});

/// Inserts all rows of `batch`, which become rows row_count() and on. Statuses are told by t.status(row).
/// @throws InputError when dimension or weights do not fit, for NaN and infinity; Cancelled; std::bad_alloc. Then `t`
/// is as it was: the work is done on a copy. Cost: O(cells) for the copy, then as for building. Of the options method,
/// order and seed are not looked at.
void insert(AnyTriangulation& t, PointsView batch, const BuildOptions& options = {});

}  // namespace delone
