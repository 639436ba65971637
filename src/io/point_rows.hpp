// Points from rows of text, once the columns are known: shared by delimited text, .node, XYZ, OBJ and OFF.
#pragma once

#include <cstddef>
#include <optional>

#include "io/columns.hpp"
#include "io/rows.hpp"

namespace delone::io {

/// Reads the row at hand and those after it, at most `row_count` of them.
///
/// A column is numeric when its first entry is a number, and then must be so throughout if it is taken. Where
/// coordinates are told by being numeric, a column whose first entry is text while at least half are numbers is refused
/// rather than passed over as text. An attribute that is not numeric throughout is kept as text.
/// @throws InputError naming line and column
PointTable read_point_rows(Rows& rows, Columns& columns, const ReadOptions& options,
                           std::optional<std::size_t> row_count = std::nullopt);

}  // namespace delone::io
