// Move a point, which keeps its row.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "delone/build/insert.hpp"
#include "delone/remove/remove.hpp"

namespace delone {

/// How a move was made.
enum class Motion : std::uint8_t {
  in_place,    ///< every cell kept its vertices
  reinserted,  ///< the point left and came back
  rebuilt,     ///< the flat that holds all points changed, and every cell with it
};

struct Moved {
  Outcome outcome;  ///< what the point is now
  Motion motion;
};

/// Moves a row to `point`, and with `weight` gives it another weight. The result is the canonical triangulation of the
/// points as they are now, as from building. A vertex inside the hull whose cells all stay right keeps them.
/// Listeners hear of a move in place as of one edit, in which the vertex went and came and its star was made anew.
/// @throws InputError when there is no such row or the point does not fit; std::bad_alloc. Then `t` is as it was.
/// Cost in place: a few tests per cell at the vertex; else that of a removal and an insertion.
Moved move(AnyTriangulation& t, Index row, std::span<const double> point, std::optional<double> weight = std::nullopt,
           const InsertOptions& options = {});

}  // namespace delone
