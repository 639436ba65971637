#include "delone/geometry/sites.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>

#include "base/chunks.hpp"

namespace delone {
namespace {

/// Of points that are equal it does not show which came first.
double without_sign_of_zero(double x) { return x + 0.0; }  // -0.0 + 0.0 is 0.0

/// The largest e such that x is an integer times 2^e; of zero, more than any other has.
int trailing_exponent(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>(bits >> 52 & 0x7FF);
  const int zeros = std::countr_zero(bits | std::uint64_t{1} << 52);
  return x == 0.0 ? 2048 : std::max(field, 1) - 1075 + zeros;
}

}  // namespace

void NumberRange::include(std::span<const double> coordinates) {
  for (const double x : coordinates) {
    magnitude = std::max(magnitude, std::abs(x));
    // Nearly always the last bit of x, one or not, stands for 2^unit or more.
    const int last_bit = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7FF) - 1075;
    if (last_bit < unit) [[unlikely]]
      unit = std::min(unit, trailing_exponent(x));
  }
}

void NumberRange::include_weight(double weight) {
  unit = std::min(unit, trailing_exponent(weight) >> 1);  // rounded down
}

void NumberRange::include(const NumberRange& other) {
  magnitude = std::max(magnitude, other.magnitude);
  unit = std::min(unit, other.unit);
}

Sites::Sites(int dimension, bool weighted, Flat flat)
    : dimension_(dimension), weighted_(weighted), flat_(flat), leading_count_(std::max(flat.dimension, 0)) {
  const auto k = static_cast<std::size_t>(leading_count_);
  std::size_t next_other = k;
  for (int axis = 0; axis < dimension; ++axis) {
    const auto* const found = std::find(flat.axes.begin(), flat.axes.begin() + leading_count_, axis);
    const auto leading = static_cast<std::size_t>(found - flat.axes.begin());
    const std::size_t place = leading < k ? leading : next_other++;
    axis_at_place_[place] = axis;
    place_of_axis_[static_cast<std::size_t>(axis)] = static_cast<int>(place);
  }
}

void Sites::swap_rows(VertexId a, VertexId b) {
  std::swap(vertex_of_[row(a)], vertex_of_[row(b)]);
  std::swap(row_of_[raw(a)], row_of_[raw(b)]);
}

void Sites::reserve_more(std::size_t count) {
  const auto k = static_cast<std::size_t>(leading_count_);
  const auto d = static_cast<std::size_t>(dimension_);
  leading_.reserve_more(count * k);
  others_.reserve_more(count * (d - k));
  if (weighted_) weights_.reserve_more(count);
  row_of_.reserve_more(count);
  vertex_of_.reserve_more(count);
}

VertexId Sites::append(std::span<const double> point, double weight, Index row) {
  const VertexId v{static_cast<Index>(size())};
  leading_.extend(static_cast<std::size_t>(leading_count_));
  others_.extend(point.size() - static_cast<std::size_t>(leading_count_));
  if (weighted_) weights_.extend(1);
  row_of_.push_back(row);
  if (row >= vertex_of_.size()) grow_rows(row + std::size_t{1});
  vertex_of_[row] = raw(v);
  move(v, point, weight);
  return v;
}

void Sites::append(PointsView points, std::span<const Index> order, Index first_row, int threads) {
  constexpr std::size_t kAhead = 16;
  reserve_more(order.size());
  grow_rows(first_row + points.size());
  const std::size_t first = size();
  const auto k = static_cast<std::size_t>(leading_count_);
  leading_.extend(order.size() * k);
  others_.extend(order.size() * (static_cast<std::size_t>(dimension_) - k));
  if (weighted_) weights_.extend(order.size());
  row_of_.extend(order.size());
  std::mutex mutex;
  for_chunks(order.size(), threads, [&](std::size_t begin, std::size_t end, std::size_t) {
    NumberRange range;
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kAhead < order.size()) {
        __builtin_prefetch(points[order[i + kAhead]].data());
        __builtin_prefetch(vertex_of_.data() + first_row + order[i + kAhead], 1);
        if (weighted_) __builtin_prefetch(points.weights().data() + order[i + kAhead]);
      }
      const VertexId v{static_cast<Index>(first + i)};
      const Index row = first_row + order[i];
      row_of_[raw(v)] = row;
      vertex_of_[row] = raw(v);
      place(v, points[order[i]]);
      range.include(points[order[i]]);
      if (!weighted_) continue;
      weights_[raw(v)] = without_sign_of_zero(points.weight(order[i]));
      range.include_weight(points.weight(order[i]));
    }
    const std::lock_guard lock(mutex);
    range_.include(range);
  });
}

VertexId Sites::put(std::span<const double> point, double weight, Index row) {
  if (empty_.empty()) return append(point, weight, row);
  const VertexId v{empty_[empty_.size() - 1]};
  empty_.resize(empty_.size() - 1);
  move(v, point, weight);
  row_of_[raw(v)] = row;
  if (row >= vertex_of_.size()) grow_rows(row + std::size_t{1});
  vertex_of_[row] = raw(v);
  return v;
}

void Sites::remove(VertexId v) {
  vertex_of_[row(v)] = kNone;
  row_of_[raw(v)] = kNone;
  empty_.push_back(raw(v));
}

void Sites::take_back(VertexId v) {
  const Index last = row(v);
  remove(v);
  if (last + std::size_t{1} == vertex_of_.size()) vertex_of_.resize(last);
}

Sites Sites::lent() {
  Sites other(dimension_, weighted_, flat_);
  other.range_ = range_;
  other.leading_ = leading_.lent();
  other.others_ = others_.lent();
  other.weights_ = weights_.lent();
  other.row_of_ = row_of_.lent();
  other.vertex_of_ = vertex_of_.lent();
  other.empty_ = empty_.lent();
  return other;
}

void Sites::rename_rows(std::span<const Index> names, std::size_t count) {
  Buffer<Index> renamed;
  renamed.resize(count, kNone);
  for (std::size_t v = 0; v < size(); ++v) {
    row_of_[v] = names[row_of_[v]];
    renamed[row_of_[v]] = static_cast<Index>(v);
  }
  vertex_of_.swap(renamed);
}

void Sites::place(VertexId v, std::span<const double> point) {
  const auto k = static_cast<std::size_t>(leading_count_);
  double* const leading = leading_.data() + raw(v) * k;
  if (k == point.size()) {
    for (std::size_t place = 0; place < k; ++place) leading[place] = without_sign_of_zero(point[place]);
    return;
  }
  double* const others = others_.data() + raw(v) * (point.size() - k);
  for (std::size_t place = 0; place < point.size(); ++place) {
    const double x = without_sign_of_zero(point[static_cast<std::size_t>(axis_at_place_[place])]);
    (place < k ? leading[place] : others[place - k]) = x;
  }
}

void Sites::move(VertexId v, std::span<const double> point, double weight) {
  place(v, point);
  range_.include(point);
  if (!weighted_) return;
  weights_[raw(v)] = without_sign_of_zero(weight);
  range_.include_weight(weight);
}

void Sites::copy_point(VertexId v, std::span<double> to) const {
  for (std::size_t axis = 0; axis < to.size(); ++axis) to[axis] = coordinate(v, static_cast<int>(axis));
}

bool Sites::same_place(VertexId a, VertexId b) const { return std::equal(at(a), at(a) + leading_count_, at(b)); }

void Sites::shrink() {
  for (Buffer<double>* buffer : {&leading_, &others_, &weights_}) buffer->shrink_to_fit();
  row_of_.shrink_to_fit();
  vertex_of_.shrink_to_fit();
  empty_.shrink_to_fit();
}

}  // namespace delone
