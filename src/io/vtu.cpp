// Meshes as VTK files. Every input row is a point, so ids are row numbers; attributes, weights and the status of each
// row are point data.
#include "io/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <ranges>

#include "io/mesh_io.hpp"

namespace delone::io {
namespace {

constexpr std::array<unsigned char, 5> kCellTypes{0, 1, 3, 5, 10};  // by corners: vertex, line, triangle, tetrahedron
constexpr unsigned char kPolygon = 7;

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

struct Grid {
  const MeshView& mesh;
  Embedding points;
  PolytopeTable polygons;  // when merged
  std::vector<NamedNumbers> numbers;
  std::vector<unsigned char> status;

  bool merged() const { return mesh.merged != nullptr; }
  std::size_t cell_count() const { return merged() ? polygons.size() : mesh.cells.size(); }
  std::span<const Index> corners() const {
    return merged() ? std::span(polygons.vertices) : std::span(mesh.cells.vertices);
  }
  bool wide() const {
    return std::max(mesh.points.size(), corners().size()) > std::size_t{std::numeric_limits<std::int32_t>::max()};
  }
};

std::string announce(const Grid& grid) {
  const std::size_t n = grid.mesh.points.size();
  const std::string_view integer = grid.wide() ? "Int64" : "Int32";
  const std::size_t size = grid.wide() ? 8 : 4;
  VtuHead xml(n, grid.cell_count());
  xml.begin("Points");
  xml.array("Float64", "Points", n * 3 * sizeof(double), " NumberOfComponents=\"3\"");
  xml.end("Points");
  xml.begin("Cells");
  xml.array(integer, "connectivity", grid.corners().size() * size);
  xml.array(integer, "offsets", grid.cell_count() * size);
  xml.array("UInt8", "types", grid.cell_count());
  xml.end("Cells");
  xml.begin("PointData");
  for (const NamedNumbers& column : grid.numbers) xml.array("Float64", column.name, n * sizeof(double));
  if (!grid.status.empty()) xml.array("UInt8", "status", n);
  xml.end("PointData");
  return xml.finish();
}

template <class Integer>
void put_cells(Output& out, const Grid& grid) {
  put_array<Integer>(out, grid.corners());
  const auto corners = static_cast<std::size_t>(grid.mesh.cells.corners);
  if (grid.merged()) {
    put_array<Integer>(out, std::span(grid.polygons.offsets).subspan(1));
  } else {
    put_array<Integer>(out, std::views::iota(std::size_t{1}, grid.cell_count() + 1) |
                                std::views::transform([=](std::size_t cell) { return cell * corners; }));
  }
  const unsigned char type = grid.merged() ? kPolygon : kCellTypes[corners];
  put_array<unsigned char>(out, std::vector(grid.cell_count(), type));
}

}  // namespace

VtuHead::VtuHead(std::size_t points, std::size_t cells)
    : text_(fmt::format("<?xml version=\"1.0\"?>\n"
                        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                        "header_type=\"UInt64\">\n"
                        "  <UnstructuredGrid>\n"
                        "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                        points, cells)) {}

void VtuHead::begin(std::string_view section) { text_ += fmt::format("      <{}>\n", section); }

void VtuHead::array(std::string_view type, std::string_view name, std::size_t bytes, std::string_view more) {
  text_ += fmt::format("        <DataArray type=\"{}\" Name=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n", type,
                       escaped(name), more, offset_);
  offset_ += sizeof(std::uint64_t) + bytes;
}

void VtuHead::end(std::string_view section) { text_ += fmt::format("      </{}>\n", section); }

std::string VtuHead::finish() {
  return std::move(text_) + "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
}

void write_vtu(const std::string& path, const MeshView& mesh) {
  const Grid grid{mesh, Embedding(mesh, "vtu"), mesh.merged != nullptr ? polygons_of(mesh, "vtu") : PolytopeTable(),
                  point_numbers(mesh), status_codes(mesh)};
  Output out(path);
  out << announce(grid);
  const std::size_t n = mesh.points.size();
  out.put<std::uint64_t>(n * 3 * sizeof(double));
  for (std::size_t row = 0; row < n; ++row) {
    for (const double coordinate : grid.points[row]) out.put(coordinate);
  }
  if (grid.wide()) {
    put_cells<std::int64_t>(out, grid);
  } else {
    put_cells<std::int32_t>(out, grid);
  }
  for (const NamedNumbers& column : grid.numbers) put_array<double>(out, *column.numbers);
  if (!grid.status.empty()) put_array<unsigned char>(out, grid.status);
  out << kVtuTail;
  out.commit();
}

}  // namespace delone::io
