// Tables of file formats, as the writers have them: rows with a name, a format, and whether it can be compressed.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "delone/base/errors.hpp"
#include "io/source.hpp"

namespace delone::io {

/// The format of this name; the first row of a format has its own name, further ones are aliases.
template <class Table>
auto format_named(const Table& table, std::string_view name) {
  const auto row = std::ranges::find_if(table, [&](const auto& entry) { return entry.name == name; });
  return row == table.end() ? std::nullopt : std::optional(row->format);
}

/// The row of a format.
template <class Table, class Format>
const auto& entry_of(const Table& table, Format format) {
  return *std::ranges::find(table, format, &Table::value_type::format);
}

/// The format of a path by its extension, a further ".gz" looked through where the format can be compressed.
template <class Table>
auto format_of_extension(const Table& table, const std::string& path) {
  const auto format = format_named(table, Source::extension(path));
  return format && path.ends_with(".gz") && !entry_of(table, *format).packs ? std::nullopt : format;
}

/// @throws InputError when the path asks for compression that the format of this row does not have
template <class Entry>
void require_packs(const Entry& entry, const std::string& path) {
  if (path.ends_with(".gz") && !entry.packs)
    throw InputError(fmt::format("{} files are not compressed: leave out .gz", entry.name));
}

}  // namespace delone::io
