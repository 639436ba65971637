// A division of the plane into convex cells, looked at once: its edges, each with the cells on both sides, and that it
// is one. In exact numbers or in doubles.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/groups.hpp"
#include "delone/apps/recognise.hpp"
#include "delone/base/errors.hpp"
#include "exact/integer.hpp"
#include "exact/quotient.hpp"

namespace delone::recognise_detail {

using BigRational =
    boost::multiprecision::number<boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
                                  boost::multiprecision::et_off>;

template <class Number>
struct Vector2 {
  Number x, y;

  friend Vector2 operator+(const Vector2& a, const Vector2& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector2 operator-(const Vector2& a, const Vector2& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector2 operator-(const Vector2& a) { return {-a.x, -a.y}; }
  friend Vector2 operator*(const Number& s, const Vector2& a) { return {s * a.x, s * a.y}; }
  friend Number dot(const Vector2& a, const Vector2& b) { return a.x * b.x + a.y * b.y; }
  friend Number cross(const Vector2& a, const Vector2& b) { return a.x * b.y - a.y * b.x; }
  friend Vector2 turned_left(const Vector2& a) { return {-a.y, a.x}; }
  /// v reflected in the line through the origin along a.
  friend Vector2 reflected(const Vector2& a, const Vector2& v) { return Number(2 * dot(a, v) / dot(a, a)) * a - v; }
};

inline constexpr double kPi = std::numbers::pi;

/// An edge as it is seen from the cell to its left: a line through a finite point of it.
struct Side {
  Index cell;
  Index from, to;
};

struct Edge {
  std::array<Side, 2> sides;
  double length;  ///< relative to the size; 1 for rays
};

/// Coordinates in which the box around all vertices has the size 1 and the origin in its middle, rounded; and in
/// Numbers: the same for doubles, those of the input for rationals.
template <class Number>
class Plan {
 public:
  using Vector = Vector2<Number>;
  static constexpr bool kExact = !std::is_same_v<Number, double>;

  Plan(const PlanarComplex& complex, double tolerance) : complex_(complex), tolerance_(tolerance) {
    require_places();
    measure();
    find_edges();
    check_corners();
    require_connected();
  }

  const std::vector<Edge>& edges() const { return edges_; }
  std::size_t cell_count() const { return complex_.cells.size(); }
  const std::vector<Index>& loop(std::size_t cell) const { return complex_.cells[cell]; }
  bool is_vertex(Index place) const { return place < complex_.vertices.size(); }
  double tolerance() const { return tolerance_; }

  /// A vertex, or a direction of about the length 1, or the size.
  const Vector& at(Index place) const { return places_[place]; }
  Vector way(Index from, Index to) const {
    if (!is_vertex(to)) return at(to);
    return is_vertex(from) ? at(to) - at(from) : -at(from);
  }
  const Vector& origin(const Side& side) const { return at(is_vertex(side.from) ? side.from : side.to); }

  std::array<double, 2> rounded(const Vector& v) const {
    if constexpr (kExact) {
      const auto nearest = [](const Number& x) { return exact::nearest_double(numerator(x), denominator(x), 0); };
      return {nearest(v.x), nearest(v.y)};
    } else {
      return {2 * (middle_[0] + v.x * half_size_), 2 * (middle_[1] + v.y * half_size_)};
    }
  }

  /// Whether it is a half-plane or a strip: whether its loop has opposite directions.
  bool holds_a_line(std::size_t cell) const {
    for (const Index a : loop(cell)) {
      for (const Index b : loop(cell)) {
        if (is_vertex(a) || is_vertex(b) || dot(at(a), at(b)) >= 0) continue;
        using std::abs;
        if (abs(cross(at(a), at(b))) <= 2 * tolerance_) return true;
      }
    }
    return false;
  }

  std::string name(Index place) const {
    if (is_vertex(place)) return "vertex " + std::to_string(place);
    return "direction " + std::to_string(place - complex_.vertices.size());
  }
  std::string name(const Side& side) const { return "the edge from " + name(side.from) + " to " + name(side.to); }

 private:
  static std::string cell_name(std::size_t cell) { return "cell " + std::to_string(cell); }

  void require_places() const {
    const auto is_finite = [](const auto& x) { return std::isfinite(x[0]) && std::isfinite(x[1]); };
    const std::size_t vertex_count = complex_.vertices.size();
    for (std::size_t v = 0; v < vertex_count; ++v) {
      if (!is_finite(complex_.vertices[v])) throw InputError("vertex " + std::to_string(v) + " is not finite");
    }
    for (std::size_t d = 0; d < complex_.directions.size(); ++d) {
      const auto& x = complex_.directions[d];
      if (!is_finite(x) || (x[0] == 0 && x[1] == 0))
        throw InputError("direction " + std::to_string(d) + " leads nowhere");
    }
    if (complex_.cells.empty()) throw InputError("no cells: they must cover the plane");
    for (std::size_t c = 0; c < cell_count(); ++c) {
      if (loop(c).size() < 3) throw InputError(cell_name(c) + " is no loop: it has less than 3 places");
      for (const Index place : loop(c)) {
        if (place >= vertex_count + complex_.directions.size())
          throw InputError(cell_name(c) + ": there is no place " + std::to_string(place));
      }
    }
  }

  void measure() {
    std::array<double, 2> low, high;
    low.fill(HUGE_VAL);
    high.fill(-HUGE_VAL);
    for (const auto& v : complex_.vertices) {
      for (std::size_t j = 0; j < 2; ++j) {
        low[j] = std::min(low[j], v[j] / 2);  // halves do not overflow
        high[j] = std::max(high[j], v[j] / 2);
      }
    }
    half_size_ = std::max({high[0] - low[0], high[1] - low[1], 0.0});
    if (half_size_ == 0) half_size_ = 0.5;  // one vertex
    for (std::size_t j = 0; j < 2; ++j) middle_[j] = low[j] / 2 + high[j] / 2;
    for (const auto& v : complex_.vertices) {
      near_.push_back({(v[0] / 2 - middle_[0]) / half_size_, (v[1] / 2 - middle_[1]) / half_size_});
      places_.push_back(kExact ? Vector{Number(v[0]), Number(v[1])}
                               : Vector{Number(near_.back()[0]), Number(near_.back()[1])});
    }
    for (const auto& d : complex_.directions) {
      const double largest = std::max(std::abs(d[0]), std::abs(d[1]));
      if constexpr (kExact) {  // by a power of two
        const int exponent = std::ilogb(half_size_) + 1 - std::ilogb(largest);
        const Number two =
            exponent < 0 ? Number(1, exact::BigInt(1) << -exponent) : Number(exact::BigInt(1) << exponent);
        places_.push_back({two * Number(d[0]), two * Number(d[1])});
      } else {
        const double size = std::hypot(d[0] / largest, d[1] / largest);
        places_.push_back({d[0] / largest / size, d[1] / largest / size});
      }
    }
  }

  /// Pairs the sides of the cells.
  void find_edges() {
    std::vector<Side> sides;
    for (std::size_t c = 0; c < cell_count(); ++c) {
      for (std::size_t i = 0; i < loop(c).size(); ++i) {
        const Index from = loop(c)[i], to = loop(c)[(i + 1) % loop(c).size()];
        if (is_vertex(from) || is_vertex(to)) sides.push_back({static_cast<Index>(c), from, to});
      }
    }
    const auto key = [](const Side& s) { return std::pair(std::min(s.from, s.to), std::max(s.from, s.to)); };
    std::ranges::sort(
        sides, [&](const Side& a, const Side& b) { return std::pair(key(a), a.cell) < std::pair(key(b), b.cell); });
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      while (end < sides.size() && key(sides[end]) == key(sides[i])) ++end;
      const std::string cell = " of " + cell_name(sides[i].cell);
      if (end - i != 2)
        throw InputError(name(sides[i]) + cell + " is in " + std::to_string(end - i) + " cells, not in two");
      if (sides[i].from == sides[i + 1].from)
        throw InputError(name(sides[i]) + cell + " runs the same way in " + cell_name(sides[i + 1].cell) +
                         ": cells run counter-clockwise");
      edges_.push_back({{sides[i], sides[i + 1]}, length_of(sides[i])});
    }
  }

  double length_of(const Side& side) const {
    if (!is_vertex(side.from) || !is_vertex(side.to)) return 1.0;
    const auto &a = near_[side.from], &b = near_[side.to];
    const double distance = std::hypot(a[0] - b[0], a[1] - b[1]);
    if (!kExact && distance <= 4 * tolerance_)
      throw InputError(name(side) + " is not longer than the tolerance: make its ends one vertex");
    return std::max(distance, 0x1p-1000);
  }

  /// The angle from u left to v, from 0 to pi; nothing when it is another one, by more than rounding explains: a cross
  /// product changes by at most twice the tolerance times the lengths when three points move by the tolerance.
  std::optional<double> left_turn(const Vector& u, const Vector& v) const {
    const Number area = cross(u, v), along = dot(u, v);
    if constexpr (kExact) {
      const Number size = abs(area) + abs(along);
      if (area < 0 || size == 0) return {};
      const double angle = std::atan2(Number(area / size).template convert_to<double>(),
                                      Number(along / size).template convert_to<double>());
      return area > 0 ? std::max(angle, 0x1p-1000) : angle;
    } else {
      if (area < -2.5 * tolerance_ * (std::hypot(u.x, u.y) + std::hypot(v.x, v.y))) return {};
      const double angle = std::atan2(area, along);
      return angle < -kPi / 2 ? angle + 2 * kPi : angle;
    }
  }

  /// Loops of convex corners that turn once, and corners that surround each vertex once, make a surface without folds
  /// and boundary. If it is connected, it covers the plane once.
  void check_corners() const {
    std::vector<double> around(complex_.vertices.size(), 0.0);
    for (std::size_t c = 0; c < cell_count(); ++c) {
      double turned = 0;
      for (std::size_t i = 0; i < loop(c).size(); ++i) turned += turn_at(c, i, around);
      if (std::abs(turned - 2 * kPi) > 1)
        throw InputError(cell_name(c) + " is not convex: its loop does not turn exactly once");
    }
    for (std::size_t v = 0; v < around.size(); ++v) {
      if (std::abs(around[v] - 2 * kPi) > 1)
        throw InputError("the cells at vertex " + std::to_string(v) + " do not surround it exactly once");
    }
  }

  /// How far to the left the loop of cell c turns at its place i. At infinity it turns back, and between two directions
  /// as far as these differ.
  double turn_at(std::size_t c, std::size_t i, std::vector<double>& around) const {
    const std::size_t size = loop(c).size();
    const Index place = loop(c)[i], next = loop(c)[(i + 1) % size], last = loop(c)[(i + size - 1) % size];
    const auto refuse = [&] {
      throw InputError(cell_name(c) + " is not convex, or does not run counter-clockwise, at " + name(place));
    };
    if (is_vertex(place)) {
      const std::optional<double> angle = left_turn(way(place, next), way(place, last));
      if (!angle || (kExact && *angle == 0)) refuse();
      around[place] += *angle;
      return kPi - *angle;
    }
    if (!is_vertex(last)) return 0.0;  // counted at the direction before
    const Index after = is_vertex(next) ? next : loop(c)[(i + 2) % size];
    if (!is_vertex(after)) throw InputError(cell_name(c) + " has more than two directions in a row at " + name(place));
    const std::optional<double> angle = is_vertex(next) ? 0.0 : left_turn(at(place), at(next));
    if (!angle) refuse();
    const bool parallel = *angle <= 5 * tolerance_;
    if (parallel && cross(at(place), at(after) - at(last)) <= 0) refuse();
    return kPi + *angle;
  }

  void require_connected() const {
    Groups groups(cell_count());
    for (const Edge& edge : edges_) groups.unite(edge.sides[0].cell, edge.sides[1].cell);
    for (std::size_t c = 0; c < cell_count(); ++c) {
      if (groups.find(static_cast<Index>(c)) != 0)
        throw InputError(cell_name(c) + " has no connection with cell 0 through edges");
    }
  }

  const PlanarComplex& complex_;
  double tolerance_;
  std::array<double, 2> middle_{};  // halved, as the size
  double half_size_ = 0;
  std::vector<std::array<double, 2>> near_;  // vertices in units of the size
  std::vector<Vector> places_;
  std::vector<Edge> edges_;
};

}  // namespace delone::recognise_detail
