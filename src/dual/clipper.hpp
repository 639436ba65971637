// Shapes of cells within a region, a block of sites at a time.
//
// Where the points span the space and the region is convex, a cell is made of the centres that the triangulation tells,
// closed far outside where it has no end, and cut by the sides of the region. Otherwise the region is cut by the
// bisectors of the site with those around, so that flat sets of sites need nothing of their own; a region of many
// corners is first divided among groups of cells.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "delone/dual/clip.hpp"
#include "dual/centres.hpp"
#include "dual/frame.hpp"
#include "dual/loops.hpp"
#include "dual/polytope.hpp"
#include "dual/stars.hpp"

namespace delone::dual_detail {

/// What is nearer to one site than to another, by power, seen from an eye: where it is one of the sites nothing
/// cancels, so that the bisectors of sites that are close together keep their digits.
Plane bisector(std::span<const double> near, double near_weight, std::span<const double> far, double far_weight,
               const Frame& frame, std::span<const double> eye, Index across);

/// From one site to another, in space.
inline Point3 direction(const Sites& sites, const Frame& frame, VertexId from, VertexId to) {
  const double* const a = sites.at(from);
  const double* const b = sites.at(to);
  return {frame.scaled(b[0] - a[0]), frame.scaled(b[1] - a[1]), frame.scaled(b[2] - a[2])};
}

/// Cells of some sites, seen in a frame.
struct ClippedBlock {
  CellShapes shapes;
  std::vector<VertexId> sites;  ///< of the cells
  /// Rows whose cells may have a border in common, of which the first was read by itself: the other may tell otherwise
  /// about a border that is hardly longer than rounding errors.
  std::vector<std::array<Index, 2>> doubtful;
};

/// Appends cells to shapes, whose corners are seen in the frame too.
class CellWriter {
 public:
  explicit CellWriter(const Frame& frame) : frame_(frame) {}

  void begin(CellShapes& shapes) {
    shapes_ = &shapes;
    shapes.dimension = frame_.dimension;
  }
  void end_cell(Index row) {
    shapes_->rows.push_back(row);
    shapes_->cells.push_back(shapes_->loops.size() - 1);
  }
  /// In the plane: a loop, or all loops of what was cut, each hole after its piece.
  void add(std::span<const Corner> loop);
  void add(const Loops& loops);
  /// In space: a face that lies in the region.
  void add_face(const Polygon3& face, Index across);
  void add_face(const Star& star, std::size_t begin, std::size_t end, Index across);
  /// What planes leave of it.
  void add_cut_face(const Polygon3& face, Index across, std::span<const Plane> cuts);

  /// Cells cut out of the region, seen from an eye: the site, or where that is far away the middle of the region, so
  /// that all sites see the same. Returns the eye's coordinates.
  std::span<const double> look_from(std::span<const double> site);
  Loops seen_from_eye(Loops loops) const;
  void add_seen_from_eye(Loops loops);
  /// In space: what planes leave of the region.
  void add_cut_region(std::span<const Plane> cuts);

 private:
  void add_without_short_edges(std::span<const Corner> loop);

  const Frame& frame_;
  CellShapes* shapes_ = nullptr;
  FaceCutter cutter_;
  std::vector<Corner> kept_;
  Point3 eye_{};
  Polytope polytope_;
};

template <int D>
class Clipper {
 public:
  Clipper(const AnyTriangulation& t, const Frame& frame)
      : t_(t),
        frame_(frame),
        full_(t.affine_dimension() == D),
        centres_(t, frame),
        stars_(t, centres_),
        writer_(frame) {}

  /// The cells of some sites, fast where sites that follow each other are near each other.
  void read(std::span<const VertexId> sites, ClippedBlock& block);

 private:
  static constexpr auto kAxes = static_cast<std::size_t>(D);

  /// A cell of the plane before it is cut.
  struct PlanarCell {
    VertexId site;
    std::size_t begin, end;  ///< its corners
    bool exists;
    bool placed;  ///< the corners have their places; else they only name the neighbours
    bool within;  ///< a convex region
    std::array<double, 2> low, high;
  };

  bool is_vertex(VertexId v) const { return t_.complex().incident_cell(v) != kNoCell; }
  std::array<double, kAxes> place(VertexId v) const;
  Plane bisector_of(VertexId v, VertexId u, std::span<const double> eye) const;
  void end_cell(VertexId v);
  Point3 ray(CellId ghost) const;
  /// The run of ghosts in a ring as corners far outside: from the finite cell before to the one after them.
  void add_far_corners(const Point3& before, CellId first, CellId last, const Point3& after, const Point3& axis);
  void read_facet(VertexId v, VertexId neighbour, std::size_t begin, std::size_t end);

  void planar_block(std::span<const VertexId> sites);
  bool read_far_corners(std::size_t i);
  PlanarCell read_planar(VertexId v);
  void write_planar(const PlanarCell& cell);
  void divide(std::span<const PlanarCell> cells, Loops region);
  Loops around(std::span<const PlanarCell> cells, Loops region);
  void cut_region(const PlanarCell& cell, const Loops& region);

  void write_spatial(VertexId v);
  void read_planes(VertexId v, std::span<const double> eye);
  template <class F>
  void for_facets(VertexId v, const F& f);
  bool lies_on_side(VertexId v);
  void write_placed(VertexId v);

  const AnyTriangulation& t_;
  const Frame& frame_;
  bool full_;
  Centres<D> centres_;
  Stars stars_;
  CellWriter writer_;
  ClippedBlock* block_ = nullptr;
  Star star_;
  LoopCutter cutter_;
  std::vector<PlanarCell> cells_;
  std::vector<Corner> corners_;
  std::vector<Plane> planes_, sides_;
  Polygon3 polygon_;
  std::vector<bool> crossed_;  ///< sides of the region that the cell reaches over
};

}  // namespace delone::dual_detail
