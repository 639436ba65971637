// Keep a whole triangulation in a file, and get it back without building anew.
// Format: 8 bytes "DELONE\0\1" (the last is the version), then 64-bit little-endian words: the width of ids in bytes,
// the dimension, 1 if weighted, the affine dimension, its axes, the number of sites; then the arrays; then a 64-bit
// checksum of everything before it (each 64-bit word w, the last padded with zeros, by h = mix(h xor w), see
// canonical_hash).
#pragma once

#include <iosfwd>

#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Writes `t`. @throws std::runtime_error when the stream fails
void save(const AnyTriangulation& t, std::ostream& out);

/// Reads what save() wrote: the same vertices, cells, statuses and canonical hash, whatever the machine.
/// @throws InputError when the bytes are cut off, damaged, of another version, or no triangulation (I1 to I4 are
/// checked)
AnyTriangulation load(std::istream& in);

}  // namespace delone
