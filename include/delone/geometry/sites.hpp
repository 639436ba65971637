// The points as a triangulation keeps them: numbered by VertexId in the order of insertion, which follows a curve
// through space, so that neighbours in space are neighbours in memory. Input rows are names, looked up only at the
// door.
//
// In a flat of dimension k < D the complex has dimension k: orientation is taken on k coordinate axes on which the
// points stay independent, heights from all D coordinates (an affine map does not change the lower hull). Hence the
// split: `k` leading coordinates per site in one array, the D - k others, which only heights see, in another.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "delone/base/assert.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

/// The flat that points span: its dimension and the axes that stay independent on it, ascending.
/// Chosen greedily from axis 0 on, so that comparing points on these axes compares them on all.
struct Flat {
  int dimension = -1;
  std::array<int, kMaxDimension> axes{};

  bool operator==(const Flat&) const = default;
};

/// What filters and short integers rest on: how large numbers are, and what they are multiples of.
struct NumberRange {
  double magnitude = 0.0;  ///< the largest absolute coordinate
  int unit = 1024;         ///< every coordinate is an integer times 2^unit, every weight times 2^(2 unit)

  void include(std::span<const double> coordinates);
  void include_weight(double weight);
  void include(const NumberRange& other);
};

/// Coordinates and weights as they were given, but a zero has no sign: it does not show which of equal points came
/// first.
class Sites {
 public:
  explicit Sites(int dimension, bool weighted = false, Flat flat = {});

  int dimension() const { return dimension_; }
  const Flat& flat() const { return flat_; }
  bool weighted() const { return weighted_; }
  /// Slots: every VertexId lies below. Those of removed points are empty until a new point takes them.
  std::size_t size() const { return row_of_.size(); }
  bool is_empty(VertexId v) const { return row_of_[raw(v)] == kNone; }
  /// Rows that were ever appended, removed ones included; and how many are there now.
  std::size_t row_count() const { return vertex_of_.size(); }
  std::size_t present_count() const { return size() - empty_.size(); }

  /// k leading coordinates per site, and those of one; D - k others; weights, null when there are none.
  const double* leading() const { return leading_.data(); }
  const double* at(VertexId v) const { return leading_.data() + raw(v) * static_cast<std::size_t>(leading_count_); }
  const double* others() const { return others_.data(); }
  const double* weights() const { return weighted_ ? weights_.data() : nullptr; }
  /// Of all sites so far.
  const NumberRange& range() const { return range_; }
  double weight(VertexId v) const { return weighted_ ? weights_[raw(v)] : 0.0; }
  /// Coordinate of `v` on one of the D axes of the input.
  double coordinate(VertexId v, int axis) const {
    const auto place = static_cast<std::size_t>(place_of_axis_[static_cast<std::size_t>(axis)]);
    const auto k = static_cast<std::size_t>(leading_count_);
    return place < k ? at(v)[place] : others_[raw(v) * (static_cast<std::size_t>(dimension_) - k) + place - k];
  }

  /// The D coordinates of a point as sites keep theirs: the leading ones, then the others.
  std::array<double, kMaxDimension> placed(std::span<const double> point) const {
    std::array<double, kMaxDimension> x{};
    for (std::size_t place = 0; place < point.size(); ++place) {
      x[place] = point[static_cast<std::size_t>(axis_at_place_[place])];
    }
    return x;
  }

  Index row(VertexId v) const { return row_of_[raw(v)]; }
  /// Asks memory for the name of v, which will change.
  void prefetch_row(VertexId v) const { __builtin_prefetch(row_of_.data() + raw(v), 1); }
  bool is_removed(Index row) const { return vertex_of_[row] == kNone; }
  /// Of a row that is not removed.
  VertexId vertex(Index row) const {
    DELONE_ASSERT(!is_removed(row), "I9 a removed row has no site");
    return VertexId{vertex_of_[row]};
  }
  /// Equal points may trade their rows.
  void swap_rows(VertexId a, VertexId b);

  /// Room for `count` more sites; on std::bad_alloc nothing has changed.
  void reserve_more(std::size_t count);
  /// Appends row `row` of the input; rows are appended in any order, each once. Requires reserved room.
  VertexId append(std::span<const double> point, double weight, Index row);
  /// Appends rows of `points` in the given order, each under its number plus `first_row`; makes room.
  void append(PointsView points, std::span<const Index> order, Index first_row, int threads = 1);
  /// Makes room for rows below `count` to be named.
  void grow_rows(std::size_t count) { vertex_of_.resize(count, kNone); }
  /// Puts a point into an empty slot, or appends it. Requires reserved room.
  VertexId put(std::span<const double> point, double weight, Index row);
  /// Empties the slot of v; its row is removed for good. Requires room (reserve_empty).
  void remove(VertexId v);
  /// The same for a site just put: if its row is the last, it is as if it had never been.
  void take_back(VertexId v);
  void reserve_empty(std::size_t count) { empty_.reserve_more(count); }
  /// Renames all rows: row r becomes names[r], ascending numbers below `count`.
  void rename_rows(std::span<const Index> names, std::size_t count);
  /// Gives v another place and weight.
  void move(VertexId v, std::span<const double> point, double weight);
  /// All D coordinates of v in the order of the input's axes.
  void copy_point(VertexId v, std::span<double> to) const;
  /// Whether two sites have the same coordinates.
  bool same_place(VertexId a, VertexId b) const;
  void shrink();
  /// The same sites in the same memory, good until these grow or go.
  Sites lent();

  std::size_t memory_bytes() const {
    return (leading_.capacity() + others_.capacity() + weights_.capacity()) * sizeof(double) +
           (row_of_.capacity() + vertex_of_.capacity() + empty_.capacity()) * sizeof(Index);
  }

 private:
  /// Writes the coordinates of v.
  void place(VertexId v, std::span<const double> point);

  int dimension_;
  bool weighted_;
  Flat flat_;
  int leading_count_;
  std::array<int, kMaxDimension> axis_at_place_{};  // leading axes first, then the others, both ascending
  std::array<int, kMaxDimension> place_of_axis_{};
  NumberRange range_;
  Buffer<double> leading_, others_, weights_;
  Buffer<Index> row_of_, vertex_of_;
  Buffer<Index> empty_;  // slots, the last one is taken first
};

}  // namespace delone
