// What the mesh writers share: the view they are given, checked, and the numbers they put into points.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "delone/io/mesh_file.hpp"
#include "io/output.hpp"

namespace delone::io {

/// Points as up to three coordinates: missing ones are 0, the third of 2D points is the elevation where there is one.
class Embedding {
 public:
  /// @throws InputError when the view names an elevation that is no attribute of numbers, or has more than 3 dimensions
  Embedding(const MeshView& mesh, std::string_view format);

  std::array<double, 3> operator[](std::size_t row) const {
    std::array<double, 3> point{};
    for (std::size_t axis = 0; axis < dimension_; ++axis) point[axis] = coordinates_[row * dimension_ + axis];
    if (elevation_ != nullptr) point[2] = (*elevation_)[row];
    return point;
  }
  const std::vector<double>* elevation() const { return elevation_; }

 private:
  const double* coordinates_;
  std::size_t dimension_;
  const std::vector<double>* elevation_ = nullptr;
};

/// Faces that a surface format can hold: the cells of affine dimension up to 2, the boundary triangles of tetrahedra
/// turned outwards, or the polygons of a merged triangulation of the plane, counter-clockwise.
PolytopeTable faces_of(const MeshView& mesh, std::string_view format);

/// Merged polygons with their corners counter-clockwise; corners within an edge are kept, those inside are left out.
/// @throws InputError for merged polytopes that are not polygons in the plane
PolytopeTable polygons_of(const MeshView& mesh, std::string_view format);

/// Numeric attributes and then the weights, each one double per row.
struct NamedNumbers {
  std::string name;
  const std::vector<double>* numbers;
};
std::vector<NamedNumbers> point_numbers(const MeshView& mesh);

/// 0 vertex, 1 duplicate, 2 hidden, per row; empty when the status is not known.
std::vector<unsigned char> status_codes(const MeshView& mesh);

/// @throws InputError "vtu files hold at most 3 dimensions ..."
[[noreturn]] void refuse_mesh(std::string_view format, const std::string& why);

// The writers, one per format family. Each throws InputError before it opens a file.
void write_vtu(const std::string& path, const MeshView& mesh);
void write_ply(const std::string& path, const MeshView& mesh);
void write_obj(const std::string& path, const MeshView& mesh);
void write_off(const std::string& path, const MeshView& mesh);
void write_csv(const std::string& path, const MeshView& mesh);
void write_cells(const std::string& path, const MeshView& mesh);
void write_geojson(const std::string& path, const MeshView& mesh);
void write_svg(const std::string& path, const MeshView& mesh, const PictureOptions& picture);
void write_png(const std::string& path, const MeshView& mesh, const PictureOptions& picture);
std::vector<std::string> write_node_ele(const std::string& stem, const MeshView& mesh);
std::vector<std::string> write_npy(const std::string& stem, const MeshView& mesh);

}  // namespace delone::io
