// What the cells of all sites measure, written down as they come and given by row in the end.
#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

#include "delone/base/assert.hpp"
#include "delone/base/buffer.hpp"
#include "delone/dual/clip.hpp"
#include "delone/mesh/triangulation.hpp"
#include "dual/clipper.hpp"
#include "dual/frame.hpp"
#include "dual/measure.hpp"

namespace delone::dual_detail {

class MeasureTable {
 public:
  /// A cell, side by side in memory, since rows follow in no order. Its surface is the boundary and what it shares.
  struct Line {
    std::size_t begin = 0;  ///< of its neighbours, with room for as many as it can have
    Index count = 0;
    double volume = 0, boundary = 0, second_moment = 0;
    std::array<double, 3> centroid{};
  };

  /// With empty lines.
  explicit MeasureTable(const AnyTriangulation& t);

  // Lines of different sites are written from several threads at once.
  Line& operator[](VertexId v) { return lines_[raw(v)]; }
  /// Each once, in any order; what has no size is left out in the end.
  void add_neighbour(Line& line, VertexId v, double size) {
    const std::size_t place = line.begin + line.count++;
    DELONE_ASSERT(place < neighbours_.size(), "no more neighbours than edges at the site");
    neighbours_[place] = t_.sites().row(v);
    shared_[place] = size;
  }
  /// Asks memory for where neighbours of v will be written.
  void prefetch(VertexId v) const {
    const Line& line = lines_[raw(v)];
    __builtin_prefetch(neighbours_.data() + line.begin, 1);
    __builtin_prefetch(shared_.data() + line.begin, 1);
  }
  /// Rows that were added.
  std::span<const Index> neighbours(const Line& line) const { return {neighbours_.data() + line.begin, line.count}; }
  /// Moments of the cell of v in a frame, about a corner there.
  template <int D>
  void put(VertexId v, const Moments<D>& moments, const typename Moments<D>::Place& corner, const Frame& frame) {
    typename Moments<D>::Place site;
    for (std::size_t axis = 0; axis < D; ++axis) site[axis] = frame.seen(t_.sites().at(v)[axis], axis);
    const auto centroid = moments.centroid(corner, site);
    Line& line = lines_[raw(v)];
    line.volume = frame.enlarged(moments.volume, D);
    line.second_moment = frame.enlarged(moments.second_about(corner, site), D + 2);
    for (std::size_t axis = 0; axis < D; ++axis) line.centroid[axis] = frame.placed(centroid[axis], axis);
  }
  void put(const ClippedBlock& block, const CellMeasures& measures);

  /// Row by row, neighbours ascending. The table is of no use then.
  CellMeasures rows();

 private:
  struct Entries {
    std::span<Index> neighbours;
    std::span<double> shared;
  };
  template <int K>
  void count_cells(Buffer<Index>& cells) const;
  Entries entries(const Line& line);
  double* shared_with(Index row, Index other);
  void agree();

  const AnyTriangulation& t_;
  Buffer<Line> lines_;             ///< per site
  std::vector<Index> neighbours_;  ///< by row, each with its room
  std::vector<double> shared_;
  std::mutex mutex_;
  std::vector<std::array<Index, 2>> doubtful_;  ///< pairs of rows, the lower one first
};

}  // namespace delone::dual_detail
