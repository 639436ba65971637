#include "delone/geometry/affine.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/geometry/exact_predicates.hpp"

namespace delone {
namespace {

constexpr std::size_t size(int n) { return static_cast<std::size_t>(n); }

/// Whether rows[0..K] are affinely independent on the K axes.
bool independent(PointsView points, std::span<const Index> rows, std::span<const int> axes) {
  if (axes.empty()) return true;
  return with_dimension<1>(static_cast<int>(axes.size()), [&](auto dimension) {
    constexpr int K = dimension;
    std::array<std::array<double, size(K)>, size(K + 1)> x;
    std::array<const double*, size(K + 1)> pointers;
    bool differs = false;
    for (std::size_t i = 0; i <= size(K); ++i) {
      for (std::size_t j = 0; j < size(K); ++j) x[i][j] = points[rows[i]][size(axes[j])];
      pointers[i] = x[i].data();
      differs = differs || x[i].back() != x[0].back();
    }
    return differs && slow_orient<K>(pointers).sign != 0;  // a constant column needs no arithmetic
  });
}

/// Adds `row` to `basis` and one axis to `axes` if the row leaves the flat that they span.
bool extend(PointsView points, std::vector<Index>& basis, std::vector<int>& axes, Index row) {
  basis.push_back(row);
  for (int axis = 0; axis < points.dimension(); ++axis) {
    if (std::ranges::find(axes, axis) != axes.end()) continue;
    axes.push_back(axis);
    if (independent(points, basis, axes)) return true;
    axes.pop_back();
  }
  basis.pop_back();
  return false;
}

}  // namespace

void AffineHull::bring_to_front(std::span<Index> order) const {
  for (std::size_t i = 0; i < size(flat.dimension + 1); ++i) {
    const auto found = std::ranges::find(order.subspan(i), basis[i]);
    std::swap(order[i], *found);  // it is there: rows are distinct
  }
}

AffineHull affine_hull(PointsView points) {
  const ExactEnvironment environment;
  AffineHull hull;
  if (points.empty()) return hull;
  std::vector<Index> basis{0};
  std::vector<int> axes;
  for (std::size_t row = 1; row < points.size() && axes.size() < size(points.dimension()); ++row) {
    extend(points, basis, axes, static_cast<Index>(row));
  }
  // The axes found depend on which rows came first; the greedy ones do not.
  std::vector<int> greedy;
  std::vector<Index> prefix{basis.front()};
  for (int axis = 0; axis < points.dimension() && greedy.size() < axes.size(); ++axis) {
    greedy.push_back(axis);
    bool enlarged = false;
    std::vector<Index> chosen(prefix);
    for (const Index row : basis) {
      if (std::ranges::find(prefix, row) != prefix.end()) continue;
      chosen.push_back(row);
      enlarged = independent(points, chosen, greedy);
      if (enlarged) break;
      chosen.pop_back();
    }
    if (enlarged) {
      prefix = chosen;
    } else {
      greedy.pop_back();
    }
  }
  hull.flat.dimension = static_cast<int>(greedy.size());
  std::ranges::copy(greedy, hull.flat.axes.begin());
  std::ranges::copy(basis, hull.basis.begin());
  return hull;
}

int affine_dimension(PointsView points) { return affine_hull(points).flat.dimension; }

}  // namespace delone
