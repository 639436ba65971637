#include "dual/rings.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "delone/base/ids.hpp"
#include "delone/geometry/exact_predicates.hpp"

namespace delone::dual_detail {
namespace {

using Point = std::array<double, 2>;

int orient(const Point& a, const Point& b, const Point& c) {
  return slow_orient<2>({a.data(), b.data(), c.data()}).sign;
}

/// The edge from corner `corner` of ring `ring`.
struct Edge {
  Point from, to;
  std::size_t ring, corner;

  double low(std::size_t axis) const { return std::min(from[axis], to[axis]); }
  double high(std::size_t axis) const { return std::max(from[axis], to[axis]); }
};

std::string place(const Edge& edge) {
  return "ring " + std::to_string(edge.ring) + ", edge from corner " + std::to_string(edge.corner);
}

[[noreturn]] void refuse(const Edge& a, const Edge& b, const std::string& how) {
  throw InputError(place(a) + ": " + how + " the edge from corner " + std::to_string(b.corner) + " of ring " +
                   std::to_string(b.ring));
}

std::vector<Edge> edges_of(const std::vector<Ring>& rings) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = rings[r];
    if (ring.size() < 3)
      throw InputError("ring " + std::to_string(r) + " has " + std::to_string(ring.size()) +
                       " corners; a ring has 3 or more");
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Edge edge{ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], r, i};
      if (!std::isfinite(edge.from[0]) || !std::isfinite(edge.from[1]))
        throw InputError("ring " + std::to_string(r) + ", corner " + std::to_string(i) + ": coordinate is not finite");
      if (edge.from == edge.to) throw InputError(place(edge) + ": the next corner is the same; leave one out");
      edges.push_back(edge);
    }
  }
  return edges;
}

/// Is x, which lies on the line of the edge, between its ends or one of them?
bool within(const Edge& edge, const Point& x) {
  return edge.low(0) <= x[0] && x[0] <= edge.high(0) && edge.low(1) <= x[1] && x[1] <= edge.high(1);
}

/// Two edges may have an end in common and nothing else.
void require_apart(const Edge& a, const Edge& b) {
  if (a.low(1) > b.high(1) || b.low(1) > a.high(1)) return;
  const int from = orient(a.from, a.to, b.from);
  const int to = orient(a.from, a.to, b.to);
  if (from * to > 0) return;
  if (from == 0 && to == 0) {
    int shared = 0;
    for (const auto& [edge, x] : {std::pair{&a, &b.from}, {&a, &b.to}, {&b, &a.from}, {&b, &a.to}})
      shared += within(*edge, *x);
    if (shared > 2 || (shared == 2 && !(a.to == b.from || a.from == b.to || a.from == b.from || a.to == b.to)))
      refuse(a, b, "lies on");
    return;
  }
  const int over = orient(b.from, b.to, a.from) * orient(b.from, b.to, a.to);
  if (over > 0) return;
  const bool corner = a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
  if (!corner) refuse(a, b, from == 0 || to == 0 || over == 0 ? "touches" : "crosses");
}

/// A corner with the ends of the edges before and after it.
struct Turn {
  Point at, before, after;
  std::size_t ring, corner;
};

/// Does the direction to x lead into the sector that is swept when turning left from `after` to `before`?
bool leads_inside(const Turn& turn, const Point& x) {
  const bool left_of_after = orient(turn.at, turn.after, x) > 0;
  const bool right_of_before = orient(turn.at, turn.before, x) < 0;
  return orient(turn.before, turn.at, turn.after) > 0 ? left_of_after && right_of_before
                                                      : left_of_after || right_of_before;
}

void require_no_crossing_at_corners(const std::vector<Ring>& rings) {
  std::vector<Turn> turns;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::size_t n = rings[r].size();
    for (std::size_t i = 0; i < n; ++i)
      turns.push_back({rings[r][i], rings[r][(i + n - 1) % n], rings[r][(i + 1) % n], r, i});
  }
  std::ranges::sort(turns, {}, [](const Turn& turn) { return std::tuple(turn.at, turn.ring, turn.corner); });
  for (std::size_t i = 0; i < turns.size(); ++i) {
    for (std::size_t j = i + 1; j < turns.size() && turns[j].at == turns[i].at; ++j) {
      if (leads_inside(turns[i], turns[j].before) != leads_inside(turns[i], turns[j].after))
        throw InputError("ring " + std::to_string(turns[i].ring) + ", corner " + std::to_string(turns[i].corner) +
                         ": crosses ring " + std::to_string(turns[j].ring) + " at its corner " +
                         std::to_string(turns[j].corner));
    }
  }
}

struct Box {
  Point low, high;
  bool holds(const Point& x) const { return low[0] <= x[0] && x[0] <= high[0] && low[1] <= x[1] && x[1] <= high[1]; }
};

Box box_of(const Ring& ring) {
  Box box{ring[0], ring[0]};
  for (const Point& x : ring) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      box.low[axis] = std::min(box.low[axis], x[axis]);
      box.high[axis] = std::max(box.high[axis], x[axis]);
    }
  }
  return box;
}

/// Does the ring go around x, which does not lie on it? Counts the edges that a ray to the right meets.
bool goes_around(const Ring& ring, const Point& x) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if ((a[1] > x[1]) == (b[1] > x[1])) continue;
    inside ^= orient(a, b, x) == (b[1] > a[1] ? 1 : -1);
  }
  return inside;
}

/// A place on `ring` that does not lie on `other`.
Point place_off(const Ring& ring, const Ring& other, const Box& box) {
  for (const Point& x : ring) {
    if (!box.holds(x) || std::ranges::find(other, x) == other.end()) return x;
  }
  return {(ring[0][0] + ring[1][0]) / 2, (ring[0][1] + ring[1][1]) / 2};
}

bool is_counter_clockwise(const Ring& ring) {
  const auto n = ring.size();
  const auto i = static_cast<std::size_t>(std::ranges::min_element(ring) - ring.begin());
  return orient(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]) > 0;
}

}  // namespace

void require_simple(const std::vector<Ring>& rings) {
  if (rings.empty()) throw InputError("a polygon has at least one ring");
  std::vector<Edge> edges = edges_of(rings);
  std::ranges::sort(edges, {}, [](const Edge& edge) { return std::tuple(edge.low(0), edge.ring, edge.corner); });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].low(0) <= edges[i].high(0); ++j)
      require_apart(edges[i], edges[j]);
  }
  require_no_crossing_at_corners(rings);
}

void orient_rings(std::vector<Ring>& rings) {
  std::vector<Box> boxes;
  for (const Ring& ring : rings) boxes.push_back(box_of(ring));
  std::vector<bool> hole(rings.size(), false);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t other = 0; other < rings.size(); ++other) {
      if (other == r || !boxes[other].holds(boxes[r].low) || !boxes[other].holds(boxes[r].high)) continue;
      if (goes_around(rings[other], place_off(rings[r], rings[other], boxes[other]))) hole[r] = !hole[r];
    }
  }
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (is_counter_clockwise(rings[r]) == hole[r]) std::ranges::reverse(rings[r]);
  }
}

}  // namespace delone::dual_detail
