// A triangulation is points + a complex + a kernel; this is what users hold.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/geometry/points.hpp"
#include "delone/geometry/sites.hpp"
#include "delone/mesh/duplicates.hpp"
#include "delone/mesh/hidden.hpp"
#include "delone/mesh/scratch.hpp"
#include "delone/topology/complex.hpp"

namespace delone {

/// What became of an input row.
enum class Status : std::uint8_t {
  vertex,     ///< it is a vertex of the triangulation
  duplicate,  ///< a vertex stands at the same place with the same weight
  hidden,     ///< redundant by its weight: its lifted point lies above the lower hull
  removed,    ///< it was removed; no later point takes its row
};

struct RowStatus {
  Status status;
  Index of;  ///< for a duplicate the row of the vertex it repeats, else the row itself
  bool operator==(const RowStatus&) const = default;
};

/// What the work so far has cost.
struct BuildStatistics {
  double order_seconds = 0.0;   ///< checking the input and sorting it along the curve
  double insert_seconds = 0.0;  ///< inserting
  double finish_seconds = 0.0;  ///< giving back memory, settling statuses
  PredicateStats predicates;
  std::uint64_t walk_steps = 0;
  std::uint64_t walk_fallbacks = 0;  ///< walks that hit their bound and were answered by looking at every cell
  std::uint64_t cells_created = 0;
  std::uint64_t put_off = 0;        ///< times that a thread left a site to others
  std::uint64_t in_turn = 0;        ///< of insertion in rounds: sites tried one after the other, by the busiest thread
  std::uint64_t flips = 0;          ///< of methods that flip
  std::uint64_t history_steps = 0;  ///< cells of a history, or of a conflict graph, that were asked about a point

  BuildStatistics& operator+=(const BuildStatistics& other);
};

/// The parts of a triangulation, for the algorithms that grow and change it.
struct Mesh {
  explicit Mesh(Sites points) : sites(std::move(points)), complex(sites.flat().dimension) {}

  Sites sites;
  Complex complex;
  /// Sites that were found at the place of a vertex with the same weight. The vertex may have been hidden since; then
  /// so are they.
  Duplicates duplicates;
  HiddenSites hidden;
  std::size_t vertex_count = 0;
  BuildStatistics statistics;
  Scratch scratch;

  /// Row r becomes names[r], ascending numbers below `count`.
  void rename_rows(std::span<const Index> names, std::size_t count) {
    sites.rename_rows(names, count);
    duplicates.rename_rows(names);
  }
};

/// The Delaunay or regular triangulation of a set of points whose dimension is known at run time.
///
/// Cells are simplices of the affine dimension k of the points: k + 1 vertices each, positively oriented on the first k
/// coordinate axes that are independent. Outside, points are named by their input row, a number from 0 on.
/// Const calls may run from many threads at once.
class AnyTriangulation {
 public:
  /// No points yet.  @throws InputError unless 1 <= dimension <= 8
  explicit AnyTriangulation(int dimension, bool weighted = false);
  explicit AnyTriangulation(Mesh mesh) : mesh_(std::move(mesh)) {}

  int dimension() const { return mesh_.sites.dimension(); }
  int affine_dimension() const { return mesh_.sites.flat().dimension; }  ///< -1 without points
  bool weighted() const { return mesh_.sites.weighted(); }

  /// Rows so far; those of removed points count, and keep their numbers.
  std::size_t row_count() const { return mesh_.sites.row_count(); }
  std::size_t removed_count() const { return row_count() - mesh_.sites.present_count(); }
  std::size_t vertex_count() const { return mesh_.vertex_count; }
  std::size_t duplicate_count() const;
  std::size_t hidden_count() const { return mesh_.sites.present_count() - vertex_count() - duplicate_count(); }
  std::size_t cell_count() const { return mesh_.complex.live_count() - mesh_.complex.ghost_count(); }
  std::size_t hull_facet_count() const { return affine_dimension() > 0 ? mesh_.complex.ghost_count() : 0; }
  std::size_t memory_bytes() const;

  RowStatus status(Index row) const;
  /// Coordinates and weight of a row, as given. @throws InputError when there is no such row, or it was removed
  std::vector<double> point(Index row) const;
  double weight(Index row) const;
  /// All rows that are not removed, ascending.
  std::vector<Index> present_rows() const;
  /// All rows again, as given: row_count() x dimension() coordinates, NaN for removed rows.
  std::vector<double> coordinates() const;
  std::vector<double> weights() const;  ///< of all rows, empty when there are none, NaN for removed rows
  /// The input row of a vertex, kNone for the ghost.
  Index row(VertexId v) const { return v == kGhost ? kNone : mesh_.sites.row(v); }
  /// The site of a row that is not removed.
  VertexId vertex(Index row) const { return mesh_.sites.vertex(row); }
  /// The live cells at a vertex, ghosts included. Cost O(their number).
  std::vector<CellId> star(VertexId v) const;

  const BuildStatistics& statistics() const { return mesh_.statistics; }
  const Complex& complex() const { return mesh_.complex; }
  const Sites& sites() const { return mesh_.sites; }
  const Mesh& mesh() const { return mesh_; }
  Mesh& mesh() { return mesh_; }

 private:
  Mesh mesh_;
};

/// Coordinates of the vertices of one finite cell: they span the flat of all points. Nothing without points.
std::vector<double> spanning_points(const AnyTriangulation& t);

/// @throws InputError unless there is such a row and it is not removed
void require_present(const AnyTriangulation& t, Index row);

/// The same with the dimension in the type.
template <int D>
class Triangulation : public AnyTriangulation {
 public:
  Triangulation() : AnyTriangulation(D) {}
  explicit Triangulation(AnyTriangulation any) : AnyTriangulation(std::move(any)) {
    if (dimension() != D) throw InputError("the triangulation has another dimension than its type");
  }

  std::array<double, D> point(Index row) const {
    std::array<double, D> x;
    for (int axis = 0; axis < D; ++axis) x[static_cast<std::size_t>(axis)] = sites().coordinate(vertex(row), axis);
    return x;
  }
};

}  // namespace delone
