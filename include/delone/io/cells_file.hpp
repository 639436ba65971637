// Read lists of cells: our own files and those of other programs.
#pragma once

#include <string>

#include "delone/mesh/cell_table.hpp"

namespace delone::io {

/// Reads cells as rows of zero-based point rows from .cells or .csv text, .ele, .npy, .vtu, .ply, .off, .obj (and .gz).
/// @param point_count  ids must lie below it
/// @param format       "" to go by the extension
/// @throws InputError with one line naming file, row and what was expected
CellTable read_cells(const std::string& path, std::size_t point_count, const std::string& format = "");

}  // namespace delone::io
