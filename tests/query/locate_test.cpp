#include "delone/query/locate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "exact/integer.hpp"
#include "query/queries.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;
using exact::BigInt;
using Row = std::vector<BigInt>;

BigInt determinant(std::vector<Row> m) {
  const std::size_t n = m.size();
  BigInt previous = 1;
  BigInt sign = 1;
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t pivot = step;
    while (pivot < n && m[pivot][step] == 0) ++pivot;
    if (pivot == n) return 0;
    if (pivot != step) sign = -sign;
    std::swap(m[pivot], m[step]);
    for (std::size_t i = step + 1; i < n; ++i) {
      for (std::size_t j = step + 1; j < n; ++j) {
        m[i][j] = (m[i][j] * m[step][step] - m[i][step] * m[step][j]) / previous;
      }
    }
    previous = m[step][step];
  }
  return sign * previous;
}

/// Looks at every cell with integers of any size: the rows of the face that has q in its relative interior, or none.
class BruteForce {
 public:
  BruteForce(const AnyTriangulation& t, const PointSet& points, std::span<const double> q)
      : t_(&t), points_(&points), q_(q) {
    for (const auto& numbers : {std::span<const double>(points.coordinates), q}) {
      for (const double x : numbers) exact::lower_unit(unit_, exact::decompose(x));
    }
  }

  std::vector<Index> face() const {
    for (const std::vector<Index>& cell : sorted_cells(*t_)) {
      std::vector<Index> face;
      if (holds_query(cell, face)) return face;
    }
    return {};
  }

 private:
  BigInt coordinate(Index row, std::size_t axis) const {
    const double x = row == kNone ? q_[axis] : points_->view()[row][axis];
    return exact::to_integer<BigInt>(exact::decompose(x), unit_);
  }

  /// On the axes that span the flat.
  BigInt volume(const std::vector<Index>& rows) const {
    std::vector<Row> m;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      Row row;
      for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
        const auto axis = static_cast<std::size_t>(t_->sites().flat().axes[j]);
        row.push_back(coordinate(rows[i], axis) - coordinate(rows[0], axis));
      }
      m.push_back(std::move(row));
    }
    return determinant(std::move(m));
  }

  bool holds_query(const std::vector<Index>& cell, std::vector<Index>& face) const {
    const BigInt whole = volume(cell);
    std::vector<BigInt> parts;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      std::vector<Index> with_query = cell;
      with_query[i] = kNone;
      parts.push_back(cell.size() == 1 ? BigInt(1) : volume(with_query));
      if (parts.back() * whole < 0) return false;
      if (parts.back() != 0) face.push_back(cell[i]);
    }
    // q is that combination of the corners, on all axes: what tells whether it lies on the flat.
    for (std::size_t axis = 0; axis < q_.size(); ++axis) {
      BigInt sum = 0;
      for (std::size_t i = 0; i < cell.size(); ++i) sum += parts[i] * coordinate(cell[i], axis);
      if (sum != whole * coordinate(kNone, axis)) return false;
    }
    return true;
  }

  const AnyTriangulation* t_;
  const PointSet* points_;
  std::span<const double> q_;
  int unit_ = 0;
};

std::vector<Index> rows_of(const Location& location) { return {location.rows().begin(), location.rows().end()}; }

Place expected_place(const AnyTriangulation& t, const std::vector<Index>& face) {
  if (face.empty()) return Place::outside;
  if (face.size() == 1) return Place::vertex;
  return static_cast<int>(face.size()) == t.affine_dimension() + 1 ? Place::cell : Place::face;
}

/// The cell has the face; outside it is a ghost, or there is none off the flat.
void expect_cell_fits(const AnyTriangulation& t, const Location& location) {
  if (location.cell == kNoCell) {
    EXPECT_EQ(location.place, Place::outside);
    EXPECT_LT(t.affine_dimension(), t.dimension());
    return;
  }
  ASSERT_TRUE(t.complex().is_live(location.cell));
  EXPECT_EQ(t.complex().is_ghost(location.cell), location.place == Place::outside);
  for (const Index row : location.rows()) {
    bool found = false;
    for (int i = 0; i < t.complex().corners(); ++i) found |= t.row(t.complex().vertex(location.cell, i)) == row;
    EXPECT_TRUE(found);
  }
}

void expect_brute_force_agrees(const PointSet& points, std::uint64_t seed) {
  const AnyTriangulation t = built(points);
  const PointSet queries = queries_around(points, seed);
  Random random(seed);
  const auto batch = locate(t, queries.view());
  const auto shared = locate(t, queries.view(), {.threads = 3});
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto q = queries.view()[i];
    const std::vector<Index> face = BruteForce(t, points, q).face();
    for (const Location& found : {locate(t, q), locate(t, q, any_live_cell(t, random)), batch[i], shared[i]}) {
      ASSERT_EQ(rows_of(found), face) << points << "\nquery " << i << " of " << queries;
      ASSERT_EQ(found.place, expected_place(t, face));
      ASSERT_EQ(found.face_dimension(), static_cast<int>(face.size()) - 1);
      expect_cell_fits(t, found);
    }
    ASSERT_EQ(batch[i].cell, shared[i].cell);
  }
}

TEST(LocateQuery, agrees_with_exact_brute_force_on_every_family) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    for (const PointSet& points : families(dimension, dimension <= 3 ? 10 : 6, 3)) expect_brute_force_agrees(points, 8);
  }
}

TEST(LocateQuery, few_points_or_none) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (std::size_t n = 1; n <= 4; ++n) expect_brute_force_agrees(lattice(dimension, n, 2, n), 3);
  }
  const std::vector<double> q{1, 2};
  const Location nowhere = locate(AnyTriangulation(2), q);
  EXPECT_EQ(nowhere.place, Place::outside);
  EXPECT_EQ(nowhere.cell, kNoCell);
}

TEST(LocateQuery, tells_faces_of_every_dimension) {
  const PointSet corners{"tetrahedron", 3, {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8}};
  const AnyTriangulation t = built(corners);
  const auto rows = [&](std::vector<double> q) { return rows_of(locate(t, q)); };
  EXPECT_EQ(rows({8, 0, 0}), (std::vector<Index>{1}));
  EXPECT_EQ(rows({0, 3, 0}), (std::vector<Index>{0, 2}));
  EXPECT_EQ(rows({1, 3, 4}), (std::vector<Index>{1, 2, 3}));
  EXPECT_EQ(rows({1, 1, 1}), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(rows({3, 3, std::nextafter(2.0, 3.0)}), (std::vector<Index>{}));
  EXPECT_EQ(locate(t, std::vector<double>{0, 3, 0}).place, Place::face);
  EXPECT_EQ(locate(t, std::vector<double>{1, 1, 1}).place, Place::cell);
}

TEST(LocateQuery, off_the_flat_is_outside) {
  const PointSet square{"square in space", 3, {0, 0, 1, 2, 0, 1, 0, 2, 1, 2, 2, 1}};
  const AnyTriangulation t = built(square);
  EXPECT_EQ(locate(t, std::vector<double>{1, 0.5, 1}).place, Place::cell);
  EXPECT_EQ(locate(t, std::vector<double>{1, 0.5, std::nextafter(1.0, 2.0)}).place, Place::outside);
  EXPECT_EQ(locate(t, std::vector<double>{1, 0.5, std::nextafter(1.0, 2.0)}).cell, kNoCell);
  EXPECT_NE(locate(t, std::vector<double>{-1, 0.5, 1}).cell, kNoCell);
}

TEST(LocateQuery, bad_queries_are_refused) {
  const AnyTriangulation t = built(uniform(2, 10, 1));
  EXPECT_THROW(locate(t, std::vector<double>{1}), InputError);
  EXPECT_THROW(locate(t, std::vector<double>{1, std::nan("")}), InputError);
  EXPECT_THROW(locate(t, PointsView(std::vector<double>{1, 2, 3}, 3)), InputError);
}

}  // namespace
}  // namespace delone
