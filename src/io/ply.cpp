// Points and cells of PLY files, and writing them: binary little-endian, every input row a vertex with its attributes,
// weight and status; cells as element "face" (triangles, merged polygons), "edge", or "cell" (tetrahedra, points).
#include "io/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/cell_rows.hpp"
#include "io/mesh_io.hpp"
#include "io/point_matrix.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

bool is_corner_list(const PlyProperty& property) {
  return property.is_list() && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Which element holds the cells: "cell" before "face" before "edge".
int rank_of_cells(const PlyElement& element) {
  constexpr std::array kNames{"edge", "face", "tetrahedra", "cell"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (element.name == kNames[i]) return static_cast<int>(i);
  }
  return -1;
}

std::size_t column_of(const std::string& file, const PlyElement& element, std::string_view name) {
  std::size_t column = 0;
  for (const PlyProperty& property : element.properties) {
    if (property.is_list()) continue;
    if (property.name == name) return column;
    ++column;
  }
  complain(file, fmt::format("expected property {} of element {}, found none", name, element.name));
}

/// A name that stands in a header line and is not yet taken.
std::string property_name(std::string name, std::vector<std::string>& taken) {
  std::ranges::replace_if(
      name, [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
  while (name.empty() || std::ranges::find(taken, name) != taken.end()) name += '_';
  taken.push_back(name);
  return name;
}

std::string header_of(const MeshView& mesh, const std::vector<NamedNumbers>& numbers, bool status,
                      const PolytopeTable& cells, std::string_view element) {
  std::string text = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh.points.size());
  std::vector<std::string> taken;
  for (const char* axis : {"x", "y", "z"}) text += fmt::format("property double {}\n", property_name(axis, taken));
  for (const NamedNumbers& column : numbers)
    text += fmt::format("property double {}\n", property_name(column.name, taken));
  if (status) text += fmt::format("property uchar {}\n", property_name("status", taken));
  text += fmt::format("element {} {}\n", element, cells.size());
  text += element == "edge" ? "property int vertex1\nproperty int vertex2\n" : "property list int int vertex_indices\n";
  return text + "end_header\n";
}

PolytopeTable cells_of(const MeshView& mesh) {
  if (mesh.merged != nullptr) return polygons_of(mesh, "ply");
  PolytopeTable cells;
  cells.vertices = mesh.cells.vertices;
  for (std::size_t cell = 1; cell <= mesh.cells.size(); ++cell) {
    cells.offsets.push_back(cell * static_cast<std::size_t>(mesh.cells.corners));
  }
  return cells;
}

std::string_view element_of(const MeshView& mesh) {
  if (mesh.merged != nullptr || mesh.cells.corners == 3 || mesh.cells.corners == 0) return "face";
  return mesh.cells.corners == 2 ? "edge" : "cell";
}

}  // namespace

PointTable read_ply_points(const Source& source, const ReadOptions& options) {
  const auto elements = parse_ply(source, [](const PlyElement& element) { return element.name == "vertex"; });
  if (elements.size() != 1)
    complain(source.name(), fmt::format("expected one element vertex, found {}", elements.size()));
  const PlyElement& vertex = elements.front();
  std::vector<std::string> names;
  for (const PlyProperty& property : vertex.properties) {
    if (!property.is_list()) names.push_back(property.name);
  }
  const std::size_t width = names.size();
  Columns columns = Columns::with_names(names, width);
  for (const char* axis : {"x", "y", "z"}) {
    const auto at = std::ranges::find(columns.names, axis);
    if (at != columns.names.end()) columns.usual.push_back(static_cast<std::size_t>(at - columns.names.begin()));
  }
  return take_points(source.name(), columns, options, vertex.count, "vertex",
                     [&](std::size_t row, std::size_t column) { return vertex.numbers[row * width + column]; });
}

CellTable read_ply_cells(const Source& source, std::size_t point_count) {
  const auto elements = parse_ply(
      source, [](const PlyElement& element) { return rank_of_cells(element) >= 0; }, is_corner_list);
  if (elements.empty()) complain(source.name(), "expected an element face, cell or edge, found none");
  const PlyElement& element = *std::ranges::max_element(elements, {}, rank_of_cells);
  CellRows cells(point_count);
  std::vector<double> ids = element.list_items;
  std::vector<std::size_t> ends = element.list_ends;
  if (element.name == "edge") {
    const std::size_t first = column_of(source.name(), element, "vertex1");
    const std::size_t second = column_of(source.name(), element, "vertex2");
    const std::size_t width = element.count == 0 ? 0 : element.numbers.size() / element.count;
    for (std::size_t edge = 0; edge < element.count; ++edge) {
      for (const std::size_t column : {first, second}) ids.push_back(element.numbers[edge * width + column]);
      ends.push_back(ids.size());
    }
  }
  if (ends.size() != element.count) {
    complain(source.name(), fmt::format("expected a list vertex_indices in element {}", element.name));
  }
  std::size_t at = 0;
  for (std::size_t cell = 0; cell < ends.size(); ++cell) {
    const std::size_t corners = ends[cell] - at;
    for (std::size_t corner = 0; at < ends[cell]; ++at, ++corner) {
      const bool whole = ids[at] >= 0 && ids[at] < 0x1p63 && ids[at] == std::floor(ids[at]);
      if (!whole || !cells.holds(static_cast<std::uint64_t>(ids[at]))) {
        complain(source.name(), fmt::format("{} {}, corner {}: expected {}, found {}", element.name, cell, corner + 1,
                                            cells.expectation(), ids[at]));
      }
      cells.push(static_cast<std::uint64_t>(ids[at]));
    }
    if (!cells.end(corners)) {
      complain(source.name(),
               fmt::format("{} {}: expected as many corners as before, found {}", element.name, cell, corners));
    }
  }
  return cells.take();
}

void write_ply(const std::string& path, const MeshView& mesh) {
  const Embedding points(mesh, "ply");
  if (mesh.points.size() > std::size_t{std::numeric_limits<std::int32_t>::max()}) {
    refuse_mesh("ply", "hold at most 2147483647 points: write vtu or npy");
  }
  const PolytopeTable cells = cells_of(mesh);
  const std::vector<NamedNumbers> numbers = point_numbers(mesh);
  const std::vector<unsigned char> status = status_codes(mesh);
  const std::string_view element = element_of(mesh);
  Output out(path);
  out << header_of(mesh, numbers, !status.empty(), cells, element);
  for (std::size_t row = 0; row < mesh.points.size(); ++row) {
    for (const double coordinate : points[row]) out.put(coordinate);
    for (const NamedNumbers& column : numbers) out.put((*column.numbers)[row]);
    if (!status.empty()) out.put(status[row]);
  }
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (element != "edge") out.put(static_cast<std::int32_t>(cells[cell].size()));
    for (const Index row : cells[cell]) out.put(static_cast<std::int32_t>(row));
  }
  out.commit();
}

}  // namespace delone::io
