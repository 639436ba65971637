// The diagrams of all orders from circles, ties included.
//
// Let O be the centre of a circle with i sites inside and m >= 3 on it, a_0 to a_(m-1) counter-clockwise; indices go
// round. Seen from a place near O in direction d, those inside come first, then those on the circle, the further in
// direction d the sooner. A line parts r of the sites on a circle from the others if and only if they follow each other
// there. So, with r = k - i:
//
// (1) O is a vertex of order k if and only if 0 < r < m. Then m cells meet there, one for each arc of r sites: corner p
//     is that of the cell of those inside and a_p to a_(p+r-1). Between corners p - 1 and p a border ends, end p, where
//     a_(p-1) and a_(p+r-1) change places. Each cell takes up less than half a turn.
// (2) If the sites are not on one line, every border has an end. Along it two sites a and b are equally far and the
//     same sites are nearer; but a site c off the line ab is nearer than they are on one side of the centre of the
//     circle abc only. So the circles tell all cells, and each is met by going round it: its border at end p leads to
//     infinity, or to an end q of another circle, where the corner of the cell is q - 1.
//
// From order k to k + 1, within the cell V of a set S: V falls into parts, by the nearest site out of S. Along all
// borders of order k + 1 the k nearest sites are strictly nearer, so each lies within such a V, between two parts. From
// a place of the part of t go straight to t: t stays the nearest out of S, and V is left on the way, so across a border
// with t beyond. The part is convex and t is not in V, so seen from t it covers those borders in one piece. Hence:
//
// (3) Sites with parts are those beyond the borders of V, each beyond borders that follow each other. So the new
//     borders make no ring in V: they are trees, which end at infinity and at the corners of V with two sites beyond.
//     By (1) these are the corners p of circles with r + 1 < m, and it is end p of order k + 1 that goes from there
//     into V. All other new vertices are centres of circles with just S inside.
// (4) So the sites t_0, t_1, ... beyond the borders, counter-clockwise, are the corners of a polygon, with infinity as
//     one more where V has no end. It falls into polygons with sites of one circle as corners, counter-clockwise again,
//     whose centres are the new vertices. The one on the left of the side from t_high to t_low has those t between
//     them that make the empty circle with the two.
//     Source: [For92] 4.6 (gift wrapping).
// (5) Sites whose parts go to infinity follow each other on the convex hull of all t; of those on one line, the first
//     comes next.
//
// Departure from [Lee82]: it makes the Voronoi diagram of the t of each cell, which takes O(k^2 n log n) in all.
#include "delone/apps/order_k.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "base/grown.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/geometry/kernel.hpp"

namespace delone {
namespace {

/// Circles by the sites on them, which have places, circle after circle; and by the sites inside.
class Circles {
 public:
  std::size_t size() const { return inside_offsets_.size() - 1; }
  std::size_t place_count() const { return on_.size(); }
  Index first(Index circle) const { return offsets_[circle]; }
  std::span<const VertexId> on(Index circle) const { return std::span(on_).subspan(first(circle), count(circle)); }
  std::span<const VertexId> inside(Index circle) const {
    return std::span(inside_).subspan(inside_offsets_[circle], inside_offsets_[circle + 1] - inside_offsets_[circle]);
  }

  Index circle(Index place) const { return circle_[place]; }
  VertexId site(Index place) const { return on_[place]; }
  /// Round the circle counter-clockwise. Requires by <= how many sites are on it.
  Index turned(Index place, std::size_t by) const {
    const Index circle = circle_[place];
    const std::size_t to = place + by;
    return static_cast<Index>(to < first(circle + 1) ? to : to - count(circle));
  }
  Index next(Index place) const { return turned(place, 1); }
  Index previous(Index place) const { return turned(place, count(circle_[place]) - 1); }

  /// @return  its first place
  Index add(std::span<const VertexId> on, std::span<const VertexId> inside) {
    const Index first = next_id(on_.size() + on.size()) - static_cast<Index>(on.size());
    circle_.resize(on_.size() + on.size(), static_cast<Index>(size()));
    on_.insert(on_.end(), on.begin(), on.end());
    inside_.insert(inside_.end(), inside.begin(), inside.end());
    offsets_.push_back(static_cast<Index>(on_.size()));
    inside_offsets_.push_back(inside_.size());
    return first;
  }

 private:
  std::size_t count(Index circle) const { return offsets_[circle + 1] - offsets_[circle]; }

  std::vector<Index> offsets_{0}, circle_;
  std::vector<VertexId> on_, inside_;
  std::vector<std::size_t> inside_offsets_{0};
};

/// The diagram of one order after the other, for sites that span the plane.
class Diagram {
 public:
  explicit Diagram(const AnyTriangulation& t) : kernel_(t.sites()) { begin(ConstComplexView<2>(t.complex())); }

  const Circles& circles() const { return circles_; }

  /// Of the circle at a place, how many sites on it are in each cell.
  std::size_t arc(Index place) const { return order_ - circles_.inside(circles_.circle(place)).size(); }
  /// The sites that change places at an end, as seen from the cell with that corner, which the border leaves there.
  VertexId near(Index end) const { return circles_.site(circles_.turned(end, arc(end) - 1)); }
  VertexId far(Index end) const { return circles_.site(circles_.previous(end)); }

  /// The sites of the cell with this corner, in no order.
  void collect_subset(Index corner, std::vector<VertexId>& subset) const {
    const auto inside = circles_.inside(circles_.circle(corner));
    subset.assign(inside.begin(), inside.end());
    for (Index p = corner; subset.size() < order_; p = circles_.next(p)) subset.push_back(circles_.site(p));
  }

  /// Calls visit(corners, bounded) for each cell: counter-clockwise, those of an unbounded one from infinity on.
  template <class Visit>
  void for_cells(const Visit& visit) const {
    std::vector<bool> seen(circles_.place_count());
    std::vector<Index> corners;
    const auto go_round = [&](Index first, bool bounded) {
      corners.clear();
      for (Index p = first; !seen[p];) {
        seen[p] = true;
        corners.push_back(p);
        if (other_end_[p] != kNone) p = circles_.previous(other_end_[p]);
      }
      visit(std::span<const Index>(corners), bounded);
    };
    for (Index p = 0; p < circles_.place_count(); ++p) {
      if (other_end_[circles_.next(p)] == kNone) go_round(p, false);
    }
    for (Index p = 0; p < circles_.place_count(); ++p) {
      if (!seen[p]) go_round(p, true);
    }
  }

  /// From this order to the next one. @param tell  called for each cell
  template <class Tell>
  void advance(const Tell& tell) {
    next_ = {};
    const std::vector<Index> moved = keep_circles();
    next_end_.assign(next_.place_count(), kNone);
    for_cells([&](std::span<const Index> corners, bool bounded) {
      tell();
      divide(corners, bounded, moved);
    });
    circles_ = std::move(next_);
    other_end_ = std::move(next_end_);
    ++order_;
  }

 private:
  /// A part of the polygon of (4), beyond the side of the border that ends at `end`, or goes to infinity.
  struct Part {
    Index end;
    std::size_t low, high;
  };

  /// Order 1: the polygons of the triangulation. Corner p of a polygon stands at the end of its edge p.
  void begin(ConstComplexView<2> complex) {
    const auto is_outer = [&](FacetId f) {
      const FacetId across = complex.twin(f);
      return complex.is_ghost(complex.cell(across)) ||
             side_of_circle(complex.vertices(complex.cell(f)), complex.vertex(across)) != 0;
    };
    const auto next_edge = [&](FacetId f) {
      return complex.facet(complex.cell(f), complex.turned(complex.slot(f), 1));
    };
    std::vector<Index> end(complex.facet_slots(), kNone);
    std::vector<VertexId> polygon;
    std::vector<FacetId> edges;
    for (std::size_t i = 0; i < 3 * complex.slot_count(); ++i) {
      const CellId c{static_cast<Index>(i / 3)};
      const FacetId start = complex.facet(c, static_cast<int>(i % 3));
      if (end[raw(start)] != kNone || !complex.is_live(c) || complex.is_ghost(c) || !is_outer(start)) continue;
      polygon.clear();
      FacetId f = start;
      do {
        end[raw(f)] = static_cast<Index>(edges.size());
        edges.push_back(f);
        polygon.push_back(complex.vertex(complex.cell(f), complex.turned(complex.slot(f), 2)));
        for (f = next_edge(f); !is_outer(f);) f = next_edge(complex.twin(f));
      } while (f != start);
      circles_.add(polygon, {});
    }
    for (const FacetId f : edges) other_end_.push_back(end[raw(complex.twin(f))]);
  }

  /// The circles that the next order has, too. @return for each circle its first place there, kNone for the others
  std::vector<Index> keep_circles() {
    std::vector<Index> moved(circles_.size(), kNone);
    for (Index c = 0; c < circles_.size(); ++c) {
      if (arc(circles_.first(c)) + 1 < circles_.on(c).size()) moved[c] = next_.add(circles_.on(c), circles_.inside(c));
    }
    return moved;
  }

  /// Finds the borders and the vertices of the next order within a cell of this one.
  void divide(std::span<const Index> corners, bool bounded, const std::vector<Index>& moved) {
    ends_.clear();
    sites_.clear();
    VertexId last = kGhost;
    for (const Index p : corners) {
      const Index circle = circles_.circle(p);
      if (moved[circle] == kNone) continue;
      ends_.push_back(moved[circle] + p - circles_.first(circle));
      sites_.push_back(circles_.site(circles_.turned(p, arc(p))));
      last = far(p);
    }
    if (ends_.empty()) return;
    collect_subset(corners[0], subset_);
    if (bounded) return fill({ends_.back(), 0, sites_.size() - 1});
    sites_.push_back(last);
    fill_from_infinity();
  }

  /// Along the sides of the convex hull, from which borders go to infinity.
  void fill_from_infinity() {
    for (std::size_t low = 0, high = 0; high + 1 < sites_.size(); low = high) {
      high = low + 1;
      for (std::size_t i = high + 1; i < sites_.size(); ++i) {
        if (kernel_.orient({sites_[high], sites_[low], sites_[i]}) < 0) high = i;
      }
      fill({kNone, low, high});
    }
  }

  /// Cuts a part of the polygon into polygons of one circle.
  void fill(Part whole) {
    parts_.assign(1, whole);
    while (!parts_.empty()) {
      const Part part = parts_.back();
      parts_.pop_back();
      if (part.high == part.low + 1) {
        link(part.end, ends_[part.low]);
        continue;
      }
      find_apexes(part);
      add_circle(part);
    }
  }

  /// The corners between the two of a side, whose circle with them is empty.
  void find_apexes(const Part& part) {
    const VertexId u = sites_[part.high], v = sites_[part.low];
    apexes_.clear();
    for (std::size_t i = part.low + 1; i < part.high; ++i) {
      const int inside = apexes_.empty() ? 1 : side_of_circle({u, v, sites_[apexes_[0]]}, sites_[i]);
      if (inside < 0 || kernel_.orient({u, v, sites_[i]}) <= 0) continue;
      if (inside > 0) apexes_.clear();
      apexes_.push_back(i);
    }
  }

  void add_circle(const Part& part) {
    apexes_.push_back(part.high);
    polygon_.assign(1, sites_[part.low]);
    for (const std::size_t i : apexes_) polygon_.push_back(sites_[i]);
    Index end = next_.add(polygon_, subset_);
    next_end_.resize(next_.place_count(), kNone);
    link(part.end, end);
    std::size_t low = part.low;
    for (const std::size_t high : apexes_) parts_.push_back({++end, std::exchange(low, high), high});
  }

  void link(Index a, Index b) {
    if (a != kNone) next_end_[a] = b;
    next_end_[b] = a;
  }

  /// +1 for a site inside the circle through three that turn left, 0 for one on it, -1 for one outside.
  int side_of_circle(const Kernel<2>::Cell& three, VertexId site) const {
    const int sign = kernel_.filtered_conflict(three, site);
    return sign != Kernel<2>::kUnsure ? sign : kernel_.slow_conflict_sign(three, site).sign;
  }

  Kernel<2> kernel_;
  std::size_t order_ = 1;
  Circles circles_, next_;                   // of this order, and of the next one while it comes into being
  std::vector<Index> other_end_, next_end_;  // of the border at each end, kNone where it goes to infinity
  // Of the cell that is being divided: ends_[i] is that of the border between sites_[i] and sites_[i + 1].
  std::vector<Index> ends_;
  std::vector<VertexId> sites_, subset_, polygon_;
  std::vector<Part> parts_;
  std::vector<std::size_t> apexes_;
};

/// Numbers 0, 1, ... of subsets of k rows, in the order of these.
std::vector<Index> sorted_order(const std::vector<Index>& subsets, std::size_t k) {
  std::vector<Index> order(subsets.size() / k);
  std::iota(order.begin(), order.end(), Index{0});
  const auto subset = [&](Index i) { return std::span(subsets).subspan(i * k, k); };
  std::ranges::sort(order,
                    [&](Index a, Index b) { return std::ranges::lexicographical_compare(subset(a), subset(b)); });
  return order;
}

std::vector<Index> ranks(const std::vector<Index>& order) {
  std::vector<Index> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<Index>(i);
  return rank;
}

/// A diagram in rows, in the order that is promised.
class Export {
 public:
  Export(const AnyTriangulation& t, const Diagram& diagram, int k)
      : t_(&t), diagram_(&diagram), cell_(diagram.circles().place_count()), vertex_(diagram.circles().size(), kNone) {
    result_.k = k;
    number_cells();
    const std::vector<Index> order = sorted_order(subsets_, static_cast<std::size_t>(k));
    rank_ = ranks(order);
    for (const Index cell : order) add_cell(cell);
  }

  OrderK result() { return std::move(result_); }

 private:
  struct Border {
    Bisector line;
    Index start;  // a circle
  };

  void number_cells() {
    std::vector<VertexId> subset;
    diagram_->for_cells([&](std::span<const Index> corners, bool bounded) {
      const auto cell = static_cast<Index>(bounded_.size());
      for (const Index p : corners) cell_[p] = cell;
      corners_.insert(corners_.end(), corners.begin(), corners.end());
      offsets_.push_back(corners_.size());
      bounded_.push_back(bounded);
      diagram_->collect_subset(corners[0], subset);
      for (const VertexId v : subset) subsets_.push_back(t_->row(v));
      std::sort(subsets_.end() - result_.k, subsets_.end());
    });
  }

  void add_cell(Index cell) {
    const auto k = static_cast<std::size_t>(result_.k);
    const auto subset = std::span(subsets_).subspan(cell * k, k);
    result_.subsets.insert(result_.subsets.end(), subset.begin(), subset.end());
    const auto corners = std::span(corners_).subspan(offsets_[cell], offsets_[cell + 1] - offsets_[cell]);
    const Circles& circles = diagram_->circles();
    borders_.clear();
    if (!bounded_[cell]) {
      const Bisector back = seen_from_corner(circles.next(corners[0]));
      borders_.push_back({{back.far, back.near, rank_[cell_[circles.next(corners[0])]]}, kNone});
    }
    for (const Index p : corners) borders_.push_back({seen_from_corner(p), circles.circle(p)});
    if (bounded_[cell]) {
      std::ranges::rotate(borders_, std::ranges::min_element(borders_, {}, [](const Border& b) {
                            return std::pair(b.line.near, b.line.far);
                          }));
    }
    for (const auto& [line, start] : borders_) {
      result_.borders.push_back(line);
      result_.starts.push_back(start == kNone ? kNone : vertex(start));
    }
    result_.offsets.push_back(result_.borders.size());
  }

  /// The border that leaves corner p.
  Bisector seen_from_corner(Index p) const {
    return {t_->row(diagram_->near(p)), t_->row(diagram_->far(p)), rank_[cell_[diagram_->circles().previous(p)]]};
  }

  /// The number of a circle's centre.
  Index vertex(Index circle) {
    if (vertex_[circle] != kNone) return vertex_[circle];
    const auto begin = static_cast<std::ptrdiff_t>(result_.on.size());
    for (const VertexId v : diagram_->circles().on(circle)) result_.on.push_back(t_->row(v));
    std::rotate(result_.on.begin() + begin, std::min_element(result_.on.begin() + begin, result_.on.end()),
                result_.on.end());
    result_.circles.push_back(result_.on.size());
    result_.inside.push_back(static_cast<Index>(diagram_->circles().inside(circle).size()));
    return vertex_[circle] = static_cast<Index>(result_.inside.size() - 1);
  }

  const AnyTriangulation* t_;
  const Diagram* diagram_;
  OrderK result_;
  std::vector<Index> cell_;    // of each corner: its cell, as they are found
  std::vector<Index> vertex_;  // of each circle: its number in the result
  std::vector<Index> corners_, subsets_, rank_;
  std::vector<std::size_t> offsets_{0};
  std::vector<bool> bounded_;
  std::vector<Border> borders_;
};

/// Of sites on a line, or of all sites: the k nearest follow each other.
OrderK windows(const std::vector<Index>& rows, int k) {
  const auto size = static_cast<std::size_t>(k);
  const std::size_t count = rows.size() - size + 1;
  std::vector<Index> subsets;
  for (std::size_t i = 0; i < count; ++i) {
    subsets.insert(subsets.end(), rows.begin() + static_cast<std::ptrdiff_t>(i),
                   rows.begin() + static_cast<std::ptrdiff_t>(i + size));
    std::sort(subsets.end() - k, subsets.end());
  }
  const std::vector<Index> order = sorted_order(subsets, size);
  const std::vector<Index> rank = ranks(order);
  OrderK result;
  result.k = k;
  for (const Index i : order) {
    const auto subset = std::span(subsets).subspan(i * size, size);
    result.subsets.insert(result.subsets.end(), subset.begin(), subset.end());
    if (i > 0) result.borders.push_back({rows[i + size - 1], rows[i - 1], rank[i - 1]});
    if (i + 1 < count) result.borders.push_back({rows[i], rows[i + size], rank[i + 1]});
    result.offsets.push_back(result.borders.size());
  }
  result.starts.assign(result.borders.size(), kNone);
  return result;
}

/// The rows that count, in lexicographic order of their places: along the line, if they are on one.
std::vector<Index> sorted_vertices(PointsView points, const AnyTriangulation& t) {
  std::vector<Index> rows;
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (t.status(static_cast<Index>(row)).status == Status::vertex) rows.push_back(static_cast<Index>(row));
  }
  std::ranges::sort(rows, [&](Index a, Index b) { return std::ranges::lexicographical_compare(points[a], points[b]); });
  return rows;
}

void require_orders(PointsView points, int first, int last) {
  if (points.dimension() != 2)
    throw InputError("diagrams of order k are made in the plane, not in dimension " +
                     std::to_string(points.dimension()));
  if (points.weighted()) throw InputError("diagrams of order k have no weights here");
  if (first < 1 || last < first)
    throw InputError("orders begin with 1 and ascend: there are none from " + std::to_string(first) + " to " +
                     std::to_string(last));
}

}  // namespace

void for_orders(PointsView points, int first, int last, const std::function<void(OrderK)>& visit,
                const OrderKOptions& options) {
  require_orders(points, first, last);
  const ExactEnvironment environment;
  const AnyTriangulation t = build(points);
  const auto most = static_cast<std::size_t>(last);
  if (t.vertex_count() < most)
    throw InputError("order " + std::to_string(last) + ": the points stand at only " +
                     std::to_string(t.vertex_count()) + " places");
  if (t.affine_dimension() < 2) {
    const std::vector<Index> rows = sorted_vertices(points, t);
    for (int k = first; k <= last; ++k) visit(windows(rows, k));
    return;
  }
  Diagram diagram(t);
  std::size_t done = 0;
  const std::size_t all = most * most * t.vertex_count();  // of order k there are less than (2 k - 1) n cells
  for (int k = 1;; ++k) {
    const bool whole = static_cast<std::size_t>(k) == t.vertex_count();
    if (k >= first) visit(whole ? windows(sorted_vertices(points, t), k) : Export(t, diagram, k).result());
    if (k == last) return;
    diagram.advance([&] { tell(options.progress, done++, all); });
  }
}

OrderK order_k_voronoi(PointsView points, int k, const OrderKOptions& options) {
  OrderK result;
  for_orders(
      points, k, k, [&](OrderK diagram) { result = std::move(diagram); }, options);
  return result;
}

}  // namespace delone
