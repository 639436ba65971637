#include "delone/build/build.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/build/insert.hpp"
#include "delone/mesh/export.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"
#include "support/float_modes.hpp"

namespace delone {
namespace {

using namespace test;

TEST(Build, zero_one_and_two_points_work_in_every_dimension) {
  for (int dimension = 1; dimension <= kMaxDimension; ++dimension) {
    EXPECT_EQ(build(PointsView({}, dimension)).affine_dimension(), -1);
    const PointSet one = uniform(dimension, 1, 1);
    EXPECT_EQ(built(one).affine_dimension(), 0);
    EXPECT_EQ(built(one).cell_count(), 1U);
    EXPECT_EQ(built(one).hull_facet_count(), 0U);
    const PointSet two = uniform(dimension, 2, 1);
    EXPECT_EQ(built(two).affine_dimension(), 1);
    EXPECT_EQ(built(two).cell_count(), 1U);
    EXPECT_EQ(built(two).hull_facet_count(), 2U);
    EXPECT_EQ(fails_check(built(two), two), "");
  }
}

TEST(Build, one_simplex_works_in_every_dimension) {
  for (int dimension = 1; dimension <= kMaxDimension; ++dimension) {
    PointSet simplex{"simplex", dimension, {}, {}};
    simplex.coordinates.assign(static_cast<std::size_t>(dimension * (dimension + 1)), 0.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
      simplex.coordinates[(i + 1) * static_cast<std::size_t>(dimension) + i] = 1.0;
    }
    EXPECT_EQ(built(simplex).cell_count(), 1U);
    EXPECT_EQ(built(simplex).hull_facet_count(), static_cast<std::size_t>(dimension) + 1);
    EXPECT_EQ(broken_invariant(built(simplex)), "");
  }
}

TEST(Build, progress_runs_from_nothing_to_all_and_the_result_does_not_depend_on_it) {
  const PointSet points = uniform(2, 20000, 1);
  std::vector<double> shares;
  const auto t = build(points.view(), {.progress = [&](double done) {
                         shares.push_back(done);
                         return true;
                       }});
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_LE(shares.back(), 1.0);
  EXPECT_EQ(canonical_hash(t), canonical_hash(built(points)));
  EXPECT_THROW(build(points.view(), {.progress = [](double) { return false; }}), Cancelled);
}

TEST(Build, the_number_of_threads_does_not_show) {
  for (const int dimension : {2, 3}) {
    const PointSet points = lattice(dimension, 3000, 12, 1);
    const std::string one = description(build(points.view(), {.threads = 1}));
    EXPECT_EQ(description(build(points.view(), {.threads = 4})), one);
  }
}

TEST(Build, the_dimension_in_the_type_must_be_that_of_the_points) {
  const PointSet points = uniform(3, 5, 1);
  EXPECT_EQ(build<3>(points.view()).row_count(), 5U);
  EXPECT_THROW(build<2>(points.view()), InputError);
}

TEST(Build, statistics_count_what_was_done) {
  const PointSet points = uniform(2, 5000, 1);
  const AnyTriangulation t = built(points);
  const BuildStatistics& statistics = t.statistics();
  EXPECT_GT(statistics.predicates.conflict_filter, 5000U);
  EXPECT_EQ(statistics.predicates.conflict_symbolic, 0U);
  EXPECT_GE(statistics.cells_created, t.cell_count());
  EXPECT_LT(statistics.walk_steps, 20U * 5000);
  EXPECT_EQ(statistics.walk_fallbacks, 0U);
  EXPECT_GT(built(lattice(2, 500, 20, 1)).statistics().predicates.conflict_symbolic, 100U);
}

std::vector<PointSet> sensitive_to_rounding() {
  std::vector<PointSet> all;
  for (const int dimension : {2, 3, 4}) {
    for (PointSet& points : unweighted_families(dimension, 30, 1)) {
      if (dimension < 4 || points.name == "uniform") all.push_back(std::move(points));
    }
    all.push_back(with_random_weights(lattice(dimension, 30, 3, 2), 3));
  }
  return all;
}

TEST(Build, is_right_under_every_rounding_mode_and_restores_it) {
  for (const PointSet& points : sensitive_to_rounding()) {
    const std::string expected = description(built(points));
    const PointSet first = rows(points, 0, points.size() / 2);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::uint64_t hash = 0;
      AnyTriangulation whole(points.dimension), grown(points.dimension);
      {
        const Rounding rounding(mode);
        whole = built(points);
        EXPECT_EQ(std::fegetround(), mode);
        grown = built(first);
        for (std::size_t row = first.size(); row < points.size(); ++row) {
          insert(grown, points.view()[row], points.view().weight(row));
        }
        EXPECT_EQ(std::fegetround(), mode);
        hash = canonical_hash(whole);
      }
      EXPECT_EQ(description(whole), expected) << points;
      EXPECT_EQ(description(grown), expected) << points;
      EXPECT_EQ(hash, canonical_hash(whole));
    }
  }
}

TEST(Build, is_right_when_the_caller_flushes_denormals) {
  if (!can_flush_denormals()) GTEST_SKIP() << "no such mode on this machine";
  for (const PointSet& points : sensitive_to_rounding()) {
    const std::string expected = description(built(points));
    const FlushedDenormals flushed(Flush::both);
    const AnyTriangulation t = built(points);
    EXPECT_TRUE(denormals_are_flushed());
    const std::string seen = description(t);
    AnyTriangulation grown(points.dimension, !points.weights.empty());
    insert(grown, points.view());
    EXPECT_EQ(canonical_hash(grown), canonical_hash(t));
    EXPECT_EQ(fails_check(t, points), "");
    // Every question has the same answer, whatever the mode in which it is asked; only printing flushes.
    EXPECT_EQ(seen.substr(0, seen.find("points")), expected.substr(0, expected.find("points"))) << points;
  }
}

TEST(Build, points_of_one_place_leave_the_heaviest_and_of_equal_ones_the_lowest_row) {
  const PointSet plain{"twins", 2, {1, 1, 1, 1, 0, 0, 1, 1}, {}};
  EXPECT_EQ(built(plain).status(0), (RowStatus{Status::vertex, 0}));
  EXPECT_EQ(built(plain).status(1), (RowStatus{Status::duplicate, 0}));
  EXPECT_EQ(built(plain).status(3), (RowStatus{Status::duplicate, 0}));
  const PointSet weighted{"weighted twins", 2, {1, 1, 1, 1, 0, 0, 1, 1}, {1, 2, 0, 2}};
  EXPECT_EQ(built(weighted).status(0), (RowStatus{Status::hidden, 0}));
  EXPECT_EQ(built(weighted).status(1), (RowStatus{Status::vertex, 1}));
  EXPECT_EQ(built(weighted).status(3), (RowStatus{Status::duplicate, 1}));
  const PointSet negative_zero{"zeros", 1, {0.0, -0.0, 1.0}, {}};
  EXPECT_EQ(built(negative_zero).status(1), (RowStatus{Status::duplicate, 0}));
}

}  // namespace
}  // namespace delone
