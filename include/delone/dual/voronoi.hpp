// Voronoi and power diagrams as cell complexes, in every dimension: the duals of Delaunay and regular triangulations.
// Source: [For92] 2 (definitions), 2.1 (duality, theorem 2.1; degenerate cells); [ES96] 2 for weights.
//
// A face of the diagram is where the sites of one Delaunay face are nearest, all equally. Delaunay faces are those of
// polytopes: simplices on one sphere are merged, so the diagram is the same however ties are broken.
// Points that only span a flat have prisms: every face is one within the flat times all directions orthogonal to it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/power_centre.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Lists of numbers: list i is values[offsets[i]] to values[offsets[i + 1]].
struct Lists {
  std::vector<std::size_t> offsets{0};
  std::vector<Index> values;

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const Index> operator[](std::size_t i) const {
    return std::span(values).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
  void push(std::span<const Index> list) {
    values.insert(values.end(), list.begin(), list.end());
    offsets.push_back(values.size());
  }
};

/// Faces of one dimension. What spans face i are vertices and rays: `ends` holds numbers of vertices, and those of rays
/// plus the number of vertices. Faces are sorted by their sites.
struct DiagramFaces {
  int dimension = 0;
  Lists sites;  ///< rows, ascending: the corners of the dual Delaunay face
  /// Of faces of dimension 2 above that of the prisms (polygons) in their order around, from one ray to the other where
  /// there is no end, in the plane counter-clockwise; else ascending.
  Lists ends;

  std::size_t size() const { return sites.size(); }
};

struct DiagramOptions {
  bool merged = true;  ///< false: a vertex for every simplex, cospherical ones several times at one place
};

class Diagram {
 public:
  /// @throws std::bad_alloc
  explicit Diagram(const AnyTriangulation& t, const DiagramOptions& options = {});

  int dimension() const { return dimension_; }
  /// Dimension of the vertices' faces: 0, or that of the prisms' directions where the points lie in a flat.
  int least_dimension() const { return static_cast<int>(directions_.size()); }

  std::size_t vertex_count() const { return vertex_sites_.size(); }
  /// `dimension` coordinates each, correctly rounded; of prisms the point in the flat of the sites.
  const std::vector<double>& vertices() const { return vertices_; }
  /// Rows, ascending: the corners of the Delaunay polytope that is dual to each vertex, in the order of
  /// merged_cells(t).
  const Lists& vertex_sites() const { return vertex_sites_; }
  /// A coordinate per axis, exactly.
  std::vector<Rational> exact_vertex(std::size_t vertex) const;

  std::size_t ray_count() const { return ray_sites_.size(); }
  /// Where each ray begins.
  const std::vector<Index>& ray_origins() const { return ray_origins_; }
  /// `dimension` components each: orthogonal to a facet of the convex hull, outwards; the largest is 1 or -1, the
  /// others are correctly rounded.
  const std::vector<double>& ray_directions() const { return ray_directions_; }
  /// Rows, ascending: the corners of the facet of the Delaunay polytope.
  const Lists& ray_sites() const { return ray_sites_; }

  /// Directions in which all faces extend without end, both ways: none when the points span the space.
  const std::vector<Vector>& prism_directions() const { return directions_; }

  /// All faces of a dimension from least_dimension() to dimension().
  /// Cost: in memory and time of order of the number of simplices times that of their faces.
  DiagramFaces faces(int dimension) const;
  /// What spans the cell of each row; nothing for hidden and removed rows and for duplicates.
  Lists cells() const;

 private:
  std::vector<std::vector<Index>> spans(int simplex_dimension, std::vector<std::vector<Index>>& sites) const;
  void order_polygons(DiagramFaces& faces) const;

  const AnyTriangulation* t_;
  int dimension_;
  std::vector<double> vertices_, ray_directions_;
  Lists vertex_sites_, ray_sites_;
  std::vector<Index> ray_origins_;
  std::vector<Vector> directions_;
  std::vector<CellId> vertex_cells_;  ///< one of each vertex
  std::vector<Index> dual_;           ///< per slot of the triangulation: its vertex, or its ray plus vertex_count()
};

}  // namespace delone
