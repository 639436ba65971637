// Regions of the plane as loops of corners, and what a line leaves of them. The region lies to the left of every edge:
// outer loops run counter-clockwise, holes clockwise.
//
// Cutting decides once for each corner on which side of the line it lies; all else follows from these decisions. The
// chains of corners that stay enter and leave through the line; along it, with the kept side to the left, the region
// begins where a chain leaves and ends where one enters. So the first of those that leave is joined to the first of
// those that enter, and so on: there are as many of one kind as of the other, whatever was rounded, and every loop is
// closed. A region may fall into pieces that way, or a hole become part of its edge.
// Source: [WA77], for a clip region that is one line.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone::dual_detail {

/// The points x with normal . x <= offset.
struct HalfPlane {
  std::array<double, 2> normal;
  double offset;
};

struct Corner {
  std::array<double, 2> at;
  Index across;  ///< names what lies beyond the edge from here to the next corner

  bool operator==(const Corner&) const = default;
};

struct Loops {
  std::vector<Corner> corners;
  std::vector<std::size_t> ends;  ///< loop l ends before corner ends[l], where the next one begins

  bool empty() const { return ends.empty(); }
  void clear() {
    corners.clear();
    ends.clear();
  }
};

/// Cuts regions; keeps its memory from one cut to the next.
class LoopCutter {
 public:
  /// What the half-plane leaves of the region; edges on its line get this name. Corners on the line stay.
  void cut(Loops& region, const HalfPlane& by, Index across);

 private:
  /// A place where the boundary crosses the line.
  struct Crossing {
    double along;
    std::size_t chain;
  };
  struct Chain {
    std::size_t begin, end;  ///< of chain_corners_
    std::size_t next;        ///< the chain that follows along the line
  };

  bool classify(const Loops& region, const HalfPlane& by);
  void add_chains(const Loops& region, std::size_t begin, std::size_t end, Index across);
  void join(const HalfPlane& by);

  std::vector<double> side_;
  std::vector<Corner> chain_corners_;
  std::vector<Chain> chains_;
  std::vector<Crossing> leaving_, entering_;
  Loops result_;
};

/// Twice the area of a loop, from its first corner, so that small loops far away keep their digits.
double doubled_area(const Corner* begin, const Corner* end);

}  // namespace delone::dual_detail
