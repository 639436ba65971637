// Read regions to clip by: rings of corners as text or GeoJSON, half-spaces as text.
#pragma once

#include <string>

#include "delone/dual/region.hpp"

namespace delone::io {

/// Reads the region of `path`, also where it is compressed by gzip; "-" is standard input.
///
/// Text is delimited as that of points (points_file.hpp). A header a,b,d or a,b,c,d, or nx,ny,offset or
/// nx,ny,nz,offset, makes every row a half-space: a x + b y (+ c z) <= d; what all have in common is the region, of the
/// plane or of space. Any other text holds rings of the plane, with or without a header: the coordinates are the last
/// two columns. Where there are more, the first one is the ring's name, and rows that follow one another under one name
/// are one ring; two columns are one ring. What an odd number of rings goes around is the region. GeoJSON is known by
/// its brace: the rings of all its polygons, also in features and collections; what is no polygon is passed over.
/// A corner that repeats the one before, or the first one at the end, is dropped.
/// @param dimension  that of the points to be clipped, 2 or 3
/// @throws InputError with one line naming the file, and the row or the ring and its corner, counted from 0
Region read_region(const std::string& path, int dimension);

}  // namespace delone::io
