// The XYZ format of chemistry: a count, a comment line, then rows "element x y z ...". Files that do not begin with a
// line of one count are plain rows of numbers and read as text.
#include <fmt/format.h>

#include "io/complain.hpp"
#include "io/point_rows.hpp"
#include "io/readers.hpp"

namespace delone::io {

PointTable read_xyz(const Source& source, const ReadOptions& options) {
  Rows rows(source, kBlanks);
  if (!rows.next() || rows.size() != 1) return read_text_points(source, options);
  const std::uint64_t count = rows.whole(0, "the count of atoms");
  rows.skip_line();
  const bool any = rows.next();
  if (any && count == 0) rows.refuse_row("expected the end of the file after 0 atoms");
  if (any && rows.size() < 4)
    rows.refuse_row(fmt::format("expected element, x, y and z, found {}", counted(rows.size(), "column")));
  Columns columns = Columns::with_names({"element", "x", "y", "z"}, any ? rows.size() : 4);
  columns.usual = {1, 2, 3};
  PointTable table = any ? read_point_rows(rows, columns, options, count)
                         : empty_table(columns, choose(source.name(), columns, options));
  if (table.size() < count) {
    complain(source.name(),
             fmt::format("expected {}, found {} before the end of the file", counted(count, "atom"), table.size()));
  }
  if (rows.next()) rows.refuse_row(fmt::format("expected the end of the file after {}", counted(count, "atom")));
  return table;
}

}  // namespace delone::io
