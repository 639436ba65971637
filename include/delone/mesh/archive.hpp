// Keep a whole triangulation in a file, and get it back without building anew.
//
// Format, version 2: 64-bit little-endian words.
//   "DELONE\0\2"       the last byte is the version
//   width              bytes of an id: 4 where that suffices, else 8
//   D, weighted, k     dimension of the points, 0 or 1, affine dimension (-1 without points)
//   k axes             on which the points stay independent
//   r, n, d, m         rows, removed ones included; sites, duplicates, cells
//   n x D coordinates  of the sites, in the order of their insertion; then n weights if weighted
//   r sites            the site of each row; the largest id for removed rows
//   d x 2 sites        a duplicate and the site whose place it shares
//   m x 2 (k + 1) ids  each cell's vertices, then its twins; the ghost is the largest id
//   checksum           of all words before, by h = mix(h xor w) from h = 0 on (mix: see canonical_hash)
// Ids are packed low end first; each array of ids is filled with zeros up to a whole word.
#pragma once

#include <iosfwd>

#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Writes `t`. Sites and cells are renumbered without gaps. @throws std::runtime_error when the stream fails
void save(const AnyTriangulation& t, std::ostream& out);

/// Reads what save() wrote, and not a byte more: the same vertices, cells, statuses and canonical hash, whatever the
/// machine that wrote it. Bytes are not trusted: that the cells are the canonical triangulation of their vertices is
/// decided exactly (I1 to I7), so whatever comes back is safe to use. Cost: O(cells), some tenth of building.
/// @throws InputError when the bytes are cut off, damaged, of another version, or no triangulation; std::bad_alloc
AnyTriangulation load(std::istream& in);

}  // namespace delone
