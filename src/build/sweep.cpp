// A line sweeps the plane upwards, and what lies below is triangulated.
// Source: [For92] 4.5.
//
// The frontier is a path of edges u -> v, one for each two intervals of the line that meet: the circles whose last
// point is in the interval of a site touch that site and no other. Two events change it. The line passes a site s in
// the interval of t: between u -> t -> v comes t -> s -> t. The line leaves the circle of two edges s -> t -> u that
// turn left: the cell stu is found, and s -> u takes their place.
//
// Departure from [For92] 4.5: sites need not be in general position, because the line is tilted by an infinitesimal
// angle (sweep_predicates.hpp): it passes sites of equal y one by one, the left one first, and no site is the last
// point of a circle. So rows, sites on breakpoints and sites on tops of circles are no special cases.
//
// Departure from [For92] 4.5: more than three sites may lie on one circle, because all events of a circle are taken
// together: it is left at once, and nothing comes between. They make a polygon of the frontier, which is cut from
// its first corner, as the tie rule wants it (perturb.hpp). So the sweep ends with the canonical triangulation.
//
// Departure from [For92] 4.5: an event that is no longer due stays in the queue, because it is cheaper to recognize
// it by its number when its turn comes.
//
// Departure from [For92] 4.5: cells are recorded, not edges. An edge of the frontier knows the cell below it, so
// that cells are linked as they are found. Both ends of the path are the lowest site, whose interval is unbounded:
// in the end the path is a cycle, the hull in clockwise order, and gets the ghost cells.
//
// Sites on one line turn nowhere and have no circle: no flat cell is made.
// Cost: O(n log n) in expectation over the priorities of the tree.
#include "build/sweep.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "delone/base/assert.hpp"
#include "delone/base/random.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/geometry/sweep_predicates.hpp"
#include "delone/topology/complex.hpp"

namespace delone {
namespace {

enum class ArcId : Index { none = kNone };

constexpr Index raw(ArcId a) { return static_cast<Index>(a); }

/// The lower side of an edge of the frontier: a facet of a cell, or, while there is no cell, another edge of the
/// frontier, which runs along the same two sites the other way. What comes above that one is below this one.
struct Side {
  FacetId facet = kNoFacet;
  ArcId edge = ArcId::none;  ///< the edge from this arc to the next
};

/// An interval of the line, and the edge of the frontier that leads from its site to that of the next one.
struct Arc {
  Point2 place;
  VertexId site;
  ArcId previous, next;
  ArcId parent;
  std::array<ArcId, 2> child;
  std::uint32_t priority;
  Side below;
  std::uint64_t event;  ///< number of the event that will end it, or kNoEvent
};

constexpr std::uint64_t kNoEvent = 0;
constexpr std::uint64_t kEnding = 1;  ///< its circle is being left

/// The intervals from left to right, as a list and as a treap: a search tree by place on the line, and a heap by random
/// priorities, which makes it as balanced as one that grew in random order.
class Frontier {
 public:
  Arc& operator[](ArcId a) { return arcs_[raw(a)]; }
  const Arc& operator[](ArcId a) const { return arcs_[raw(a)]; }
  ArcId first() const { return first_; }

  /// The interval that s, on the line, lies in. Cost O(log n).
  ArcId find(Point2 s) const {
    ArcId found = ArcId::none;
    for (ArcId a = root_; a != ArcId::none;) {
      const Arc& arc = (*this)[a];
      const bool right = arc.next != ArcId::none && right_of_breakpoint(s, arc.place, (*this)[arc.next].place);
      found = right ? found : a;
      a = arc.child[right ? 1 : 0];
    }
    return found;
  }

  /// A new arc before `next`; the only one when that is none.
  ArcId add_before(ArcId next, VertexId site, Point2 place) {
    const ArcId a = fresh();
    Arc& arc = (*this)[a];
    arc = {.place = place,
           .site = site,
           .previous = next == ArcId::none ? ArcId::none : (*this)[next].previous,
           .next = next,
           .parent = ArcId::none,
           .child = {ArcId::none, ArcId::none},
           .priority = static_cast<std::uint32_t>(mix(++added_)),
           .below = {},
           .event = kNoEvent};
    (arc.previous == ArcId::none ? first_ : (*this)[arc.previous].next) = a;
    if (next == ArcId::none) {
      root_ = a;
      return a;
    }
    (*this)[next].previous = a;
    // The next arc has no left child, or what precedes it is the last one there and has no right child.
    const bool below_next = (*this)[next].child[0] == ArcId::none;
    arc.parent = below_next ? next : arc.previous;
    (*this)[arc.parent].child[below_next ? 0 : 1] = a;
    while (arc.parent != ArcId::none && (*this)[arc.parent].priority < arc.priority) rotate_up(a);
    return a;
  }

  void remove(ArcId a) {
    Arc& arc = (*this)[a];
    while (arc.child != std::array{ArcId::none, ArcId::none}) {
      const auto [left, right] = arc.child;
      const bool left_up =
          right == ArcId::none || (left != ArcId::none && (*this)[left].priority > (*this)[right].priority);
      rotate_up(left_up ? left : right);
    }
    replace_child(arc.parent, a, ArcId::none);
    (arc.previous == ArcId::none ? first_ : (*this)[arc.previous].next) = arc.next;
    if (arc.next != ArcId::none) (*this)[arc.next].previous = arc.previous;
    arc.event = kNoEvent;
    free_.push_back(a);
  }

 private:
  ArcId fresh() {
    if (free_.empty()) {
      arcs_.emplace_back();
      return ArcId{static_cast<Index>(arcs_.size() - 1)};
    }
    const ArcId a = free_.back();
    free_.pop_back();
    return a;
  }

  /// The child takes the place of its parent, which becomes its child.
  void rotate_up(ArcId a) {
    Arc& arc = (*this)[a];
    const ArcId p = arc.parent;
    Arc& parent = (*this)[p];
    const std::size_t side = parent.child[1] == a ? 1 : 0;
    const ArcId inner = arc.child[1 - side];
    parent.child[side] = inner;
    if (inner != ArcId::none) (*this)[inner].parent = p;
    replace_child(parent.parent, p, a);
    arc.parent = parent.parent;
    arc.child[1 - side] = p;
    parent.parent = a;
  }
  void replace_child(ArcId parent, ArcId old, ArcId fresh) {
    if (parent == ArcId::none) {
      root_ = fresh;
    } else {
      auto& child = (*this)[parent].child;
      child[child[1] == old ? 1 : 0] = fresh;
    }
  }

  std::vector<Arc> arcs_;
  std::vector<ArcId> free_;
  ArcId first_ = ArcId::none;
  ArcId root_ = ArcId::none;
  std::uint64_t added_ = 0;
};

/// The line will leave the circle of an arc's site and those of the arcs before and after it.
struct Event {
  RoughTop top;
  std::array<VertexId, 3> sites;
  ArcId arc;
  std::uint64_t number;
};

class Sweep {
 public:
  explicit Sweep(Mesh& mesh) : complex_(mesh.complex), kernel_(mesh.sites) {}

  /// The sites in the order in which the line passes them.
  void pass_site(VertexId v) {
    const Point2 s = place(v);
    while (next_event() && leaves_before(events_.front(), s)) leave_circle();
    const ArcId t = frontier_.find(s);
    if (t == ArcId::none) {
      frontier_.add_before(t, v, s);
      return;
    }
    frontier_[t].event = kNoEvent;
    const ArcId before = frontier_.add_before(t, frontier_[t].site, frontier_[t].place);
    const ArcId middle = frontier_.add_before(t, v, s);
    frontier_[before].below.edge = middle;  // the two sides of the edge between t and s
    frontier_[middle].below.edge = before;
    foresee(before);
    foresee(t);
  }

  /// Once all sites are passed.
  void finish() {
    while (next_event()) leave_circle();
    close_hull();
  }

  const PredicateStats& stats() const { return kernel_.stats(); }

 private:
  using View = ComplexView<2>;

  Point2 place(VertexId v) const { return {kernel_.at(v)[0], kernel_.at(v)[1]}; }
  Circle circle(const Event& e) const { return {place(e.sites[0]), place(e.sites[1]), place(e.sites[2])}; }

  int compare(const Event& a, const Event& b) const {
    const int sign = sweep::filtered_compare_tops(a.top, b.top);
    return sign != filter::kUnsure ? sign : sweep::slow_compare_tops(circle(a), circle(b)).sign;
  }
  bool leaves_before(const Event& e, Point2 s) const {
    const int sign = sweep::filtered_compare_top(e.top, s);
    return (sign != filter::kUnsure ? sign : sweep::slow_compare_top(circle(e), s).sign) < 0;
  }

  // The queue: a heap with the first event in front.

  auto later() const {
    return [this](const Event& a, const Event& b) { return compare(a, b) > 0; };
  }
  void drop_event() {
    std::pop_heap(events_.begin(), events_.end(), later());
    events_.pop_back();
  }
  /// Whether there is an event that is due, which then is in front.
  bool next_event() {
    while (!events_.empty() && frontier_[events_.front().arc].event != events_.front().number) drop_event();
    return !events_.empty();
  }
  /// Puts the event that ends an arc into the queue, if there is one. Where the edges before and after it turn left,
  /// the ends of its interval approach each other, and the line has not yet left their circle.
  void foresee(ArcId a) {
    Arc& arc = frontier_[a];
    arc.event = kNoEvent;
    if (arc.previous == ArcId::none || arc.next == ArcId::none) return;
    const Arc& before = frontier_[arc.previous];
    const Arc& after = frontier_[arc.next];
    if (before.site == after.site) return;
    if (kernel_.orient(Kernel<2>::Points{before.place.data(), arc.place.data(), after.place.data()}) <= 0) return;
    arc.event = ++last_event_;
    const RoughTop top = rough_top({before.place, arc.place, after.place});
    events_.push_back({top, {before.site, arc.site, after.site}, a, arc.event});
    std::push_heap(events_.begin(), events_.end(), later());
  }

  /// Ends all arcs whose sites lie on the circle in front: their intervals have become one point.
  void leave_circle() {
    const Event first = events_.front();
    std::size_t count = 0;
    do {
      frontier_[events_.front().arc].event = kEnding;
      drop_event();
      ++count;
    } while (next_event() && compare(events_.front(), first) == 0);
    ArcId begin = first.arc;
    do begin = frontier_[begin].previous;
    while (frontier_[begin].event == kEnding);
    polygon_.assign(1, begin);
    ArcId end = frontier_[begin].next;
    for (; frontier_[end].event == kEnding; end = frontier_[end].next) polygon_.push_back(end);
    polygon_.push_back(end);
    DELONE_ASSERT(polygon_.size() == count + 2, "the arcs of a circle that is left follow each other");
    const FacetId top = cut_polygon();
    for (std::size_t i = 1; i + 1 < polygon_.size(); ++i) frontier_.remove(polygon_[i]);
    frontier_[begin].below = {.facet = top};
    foresee(begin);
    foresee(end);
  }

  /// Cells for the polygon above some edges of the frontier and below one from its last corner to its first, from the
  /// corner that is first in the order of the tie rule. Returns the facet at the new edge.
  FacetId cut_polygon() {
    const std::size_t n = polygon_.size();
    const auto site = [&](std::size_t i) { return frontier_[polygon_[i % n]].site; };
    std::size_t apex = 0;
    for (std::size_t i = 1; i < n; ++i) apex = kernel_.before(site(i), site(apex)) ? i : apex;
    FacetId top = kNoFacet;
    const auto attach = [&](FacetId f, std::size_t edge) {
      if (edge == n - 1) {
        top = f;
      } else {
        put_above(polygon_[edge], f);
      }
    };
    FacetId last = kNoFacet;  // of the cell before
    for (std::size_t i = apex + 1; i + 1 < apex + n; ++i) {
      const CellId c = complex_.create();
      complex_.set_vertices(c, {site(apex), site(i), site(i + 1)});
      attach(View::facet(c, 0), i % n);
      if (last == kNoFacet) {
        attach(View::facet(c, 2), apex);
      } else {
        complex_.link(View::facet(c, 2), last);
      }
      last = View::facet(c, 1);
    }
    attach(last, (apex + n - 1) % n);
    return top;
  }

  /// Links a facet to what lies below the edge of an arc.
  void put_above(ArcId a, FacetId f) {
    const Side below = frontier_[a].below;
    if (below.facet != kNoFacet) {
      complex_.link(f, below.facet);
    } else {
      frontier_[below.edge].below = {.facet = f};
    }
  }

  /// Ghost cells above the edges that are left.
  void close_hull() {
    ArcId a = frontier_.first();
    [[maybe_unused]] const VertexId lowest = frontier_[a].site;
    FacetId last = kNoFacet;
    FacetId first = kNoFacet;
    for (ArcId next; (next = frontier_[a].next) != ArcId::none; a = next) {
      const CellId c = complex_.create();
      complex_.set_vertices(c, {frontier_[a].site, frontier_[next].site, kGhost});
      complex_.link(View::facet(c, 2), frontier_[a].below.facet);
      if (last == kNoFacet) {
        first = View::facet(c, 1);
      } else {
        complex_.link(View::facet(c, 1), last);
      }
      last = View::facet(c, 0);
      complex_.count_ghost(c);
    }
    DELONE_ASSERT(frontier_[a].site == lowest, "the hull is a cycle");
    complex_.link(first, last);
  }

  View complex_;
  Kernel<2> kernel_;
  Frontier frontier_;
  std::vector<Event> events_;
  std::vector<ArcId> polygon_;
  std::uint64_t last_event_ = kEnding;
};

struct PlacedSite {
  Point2 place;
  VertexId site;
};

std::vector<PlacedSite> from_below(const Sites& sites, std::size_t count) {
  std::vector<PlacedSite> sorted(count);
  for (std::size_t i = 0; i < count; ++i) {
    const VertexId v{static_cast<Index>(i)};
    sorted[i] = {{sites.at(v)[0], sites.at(v)[1]}, v};
  }
  std::ranges::sort(sorted, passed_before, &PlacedSite::place);
  return sorted;
}

}  // namespace

void build_by_sweep(Mesh& mesh, std::size_t count, const Progress& progress) {
  mesh.complex.reserve_more(2 * count - 2, mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  Sweep sweep(mesh);
  std::size_t done = 0;
  for (const PlacedSite& s : from_below(mesh.sites, count)) {
    tell(progress, done++, count);
    sweep.pass_site(s.site);
  }
  sweep.finish();
  ComplexView<2> complex(mesh.complex);
  DELONE_ASSERT(complex.slot_count() == 2 * count - 2, "as many cells as Euler's formula wants");
  for (std::size_t c = 0; c < complex.slot_count(); ++c) complex.settle(CellId{static_cast<Index>(c)});
  mesh.vertex_count = count;
  mesh.statistics.predicates += sweep.stats();
  mesh.statistics.cells_created += complex.slot_count();
}

}  // namespace delone
