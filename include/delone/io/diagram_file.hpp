// Write the cells of diagrams, clipped to a region, as files and pictures. Every file is written beside its target and
// renamed when complete, and is byte-identical for equal input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delone/dual/clip.hpp"
#include "delone/io/mesh_file.hpp"
#include "delone/io/points_file.hpp"
#include "delone/mesh/cell_table.hpp"

namespace delone::io {

enum class DiagramFormat { vtu, geojson, svg, png, csv };

/// What a writer is given: all of it borrowed.
struct DiagramView {
  const PointTable& points;
  const CellShapes& shapes;                              ///< rows of `points`, none twice, in any order
  const CellMeasures& measures;                          ///< of the same cells
  const std::vector<std::string>* row_status = nullptr;  ///< "vertex", "duplicate", "hidden" per row, when known
  const std::vector<float>* tone = nullptr;  ///< per cell, 0 to 1: what pictures colour it by, not by its size
  const PolytopeTable* subsets =
      nullptr;  ///< cells that belong to several rows each: these, and rows of shapes count cells
};

std::optional<DiagramFormat> diagram_format(const std::string& name);          ///< "vtu", "geojson", ...
std::optional<DiagramFormat> diagram_format_of_path(const std::string& path);  ///< by extension, also before ".gz"

/// Can the format hold cells of space? vtu and csv can.
bool holds_space(DiagramFormat format);

/// Writes the cells to `path`; "-" is standard output. csv, geojson and svg are compressed where the path ends in
/// ".gz".
///
/// Every cell goes with its row and that row's weight and attributes, or with the rows of its subset, and with what it
/// measures: area, perimeter, boundary, neighbours (how many), cx, cy, second_moment; in space volume, surface and cz.
/// Where an attribute has such a name, the measure's name is cell_NAME.
/// csv: a line per row, 0 for a row without a cell; or a line per subset.
/// geojson: a feature per cell, without geometry where it is empty; pieces counter-clockwise, holes clockwise.
/// vtu: polygons, one for each piece of a cell, holes joined to its boundary by an edge that is gone both ways; in
/// space polyhedra whose faces meet in common points. Empty cells are left out, and so are attributes that are texts.
/// svg, png: cells coloured by their size, small ones dark, or by their tone; sites where they are few, those that are
/// hidden in red.
/// @throws InputError when the format cannot hold this dimension; std::runtime_error when writing fails
void write_diagram(const std::string& path, DiagramFormat format, const DiagramView& diagram,
                   const PictureOptions& picture = {});

}  // namespace delone::io
