#include "support/brute_force.hpp"

#include <algorithm>

#include "exact/integer.hpp"

namespace delone::test {
namespace {

using exact::BigInt;
using Row = std::vector<BigInt>;

/// Rows as integers over one power of two: coordinates over 2^unit, weights over 2^(2 unit).
struct Integers {
  std::vector<Row> x;
  std::vector<BigInt> weight;
};

Integers integers(PointsView points) {
  int unit = 0;
  for (const double x : points.coordinates()) unit = std::min(unit, exact::decompose(x).exponent);
  for (const double w : points.weights()) unit = std::min(unit, (exact::decompose(w).exponent - 1) / 2);
  Integers result;
  for (std::size_t row = 0; row < points.size(); ++row) {
    Row x;
    for (const double value : points[row]) x.push_back(exact::to_integer<BigInt>(exact::decompose(value), unit));
    result.x.push_back(std::move(x));
    result.weight.push_back(exact::to_integer<BigInt>(exact::decompose(points.weight(row)), 2 * unit));
  }
  return result;
}

/// The sign of a determinant by Bareiss' elimination, in which every division is exact.
int determinant_sign(std::vector<Row> m) {
  const std::size_t n = m.size();
  int parity = 1;
  BigInt previous = 1;
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t pivot = step;
    while (pivot < n && m[pivot][step] == 0) ++pivot;
    if (pivot == n) return 0;
    if (pivot != step) {
      std::swap(m[pivot], m[step]);
      parity = -parity;
    }
    for (std::size_t i = step + 1; i < n; ++i) {
      for (std::size_t j = step + 1; j < n; ++j) {
        m[i][j] = (m[i][j] * m[step][step] - m[i][step] * m[step][j]) / previous;
      }
    }
    previous = m[step][step];
  }
  return n == 0 ? 1 : parity * exact::sign(previous);
}

std::size_t rank(std::vector<Row> m) {
  std::size_t done = 0;
  const std::size_t columns = m.empty() ? 0 : m.front().size();
  for (std::size_t column = 0; column < columns && done < m.size(); ++column) {
    std::size_t pivot = done;
    while (pivot < m.size() && m[pivot][column] == 0) ++pivot;
    if (pivot == m.size()) continue;
    std::swap(m[pivot], m[done]);
    for (std::size_t i = done + 1; i < m.size(); ++i) {
      const BigInt factor = m[i][column];
      for (std::size_t j = 0; j < columns; ++j) m[i][j] = m[i][j] * m[done][column] - m[done][j] * factor;
    }
    ++done;
  }
  return done;
}

class Search {
 public:
  explicit Search(PointsView points) : points_(points), table_(integers(points)) { choose_axes(); }

  Truth run() {
    Truth truth;
    truth.affine_dimension = points_.empty() ? -1 : static_cast<int>(axes_.size());
    truth.status.assign(points_.size(), 2);
    truth.of.assign(points_.size(), kNone);
    if (points_.empty()) return truth;
    collect_candidates();
    std::vector<Index> cell;
    extend(cell, 0, truth.cells);
    std::sort(truth.cells.begin(), truth.cells.end());
    settle_rows(truth);
    return truth;
  }

 private:
  /// The first axis on which the points differ, the next one that adds to the rank, and so on.
  void choose_axes() {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(points_.dimension()); ++axis) {
      axes_.push_back(axis);
      std::vector<Row> differences;
      for (std::size_t row = 1; row < points_.size(); ++row) differences.push_back(difference(0, row));
      if (rank(differences) < axes_.size()) axes_.pop_back();
    }
  }

  Row difference(std::size_t from, std::size_t to) const {
    Row d;
    for (const std::size_t axis : axes_) d.push_back(table_.x[to][axis] - table_.x[from][axis]);
    return d;
  }

  BigInt height(std::size_t row) const {
    BigInt h = -table_.weight[row];
    for (const BigInt& x : table_.x[row]) h += x * x;
    return h;
  }

  /// Of several rows at one position only the heaviest can live, of equal ones the lowest.
  void collect_candidates() {
    for (std::size_t row = 0; row < points_.size(); ++row) {
      const bool beaten = std::any_of(table_.x.begin(), table_.x.end(), [&](const Row& x) {
        const auto other = static_cast<std::size_t>(&x - table_.x.data());
        const BigInt heavier = table_.weight[other] - table_.weight[row];
        return other != row && x == table_.x[row] && (heavier > 0 || (heavier == 0 && other < row));
      });
      if (!beaten) candidates_.push_back(static_cast<Index>(row));
    }
  }

  void extend(std::vector<Index>& cell, std::size_t next, std::vector<std::vector<Index>>& cells) const {
    if (cell.size() == axes_.size() + 1) {
      if (is_empty_cell(cell)) cells.push_back(cell);
      return;
    }
    for (std::size_t i = next; i < candidates_.size(); ++i) {
      cell.push_back(candidates_[i]);
      extend(cell, i + 1, cells);
      cell.pop_back();
    }
  }

  bool is_empty_cell(const std::vector<Index>& cell) const {
    const int volume = orient(cell);
    return volume != 0 && std::none_of(candidates_.begin(), candidates_.end(), [&](Index q) {
             return std::find(cell.begin(), cell.end(), q) == cell.end() && conflict(cell, volume, q);
           });
  }

  int orient(const std::vector<Index>& cell) const {
    std::vector<Row> m;
    for (std::size_t i = 1; i < cell.size(); ++i) m.push_back(difference(cell[0], cell[i]));
    return determinant_sign(std::move(m));
  }

  bool conflict(const std::vector<Index>& cell, int volume, Index q) const {
    std::vector<Row> m;
    for (std::size_t i = 1; i <= cell.size(); ++i) {
      const Index row = i < cell.size() ? cell[i] : q;
      m.push_back(difference(cell[0], row));
      m.back().push_back(height(row) - height(cell[0]));
    }
    const int above = determinant_sign(std::move(m)) * volume;
    return above == 0 ? tie(cell, volume, q) : above < 0;
  }

  bool tie(const std::vector<Index>& cell, int volume, Index q) const {
    std::vector<Index> order = cell;
    order.push_back(q);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return table_.x[a] < table_.x[b]; });
    for (const Index v : order) {
      if (v == q) return true;
      std::vector<Index> replaced = cell;
      std::replace(replaced.begin(), replaced.end(), v, q);
      const int barycentric = orient(replaced) * volume;
      if (barycentric != 0) return barycentric < 0;
    }
    return true;  // never reached: q is among the points
  }

  void settle_rows(Truth& truth) const {
    for (const auto& cell : truth.cells) {
      for (const Index v : cell) {
        truth.status[v] = 0;
        truth.of[v] = v;
      }
    }
    for (std::size_t row = 0; row < points_.size(); ++row) {
      for (const Index v : candidates_) {
        if (v == row || truth.status[v] != 0) continue;
        if (table_.x[v] != table_.x[row] || table_.weight[v] != table_.weight[row]) continue;
        truth.status[row] = 1;
        truth.of[row] = v;
      }
    }
  }

  PointsView points_;
  Integers table_;
  std::vector<std::size_t> axes_;
  std::vector<Index> candidates_;
};

}  // namespace

Truth brute_force(PointsView points) { return Search(points).run(); }

}  // namespace delone::test
