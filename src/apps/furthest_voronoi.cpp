// Two cells share a facet when their sites are the ends of an edge of the furthest Delaunay polytopes. An edge of the
// triangulation lies in the interior of some face of these, or of the hull, and that is the common part of all
// polytopes and hull faces that hold both ends: those of one place turn about it, so that nothing but it is left. So an
// edge is one of the polytopes exactly when no third corner lies in everything that holds its ends.
#include "delone/apps/furthest_voronoi.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "delone/apps/hull.hpp"

namespace delone {
namespace {

/// Polytopes by number, and for each row the numbers of those that have it for a corner.
class Faces {
 public:
  Faces(std::size_t row_count, const PolytopeTable& a, const PolytopeTable& b) : holders_(row_count) {
    for (const PolytopeTable* table : {&a, &b}) {
      for (std::size_t i = 0; i < table->size(); ++i) {
        for (const Index row : (*table)[i]) holders_[row].push_back(faces_.size());
        faces_.push_back((*table)[i]);
      }
    }
  }

  /// Whether a and b are alone in all that holds both.
  bool is_edge(Index a, Index b) const {
    std::vector<std::span<const Index>> common;
    if (holders_[a].size() > holders_[b].size()) std::swap(a, b);
    for (const std::size_t face : holders_[a]) {
      if (std::ranges::binary_search(faces_[face], b)) common.push_back(faces_[face]);
    }
    const auto smallest = std::ranges::min_element(common, {}, [](auto face) { return face.size(); });
    return std::ranges::none_of(*smallest, [&](Index c) {
      return c != a && c != b &&
             std::ranges::all_of(common, [&](auto face) { return std::ranges::binary_search(face, c); });
    });
  }

 private:
  std::vector<std::span<const Index>> faces_;
  std::vector<std::vector<std::size_t>> holders_;
};

std::vector<std::array<Index, 2>> edges_of(const CellTable& cells) {
  std::vector<std::array<Index, 2>> edges;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const Index a : cells[c]) {
      for (const Index b : cells[c]) {
        if (a != b) edges.push_back({a, b});  // from both ends
      }
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

FurthestVoronoi furthest_voronoi(PointsView points, const BuildOptions& options) {
  const FurthestDelaunay furthest = furthest_delaunay(points, options);
  FurthestVoronoi diagram;
  if (furthest.affine_dimension < 1) {
    if (furthest.affine_dimension == 0) {
      diagram.rows = {0};
      diagram.offsets.push_back(0);
    }
    return diagram;
  }
  const ConvexHull hull =
      convex_hull(points, {.threads = options.threads, .progress = options.progress, .seed = options.seed});
  const Faces faces(points.size(), furthest.polytopes, hull.faces);
  diagram.rows = hull.corners;
  const std::vector<std::array<Index, 2>> edges = edges_of(furthest.cells);
  auto edge = edges.begin();
  for (const Index row : diagram.rows) {
    for (; edge != edges.end() && (*edge)[0] == row; ++edge) {
      const Index other = (*edge)[1];
      if (faces.is_edge(row, other)) diagram.cuts.push_back({.near = other, .far = row, .across = other});
    }
    diagram.offsets.push_back(diagram.cuts.size());
  }
  return diagram;
}

}  // namespace delone
