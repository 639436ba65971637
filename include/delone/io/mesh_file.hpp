// Write triangulations as mesh files and pictures. Every file is written beside its target and renamed when complete,
// and is byte-identical for equal input.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "delone/io/points_file.hpp"
#include "delone/mesh/cell_table.hpp"

namespace delone::io {

enum class MeshFormat { vtu, ply, obj, off, node_ele, npy, csv, cells, geojson, svg, png };

/// What a writer is given: all of it borrowed.
struct MeshView {
  const PointTable& points;
  const CellTable& cells;                                ///< rows of `points`
  std::size_t affine_dimension = 0;                      ///< corners - 1 of the cells
  const std::vector<std::string>* row_status = nullptr;  ///< "vertex", "duplicate", "hidden" per row, when known
  const PolytopeTable* merged = nullptr;                 ///< write these instead of the simplices, where the format can
  std::string elevation;                     ///< attribute that lifts 2D points into the third coordinate of 3D formats
  const std::vector<float>* tone = nullptr;  ///< per cell, 0 to 1: what pictures colour it by, in place of its size
};

struct PictureOptions {
  int width = 1600;  ///< pixels (PNG) or user units (SVG); the height follows from the points
};

std::optional<MeshFormat> mesh_format(const std::string& name);          ///< "vtu", "ply", ...
std::optional<MeshFormat> mesh_format_of_path(const std::string& path);  ///< by extension

/// Writes `mesh` to `path`; "-" is standard output. Every input row is written as a point, so ids are row numbers.
///
/// vtu and ply hold every cell, numeric attributes, weights and row status. obj and off hold triangles, edges and
/// points; of tetrahedra only the surface, its triangles counter-clockwise from outside. geojson, svg and png show the
/// plane. Only cells, csv, npy and node hold more than 3 dimensions. Merged polytopes are polygons, counter-clockwise,
/// or in cells and csv rows of any length. csv, cells, ply, obj, off, geojson and svg are compressed where the path
/// ends in
/// ".gz". node_ele and npy take the path without its extension: STEM.node, STEM.ele, STEM.neigh; STEM_points.npy,
/// STEM_cells.npy.
/// @return the files written (node_ele writes three: .node, .ele, .neigh; npy two)
/// @throws InputError when the format cannot hold this dimension; std::runtime_error when writing fails
std::vector<std::string> write_mesh(const std::string& path, MeshFormat format, const MeshView& mesh,
                                    const PictureOptions& picture = {});

}  // namespace delone::io
