// Written: the pair STEM_points.npy, n x d doubles, and STEM_cells.npy, m x corners unsigned ids.
#include "io/npy.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "delone/base/ids.hpp"
#include "io/bytes.hpp"
#include "io/cell_rows.hpp"
#include "io/mesh_io.hpp"
#include "io/numbers.hpp"
#include "io/point_matrix.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

/// The text of the header, a Python dictionary, and the data after it.
struct Parts {
  std::string_view header;
  std::string_view data;
};

Parts split(const Source& source) {
  const std::string_view bytes = source.bytes();
  if (!bytes.starts_with(kMagic)) complain(source.name(), "expected a NumPy array, which begins with \\x93NUMPY");
  if (bytes.size() < 12) complain(source.name(), "the header is cut off");
  const int version = bytes[6];
  if (version < 1 || version > 3)
    complain(source.name(), fmt::format("expected NPY version 1 to 3, found {}", version));
  const std::size_t start = version == 1 ? 10 : 12;
  const std::size_t length = version == 1 ? load<std::uint16_t>(bytes.data() + 8, std::endian::little)
                                          : load<std::uint32_t>(bytes.data() + 8, std::endian::little);
  if (bytes.size() - start < length) complain(source.name(), "the header is cut off");
  return {bytes.substr(start, length), bytes.substr(start + length)};
}

/// What follows `'key':` in the dictionary.
std::string_view entry(const Source& source, std::string_view header, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::string quoted_key = fmt::format("{}{}{}", quote, key, quote);
    std::size_t at = header.find(quoted_key);
    if (at == std::string_view::npos) continue;
    at = header.find_first_not_of(" ", at + quoted_key.size());
    if (at == std::string_view::npos || header[at] != ':') continue;
    at = std::min(header.find_first_not_of(" ", at + 1), header.size());
    return header.substr(at);
  }
  complain(source.name(), fmt::format("expected '{}' in the NPY header", key));
}

void parse_type(const Source& source, std::string_view text, NpyArray& array) {
  const std::size_t end = text.empty() ? text.npos : text.find(text.front(), 1);
  const std::string_view type = end == text.npos ? text.substr(0, 20) : text.substr(1, end - 1);
  const bool quoted_type = !text.empty() && (text.front() == '\'' || text.front() == '"');
  std::uint64_t item = 0;
  const bool plain = quoted_type && type.size() >= 3 && std::string_view("<>|=").find(type[0]) != type.npos &&
                     parse_whole(type.substr(2), item);
  const bool is_float = plain && type[1] == 'f' && (item == 4 || item == 8);
  const bool is_integer =
      plain && (type[1] == 'i' || type[1] == 'u') && (item == 1 || item == 2 || item == 4 || item == 8);
  if (!is_float && !is_integer) {
    complain(source.name(), "expected an array of 4- or 8-byte floats or of integers, found type " + quoted(type));
  }
  array.kind = type[1];
  array.item = item;
  array.big_endian = type[0] == '>' || (type[0] == '=' && std::endian::native == std::endian::big);
}

void parse_shape(const Source& source, std::string_view text, NpyArray& array) {
  const std::string_view shape = text.substr(0, std::min(text.find(')'), text.size() - 1) + 1);
  std::vector<std::size_t> lengths;
  std::string_view rest = shape;
  if (rest.starts_with('(')) rest.remove_prefix(1);
  for (;;) {
    const std::size_t first = std::min(rest.find_first_of("0123456789"), rest.size());
    const std::size_t last = std::min(rest.find_first_not_of("0123456789", first), rest.size());
    std::uint64_t length = 0;
    if (!parse_whole(rest.substr(first, last - first), length)) break;
    lengths.push_back(length);
    rest.remove_prefix(last);
  }
  if (lengths.empty() || lengths.size() > 2) {
    complain(source.name(), "expected an array of shape (n, d) or (n,), found " + quoted(shape));
  }
  array.rows = lengths[0];
  array.columns = lengths.size() == 2 ? lengths[1] : 1;
  if (array.columns < 1 || array.columns > 10'000) {
    complain(source.name(), fmt::format("expected an array of 1 to 10000 columns, found {}", array.columns));
  }
}

double as_double(const NpyArray& array, const char* bytes) {
  const std::endian order = array.big_endian ? std::endian::big : std::endian::little;
  if (array.kind == 'f') return array.item == 8 ? load<double>(bytes, order) : double{load<float>(bytes, order)};
  if (array.kind == 'i') {
    if (array.item == 1) return load<std::int8_t>(bytes, order);
    if (array.item == 2) return load<std::int16_t>(bytes, order);
    if (array.item == 4) return load<std::int32_t>(bytes, order);
    return static_cast<double>(load<std::int64_t>(bytes, order));
  }
  if (array.item == 1) return load<std::uint8_t>(bytes, order);
  if (array.item == 2) return load<std::uint16_t>(bytes, order);
  if (array.item == 4) return load<std::uint32_t>(bytes, order);
  return static_cast<double>(load<std::uint64_t>(bytes, order));
}

/// The bits of an integer, a negative one wrapped round to something huge.
std::uint64_t as_whole(const NpyArray& array, const char* bytes) {
  const std::endian order = array.big_endian ? std::endian::big : std::endian::little;
  if (array.item == 8) return load<std::uint64_t>(bytes, order);
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(as_double(array, bytes)));  // at most 32 bits: exact
}

/// Doubles hold every integer of 32 bits, but not every one of 64.
void require_exact(const Source& source, const NpyArray& array) {
  if (array.kind == 'f' || array.item < 8) return;
  for (std::size_t row = 0; row < array.rows; ++row) {
    for (std::size_t column = 0; column < array.columns; ++column) {
      const std::uint64_t bits = as_whole(array, array.at(row, column));
      const bool negative = array.kind == 'i' && (bits >> 63) != 0;
      const std::uint64_t magnitude = negative ? 0 - bits : bits;
      if (magnitude == 0 || (magnitude >> std::countr_zero(magnitude)) < (std::uint64_t{1} << 53)) continue;
      complain(source.name(),
               fmt::format("row {}, column {}: expected an integer that a double holds exactly, found '{}{}'", row,
                           column + 1, negative ? "-" : "", magnitude));
    }
  }
}

}  // namespace

NpyArray parse_npy(const Source& source) {
  const Parts parts = split(source);
  NpyArray array;
  parse_type(source, entry(source, parts.header, "descr"), array);
  const std::string_view fortran = entry(source, parts.header, "fortran_order");
  array.by_columns = fortran.starts_with("True");
  if (!array.by_columns && !fortran.starts_with("False")) {
    complain(source.name(), "expected 'fortran_order' True or False, found " + quoted(fortran.substr(0, 20)));
  }
  parse_shape(source, entry(source, parts.header, "shape"), array);
  const std::size_t row_bytes = array.columns * array.item;
  const std::size_t most = std::numeric_limits<std::size_t>::max() / row_bytes;
  const std::size_t expected = row_bytes * std::min(array.rows, most);
  if (parts.data.size() != expected) {
    complain(source.name(), fmt::format("expected {} bytes of data for {} x {} entries, found {}", expected, array.rows,
                                        array.columns, parts.data.size()));
  }
  array.data = parts.data;
  return array;
}

std::string npy_header(std::string_view type, std::size_t rows, std::size_t columns) {
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}), }}", type, rows, columns);
  constexpr std::size_t kPrefix = 10;  // magic, version, length
  header.append(63 - (kPrefix + header.size()) % 64, ' ');
  header += '\n';
  std::string result(kMagic);
  result += {'\x01', '\x00', static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)};
  return result + header;
}

PointTable read_npy_points(const Source& source, const ReadOptions& options) {
  const NpyArray array = parse_npy(source);
  require_exact(source, array);
  return take_points(source.name(), Columns::numbered(array.columns), options, array.rows, "row",
                     [&](std::size_t row, std::size_t column) { return as_double(array, array.at(row, column)); });
}

CellTable read_npy_cells(const Source& source, std::size_t point_count) {
  const NpyArray array = parse_npy(source);
  if (array.kind == 'f') complain(source.name(), "expected an array of integers, found floats");
  CellRows cells(point_count);
  cells.set_corners(array.columns);
  for (std::size_t row = 0; row < array.rows; ++row) {
    for (std::size_t column = 0; column < array.columns; ++column) {
      const std::uint64_t id = as_whole(array, array.at(row, column));
      if (!cells.holds(id)) {
        const std::string found =
            array.kind == 'i' ? fmt::format("{}", static_cast<std::int64_t>(id)) : fmt::format("{}", id);
        complain(source.name(),
                 fmt::format("row {}, column {}: expected {}, found {}", row, column + 1, cells.expectation(), found));
      }
      cells.push(id);
    }
  }
  return cells.take();
}

std::vector<std::string> write_npy(const std::string& stem, const MeshView& mesh) {
  if (mesh.merged != nullptr) refuse_mesh("npy", "cannot hold merged polytopes: write cells or csv");
  std::vector<Output> outputs;
  outputs.emplace_back(stem + "_points.npy");
  outputs.emplace_back(stem + "_cells.npy");
  outputs[0] << npy_header("<f8", mesh.points.size(), static_cast<std::size_t>(mesh.points.dimension));
  outputs[0].put_all<double>(mesh.points.coordinates);
  outputs[1] << npy_header(sizeof(Index) == 4 ? "<u4" : "<u8", mesh.cells.size(),
                           static_cast<std::size_t>(std::max(mesh.cells.corners, 1)));
  outputs[1].put_all<Index>(mesh.cells.vertices);
  commit_all(outputs);
  return {outputs[0].path(), outputs[1].path()};
}

}  // namespace delone::io
