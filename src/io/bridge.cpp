// Polygons with holes as one loop. Holes are joined from right to left, each at its rightmost corner: what lies further
// right is joined already, so an edge from there to a corner that is not left of it can meet nothing else. One such
// corner is seen: of the edge that a ray to the right meets first the right end, or else a corner in the triangle of
// both. Left and right are lexicographic, so that no two corners are level. What is seen is decided exactly.
#include <algorithm>
#include <array>
#include <numeric>

#include "io/diagram_io.hpp"
#include "io/polygon.hpp"

namespace delone::io {
namespace {

using Loop = std::vector<std::size_t>;
using Place = std::array<double, 2>;

double squared_distance(const Place& a, const Place& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// Have the two segments a place in common?
bool meet(const Place& a, const Place& b, const Place& c, const Place& d) {
  const int c_side = turn(a, b, c), d_side = turn(a, b, d);
  if (c_side == 0 && d_side == 0)
    return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
  return c_side * d_side <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

class Bridge {
 public:
  explicit Bridge(const CellShapes& shapes) : shapes_(shapes) {}

  Place at(std::size_t corner) const { return {shapes_.corners[2 * corner], shapes_.corners[2 * corner + 1]}; }

  /// A loop that begins with its rightmost corner.
  Loop loop_from_right(std::size_t loop) const {
    Loop corners(shapes_.loops[loop + 1] - shapes_.loops[loop]);
    std::iota(corners.begin(), corners.end(), shapes_.loops[loop]);
    std::ranges::rotate(corners, std::ranges::max_element(corners, {}, [&](std::size_t c) { return at(c); }));
    return corners;
  }

  /// Goes round the hole on the way round the outer loop.
  void join(Loop& outer, const Loop& hole) const {
    const std::size_t from = find(outer, at(hole.front()));
    Loop detour = hole;
    detour.push_back(hole.front());
    detour.push_back(outer[from]);
    outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(from) + 1, detour.begin(), detour.end());
  }

 private:
  /// The position of the nearest corner not left of `place` that is seen from there; of the nearest one where rounding
  /// has let loops cross, so that none is seen.
  std::size_t find(const Loop& outer, const Place& place) const {
    Loop nearest(outer.size());
    std::iota(nearest.begin(), nearest.end(), std::size_t{0});
    std::ranges::stable_sort(nearest, {}, [&](std::size_t i) { return squared_distance(at(outer[i]), place); });
    const auto sees = [&](std::size_t i) {
      return at(outer[i]) >= place && opens_to(outer, i, place) && !is_crossed(outer, i, place);
    };
    const auto found = std::ranges::find_if(nearest, sees);
    return found == nearest.end() ? nearest.front() : *found;
  }

  /// Does the polygon lie on the way from this corner to the place, to begin with?
  bool opens_to(const Loop& outer, std::size_t i, const Place& place) const {
    const Place before = at(outer[(i + outer.size() - 1) % outer.size()]);
    const Place here = at(outer[i]);
    const Place after = at(outer[(i + 1) % outer.size()]);
    if (here == place) return true;
    const bool left_of_first = turn(before, here, place) > 0;
    const bool left_of_second = turn(here, after, place) > 0;
    return turn(before, here, after) > 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
  }

  bool is_crossed(const Loop& outer, std::size_t i, const Place& place) const {
    const Place here = at(outer[i]);
    for (std::size_t k = 0; k < outer.size(); ++k) {
      const Place a = at(outer[k]);
      const Place b = at(outer[(k + 1) % outer.size()]);
      if (a != here && b != here && meet(here, place, a, b)) return true;
    }
    return false;
  }

  const CellShapes& shapes_;
};

}  // namespace

void append_bridged(const CellShapes& shapes, std::size_t first_loop, std::size_t last_loop,
                    std::vector<std::size_t>& corners) {
  const Bridge bridge(shapes);
  Loop outer = bridge.loop_from_right(first_loop);
  std::vector<Loop> holes;
  for (std::size_t loop = first_loop + 1; loop < last_loop; ++loop) holes.push_back(bridge.loop_from_right(loop));
  std::ranges::sort(holes, std::ranges::greater{}, [&](const Loop& hole) { return bridge.at(hole.front()); });
  for (const Loop& hole : holes) bridge.join(outer, hole);
  corners.insert(corners.end(), outer.begin(), outer.end());
}

}  // namespace delone::io
