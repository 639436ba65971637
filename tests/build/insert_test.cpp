#include "delone/build/insert.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "delone/mesh/export.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

TEST(Insert, point_on_a_shared_edge_splits_both_triangles) {
  AnyTriangulation t = built(PointSet{"square", 2, {0, 0, 2, 0, 2, 2, 0, 2}, {}});
  EXPECT_EQ(insert(t, std::vector{1.0, 1.0}).outcome, Outcome::inserted);
  EXPECT_EQ(t.cell_count(), 4U);
  EXPECT_EQ(broken_invariant(t), "");
}

TEST(Insert, tells_row_and_outcome) {
  AnyTriangulation t = built(PointSet{"square", 2, {0, 0, 2, 0, 2, 2, 0, 2}, {0, 0, 0, 0}});
  const auto outcome = [&](std::vector<double> point, double weight) {
    const std::size_t rows = t.row_count();
    const Inserted inserted = insert(t, point, weight);
    EXPECT_EQ(inserted.row, rows);
    return inserted.outcome;
  };
  EXPECT_EQ(outcome({2, 2}, 0), Outcome::duplicate);
  EXPECT_EQ(outcome({2, 2}, -1), Outcome::hidden);
  EXPECT_EQ(outcome({1, 1}, -9), Outcome::hidden);
  EXPECT_EQ(outcome({1, 1}, 1), Outcome::inserted);
  EXPECT_EQ(outcome({2, 2}, 1), Outcome::inserted);  // hides row 2, and its duplicate with it
  EXPECT_EQ(t.status(2).status, Status::hidden);
  EXPECT_EQ(t.status(4).status, Status::hidden);
  EXPECT_EQ(outcome({1, 1}, 1000), Outcome::inserted);  // hides all but the corners that it cannot
}

TEST(Insert, one_by_one_from_nothing_equals_building) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    const std::size_t n = dimension < 4 ? 16 : 10;
    for (const PointSet& points :
         {uniform(dimension, n, 1), lattice(dimension, n, 3, 2), cospherical(dimension, n, 3), flat(dimension, 1, n, 4),
          flat(dimension, 2, n, 5), lattice(dimension, n, 2, 6), with_random_weights(uniform(dimension, n, 7), 8),
          with_random_weights(lattice(dimension, n, 2, 9), 10)}) {
      AnyTriangulation t(dimension, !points.weights.empty());
      for (std::size_t row = 0; row < n; ++row) {
        insert(t, points.view()[row], points.view().weight(row));
        ASSERT_EQ(description(t), description(built(rows(points, 0, row + 1)))) << points;
      }
    }
  }
}

TEST(Insert, in_batches_equals_building) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const PointSet& points : families(dimension, 12, 3)) {
      const std::string expected = description(built(points));
      for (const std::size_t first : {1U, 8U}) {
        AnyTriangulation t = built(rows(points, 0, first));
        insert(t, rows(points, first, 12).view());
        ASSERT_EQ(description(t), expected) << points << " from " << first;
      }
    }
  }
}

TEST(Insert, an_empty_batch_changes_nothing) {
  AnyTriangulation t = built(uniform(2, 9, 1));
  const std::string before = description(t);
  insert(t, PointsView({}, 2));
  EXPECT_EQ(description(t), before);
}

TEST(Insert, the_cell_to_start_from_does_not_show) {
  const PointSet points = lattice(3, 40, 4, 1);
  AnyTriangulation expected = built(points);
  const std::vector<double> q{1.5, 1.25, 2.0};
  const AnyTriangulation before = expected;
  insert(expected, q);
  for (std::size_t s = 0; s < before.complex().slot_count(); ++s) {
    const CellId near{static_cast<Index>(s)};
    if (!before.complex().is_live(near)) continue;
    AnyTriangulation t = before;
    insert(t, q, 0.0, {.near = near});
    ASSERT_EQ(description(t), description(expected));
  }
}

TEST(Insert, an_edit_names_what_went_and_what_came) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    AnyTriangulation t = built(lattice(dimension, 30, 3, 1));
    const PointSet more = lattice(dimension, 30, 5, 2);
    for (std::size_t row = 0; row < more.size(); ++row) {
      std::set<Index> live;
      for (std::size_t s = 0; s < t.complex().slot_count(); ++s) {
        if (t.complex().is_live(CellId{static_cast<Index>(s)})) live.insert(static_cast<Index>(s));
      }
      bool heard = false;
      const auto listen = [&](const Edit& edit) {
        heard = true;
        if (edit.rebuilt) return;
        for (const CellId c : edit.removed) EXPECT_EQ(live.erase(raw(c)), 1U);
        for (const CellId c : edit.created) {
          EXPECT_TRUE(live.insert(raw(c)).second);
          EXPECT_TRUE(t.complex().is_live(c));
        }
        EXPECT_EQ(live.size(), t.complex().live_count());
        EXPECT_EQ(edit.created.size(), t.star(edit.came.front()).size());
      };
      const Inserted inserted = insert(t, more.view()[row], 0.0, {.on_edit = listen});
      EXPECT_EQ(heard, inserted.outcome == Outcome::inserted);
    }
  }
}

TEST(Insert, a_point_off_the_flat_raises_the_dimension) {
  AnyTriangulation t(4);
  PointSet points{"simplex", 4, {}, {}};
  for (int i = 0; i <= 4; ++i) {
    std::vector<double> x(4, 0.0);
    if (i > 0) x[static_cast<std::size_t>(i) - 1] = 1.0;
    bool rebuilt = false;
    insert(t, x, 0.0, {.on_edit = [&](const Edit& edit) { rebuilt = edit.rebuilt; }});
    EXPECT_TRUE(rebuilt);
    EXPECT_EQ(t.affine_dimension(), i);
    EXPECT_EQ(t.cell_count(), 1U);
  }
}

}  // namespace
}  // namespace delone
