// How a polygon with k corners on one circle is cut. Arc j goes from corner j to corner j + 1, counter-clockwise.
//
// (1) An angle is half the arc that it looks at. So a side gives the same angle in every triangulation, and a diagonal
//     that cuts off an arc of s <= pi gives s/2 and pi - s/2, one on each side of it. The latter are at least pi/2, the
//     former at most, and each fixes the other: the sorted angles are largest when the sorted arcs s of the k - 3
//     diagonals are, or their lengths, which grow with s.
// (2) The best triangulation has two ears only (triangles with two sides of the polygon). Let the short ears of
//     one with three ears or more, those that span at most pi, be x1 >= x2 >= ...; at most one ear is not short.
//     With all ears short, keep those of x1 and x2 and grow from one to the other, a corner at a time: each further
//     diagonal spans more than x1 on one side and more than x2 on the other. So the new sequence is x2, x1 and others
//     that are larger than x2, while the old one has three values of at most x2, x2 and x1: it is smaller, in its third
//     place at the latest. With an ear that is not short, keep it and that of x1: the new sequence is x1 and larger
//     ones, the old one has two of at most x1.
// (3) So the diagonals are those of two chains of growing arcs, which meet at a triangle that has a side of the polygon
//     and holds the centre of the circle: arcs grow by one corner at an end, from single ones on, while they are <= pi.
//     The best chain of an arc is its chord behind the better of the two chains of the arcs that are shorter by one,
//     since the chord is longer than any in these. Chains of equally many arcs are ranked, so that two integers and a
//     chord compare them. Then all triangles that may be in the middle are tried; there are O(k) of them.
// Departure from Mount and Saalfeld: O(k^2 log k) instead of O(k log k), for the sake of ties; polygons are small.
#include "delone/apps/equiangular.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/geometry/compare_distance.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/export.hpp"

namespace delone {
namespace {

using Point = std::array<double, 2>;
using Triangle = std::array<Index, 3>;

/// Sign of |from0 - far0|^2 + |from1 - far1|^2 - |from0 - near0|^2 - |from1 - near1|^2; exact: the difference of two
/// squared distances in four dimensions.
int compare_squares(const std::array<Point, 2>& from, const std::array<Point, 2>& far,
                    const std::array<Point, 2>& near) {
  DistanceRefs refs;
  refs.dimension = 4;
  double more = 0, less = 0;
  for (std::size_t half = 0; half < 2; ++half) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::size_t at = 2 * half + axis;
      refs.q[at] = from[half][axis];
      refs.a[at] = far[half][axis];
      refs.b[at] = near[half][axis];
      more += (refs.q[at] - refs.a[at]) * (refs.q[at] - refs.a[at]);
      less += (refs.q[at] - refs.b[at]) * (refs.q[at] - refs.b[at]);
    }
  }
  // As derived in compare_distance.hpp: (4 + 5) u for each sum, and what underflows.
  const double error = 9 * filter::kU * (more + less) + 0x1p-1060;
  if (std::abs(more - less) > error) return more > less ? 1 : -1;
  return slow_compare_distance(refs).sign;
}

/// A polygon with its corners on a circle, from the lexicographically smallest one counter-clockwise.
class CocircularPolygon {
 public:
  CocircularPolygon(const AnyTriangulation& t, Kernel<2>& kernel, std::span<const Index> rows)
      : rows_(rows.begin(), rows.end()), size_(rows.size()) {
    const auto vertex = [&](Index row) { return t.vertex(row); };
    const auto first =
        std::ranges::min_element(rows_, [&](Index a, Index b) { return kernel.before(vertex(a), vertex(b)); });
    std::iter_swap(rows_.begin(), first);
    std::sort(rows_.begin() + 1, rows_.end(), [&](Index a, Index b) {  // all others lie within half a turn
      return kernel.orient({vertex(rows_[0]), vertex(a), vertex(b)}) > 0;
    });
    for (const Index row : rows_) {
      points_.push_back({t.sites().coordinate(vertex(row), 0), t.sites().coordinate(vertex(row), 1)});
    }
  }

  void cut(std::vector<Triangle>& triangles) {
    if (size_ == 4) return cut_in_two(triangles);
    find_chains();
    const auto [side, apex] = middle();
    triangles.push_back({rows_[side], rows_[(side + 1) % size_], rows_[apex]});
    unfold({(side + 1) % size_, apex}, [&](const Triangle& t) { triangles.push_back(t); });
    unfold({apex, side}, [&](const Triangle& t) { triangles.push_back(t); });
  }

 private:
  /// The arc from one corner counter-clockwise to another.
  struct Arc {
    std::size_t from, to;
  };
  /// How the best chain of an arc goes on: the arc is longer than pi, or a single one, or its last, its first is cut
  /// off.
  enum class Step : std::uint8_t { none, single, last, first };

  std::size_t next(std::size_t corner) const { return corner + 1 == size_ ? 0 : corner + 1; }
  std::size_t previous(std::size_t corner) const { return corner == 0 ? size_ - 1 : corner - 1; }
  Step& step(Arc arc) { return steps_[arc.from * size_ + arc.to]; }

  /// At most pi: by the angle at the corner that comes next, which looks at the arc.
  bool is_short(Arc arc) const {
    const Point& eye = points_[next(arc.to)];
    const Point &a = points_[arc.from], &b = points_[arc.to];
    return compare_squares({a, b}, {eye, eye}, {b, b}) >= 0;
  }
  int compare_chords(Arc a, Arc b) const {
    return compare_squares({points_[a.from], points_[b.from]}, {points_[a.to], points_[b.from]},
                           {points_[a.from], points_[b.to]});
  }

  /// The usual case, on lattices: by the longer diagonal, the usual one where both are equal.
  void cut_in_two(std::vector<Triangle>& triangles) const {
    const bool first = compare_chords({0, 2}, {1, 3}) >= 0;
    triangles.push_back({rows_[0], rows_[1], rows_[first ? 2 : 3]});
    triangles.push_back({rows_[first ? 0 : 1], rows_[2], rows_[3]});
  }

  void find_chains() {
    steps_.assign(size_ * size_, Step::none);
    std::vector<std::size_t> rank(size_, 0), longer(size_);  // by the corner where the arc begins
    std::vector<std::size_t> found;
    for (std::size_t from = 0; from < size_; ++from) {
      if (is_short({from, next(from)})) step({from, next(from)}) = Step::single;
    }
    for (std::size_t count = 2; count + 2 <= size_; ++count) {
      const auto arc = [&](std::size_t from) { return Arc{from, (from + count) % size_}; };
      std::vector<std::size_t> behind(size_);  // rank of the better chain of a shorter arc
      found.clear();
      for (std::size_t from = 0; from < size_; ++from) {
        const Arc whole = arc(from), left{from, previous(whole.to)}, right{next(from), whole.to};
        if (step(left) == Step::none || step(right) == Step::none || !is_short(whole)) continue;
        step(whole) = rank[from] >= rank[next(from)] ? Step::last : Step::first;
        behind[from] = std::max(rank[from], rank[next(from)]);
        found.push_back(from);
      }
      const auto compare = [&](std::size_t a, std::size_t b) {
        if (behind[a] != behind[b]) return behind[a] < behind[b] ? -1 : 1;
        return compare_chords(arc(a), arc(b));
      };
      std::ranges::sort(found, [&](std::size_t a, std::size_t b) { return compare(a, b) < 0; });
      for (std::size_t i = 0; i < found.size(); ++i) {
        longer[found[i]] = i == 0 ? 0 : longer[found[i - 1]] + (compare(found[i - 1], found[i]) < 0 ? 1 : 0);
      }
      rank.swap(longer);
      if (found.empty()) return;
    }
  }

  /// A side, by its first corner, and the corner that makes the triangle in the middle with it.
  std::pair<std::size_t, std::size_t> middle() {
    std::pair<std::size_t, std::size_t> best{size_, size_};
    std::vector<Arc> best_chords;
    for (std::size_t side = 0; side < size_; ++side) {
      for (std::size_t apex = 0; apex < size_; ++apex) {
        if (apex == side || apex == next(side)) continue;
        const Arc left{next(side), apex}, right{apex, side};
        if (step(left) == Step::none || step(right) == Step::none) continue;
        std::vector<Arc> chords = chain(left);
        for (const Arc chord : chain(right)) chords.push_back(chord);
        std::ranges::sort(chords, [&](Arc a, Arc b) { return compare_chords(a, b) < 0; });
        if (best.first == size_ || is_larger(chords, best_chords)) {
          best = {side, apex};
          best_chords = std::move(chords);
        }
      }
    }
    return best;
  }

  bool is_larger(const std::vector<Arc>& a, const std::vector<Arc>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (const int sign = compare_chords(a[i], b[i]); sign != 0) return sign > 0;
    }
    return false;
  }

  /// The diagonals of the best chain of an arc.
  std::vector<Arc> chain(Arc arc) {
    std::vector<Arc> chords;
    for (; step(arc) != Step::single; arc = shorter(arc)) chords.push_back(arc);
    return chords;
  }
  Arc shorter(Arc arc) {
    return step(arc) == Step::last ? Arc{arc.from, previous(arc.to)} : Arc{next(arc.from), arc.to};
  }
  template <class Take>
  void unfold(Arc arc, Take take) {
    for (; step(arc) != Step::single; arc = shorter(arc)) {
      const std::size_t cut = step(arc) == Step::last ? previous(arc.to) : next(arc.from);
      take(Triangle{rows_[arc.from], rows_[cut], rows_[arc.to]});
    }
  }

  std::vector<Index> rows_;
  std::size_t size_;
  std::vector<Point> points_;
  std::vector<Step> steps_;  // of the arc from i to j at i * size + j
};

/// Column i gets the triangle on the other side of the edge opposite corner i.
std::vector<Index> neighbours_of(const CellTable& table) {
  struct Side {
    Index low, high;
    std::size_t place;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  sides.reserve(table.vertices.size());
  for (std::size_t place = 0; place < table.vertices.size(); ++place) {
    const std::size_t first = place / 3 * 3;
    const auto [low, high] =
        std::minmax(table.vertices[first + (place + 1) % 3], table.vertices[first + (place + 2) % 3]);
    sides.push_back({low, high, place});
  }
  std::ranges::sort(sides);
  std::vector<Index> neighbours(table.vertices.size(), kNone);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i - 1].low != sides[i].low || sides[i - 1].high != sides[i].high) continue;
    neighbours[sides[i - 1].place] = static_cast<Index>(sides[i].place / 3);
    neighbours[sides[i].place] = static_cast<Index>(sides[i - 1].place / 3);
  }
  return neighbours;
}

}  // namespace

CellTable equiangular_cells(const AnyTriangulation& t, bool with_neighbours) {
  if (t.dimension() != 2)
    throw InputError("the most equiangular triangulation exists in the plane, not in dimension " +
                     std::to_string(t.dimension()));
  if (t.weighted())
    throw InputError("the most equiangular triangulation is one of Delaunay's: these points have weights");
  if (t.affine_dimension() < 2) return cells(t, with_neighbours);

  Kernel<2> kernel(t.sites());
  std::vector<Triangle> triangles;
  triangles.reserve(t.cell_count());
  const PolytopeTable polygons = merged_cells(t);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const auto rows = polygons[i];
    if (rows.size() == 3) {
      triangles.push_back({rows[0], rows[1], rows[2]});
    } else {
      CocircularPolygon(t, kernel, rows).cut(triangles);
    }
  }
  for (Triangle& rows : triangles) std::ranges::sort(rows);
  std::ranges::sort(triangles);
  CellTable table{.corners = 3, .vertices = {}, .neighbours = {}};
  table.vertices.reserve(3 * triangles.size());
  for (auto [a, b, c] : triangles) {
    if (kernel.orient({t.vertex(a), t.vertex(b), t.vertex(c)}) < 0) std::swap(b, c);
    for (const Index row : {a, b, c}) table.vertices.push_back(row);
  }
  if (with_neighbours) table.neighbours = neighbours_of(table);
  return table;
}

}  // namespace delone
