#include "delone/remove/remove.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/mesh/export.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"
#include "support/ledger.hpp"

namespace delone {
namespace {

using namespace test;

Ledger ledger_of(const PointSet& points) {
  Ledger ledger{points.dimension, !points.weights.empty(), {}};
  for (std::size_t row = 0; row < points.size(); ++row) {
    const auto point = points.view()[row];
    ledger.rows.push_back(Ledger::Entry{{point.begin(), point.end()}, points.view().weight(row)});
  }
  return ledger;
}

/// Removes all rows in random order, and looks after each.
void empty_out(const PointSet& points, std::uint64_t seed) {
  SCOPED_TRACE(points.name);
  Random random(seed);
  AnyTriangulation t = built(points);
  Ledger ledger = ledger_of(points);
  for (const std::size_t row : random_permutation(points.size(), random)) {
    const Status was = t.status(static_cast<Index>(row)).status;
    const Removed removed = remove(t, static_cast<Index>(row));
    EXPECT_EQ(removed.was, was);
    ledger.rows[row].reset();
    ASSERT_EQ(differs_from_building(t, ledger), "") << "after the removal of row " << row;
  }
  EXPECT_EQ(t.affine_dimension(), -1);
  const Inserted back = insert(t, points.view()[0], points.view().weight(0));
  EXPECT_EQ(back.row, points.size());
  EXPECT_EQ(t.vertex_count(), 1U);
}

TEST(Remove, down_to_nothing_every_step_is_as_building_from_the_rest) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : families(dimension, dimension < 4 ? 24 : 14, 7)) empty_out(points, 1);
  }
}

TEST(RemoveSlow, the_same_in_dimensions_five_to_eight) {
  for (int dimension = 5; dimension <= 8; ++dimension) {
    for (const PointSet& points : families(dimension, dimension < 7 ? 9 : 11, 8)) empty_out(points, 2);
  }
}

TEST(RemoveSlow, the_same_with_larger_sets_whose_links_are_triangulated) {
  for (int dimension = 2; dimension <= 3; ++dimension) {
    for (const PointSet& points : families(dimension, 44, 9)) empty_out(points, 3);
  }
}

/// n points of a circle whose squared radius is 5^2k, exactly, or as near as doubles come, and its centre as the last.
PointSet hub(std::size_t n) {
  PointSet points{"hub", 2, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    points.coordinates.push_back(std::cos(angle));
    points.coordinates.push_back(std::sin(angle));
  }
  for (const double x : {0.0, 0.0, 5.0, 5.0}) points.coordinates.push_back(x);
  return points;
}

TEST(Remove, the_centre_of_a_circle_goes_without_a_test_of_all_pairs) {
  constexpr std::size_t kSites = 20000;
  const PointSet points = hub(kSites);
  AnyTriangulation t = built(points);
  const auto tests = [&] {
    const PredicateStats& stats = t.statistics().predicates;
    return stats.conflict_filter + stats.conflict_adaptive + stats.conflict_exact + stats.conflict_symbolic;
  };
  const auto before = tests();
  remove(t, static_cast<Index>(kSites));
  EXPECT_LT(tests() - before, 40 * kSites);
  PointSet rest = points;
  rest.coordinates.erase(rest.coordinates.end() - 4, rest.coordinates.end() - 2);
  EXPECT_EQ(canonical_hash(t), canonical_hash(built(rest)));
}

TEST(Remove, the_lowest_duplicate_takes_over_and_no_cell_changes) {
  AnyTriangulation t = built({"square", 2, {0, 0, 4, 0, 0, 4, 1, 1, 1, 1, 1, 1}, {}});
  const auto cells_before = t.complex().live_count();
  std::size_t heard = 0;
  const Removed removed = remove(t, 3, {.on_edit = [&](const Edit&) { ++heard; }});
  EXPECT_EQ(removed.was, Status::vertex);
  EXPECT_EQ(removed.heir, 4U);
  EXPECT_EQ(heard, 0U);
  EXPECT_EQ(t.complex().live_count(), cells_before);
  EXPECT_EQ(t.status(4), (RowStatus{Status::vertex, 4}));
  EXPECT_EQ(t.status(5), (RowStatus{Status::duplicate, 4}));
  EXPECT_EQ(remove(t, 5).was, Status::duplicate);
  EXPECT_EQ(t.duplicate_count(), 0U);
}

TEST(Remove, hidden_points_come_back_when_what_hid_them_goes) {
  AnyTriangulation t = built({"weights", 2, {0, 0, 9, 0, 0, 9, 3, 3, 3.5, 3, 3, 3.5, 50, 50}, {0, 0, 0, 20, 0, 0, 0}});
  ASSERT_EQ(t.hidden_count(), 2U);
  std::vector<VertexId> came;
  remove(t, 3, {.on_edit = [&](const Edit& edit) { came.assign(edit.came.begin(), edit.came.end()); }});
  EXPECT_EQ(t.hidden_count(), 0U);
  EXPECT_EQ(came.size(), 2U);
}

TEST(Remove, listeners_hear_of_every_vertex_and_cell) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const PointSet& points : families(dimension, 30, 11)) {
      SCOPED_TRACE(points.name);
      AnyTriangulation t = built(points);
      std::vector<bool> vertices, cells;
      const auto look = [&] {
        vertices.assign(t.sites().size(), false);
        cells.assign(t.complex().slot_count() + 1, false);
        for (std::size_t v = 0; v < vertices.size(); ++v)
          vertices[v] = t.complex().incident_cell(VertexId{static_cast<Index>(v)}) != kNoCell;
        for (std::size_t c = 0; c + 1 < cells.size(); ++c)
          cells[c] = t.complex().is_live(CellId{static_cast<Index>(c)});
      };
      look();
      const auto listen = [&](const Edit& edit) {
        if (edit.rebuilt) return look();
        for (const VertexId v : edit.gone) vertices[raw(v)] = false;
        for (const VertexId v : edit.came) vertices[raw(v)] = true;
        for (const CellId c : edit.removed) cells[raw(c)] = false;
        cells.resize(std::max(cells.size(), t.complex().slot_count() + 1), false);
        for (const CellId c : edit.created) cells[raw(c)] = true;
      };
      for (std::size_t row = 0; row + 1 < points.size(); ++row) {
        remove(t, static_cast<Index>(row), {.on_edit = listen});
        const auto heard_vertices = vertices;
        const auto heard_cells = cells;
        look();
        ASSERT_EQ(heard_vertices, vertices) << row;
        ASSERT_EQ(std::count(heard_cells.begin(), heard_cells.end(), true),
                  std::count(cells.begin(), cells.end(), true));
      }
    }
  }
}

TEST(Remove, a_batch_is_as_one_after_the_other) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const PointSet& points : families(dimension, 40, 12)) {
      for (const std::size_t stride : {2, 5}) {
        SCOPED_TRACE(points.name);
        AnyTriangulation t = built(points);
        Ledger ledger = ledger_of(points);
        std::vector<Index> rows;
        for (std::size_t row = 1; row < points.size(); row += stride) {
          rows.push_back(static_cast<Index>(row));
          ledger.rows[row].reset();
        }
        std::ranges::reverse(rows);
        remove(t, rows);
        ASSERT_EQ(differs_from_building(t, ledger), "");
      }
    }
  }
}

TEST(Remove, batches_that_come_and_go_do_not_pile_up) {
  AnyTriangulation t = built(uniform(2, 300, 1));
  for (int round = 0; round < 20; ++round) {
    std::vector<Index> rows = t.present_rows();
    rows.resize(100);
    remove(t, rows);
    insert(t, uniform(2, 100, static_cast<std::uint64_t>(round) + 2).view());
  }
  EXPECT_EQ(t.sites().present_count(), 300U);
  EXPECT_LT(t.sites().size(), 1000U);
  EXPECT_EQ(t.row_count(), 2300U);
}

TEST(Remove, rows_that_are_not_there_are_refused) {
  AnyTriangulation t = built(uniform(2, 9, 1));
  const std::string before = description(t);
  const auto complaint = [&](const auto& call) -> std::string {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint([&] { remove(t, 9); }), "row 9: there are only 9 rows");
  EXPECT_EQ(complaint([&] { remove(t, std::vector<Index>{1, 2, 1}); }), "row 1: it is to be removed twice");
  EXPECT_EQ(description(t), before);
  remove(t, 4);
  EXPECT_EQ(complaint([&] { remove(t, 4); }), "row 4: it was removed before");
  EXPECT_EQ(complaint([&] { remove(t, std::vector<Index>{1, 4}); }), "row 4: it was removed before");
  EXPECT_TRUE(std::isnan(t.coordinates()[8]));
}

TEST(Remove, a_cancelled_batch_changes_nothing) {
  AnyTriangulation t = built(uniform(2, 500, 1));
  const std::string before = description(t);
  const std::vector<Index> rows{1, 2, 3};
  EXPECT_THROW(remove(t, rows, [](double) { return false; }), Cancelled);
  EXPECT_EQ(description(t), before);
}

}  // namespace
}  // namespace delone
