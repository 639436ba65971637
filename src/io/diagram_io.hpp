// What the writers of diagrams share.
#pragma once

#include <string>
#include <vector>

#include "delone/io/diagram_file.hpp"

namespace delone::io {

/// A number about every cell.
struct CellNumbers {
  std::string name;
  std::vector<double> numbers;
  bool whole = false;
};

/// What the cells measure, in the order that diagram_file.hpp gives.
std::vector<CellNumbers> measures_of(const DiagramView& diagram);

/// `name`, behind "cell_" as long as a coordinate or an attribute has that name.
std::string free_name(const PointTable& points, std::string name);

/// Where the piece of a cell of the plane ends that begins with this loop: at the cell's next loop that is no hole.
std::size_t piece_end(const CellShapes& shapes, std::size_t cell, std::size_t loop);

/// Appends the corners of a piece as one loop of the same area: each hole is joined to the rest by an edge that crosses
/// nothing and is gone both ways. Cost O(holes * corners), more where the nearest corners are not seen.
void append_bridged(const CellShapes& shapes, std::size_t first_loop, std::size_t last_loop,
                    std::vector<std::size_t>& corners);

// The writers. Each throws InputError before it opens a file.
void write_diagram_csv(const std::string& path, const DiagramView& diagram);
void write_diagram_geojson(const std::string& path, const DiagramView& diagram);
void write_diagram_vtu(const std::string& path, const DiagramView& diagram);
void write_diagram_svg(const std::string& path, const DiagramView& diagram, const PictureOptions& picture);
void write_diagram_png(const std::string& path, const DiagramView& diagram, const PictureOptions& picture);

}  // namespace delone::io
