// Points from CSV, TSV and blank-separated text.
//
// A first row without any number is a header; so is a mixed one when the options name columns and all of them are in
// it. An empty file has no points, of the demanded dimension or 2; a file with only a header has its columns'
// dimension.
#include <algorithm>

#include "delone/base/ids.hpp"
#include "io/columns.hpp"
#include "io/numbers.hpp"
#include "io/point_rows.hpp"
#include "io/readers.hpp"
#include "io/rows.hpp"

namespace delone::io {
namespace {

bool is_header(const Rows& first, const ReadOptions& options) {
  const auto has = [&](const std::string& name) {
    for (std::size_t column = 0; column < first.size(); ++column) {
      if (first.field(column).text() == name) return true;
    }
    return false;
  };
  std::size_t numbers = 0;
  for (std::size_t column = 0; column < first.size(); ++column) numbers += looks_like_number(first[column]) ? 1U : 0U;
  if (numbers == 0) return true;
  if (numbers == first.size()) return false;
  std::vector<std::string> wanted = options.columns;
  wanted.insert(wanted.end(), {options.weights, options.radii});
  std::erase_if(wanted, [](const std::string& column) { return column.empty() || !is_name(column); });
  return !wanted.empty() && std::ranges::all_of(wanted, has);
}

/// A header alone does not tell numbers from texts: the first columns, as many as can be coordinates, are taken.
PointTable table_without_rows(const Source& source, Columns columns, const ReadOptions& options) {
  if (columns.size() == 0) {
    const int chosen = options.columns.empty() ? 2 : static_cast<int>(options.columns.size());
    columns = Columns::numbered(static_cast<std::size_t>(options.dimension != 0 ? options.dimension : chosen));
    return empty_table(columns, choose(source.name(), columns, {}));
  }
  const auto weight = weight_column(source.name(), columns, options);
  const auto most = static_cast<std::size_t>(options.dimension != 0 ? options.dimension : kMaxDimension);
  for (std::size_t column = 0; column < columns.size() && columns.usual.size() < most; ++column) {
    if (column != weight) columns.usual.push_back(column);
  }
  return empty_table(columns, choose(source.name(), columns, options));
}

}  // namespace

PointTable read_text_points(const Source& source, const ReadOptions& options) {
  Rows rows(source, detect_delimiter(source));
  if (!rows.next()) return table_without_rows(source, {}, options);
  Columns columns = Columns::numbered(rows.size());
  if (is_header(rows, options)) {
    columns.named = true;
    for (std::size_t column = 0; column < rows.size(); ++column) columns.names[column] = rows.field(column).text();
    if (!rows.next()) return table_without_rows(source, columns, options);
  }
  return read_point_rows(rows, columns, options);
}

}  // namespace delone::io
