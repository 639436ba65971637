// A hierarchy of triangulations: each level triangulates a random sample of the level below, the lowest is the user's.
// Source: [Dev97] 2 (levels, march, updates), 4.3 (the nearest corner for the nearest vertex), 4.5 (jump and walk on
// the highest level), 5.4 (parameters and their defaults). In expectation O(log n) a hint for points in random order.
//
// Departures from [Dev97], all for every dimension:
// * 2.2: phases 1 and 2 turn about the vertex and go straight in the plane only, in other dimensions they are the
//   visibility walk from a cell at the vertex;
// * 2.2: phase 3, where asked for, goes from vertex to nearer neighbour (in a Delaunay triangulation every vertex but
//   the nearest has one), because that needs no angles;
// * levels above the lowest have no weights, because nearness is what leads down; so a vertex of a regular
//   triangulation stands on them like any other, and leaves when it is hidden;
// * the march on the lowest level is left to the caller, who walks there anyway, unless `arrive` is set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

#include "delone/locate/jump_and_walk.hpp"
#include "delone/locate/locator.hpp"

namespace delone {

/// Survives inserts and removes; when the affine dimension changes it is made anew. Not for sharing between threads.
/// Memory: for ratio 30 about a twelfth of what the user's triangulation takes.
class Hierarchy {
 public:
  double ratio = 30.0;  ///< of the sizes of two levels, at least 2; a vertex goes up with probability 1 / ratio
  std::size_t minimal_size = 20;         ///< a level with fewer points is kept, but not used
  std::size_t minimal_sample_size = 20;  ///< the highest level is sampled when it has so many points
  int max_levels = 64;                   ///< above the lowest
  bool jump_and_walk = true;             ///< on the highest level; else the march starts at its newest vertex
  double alpha = 1.0;                    ///< of the sample, see JumpAndWalk
  bool exact_nearest = false;            ///< go down from the nearest vertex, not only from the nearest corner
  bool straight = true;                  ///< in the plane walk as [Dev97] does, not by visibility
  bool arrive = false;                   ///< march on the lowest level, too: the hint contains the query
  std::uint64_t seed = 1;                ///< the same seed and the same edits give the same hints

  CellId hint(const AnyTriangulation& t, std::span<const double> q);
  void update(const AnyTriangulation& t, const Edit& e) noexcept;

  std::size_t level_count() const { return levels_.size(); }  ///< above the lowest
  /// Level 0 is the first above the user's.
  const AnyTriangulation& level(std::size_t i) const { return levels_[i].triangulation; }
  LocateCounts counts() const;
  std::size_t memory_bytes() const;

 private:
  /// Rows of the triangulation are the names of its points; each stands for a vertex on the level below.
  struct Level {
    Level(int dimension, double alpha, std::uint64_t seed);

    AnyTriangulation triangulation;
    JumpAndWalk sample;
    std::vector<Index> below;  ///< per row: the row on the level below, on level 0 the vertex; kNone when it has left
    std::vector<Index> above;  ///< per row: the row on the level above, kNone when there is none
    std::size_t left = 0;      ///< rows that have left
    Index newest = kNone;      ///< after rebuilding any row
    CellId place = kNoCell;    ///< where the last query was found
  };

  VertexId descend(const AnyTriangulation& t, std::span<const double> q);
  Index start_row(Level& level, std::span<const double> q) const;
  VertexId start_vertex(const AnyTriangulation& t, std::span<const double> q);
  CellId march(const AnyTriangulation& t, VertexId from, std::span<const double> q);
  VertexId nearest_corner(const AnyTriangulation& t, CellId c, std::span<const double> q);
  VertexId nearest_vertex(const AnyTriangulation& t, VertexId from, std::span<const double> q);

  void enter(const AnyTriangulation& t, VertexId v);
  bool raise(std::size_t i, std::span<const double> point, Index& below);
  void leave(VertexId v);
  void remove_row(std::size_t i, Index row);
  void renew(std::size_t i);
  void link_below(std::size_t i, Index below, Index row);
  void rebuild(const AnyTriangulation& t);
  int draw_height();
  void forget();

  std::vector<Level> levels_;
  std::unordered_map<Index, Index> lowest_rows_;  // vertex of the user's triangulation -> row on level 0
  JumpAndWalk sample_;                            // of the user's triangulation, while no level is used
  VertexId newest_ = kGhost;
  std::vector<double> last_query_;  // the places of all levels are its, unless it is empty
  std::uint64_t drawn_ = 0;
  LocateCounts counts_;
};

}  // namespace delone
