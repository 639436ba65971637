#include "mesh/halves.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

#include "base/both.hpp"
#include "delone/base/stopwatch.hpp"
#include "mesh/glue.hpp"
#include "mesh/triangulate.hpp"

namespace delone {
namespace {

constexpr std::size_t kFew = 1 << 14;     ///< fewer points are not cut in halves
constexpr std::size_t kSample = 1 << 11;  ///< of the points, to find where and whether to cut

/// Some of the rows of a table, ascending.
struct Rows {
  std::vector<Index> names;
  PointCopies copies;

  /// Of every step-th row those that `chosen` says yes to.
  template <class Chosen>
  Rows(PointsView points, const Chosen& chosen, std::size_t step = 1)
      : names(points.size() / step + 1), copies{{}, {}, points.dimension()} {
    std::size_t count = 0;
    for (std::size_t row = 0; row < points.size(); row += step) {
      names[count] = static_cast<Index>(row);
      count += chosen(row) ? 1 : 0;
    }
    names.resize(count);
    copies.coordinates.reserve(count * static_cast<std::size_t>(points.dimension()));
    copies.weights.reserve(points.weighted() ? count : 0);
    for (const Index row : names) {
      copies.coordinates.insert(copies.coordinates.end(), points[row].begin(), points[row].end());
      if (points.weighted()) copies.weights.push_back(points.weight(row));
    }
  }
  PointsView view() const { return copies.view(); }
};

/// A plane across an axis: coordinates below `at` lie on its lower side.
struct Cut {
  std::size_t axis;
  double at;

  /// Through the median of the axis on which the points reach farthest.
  Cut(PointsView points, std::span<const int> axes) : axis(0), at(0.0) {
    double widest = -1.0;
    std::vector<double> values(points.size());
    for (const int candidate : axes) {
      const auto on = static_cast<std::size_t>(candidate);
      for (std::size_t row = 0; row < points.size(); ++row) values[row] = points[row][on];
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::ranges::nth_element(values, middle);
      const auto [low, high] = std::ranges::minmax(values);
      if (const double width = high * 0.5 - low * 0.5; width > widest) {
        widest = width;
        axis = on;
        at = *middle;
      }
    }
  }
  Rows half(PointsView points, bool upper) const {
    return {points, [&, this](std::size_t row) { return (points[row][axis] < at) != upper; }};
  }
};

bool spans_as_much(const Mesh& mesh, std::span<const int> axes) {
  return mesh.complex.dimension() == static_cast<int>(axes.size());
}

/// Whether the border of two halves will be short, by that of a sample: so many sites fill a part of K dimensions, and
/// a layer of K - 1 is near the border.
bool has_short_border(PointsView sample, std::size_t points, const Cut& cut, std::span<const int> axes,
                      const Progress& progress) {
  const Rows lower = cut.half(sample, false);
  const Rows upper = cut.half(sample, true);
  const Mesh a = triangulate_points(lower.view(), 1, progress);
  const Mesh b = triangulate_points(upper.view(), 1, progress);
  if (!spans_as_much(a, axes) || !spans_as_much(b, axes)) return false;
  const double share = border_share(a, b);
  const double thinner = std::pow(static_cast<double>(sample.size()) / static_cast<double>(points),
                                  1.0 / static_cast<double>(axes.size()));
  return share < 0.5 && share * thinner < 0.2;
}

}  // namespace

std::optional<Mesh> triangulate_in_halves(PointsView points, std::span<const int> axes, int threads,
                                          const Progress& progress, std::size_t room) {
  if (threads < 2 || points.size() < kFew || axes.size() < 2) return std::nullopt;
  Stopwatch watch;
  const Rows sample(
      points, [](std::size_t) { return true; }, points.size() / kSample);
  const Cut cut(sample.view(), axes);
  const Progress ask = [&](double) { return !progress || progress(0.0); };
  if (!has_short_border(sample.view(), points.size(), cut, axes, ask)) return std::nullopt;

  // What one half throws ends the other.
  std::atomic<bool> stopped = false;
  std::exception_ptr failure;
  std::optional<Mesh> a, b;
  const auto make_half = [&](std::optional<Mesh>& mesh, bool upper, int share, const Progress& tell) {
    try {
      const Rows rows = cut.half(points, upper);
      mesh = triangulate_points(rows.view(), share, tell, upper ? 0 : std::max(room, points.size()));
      mesh->rename_rows(rows.names, points.size());
      mesh->scratch = {};
    } catch (...) {
      if (!stopped.exchange(true)) failure = std::current_exception();
    }
  };
  both(
      threads,
      [&] {
        make_half(a, false, threads - threads / 2,
                  [&](double done) { return !stopped && (!progress || progress(done)); });
      },
      [&] { make_half(b, true, threads / 2, [&](double) { return !stopped; }); });
  if (failure) std::rethrow_exception(failure);
  if (!spans_as_much(*a, axes) || !spans_as_much(*b, axes)) return std::nullopt;
  const double order_seconds = a->statistics.order_seconds;
  std::optional<Mesh> whole = glue(std::move(*a), *b, threads);
  if (whole) {
    whole->statistics.order_seconds = order_seconds;
    whole->statistics.insert_seconds = watch.lap() - order_seconds;
  }
  return whole;
}

}  // namespace delone
