// Points are the user's numbers: n rows of D doubles and optionally n weights, borrowed, never copied.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "delone/base/errors.hpp"

namespace delone {

/// A borrowed n x dimension table of doubles, row-major, with an optional weight per row.
/// The weight is that of a power distance, |x - p|^2 - w: for balls it is the squared radius.
class PointsView {
 public:
  PointsView() = default;

  /// @throws InputError when the lengths do not fit together or the dimension is not 1 to 8
  PointsView(std::span<const double> coordinates, int dimension, std::span<const double> weights = {});

  template <std::size_t D>
  PointsView(std::span<const std::array<double, D>> points, std::span<const double> weights = {})
      : PointsView(std::span(points.empty() ? nullptr : points.front().data(), points.size() * D), static_cast<int>(D),
                   weights) {}

  template <std::size_t D>
  PointsView(const std::vector<std::array<double, D>>& points, std::span<const double> weights = {})
      : PointsView(std::span<const std::array<double, D>>(points), weights) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  int dimension() const { return dimension_; }
  bool weighted() const { return !weights_.empty(); }

  std::span<const double> coordinates() const { return coordinates_; }
  std::span<const double> weights() const { return weights_; }
  std::span<const double> operator[](std::size_t row) const {
    return coordinates_.subspan(row * static_cast<std::size_t>(dimension_), static_cast<std::size_t>(dimension_));
  }
  /// 0 when there are no weights.
  double weight(std::size_t row) const { return weighted() ? weights_[row] : 0.0; }

 private:
  std::span<const double> coordinates_;
  std::span<const double> weights_;
  std::size_t size_ = 0;
  int dimension_ = 1;
};

/// Refuses NaN and infinity.
/// @throws InputError naming row and column, both counted from 0
void require_finite(PointsView points);

/// Rows that ids can name: random points of that many rows have as many facets as there are ids. (A set that needs more
/// cells than random points do is refused when its ids run out.)
std::size_t max_row_count(int dimension);

/// @throws InputError when ids cannot name that many rows
void require_row_count(std::size_t rows, int dimension);

}  // namespace delone
