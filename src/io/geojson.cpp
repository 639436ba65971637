// GeoJSON (RFC 7946): one feature per cell, counter-clockwise, with the rows of its corners as property "rows".
// Only for points of the plane; the elevation, where there is one, is the third coordinate.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/cell_rows.hpp"
#include "io/complain.hpp"
#include "io/mesh_io.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

void write_position(Output& out, const Embedding& points, Index row) {
  const auto [x, y, z] = points[row];
  out << '[' << x << ',' << y;
  if (points.elevation() != nullptr) out << ',' << z;
  out << ']';
}

/// A ring is closed: its first position comes again at the end.
void write_geometry(Output& out, const Embedding& points, std::span<const Index> face) {
  if (face.size() == 1) {
    out << "{\"type\":\"Point\",\"coordinates\":";
    write_position(out, points, face[0]);
    out << '}';
    return;
  }
  const bool ring = face.size() > 2;
  out << (ring ? "{\"type\":\"Polygon\",\"coordinates\":[[" : "{\"type\":\"LineString\",\"coordinates\":[");
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (i != 0) out << ',';
    write_position(out, points, face[i]);
  }
  if (ring) {
    out << ',';
    write_position(out, points, face[0]);
  }
  out << (ring ? "]]}" : "]}");
}

}  // namespace

void write_geojson(const std::string& path, const MeshView& mesh) {
  if (mesh.points.dimension != 2) {
    refuse_mesh("geojson", fmt::format("hold points of the plane, these have {}",
                                       counted(static_cast<std::size_t>(mesh.points.dimension), "dimension")));
  }
  const Embedding points(mesh, "geojson");
  const PolytopeTable faces = faces_of(mesh, "geojson");
  Output out(path);
  out << "{\"type\":\"FeatureCollection\",\"features\":[";
  for (std::size_t face = 0; face < faces.size(); ++face) {
    out << (face == 0 ? "\n" : ",\n") << "{\"type\":\"Feature\",\"properties\":{\"rows\":[";
    for (std::size_t i = 0; i < faces[face].size(); ++i) {
      if (i != 0) out << ',';
      out << faces[face][i];
    }
    out << "]},\"geometry\":";
    write_geometry(out, points, faces[face]);
    out << '}';
  }
  out << "\n]}\n";
  out.commit();
}

CellTable read_geojson_cells(const Source& source, std::size_t point_count) {
  const auto document = nlohmann::json::parse(source.bytes(), nullptr, false);
  if (document.is_discarded()) complain(source.name(), "expected JSON, found something else or a file that is cut off");
  if (!document.is_object() || !document.contains("features") || !document["features"].is_array()) {
    complain(source.name(), "expected a FeatureCollection");
  }
  CellRows cells(point_count);
  std::size_t cell = 0;
  for (const auto& feature : document["features"]) {
    const auto rows = feature.is_object() && feature.contains("properties") && feature["properties"].is_object()
                          ? feature["properties"].value("rows", nlohmann::json())
                          : nlohmann::json();
    if (!rows.is_array()) complain(source.name(), fmt::format("feature {}: expected the property \"rows\"", cell));
    for (const auto& row : rows) {
      if (!row.is_number_unsigned() || !cells.holds(row.get<std::uint64_t>())) {
        complain(source.name(), fmt::format("feature {}: expected {}, found {}", cell, cells.expectation(),
                                            row.is_number() ? row.dump() : std::string(row.type_name())));
      }
      cells.push(row.get<std::uint64_t>());
    }
    if (!cells.end(rows.size())) {
      complain(source.name(), fmt::format("feature {}: expected as many rows as before, found {}", cell, rows.size()));
    }
    ++cell;
  }
  return cells.take();
}

}  // namespace delone::io
