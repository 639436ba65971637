// Cells as rows of zero-based ids in delimited text, with or without a header.
#include <fmt/format.h>

#include "io/cell_rows.hpp"
#include "io/numbers.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

bool is_header(const Rows& first) {
  for (std::size_t column = 0; column < first.size(); ++column) {
    if (looks_like_number(first[column])) return false;
  }
  return true;
}

}  // namespace

CellTable read_text_cells(const Source& source, std::size_t point_count) {
  Rows rows(source, detect_delimiter(source));
  CellRows cells(point_count);
  if (!rows.next()) return cells.take();
  const std::size_t width = rows.size();
  if (is_header(rows) && !rows.next()) return cells.take();
  do {
    rows.require_size(width);
    for (std::size_t column = 0; column < width; ++column) cells.add(rows, column);
    cells.end(rows, width);
  } while (rows.next());
  return cells.take();
}

}  // namespace delone::io
