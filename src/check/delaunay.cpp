#include "delone/check/delaunay.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "check/affine_hull.hpp"
#include "check/complex_check.hpp"
#include "check/violations.hpp"
#include "delone/base/arithmetic.hpp"

namespace delone {
namespace {

using check_detail::AffineHull;
using check_detail::ComplexInput;
using check_detail::in_words;
using check_detail::Violations;

/// Which vertex is at the position of a row: open addressing by the bits of the coordinates.
class VertexPositions {
 public:
  VertexPositions(PointsView points, const std::vector<bool>& is_vertex)
      : points_(points), slots_(std::bit_ceil(2 * points.size() + 1), kNone) {
    for (std::size_t row = 0; row < points.size(); ++row) {
      if (is_vertex[row]) insert(static_cast<Index>(row));
    }
  }

  /// kNone when there is none.
  Index find(std::size_t row) const { return slots_[slot(row)]; }

 private:
  void insert(Index row) {
    Index& place = slots_[slot(row)];
    if (place == kNone) place = row;
  }

  std::size_t slot(std::size_t row) const {
    const auto point = points_[row];
    std::uint64_t hash = 0;
    for (const double x : point) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E37'79B9'7F4A'7C15U;  // -0.0 + 0.0 is 0.0
      hash ^= hash >> 32;
    }
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>(hash) & mask;
    while (slots_[at] != kNone && !std::equal(point.begin(), point.end(), points_[slots_[at]].begin())) {
      at = (at + 1) & mask;
    }
    return at;
  }

  PointsView points_;
  std::vector<Index> slots_;
};

class Checker {
 public:
  Checker(PointsView points, const CellTable& cells, const CheckOptions& options)
      : points_(points), cells_(cells), options_(options), violations_(options.max_violations) {}

  CheckReport run() {
    require_finite(points_);
    if (options_.furthest && points_.weighted()) throw InputError("furthest sites have no weights here");
    hull_ = check_detail::affine_hull(points_);
    report_.affine_dimension = hull_.dimension;
    report_.cells = cells_.size();
    check_shape();
    if (violations_.none()) check_rows_of_cells();
    if (violations_.none() && !points_.empty()) {
      mark_vertices();
      account_for_rows();
      check_complex();
    }
    report_.violation_count = violations_.count();
    report_.violations = violations_.take_lines();
    return std::move(report_);
  }

 private:
  void check_shape() {
    const int corners = hull_.dimension + 1;
    if (!cells_.vertices.empty() && cells_.corners != corners) {
      violations_.add([&] {
        return "cells have " + std::to_string(cells_.corners) + " corners, but points of affine dimension " +
               std::to_string(hull_.dimension) + " have cells of " + std::to_string(corners);
      });
    } else if (corners > 0 && cells_.vertices.size() % static_cast<std::size_t>(corners) != 0) {
      violations_.add([] { return std::string("the last cell is incomplete"); });
    } else if (cells_.vertices.empty() && !points_.empty()) {
      violations_.add([] { return std::string("there are no cells"); });
    } else if (cells_.vertices.size() >= kNone) {
      throw InputError("more cells than this build can number; build with DELONE_WIDE_IDS");
    }
  }

  /// Also keeps a copy of the cells with ascending rows.
  void check_rows_of_cells() {
    sorted_ = cells_.vertices;
    const std::size_t corners = static_cast<std::size_t>(hull_.dimension + 1);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto cell = std::span(sorted_).subspan(c * corners, corners);
      std::sort(cell.begin(), cell.end());
      if (cell.back() >= points_.size()) {
        violations_.add([&] {
          return "cell " + std::to_string(c) + " names row " + std::to_string(cell.back()) + ", but there are only " +
                 std::to_string(points_.size()) + " rows";
        });
      }
      const auto twice = std::adjacent_find(cell.begin(), cell.end());
      if (twice != cell.end()) {
        violations_.add(
            [&] { return "cell " + std::to_string(c) + " names row " + std::to_string(*twice) + " twice"; });
      }
    }
  }

  void mark_vertices() {
    is_vertex_.assign(points_.size(), false);
    for (const Index row : sorted_) is_vertex_[row] = true;
    report_.vertices = static_cast<std::size_t>(std::count(is_vertex_.begin(), is_vertex_.end(), true));
  }

  /// Every row that is no vertex: a duplicate, or lighter than the vertex at its position, or a stray.
  void account_for_rows() {
    if (report_.vertices == points_.size()) return;
    const VertexPositions positions(points_, is_vertex_);
    for (std::size_t row = 0; row < points_.size(); ++row) {
      if (is_vertex_[row]) continue;
      const Index vertex = positions.find(row);
      if (vertex == kNone) {
        strays_.push_back(static_cast<Index>(row));
        continue;
      }
      compare_with_vertex(static_cast<Index>(row), vertex);
    }
    report_.hidden += strays_.size();
    if (points_.weighted() || options_.furthest) return;
    for (const Index row : strays_) {
      violations_.add([&] { return in_words({&row, 1}) + " is neither a vertex nor at the position of one"; });
    }
    strays_.clear();
  }

  void compare_with_vertex(Index row, Index vertex) {
    const double weight = points_.weight(row);
    const double living = points_.weight(vertex);
    ++(weight == living ? report_.duplicates : report_.hidden);
    if (weight > living) {
      violations_.add([&] {
        return in_words({&row, 1}) + " is heavier than the vertex at its position, " + in_words({&vertex, 1});
      });
    } else if (options_.canonical && weight == living && row < vertex) {
      violations_.add([&] {
        return in_words({&vertex, 1}) + " is a vertex, but its duplicate " + in_words({&row, 1}) + " comes first";
      });
    }
  }

  void check_complex() {
    if (hull_.dimension == 0) {
      if (cells_.size() != 1) {
        violations_.add(
            [&] { return "all points are equal, but there are " + std::to_string(cells_.size()) + " cells"; });
      }
      return;
    }
    const ComplexInput input{points_, hull_, sorted_, strays_, options_.canonical, options_.furthest, options_.threads};
    constexpr std::array kByDimension = {check_detail::check_complex<1>, check_detail::check_complex<2>,
                                         check_detail::check_complex<3>, check_detail::check_complex<4>,
                                         check_detail::check_complex<5>, check_detail::check_complex<6>,
                                         check_detail::check_complex<7>, check_detail::check_complex<8>};
    report_.hull_facets = kByDimension[static_cast<std::size_t>(hull_.dimension - 1)](input, violations_);
  }

  PointsView points_;
  const CellTable& cells_;
  const CheckOptions& options_;
  Violations violations_;
  CheckReport report_;
  AffineHull hull_;
  std::vector<Index> sorted_;  // the cells, ascending rows within each
  std::vector<bool> is_vertex_;
  std::vector<Index> strays_;
};

}  // namespace

CheckReport check(PointsView points, const CellTable& cells, const CheckOptions& options) {
  const ExactEnvironment environment;  // with flushed denormals doubles that differ would compare equal
  return Checker(points, cells, options).run();
}

}  // namespace delone
