// An edge lies on the bisector of the sites on its two sides: reflection in it takes one to the other. So the site of
// one cell gives all, each by the reflections in the edges on a way to it. Every other edge demands that its reflection
// agrees, too: two linear equations for two unknowns. If they can be met, and every site lies inside of its cell, then
// a cell is what is nearer to its site than to those of its neighbours, hence holds the site's Voronoi cell; and since
// the cells cover the plane once, it is no larger.
//
// (Ash and Bolker ask this vertex by vertex: around one of odd degree the reflections make up a reflection in a line
// through it, on which the site must lie, the central ray of [For92] 3.2; around one of even degree a rotation, which
// must be none, and then says nothing about the site.)
// Departure from [For92] 3.2: vertices of any degree; one system of equations in place of the intersections of central
// rays cell by cell; and sites are asked for inside of their cells also where the equations leave a choice.
#include "delone/apps/recognise.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

#include "apps/planar_plan.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"

namespace delone {
namespace {

using recognise_detail::BigRational;
using recognise_detail::Edge;
using recognise_detail::Plan;
using recognise_detail::Side;
using recognise_detail::Vector2;

// ---------------------------------------------------------------------------------------------------------------------
// Equations for the site of cell 0

/// What equations leave of the plane: all of it, the line through `point` along `along`, or the point.
template <class Number>
struct Solutions {
  int freedom = 2;
  Vector2<Number> point{0, 0}, along{0, 0};
};

/// normal . x = value
template <class Number>
struct Equation {
  Vector2<Number> normal;
  Number value;
};

/// Equations that must be met exactly.
class ExactEquations {
 public:
  /// False when nothing is left.
  bool add(const Equation<BigRational>& e, double /*weight*/, double /*noise*/) {
    const BigRational lacks = e.value - dot(e.normal, left_.point);
    const Vector2<BigRational> step = left_.freedom == 2 ? e.normal : left_.along;
    const BigRational slope = left_.freedom == 0 ? BigRational(0) : dot(e.normal, step);
    if (slope == 0) return lacks == 0;
    left_.point = left_.point + BigRational(lacks / slope) * step;
    left_.along = turned_left(e.normal);
    --left_.freedom;
    return true;
  }
  Solutions<BigRational> solve() const { return left_; }

 private:
  Solutions<BigRational> left_;
};

/// The same by least squares: rotations keep an upper triangle of two equations. A direction counts as free when what
/// they say of it does not exceed the noise.
class LeastSquares {
 public:
  /// @param noise  an estimate of the error of the coefficients
  bool add(const Equation<double>& e, double weight, double noise) {
    std::array<double, 3> row{weight * e.normal.x, weight * e.normal.y, weight * e.value};
    for (std::size_t i = 0; i < 2; ++i) {
      const double length = std::hypot(rows_[i][i], row[i]);
      if (length == 0) continue;
      const double cosine = rows_[i][i] / length, sine = row[i] / length;
      for (std::size_t j = 0; j < 3; ++j) {
        const double kept = rows_[i][j];
        rows_[i][j] = cosine * kept + sine * row[j];
        row[j] = cosine * row[j] - sine * kept;
      }
    }
    noise_ += weight * weight * noise * noise;
    return true;
  }

  Solutions<double> solve() const {
    const auto& [first, second] = rows_;
    const double xx = first[0] * first[0], xy = first[0] * first[1], yy = first[1] * first[1] + second[1] * second[1];
    const double turn = std::atan2(2 * xy, xx - yy) / 2;
    Vector2<double> axis{std::cos(turn), std::sin(turn)};  // the direction of which they say most
    Solutions<double> solutions;
    while (solutions.freedom > 0) {
      const Vector2<double> image{first[0] * axis.x + first[1] * axis.y, second[1] * axis.y};
      if (dot(image, image) <= noise_) break;
      const double along = (image.x * first[2] + image.y * second[2]) / dot(image, image);
      solutions.point = solutions.point + along * axis;
      axis = solutions.along = turned_left(axis);
      --solutions.freedom;
    }
    return solutions;
  }

 private:
  std::array<std::array<double, 3>, 2> rows_{};  // x, y and the right-hand side
  double noise_ = 0;
};

// ---------------------------------------------------------------------------------------------------------------------

/// x -> x.x * a + x.y * b + shift, a motion or a reflection.
template <class Number>
struct Motion {
  Vector2<Number> a, b, shift;

  Vector2<Number> operator()(const Vector2<Number>& x) const { return x.x * a + x.y * b + shift; }
};

/// A point at / weight, or with weight 0 the direction `at`.
template <class Number>
struct Corner {
  Vector2<Number> at;
  Number weight;
};

template <class Number>
class Recogniser {
  using Vector = Vector2<Number>;
  static constexpr bool kExact = Plan<Number>::kExact;

 public:
  explicit Recogniser(const Plan<Number>& plan) : plan_(plan) {}

  Recognition run() {
    Recognition result;
    if (const Edge* wrong = reach_all()) {
      result.reason = no_bisector(*wrong);
      return result;
    }
    const Solutions<Number> solutions = equations_.solve();
    result.freedom = solutions.freedom;
    const Vector first = middle_of_choices(solutions);
    std::vector<Vector> sites;
    for (const auto& motion : motions_) sites.push_back(motion(first));
    if constexpr (!kExact) measure(sites, result);
    if (result.reason.empty()) require_inside(sites, result.reason);
    if (!result.reason.empty()) return result;
    result.is_voronoi = true;
    for (const Vector& site : sites) result.sites.push_back(plan_.rounded(site));
    return result;
  }

 private:
  /// Reflection in the edge, after the motion.
  Motion<Number> reflected_in(const Side& side, const Motion<Number>& m) const {
    const Vector way = plan_.way(side.from, side.to), &p = plan_.origin(side);
    return {reflected(way, m.a), reflected(way, m.b), p + reflected(way, m.shift - p)};
  }

  /// Goes from cell 0 to each cell along the way on which directions of edges have the smallest sum of errors: an
  /// edge's is inverse to its length. Takes the equations of edges between cells that have been reached.
  /// @return  an edge whose equations cannot be met, or null
  const Edge* reach_all() {
    std::vector<std::vector<const Edge*>> edges_of(plan_.cell_count());
    for (const Edge& edge : plan_.edges()) {
      for (const Side& side : edge.sides) edges_of[side.cell].push_back(&edge);
    }
    motions_.resize(plan_.cell_count());
    std::vector<double> error(plan_.cell_count(), HUGE_VAL);
    std::vector<const Side*> entrance(plan_.cell_count(), nullptr);  // the side, of another cell, that leads here
    std::vector<char> reached(plan_.cell_count(), 0);
    std::priority_queue<std::pair<double, Index>> queue;  // by the error, its sign turned: the smallest is first
    error[0] = 0.0;
    queue.emplace(0.0, Index{0});
    while (!queue.empty()) {
      const Index cell = queue.top().second;
      queue.pop();
      if (std::exchange(reached[cell], 1) != 0) continue;
      motions_[cell] = entrance[cell] == nullptr ? Motion<Number>{{1, 0}, {0, 1}, {0, 0}}
                                                 : reflected_in(*entrance[cell], motions_[entrance[cell]->cell]);
      for (const Edge* edge : edges_of[cell]) {
        const Side& side = edge->sides[edge->sides[0].cell == cell ? 0 : 1];
        const Index other = edge->sides[edge->sides[0].cell == cell ? 1 : 0].cell;
        const double through = error[cell] + 1 / edge->length;
        if (reached[other] != 0) {
          const double noise = plan_.tolerance() * (through + error[other]);
          for (const auto& equation : equations(side, other)) {
            if (!equations_.add(equation, edge->length, noise)) return edge;
          }
        } else if (through < error[other]) {
          error[other] = through;
          entrance[other] = &side;
          queue.emplace(-through, other);
        }
      }
    }
    return nullptr;
  }

  /// That reflection in the side of a cell gives the site of the other one: nothing new where that led there.
  std::array<Equation<Number>, 2> equations(const Side& side, Index other) const {
    const Motion<Number> there = reflected_in(side, motions_[side.cell]);
    const Motion<Number>& known = motions_[other];
    const Vector a = there.a - known.a, b = there.b - known.b, shift = known.shift - there.shift;
    return {{{{a.x, b.x}, shift.x}, {{a.y, b.y}, shift.y}}};
  }

  std::string no_bisector(const Edge& edge) const {
    return plan_.name(edge.sides[0]) + " is on no bisector of sites of cells " + std::to_string(edge.sides[0].cell) +
           " and " + std::to_string(edge.sides[1].cell) + " that suit the other edges";
  }

  /// A site of cell 0 that puts every site strictly inside of its cell, if there is one. The choices are a point, a
  /// path along a line, or a polygon, by their corners, some of them at infinity; they are clipped by the sides of all
  /// cells, moved to cell 0. The sum of the corners that are left lies on no side unless all of them do.
  Vector middle_of_choices(const Solutions<Number>& solutions) const {
    if (solutions.freedom == 0) return solutions.point;
    const bool closed = solutions.freedom == 2 && !plan_.holds_a_line(0);
    std::vector<Corner<Number>> corners = closed ? corners_of_cell_0() : path(solutions);
    for (const Edge& edge : plan_.edges()) {
      for (const Side& side : edge.sides) {
        std::vector<Corner<Number>> left = clipped(corners, side, closed);
        const auto is_finite = [](const auto& corner) { return corner.weight > 0; };
        if (std::ranges::none_of(left, is_finite)) return middle(corners);  // which lies outside of that cell
        corners = std::move(left);
      }
    }
    return middle(corners);
  }

  /// The line of choices. Or, when cell 0 is a half-plane or a strip, a line across, since nothing changes along it:
  /// its neighbours across lines are such cells, too, and so on. (Two cells beyond one line would have the same site,
  /// which would have to lie on the edge between them: that is no free choice.)
  std::vector<Corner<Number>> path(const Solutions<Number>& solutions) const {
    Vector point = solutions.point, along = solutions.along;
    if (solutions.freedom == 2) {
      const Side& side = plan_.edges()[0].sides[0];
      point = plan_.origin(side);
      along = turned_left(plan_.way(side.from, side.to));
    }
    return {{-along, 0}, {point, 1}, {along, 0}};
  }

  std::vector<Corner<Number>> corners_of_cell_0() const {
    std::vector<Corner<Number>> corners;
    for (const Index place : plan_.loop(0)) corners.push_back({plan_.at(place), plan_.is_vertex(place) ? 1.0 : 0.0});
    return corners;
  }

  /// Positive when the site of the side's cell lies to the left of it, for a corner of the choices for cell 0.
  Number inside(const Side& side, const Corner<Number>& corner) const {
    const Motion<Number>& m = motions_[side.cell];
    const Vector moved = corner.at.x * m.a + corner.at.y * m.b + corner.weight * (m.shift - plan_.origin(side));
    return cross(plan_.way(side.from, side.to), moved);
  }

  std::vector<Corner<Number>> clipped(const std::vector<Corner<Number>>& corners, const Side& side, bool closed) const {
    std::vector<Number> value;
    for (const auto& corner : corners) value.push_back(inside(side, corner));
    std::vector<Corner<Number>> left;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (value[i] >= 0) left.push_back(corners[i]);
      const std::size_t next = i + 1 == corners.size() ? 0 : i + 1;
      if (next == 0 && !closed) break;
      if (!((value[i] < 0 && value[next] > 0) || (value[i] > 0 && value[next] < 0))) continue;
      const Number s = value[i] < 0 ? value[next] : -value[next];  // positive multiples, s * value + t * value is 0
      const Number t = value[i] < 0 ? -value[i] : value[i];
      left.push_back(
          normal({s * corners[i].at + t * corners[next].at, s * corners[i].weight + t * corners[next].weight}));
    }
    return left;
  }
  static Corner<Number> normal(const Corner<Number>& corner) {
    using std::abs;
    const Number size = corner.weight > 0 ? corner.weight : Number(abs(corner.at.x) + abs(corner.at.y));
    return {Number(1 / size) * corner.at, corner.weight > 0 ? 1.0 : 0.0};
  }
  static Vector middle(const std::vector<Corner<Number>>& corners) {
    Corner<Number> sum{{0, 0}, 0};
    for (const auto& [at, weight] : corners) sum = {sum.at + at, sum.weight + weight};
    return Number(1 / sum.weight) * sum.at;
  }

  void require_inside(const std::vector<Vector>& sites, std::string& reason) const {
    for (const Edge& edge : plan_.edges()) {
      for (const Side& side : edge.sides) {
        const Vector way = plan_.way(side.from, side.to);
        const Number area = cross(way, sites[side.cell] - plan_.origin(side));
        if (area > 0 && area * area > plan_.tolerance() * plan_.tolerance() * dot(way, way)) continue;
        reason = "no choice of sites lies within the cells: that of cell " + std::to_string(side.cell) +
                 " would lie on or beyond " + plan_.name(side);
        return;
      }
    }
  }

  void measure(const std::vector<Vector2<double>>& sites, Recognition& result) const {
    const Edge* worst = nullptr;
    for (const Edge& edge : plan_.edges()) {
      const Vector2<double>&a = sites[edge.sides[0].cell], &b = sites[edge.sides[1].cell];
      for (const Index end : {edge.sides[0].from, edge.sides[0].to}) {
        const Vector2<double>&p = plan_.at(end), toward_a = a - p, toward_b = b - p;
        const double off = plan_.is_vertex(end)
                               ? std::hypot(toward_a.x, toward_a.y) - std::hypot(toward_b.x, toward_b.y)
                               : dot(p, a - b);
        if (std::abs(off) <= result.residual) continue;
        result.residual = std::abs(off);
        worst = &edge;
      }
    }
    if (result.residual <= plan_.tolerance()) return;
    std::ostringstream text;
    text << no_bisector(*worst) << ": off by " << result.residual << " of the size";
    result.reason = text.str();
  }

  const Plan<Number>& plan_;
  std::vector<Motion<Number>> motions_;
  std::conditional_t<kExact, ExactEquations, LeastSquares> equations_;
};

}  // namespace

PlanarComplex planar_complex(const Diagram& diagram) {
  if (diagram.dimension() != 2 || diagram.least_dimension() != 0)
    throw InputError("the diagram is not that of points that span the plane");
  const auto in_pairs = [](const std::vector<double>& numbers) {
    std::vector<std::array<double, 2>> pairs;
    for (std::size_t i = 0; i < numbers.size(); i += 2) pairs.push_back({numbers[i], numbers[i + 1]});
    return pairs;
  };
  PlanarComplex complex{in_pairs(diagram.vertices()), in_pairs(diagram.ray_directions()), {}};
  const DiagramFaces cells = diagram.faces(2);
  for (std::size_t c = 0; c < cells.size(); ++c) complex.cells.emplace_back(cells.ends[c].begin(), cells.ends[c].end());
  return complex;
}

Recognition recognise(const PlanarComplex& complex, double tolerance) {
  if (!(tolerance >= 0 && tolerance < 0.1)) throw InputError("the tolerance must be from 0 to 0.1");
  const ExactEnvironment environment;
  if (tolerance > 0) return Recogniser<double>(Plan<double>(complex, tolerance)).run();
  return Recogniser<BigRational>(Plan<BigRational>(complex, 0)).run();
}

}  // namespace delone
