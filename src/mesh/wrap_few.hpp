// Gift wrapping of few sites in the plane or in space, where it beats other methods: what a search costs that looks at
// every site is a handful of vector instructions then.
// Source: [For92] 4.6, as in build/gift_wrap.hpp.
#pragma once

#include <optional>

#include "delone/base/progress.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// The triangulation of few points of the plane or of space; nothing where they are too few, too many, on a flat, or in
/// the plane weighted or not all different, where floats go wrong or leave much open, or where the processor cannot.
/// @param hull  of the points
/// @throws Cancelled when `progress` says so
std::optional<Mesh> wrap_few(PointsView points, const AffineHull& hull, const Progress& progress);

// Each fills the complex of a mesh that has sites only; if it returns false, that is to be thrown away.

bool wrap_few_in_plane(Mesh& mesh);
/// The first four sites span space.
bool wrap_few_in_space(Mesh& mesh);

}  // namespace delone
