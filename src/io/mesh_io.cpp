#include "io/mesh_io.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "delone/base/errors.hpp"
#include "io/facets.hpp"
#include "io/polygon.hpp"

namespace delone::io {

void refuse_mesh(std::string_view format, const std::string& why) {
  throw InputError(fmt::format("{} files {}", format, why));
}

Embedding::Embedding(const MeshView& mesh, std::string_view format)
    : coordinates_(mesh.points.coordinates.data()), dimension_(static_cast<std::size_t>(mesh.points.dimension)) {
  if (dimension_ > 3) {
    refuse_mesh(format, fmt::format("hold at most 3 dimensions, the points have {}: write cells, csv, npy or node",
                                    dimension_));
  }
  if (mesh.elevation.empty()) return;
  const auto& attributes = mesh.points.attributes;
  const auto named = std::ranges::find(attributes, mesh.elevation, &Attribute::name);
  if (named == attributes.end() || named->numbers.size() != mesh.points.size()) {
    throw InputError(fmt::format("elevation '{}': expected the name of an attribute of numbers", mesh.elevation));
  }
  if (dimension_ == 2) elevation_ = &named->numbers;
}

PolytopeTable polygons_of(const MeshView& mesh, std::string_view format) {
  if (mesh.points.dimension != 2 || mesh.affine_dimension != 2) {
    refuse_mesh(format, "hold merged polytopes only of points in the plane: write cells or csv");
  }
  PolytopeTable polygons;
  polygons.offsets.reserve(mesh.merged->offsets.size());
  polygons.vertices.reserve(mesh.merged->vertices.size());
  for (std::size_t cell = 0; cell < mesh.merged->size(); ++cell) {
    append_polygon(mesh.points.coordinates, (*mesh.merged)[cell], polygons.vertices);
    polygons.offsets.push_back(polygons.vertices.size());
  }
  return polygons;
}

PolytopeTable faces_of(const MeshView& mesh, std::string_view format) {
  if (mesh.merged != nullptr) return polygons_of(mesh, format);
  PolytopeTable faces;
  if (mesh.cells.corners == 4) {
    for (const auto& triangle : boundary_triangles(mesh.cells)) {
      faces.vertices.insert(faces.vertices.end(), triangle.begin(), triangle.end());
      faces.offsets.push_back(faces.vertices.size());
    }
    return faces;
  }
  faces.vertices = mesh.cells.vertices;
  for (std::size_t cell = 1; cell <= mesh.cells.size(); ++cell) {
    faces.offsets.push_back(cell * static_cast<std::size_t>(mesh.cells.corners));
  }
  return faces;
}

std::vector<NamedNumbers> point_numbers(const MeshView& mesh) {
  std::vector<NamedNumbers> columns;
  for (const Attribute& attribute : mesh.points.attributes) {
    if (attribute.texts.empty()) columns.push_back({attribute.name, &attribute.numbers});
  }
  if (!mesh.points.weights.empty()) columns.push_back({"weight", &mesh.points.weights});
  return columns;
}

std::vector<unsigned char> status_codes(const MeshView& mesh) {
  std::vector<unsigned char> codes;
  if (mesh.row_status == nullptr) return codes;
  codes.reserve(mesh.row_status->size());
  for (const std::string& status : *mesh.row_status) {
    codes.push_back(status == "duplicate" ? 1 : status == "hidden" ? 2 : 0);
  }
  return codes;
}

}  // namespace delone::io
