// What every format family offers to points_file.cpp and cells_file.cpp. All throw InputError naming file and line.
#pragma once

#include <string>
#include <string_view>

#include "delone/dual/region.hpp"
#include "delone/io/points_file.hpp"
#include "delone/mesh/cell_table.hpp"
#include "io/source.hpp"

namespace delone::io {

PointTable read_text_points(const Source& source, const ReadOptions& options);
PointTable read_npy_points(const Source& source, const ReadOptions& options);
PointTable read_node(const Source& source, const ReadOptions& options);
PointTable read_xyz(const Source& source, const ReadOptions& options);
PointTable read_ply_points(const Source& source, const ReadOptions& options);
PointTable read_obj_points(const Source& source, const ReadOptions& options);
PointTable read_off_points(const Source& source, const ReadOptions& options);

CellTable read_text_cells(const Source& source, std::size_t point_count);
CellTable read_npy_cells(const Source& source, std::size_t point_count);
CellTable read_ele(const Source& source, std::size_t point_count);
CellTable read_ply_cells(const Source& source, std::size_t point_count);
CellTable read_obj_cells(const Source& source, std::size_t point_count);
CellTable read_off_cells(const Source& source, std::size_t point_count);
CellTable read_vtu_cells(const Source& source, std::size_t point_count);
CellTable read_geojson_cells(const Source& source, std::size_t point_count);

/// read_points of a file that is in memory: `name` gives the extension.
PointTable read_points_from_memory(const std::string& name, std::string_view bytes, const ReadOptions& options = {});

/// read_cells of a file that is in memory.
CellTable read_cells_from_memory(const std::string& name, std::string_view bytes, std::size_t point_count,
                                 const std::string& format = "");

/// read_region of a file that is in memory.
Region read_region_from_memory(const std::string& name, std::string_view bytes, int dimension);

}  // namespace delone::io
