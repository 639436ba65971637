// Cells of Voronoi and power diagrams within a region: their shapes and their measures.
//
// Row i of every result belongs to input row i. Hidden sites and duplicates have empty cells, and so has a site whose
// cell lies outside the region.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/base/progress.hpp"
#include "delone/dual/region.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Cells as polygons (in the plane) or polyhedra (in space). In the plane a cell is any number of loops: pieces
/// counter-clockwise, holes clockwise, each hole right after the piece it lies in. In space a cell is convex and its
/// loops are its faces, counter-clockwise from outside.
struct CellShapes {
  int dimension = 2;
  std::vector<double> corners;        ///< `dimension` coordinates each
  std::vector<std::size_t> loops{0};  ///< loop l has corners loops[l] to loops[l + 1]
  std::vector<std::size_t> cells{0};  ///< cell i has loops cells[i] to cells[i + 1]
  std::vector<Index> rows;            ///< cell i is that of row rows[i]
  /// The row of the cell beyond, kNone where the region ends: in the plane one per corner, of the edge from it to the
  /// next one; in space one per loop.
  std::vector<Index> across;

  std::size_t size() const { return rows.size(); }
  bool empty(std::size_t cell) const { return cells[cell] == cells[cell + 1]; }
};

/// What cells measure, one entry per cell (`neighbours` and `shared` by offsets).
struct CellMeasures {
  int dimension = 2;
  std::vector<double> volume;           ///< area or volume
  std::vector<double> surface;          ///< perimeter or surface, with what lies on the region's boundary
  std::vector<double> boundary;         ///< the part of it that lies on the region's boundary
  std::vector<double> centroid;         ///< `dimension` coordinates each, those of the site where the cell is empty
  std::vector<double> second_moment;    ///< the integral of |x - site|^2
  std::vector<std::size_t> offsets{0};  ///< cell i has neighbours offsets[i] to offsets[i + 1]
  std::vector<Index> neighbours;        ///< rows with whose cells it shares more than a point (in space: an edge)
  std::vector<double> shared;           ///< length or area of what it shares with each

  std::size_t size() const { return volume.size(); }
};

struct ClipOptions {
  int threads = 1;
  Progress progress = {};  ///< told of progress, may cancel
};

/// The cell of every row.
/// @throws InputError unless t and the region have the same dimension, 2 or 3; Cancelled; std::bad_alloc
CellShapes clipped_cells(const AnyTriangulation& t, const Region& region, const ClipOptions& options = {});

/// What they measure. Cells sum to the region, to some 1e-14 of it; where all sites are 1e9 times as far away as it is
/// large, to 1e-11. Of two cells both know what they share, or none. Beside the result it holds 64 bytes a site, and in
/// space a copy of the triangulation's cells with their centres, and sums: about 0.6 kB a site.
/// @throws InputError unless t and the region have the same dimension, 2 or 3; Cancelled; std::bad_alloc
CellMeasures measure_cells(const AnyTriangulation& t, const Region& region, const ClipOptions& options = {});

/// Shapes and measures a block of some thousand cells at a time, in an order in which neighbours are near each other:
/// in the plane no more than the triangulation and a block per thread is held; in space two ids and a pointer a site
/// and 4 bytes a cell and thread more. Removed rows are left out. What measure_cells() settles between cells that were
/// cut by themselves is left open: a border about as long as rounding may be known to one side only. One call at a
/// time.
/// @param visit  shapes and measures of the same cells
using VisitCells = std::function<void(const CellShapes& shapes, const CellMeasures& measures)>;
void for_cells(const AnyTriangulation& t, const Region& region, const VisitCells& visit,
               const ClipOptions& options = {});

/// A half-space between two sites: what is nearer, by power, to `near` than to `far`. `across` names the cell beyond.
struct Bisector {
  Index near, far, across;
};

/// Cells that are given by bisectors: cell i is what cuts[offsets[i]] to cuts[offsets[i + 1]] leave of the region. So
/// are drawn furthest-site and order-k diagrams. `rows` of the shapes count cells.
CellShapes cut_cells(PointsView points, const Region& region, const std::vector<std::size_t>& offsets,
                     const std::vector<Bisector>& cuts, const ClipOptions& options = {});

/// What given shapes measure. @param sites  one per cell: what second moments are taken about
CellMeasures measure_shapes(const CellShapes& shapes, PointsView sites);

}  // namespace delone
