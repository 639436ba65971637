// Reads the cells of .vtu files as vtu.cpp writes them: raw appended arrays, little-endian, lengths of 64 bits.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "io/bytes.hpp"
#include "io/cell_rows.hpp"
#include "io/complain.hpp"
#include "io/numbers.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

/// The value of `name="..."` within a tag; empty when it is not there.
std::string_view attribute(std::string_view tag, std::string_view name) {
  const std::size_t at = tag.find(fmt::format(" {}=\"", name));
  if (at == std::string_view::npos) return {};
  const std::size_t first = at + name.size() + 3;
  return tag.substr(first, tag.find('"', first) - first);
}

/// The first tag that begins with `start` and holds `mark`.
std::string_view tag_with(std::string_view xml, std::string_view start, std::string_view mark) {
  for (std::size_t at = xml.find(start); at != std::string_view::npos; at = xml.find(start, at + 1)) {
    const std::string_view tag = xml.substr(at, xml.find('>', at) - at);
    if (tag.find(mark) != std::string_view::npos) return tag;
  }
  return {};
}

/// Integers of one appended array.
class Array {
 public:
  Array(const Source& source, std::string_view xml, std::string_view block, std::string_view name) {
    const std::string_view tag = tag_with(xml, "<DataArray", fmt::format(" Name=\"{}\"", name));
    const std::string_view type = attribute(tag, "type");
    constexpr std::array kTypes{"Int32", "UInt32", "Int64", "UInt64"};
    std::uint64_t offset = 0;
    if (std::ranges::find(kTypes, type) == kTypes.end() || !parse_whole(attribute(tag, "offset"), offset)) {
      complain(source.name(), fmt::format("expected {} as an appended array of integers", name));
    }
    item_ = type.ends_with("32") ? 4 : 8;
    if (offset > block.size() || block.size() - offset < 8) complain(source.name(), fmt::format("{} is cut off", name));
    const auto length = load<std::uint64_t>(block.data() + offset, std::endian::little);
    if (length > block.size() - offset - 8) complain(source.name(), fmt::format("{} is cut off", name));
    data_ = block.substr(offset + 8, length);
  }
  std::size_t size() const { return data_.size() / item_; }
  /// A negative number becomes something huge.
  std::uint64_t operator[](std::size_t i) const {
    const char* const at = data_.data() + i * item_;
    if (item_ == 8) return load<std::uint64_t>(at, std::endian::little);
    return static_cast<std::uint64_t>(std::int64_t{load<std::int32_t>(at, std::endian::little)});
  }

 private:
  std::size_t item_ = 4;
  std::string_view data_;
};

}  // namespace

CellTable read_vtu_cells(const Source& source, std::size_t point_count) {
  const std::string_view bytes = source.bytes();
  const std::size_t appended = bytes.find("<AppendedData");
  const std::string_view xml = bytes.substr(0, appended);
  const std::string_view grid = tag_with(xml, "<VTKFile", "UnstructuredGrid");
  if (grid.empty()) complain(source.name(), "expected a VTK XML file of type UnstructuredGrid");
  const bool ours = appended != std::string_view::npos && attribute(grid, "byte_order") == "LittleEndian" &&
                    attribute(grid, "header_type") == "UInt64" && attribute(grid, "compressor").empty() &&
                    tag_with(bytes.substr(appended), "<AppendedData", "encoding=\"raw\"").size() > 0;
  const std::size_t mark = ours ? bytes.find('_', bytes.find('>', appended)) : std::string_view::npos;
  if (mark == std::string_view::npos) {
    complain(source.name(), "expected raw appended data, little-endian, not compressed, with header_type UInt64");
  }
  const std::string_view block = bytes.substr(mark + 1);
  const Array ids(source, xml, block, "connectivity");
  const Array ends(source, xml, block, "offsets");
  CellRows cells(point_count);
  std::size_t at = 0;
  for (std::size_t cell = 0; cell < ends.size(); ++cell) {
    const std::uint64_t end = ends[cell];
    if (end < at || end > ids.size() || !cells.end(static_cast<std::size_t>(end) - at)) {
      complain(source.name(),
               fmt::format("cell {}: expected an offset of as many corners as before, found {}", cell, end));
    }
    for (; at < end; ++at) {
      if (!cells.holds(ids[at])) {
        complain(source.name(), fmt::format("cell {}: expected {}, found {}", cell, cells.expectation(), ids[at]));
      }
      cells.push(ids[at]);
    }
  }
  if (at != ids.size()) complain(source.name(), fmt::format("expected {} ids, found {}", at, ids.size()));
  return cells.take();
}

}  // namespace delone::io
