// Fraction-free elimination after Bareiss, one row at a time: after r steps every entry of a row is a minor of order
// r + 1, so each division is exact and numbers stay as short as determinants are. A new row's pivot is its first entry
// that is left; the pivots of such a basis are the columns that a greedy choice from axis 0 on takes.
#include "check/affine_hull.hpp"

#include <algorithm>
#include <climits>
#include <vector>

#include "exact/integer.hpp"

namespace delone::check_detail {
namespace {

using exact::BigInt;
using Row = std::vector<BigInt>;

/// points[row] - points[0], times a power of two that makes it integral.
Row direction(PointsView points, std::size_t row) {
  const auto d = static_cast<std::size_t>(points.dimension());
  int unit = INT_MAX;
  for (const std::size_t r : {std::size_t{0}, row}) {
    for (const double x : points[r]) {
      if (x != 0) unit = std::min(unit, exact::decompose(x).exponent);
    }
  }
  Row result(d);
  for (std::size_t axis = 0; axis < d; ++axis) {
    if (points[row][axis] == points[0][axis]) continue;
    result[axis] = exact::to_integer<BigInt>(exact::decompose(points[row][axis]), unit) -
                   exact::to_integer<BigInt>(exact::decompose(points[0][axis]), unit);
  }
  return result;
}

struct Echelon {
  std::vector<Row> rows;
  std::vector<std::size_t> pivots;

  /// Takes `row` into the basis unless it depends on it.
  void add(Row row) {
    BigInt previous = 1;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const BigInt pivot = rows[r][pivots[r]];
      const BigInt factor = row[pivots[r]];
      for (std::size_t j = 0; j < row.size(); ++j) row[j] = (row[j] * pivot - rows[r][j] * factor) / previous;
      previous = pivot;
    }
    const auto first = std::find_if(row.begin(), row.end(), [](const BigInt& x) { return x != 0; });
    if (first == row.end()) return;
    pivots.push_back(static_cast<std::size_t>(first - row.begin()));
    rows.push_back(std::move(row));
  }
};

}  // namespace

AffineHull affine_hull(PointsView points) {
  AffineHull hull;
  if (points.empty()) return hull;
  const auto d = static_cast<std::size_t>(points.dimension());
  Echelon basis;
  for (std::size_t row = 1; row < points.size() && basis.rows.size() < d; ++row) {
    if (!std::equal(points[row].begin(), points[row].end(), points[0].begin())) basis.add(direction(points, row));
  }
  hull.dimension = static_cast<int>(basis.pivots.size());
  std::sort(basis.pivots.begin(), basis.pivots.end());
  std::size_t taken = 0;
  for (const std::size_t axis : basis.pivots) hull.axes[taken++] = static_cast<int>(axis);
  for (std::size_t axis = 0; axis < d; ++axis) {
    if (!std::binary_search(basis.pivots.begin(), basis.pivots.end(), axis))
      hull.axes[taken++] = static_cast<int>(axis);
  }
  return hull;
}

}  // namespace delone::check_detail
