// Gift wrapping of few sites in space, where it beats insertion: what a search costs that looks at every site is a
// handful of vector instructions then.
// Source: [For92] 4.6, as in build/gift_wrap.hpp.
#pragma once

#include <optional>

#include "delone/base/progress.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// The triangulation of few points; nothing where they are too few, too many or do not span space, where it would take
/// many exact tests, or where the processor cannot.
/// @param hull  of the points
/// @throws Cancelled when `progress` says so
std::optional<Mesh> wrap_few(PointsView points, const AffineHull& hull, const Progress& progress);

}  // namespace delone
