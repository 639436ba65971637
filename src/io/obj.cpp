// Wavefront OBJ. Columns of a vertex line as they stand in the file: v, x, y, z and, where there are more, 5, 6, ...
// Written: points as v with three coordinates; triangles and merged polygons as f, edges as l, single points as p. Of
// tetrahedra OBJ holds only the surface: the boundary triangles, seen counter-clockwise from outside.
#include <fmt/format.h>

#include "io/cell_rows.hpp"
#include "io/complain.hpp"
#include "io/mesh_io.hpp"
#include "io/numbers.hpp"
#include "io/point_rows.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

/// The id in "7", "7/1" or "7//3": from 1, or from the last vertex so far when negative; 0 when it is none.
std::uint64_t vertex_of(std::string_view entry, std::size_t vertices_so_far) {
  entry = entry.substr(0, entry.find('/'));
  const bool backwards = entry.starts_with('-');
  if (backwards) entry.remove_prefix(1);
  std::uint64_t id = 0;
  if (!parse_whole(entry, id)) return 0;
  if (!backwards) return id;
  return id <= vertices_so_far ? vertices_so_far + 1 - id : 0;
}

}  // namespace

PointTable read_obj_points(const Source& source, const ReadOptions& options) {
  Rows rows(source, kBlanks);
  rows.keep_only("v");
  const bool any = rows.next();
  if (any && rows.size() < 4)
    rows.refuse_row(fmt::format("expected v, x, y and z, found {}", counted(rows.size(), "column")));
  Columns columns = Columns::with_names({"v", "x", "y", "z"}, any ? rows.size() : 4);
  columns.usual = {1, 2, 3};
  columns.first_attribute = 1;
  if (!any) return empty_table(columns, choose(source.name(), columns, options));
  return read_point_rows(rows, columns, options);
}

CellTable read_obj_cells(const Source& source, std::size_t point_count) {
  Rows rows(source, kBlanks);
  CellRows cells(point_count, 1);
  std::size_t vertices = 0;
  while (rows.next()) {
    if (rows[0] == "v") ++vertices;
    if (rows[0] != "f" && rows[0] != "l" && rows[0] != "p") continue;
    for (std::size_t column = 1; column < rows.size(); ++column) {
      const std::uint64_t id = vertex_of(rows[column], vertices);
      if (!cells.holds(id)) {
        rows.refuse(column, fmt::format("expected {}, found {}", cells.expectation(), quoted(rows[column])));
      }
      cells.push(id);
    }
    cells.end(rows, rows.size() - 1);
  }
  return cells.take();
}

void write_obj(const std::string& path, const MeshView& mesh) {
  const Embedding points(mesh, "obj");
  const PolytopeTable faces = faces_of(mesh, "obj");
  const char keyword = mesh.cells.corners == 1 ? 'p' : mesh.cells.corners == 2 ? 'l' : 'f';
  Output out(path);
  for (std::size_t row = 0; row < mesh.points.size(); ++row) {
    const auto [x, y, z] = points[row];
    out << "v " << x << ' ' << y << ' ' << z << '\n';
  }
  for (std::size_t face = 0; face < faces.size(); ++face) {
    out << keyword;
    for (const Index row : faces[face]) out << ' ' << std::uint64_t{row} + 1;
    out << '\n';
  }
  out.commit();
}

}  // namespace delone::io
