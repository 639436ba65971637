// Ids are types, so that a cell cannot be used where a vertex is meant.
// The width is one alias: 32 bits hold about 536 million points in 2D and 158 million in 3D; the preset `wide` has 64.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace delone {

#ifdef DELONE_WIDE_IDS
using Index = std::uint64_t;
#else
using Index = std::uint32_t;
#endif

/// "No such row, cell or vertex" wherever an index may be missing.
inline constexpr Index kNone = std::numeric_limits<Index>::max();

/// Largest dimension that is compiled into the library.
inline constexpr int kMaxDimension = 8;

enum class VertexId : Index {};
enum class CellId : Index {};
enum class FacetId : Index {};

/// The vertex at infinity that closes the hull.
inline constexpr VertexId kGhost{kNone};
inline constexpr CellId kNoCell{kNone};
inline constexpr FacetId kNoFacet{kNone};

constexpr Index raw(VertexId v) { return static_cast<Index>(v); }
constexpr Index raw(CellId c) { return static_cast<Index>(c); }
constexpr Index raw(FacetId f) { return static_cast<Index>(f); }

}  // namespace delone
