// Geomview's OFF: a keyword [ST][C][N][4][n]OFF, which may be missing, the counts of vertices, faces and edges, one
// line per vertex and one per face. Columns of a vertex line: x, y, z, and those of normals and colours by number.
// Written: three coordinates; triangles, edges, points and merged polygons as faces. Of tetrahedra OFF holds only the
// surface: the boundary triangles, seen counter-clockwise from outside.
#include <fmt/format.h>

#include "delone/base/ids.hpp"
#include "io/cell_rows.hpp"
#include "io/complain.hpp"
#include "io/mesh_io.hpp"
#include "io/numbers.hpp"
#include "io/point_rows.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

struct Header {
  std::size_t dimension = 3;
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

/// What stands before "OFF": "C", "ST", "4n", ...
std::string_view prefix_of(const Rows& rows) {
  const std::string_view keyword = rows[0];
  if (!keyword.ends_with("OFF"))
    rows.refuse(0, "expected OFF or counts of vertices and faces, found " + quoted(keyword));
  const std::string_view prefix = keyword.substr(0, keyword.size() - 3);
  std::string_view rest = prefix;
  for (const std::string_view part : {"ST", "C", "N", "4", "n"}) {
    if (rest.starts_with(part)) rest.remove_prefix(part.size());
  }
  if (!rest.empty()) rows.refuse(0, "expected OFF or counts of vertices and faces, found " + quoted(keyword));
  return prefix;
}

/// Numbers that may stand behind the keyword or on lines of their own.
class Counts {
 public:
  explicit Counts(Rows& rows, std::size_t column) : rows_(rows), column_(column) {}

  std::size_t next(const char* what) {
    if (column_ == rows_.size()) {
      if (!rows_.next()) complain(rows_.source().name(), fmt::format("expected {}, found the end of the file", what));
      column_ = 0;
    }
    return static_cast<std::size_t>(rows_.whole(column_++, what));
  }
  /// The count of edges, which nobody uses, may be left out.
  void end() {
    if (column_ < rows_.size()) next("the count of edges");
    if (column_ < rows_.size()) rows_.refuse(column_, "expected the end of the line after the counts");
  }

 private:
  Rows& rows_;
  std::size_t column_;
};

Header read_header(Rows& rows) {
  if (!rows.next()) complain(rows.source().name(), "expected OFF, found an empty file");
  Header header;
  const bool has_keyword = !looks_like_number(rows[0]);
  const std::string_view prefix = has_keyword ? prefix_of(rows) : std::string_view();
  if (has_keyword && rows.size() > 1 && rows[1] == "BINARY") rows.refuse(1, "expected OFF in text, found BINARY");
  Counts counts(rows, has_keyword ? 1 : 0);
  if (prefix.ends_with('n')) header.dimension = counts.next("the dimension");
  if (prefix.find('4') != std::string_view::npos) ++header.dimension;
  if (header.dimension < 1 || header.dimension > kMaxDimension) {
    rows.refuse_row(fmt::format("expected 1 to {} dimensions, found {}", kMaxDimension, header.dimension));
  }
  header.vertices = counts.next("the count of vertices");
  header.faces = counts.next("the count of faces");
  counts.end();
  return header;
}

[[noreturn]] void refuse_end(const Rows& rows, std::size_t expected, std::size_t found, std::string_view noun) {
  complain(rows.source().name(),
           fmt::format("expected {}, found {} before the end of the file", counted(expected, noun), found));
}

/// A line "k i1 ... ik", perhaps followed by a colour. @return k
std::size_t read_face(Rows& rows, const Header& header, std::size_t face) {
  if (!rows.next()) refuse_end(rows, header.faces, face, "face");
  const std::uint64_t corners = rows.whole(0, "a count of corners");
  if (corners >= rows.size()) {
    rows.refuse_row(fmt::format("expected {}, found {}", counted(corners, "corner"), rows.size() - 1));
  }
  return static_cast<std::size_t>(corners);
}

}  // namespace

PointTable read_off_points(const Source& source, const ReadOptions& options) {
  Rows rows(source, kBlanks);
  const Header header = read_header(rows);
  const bool any = header.vertices > 0 && rows.next();
  if (any && rows.size() < header.dimension) {
    rows.refuse_row(fmt::format("expected {}, found {}", counted(header.dimension, "coordinate"), rows.size()));
  }
  const std::size_t width = any ? rows.size() : header.dimension;
  Columns columns = header.dimension == 3 ? Columns::with_names({"x", "y", "z"}, width) : Columns::numbered(width);
  for (std::size_t axis = 0; axis < header.dimension; ++axis) columns.usual.push_back(axis);
  PointTable table = any ? read_point_rows(rows, columns, options, header.vertices)
                         : empty_table(columns, choose(source.name(), columns, options));
  if (table.size() < header.vertices) refuse_end(rows, header.vertices, table.size(), "vertex line");
  for (std::size_t face = 0; face < header.faces; ++face) read_face(rows, header, face);
  if (rows.next()) rows.refuse_row(fmt::format("expected the end of the file after {}", counted(header.faces, "face")));
  return table;
}

CellTable read_off_cells(const Source& source, std::size_t point_count) {
  Rows rows(source, kBlanks);
  const Header header = read_header(rows);
  for (std::size_t vertex = 0; vertex < header.vertices; ++vertex) {
    if (!rows.next()) refuse_end(rows, header.vertices, vertex, "vertex line");
  }
  CellRows cells(point_count);
  for (std::size_t face = 0; face < header.faces; ++face) {
    const std::size_t corners = read_face(rows, header, face);
    for (std::size_t column = 1; column <= corners; ++column) cells.add(rows, column);
    cells.end(rows, corners);
  }
  return cells.take();
}

void write_off(const std::string& path, const MeshView& mesh) {
  const Embedding points(mesh, "off");
  const PolytopeTable faces = faces_of(mesh, "off");
  Output out(path);
  out << "OFF\n" << mesh.points.size() << ' ' << faces.size() << " 0\n";
  for (std::size_t row = 0; row < mesh.points.size(); ++row) {
    const auto [x, y, z] = points[row];
    out << x << ' ' << y << ' ' << z << '\n';
  }
  for (std::size_t face = 0; face < faces.size(); ++face) {
    out << faces[face].size();
    for (const Index row : faces[face]) out << ' ' << row;
    out << '\n';
  }
  out.commit();
}

}  // namespace delone::io
