#include "mesh/in_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/export.hpp"
#include "delone/remove/remove.hpp"
#include "mesh/incremental.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// Inserts rows in their order, those that span all first, and from site `first` on by several threads in one round.
AnyTriangulation built_in_parts(const PointSet& points, std::size_t first, int threads, std::size_t few) {
  const AffineHull hull = affine_hull(points.view());
  const auto basis = std::span(hull.basis).first(static_cast<std::size_t>(hull.flat.dimension) + 1);
  std::vector<Index> order(basis.begin(), basis.end());
  for (Index row = 0; row < points.size(); ++row) {
    if (std::ranges::find(basis, row) == basis.end()) order.push_back(row);
  }
  Mesh mesh(Sites(points.dimension, !points.weights.empty(), hull.flat));
  mesh.sites.append(points.view(), order, 0);
  insert_first(mesh, first, {});
  insert_rounds(mesh, first, std::array{points.size()}, threads, {}, few);
  return AnyTriangulation(std::move(mesh));
}

TEST(InParts, every_family_is_as_by_one_thread) {
  std::uint64_t put_off = 0;
  std::uint64_t in_turn = 0;
  std::uint64_t all = 0;
  for (const int dimension : {2, 3, 4}) {
    for (const PointSet& points : families(dimension, dimension < 4 ? 120 : 40, 1)) {
      for (const int threads : {2, 5}) {
        const AnyTriangulation t = built_in_parts(points, points.size() / 4, threads, 3);
        EXPECT_EQ(broken_invariant(t), "") << points.name;
        EXPECT_EQ(canonical_hash(t), canonical_hash(build(points.view()))) << points.name;
        put_off += t.statistics().put_off;
        in_turn += t.statistics().in_turn;
        all += points.size();
      }
    }
  }
  EXPECT_GT(put_off, all / 10);
  EXPECT_LT(in_turn, all + put_off);  // as many were tried
}

TEST(InParts, no_slot_is_left_over) {
  for (const int threads : {2, 64}) {
    const AnyTriangulation t = build(with_random_weights(uniform(3, 30000, 1), 2).view(), {.threads = threads});
    const std::size_t dead = t.complex().slot_count() - t.complex().live_count();
    EXPECT_LT(dead, 500U) << threads;  // of what one thread inserted at the end
  }
}

TEST(InParts, any_number_of_threads_makes_the_same) {
  for (const PointSet& points : {uniform(3, 30000, 1), with_random_weights(uniform(3, 30000, 2), 3),
                                 lattice(3, 30000, 40, 4), with_random_weights(uniform(2, 30000, 2), 3)}) {
    const std::uint64_t hash = canonical_hash(build(points.view()));
    for (const int threads : {2, 3, 64}) {
      const AnyTriangulation t = build(points.view(), {.threads = threads});
      EXPECT_EQ(broken_invariant(t), "") << points.name;
      EXPECT_EQ(canonical_hash(t), hash) << points.name << ", " << threads << " threads";
      EXPECT_GT(t.statistics().put_off, 0U) << points.name;
      EXPECT_LT(t.statistics().in_turn, points.size() * 9 / 10) << points.name;
    }
  }
}

TEST(InParts, the_numbers_of_cells_depend_on_the_number_of_threads_only) {
  for (const PointSet& points : {uniform(3, 20000, 1), uniform(4, 4000, 1)}) {
    const int dimension = points.dimension;
    const AnyTriangulation once = built_in_parts(points, points.size() / 4, 3, 256);
    const AnyTriangulation again = built_in_parts(points, points.size() / 4, 3, 256);
    EXPECT_EQ(canonical_hash(once), canonical_hash(build(points.view()))) << points.name;
    EXPECT_GT(once.statistics().put_off, 0U) << points.name;
    EXPECT_LT(once.statistics().put_off, points.size()) << points.name;
    EXPECT_EQ(once.statistics().put_off, again.statistics().put_off) << points.name;
    ASSERT_EQ(once.complex().slot_count(), again.complex().slot_count());
    for (std::size_t slot = 0; slot < once.complex().slot_count(); ++slot) {
      const CellId c{static_cast<Index>(slot)};
      ASSERT_EQ(once.complex().is_live(c), again.complex().is_live(c));
      for (int i = 0; i <= dimension && once.complex().is_live(c); ++i)
        ASSERT_EQ(once.complex().vertex(c, i), again.complex().vertex(c, i));
      for (int i = 0; i <= dimension && once.complex().is_live(c); ++i)
        ASSERT_EQ(once.complex().twin(c, i), again.complex().twin(c, i));
    }
  }
}

TEST(InParts, points_on_a_sphere_are_shared_too) {
  PointSet points = uniform(3, 20000, 1);
  for (double& x : points.coordinates) x -= 0.5;
  for (std::size_t i = 0; i < points.coordinates.size(); i += 3) {
    const auto x = std::span(points.coordinates).subspan(i, 3);
    const double length = std::hypot(x[0], x[1], x[2]);
    for (double& c : x) c /= length;
  }
  const AnyTriangulation t = build(points.view(), {.threads = 2});
  EXPECT_EQ(canonical_hash(t), canonical_hash(build(points.view())));
  EXPECT_LT(t.statistics().in_turn, points.size() * 3 / 4);
}

TEST(InParts, what_finds_no_cell_in_its_part_is_inserted_all_the_same) {
  // Few cells are there before, and each site needs many more than these had.
  PointSet points = uniform(3, 1100, 1);
  for (int i = 0; i < 1500; ++i) {
    const double t = 2.0 + i / 1500.0;
    for (const double x : {t, t * t, t * t * t}) points.coordinates.push_back(x);
  }
  const AnyTriangulation t = built_in_parts(points, 1100, 2, 500);
  EXPECT_GT(t.statistics().put_off, 500U);
  EXPECT_EQ(broken_invariant(t), "");
  EXPECT_EQ(canonical_hash(t), canonical_hash(build(points.view())));
}

TEST(InParts, batches_are_shared_too) {
  for (const PointSet& points : {uniform(3, 30000, 1), with_random_weights(uniform(3, 30000, 2), 3)}) {
    AnyTriangulation t = build(rows(points, 0, 20000).view());
    insert(t, rows(points, 20000, 30000).view(), {.threads = 3});
    EXPECT_GT(t.statistics().put_off, 0U);
    EXPECT_EQ(broken_invariant(t), "") << points.name;
    EXPECT_EQ(canonical_hash(t), canonical_hash(build(points.view())));
  }
}

TEST(InParts, batches_are_shared_in_every_dimension_after_removals_too) {
  for (const int dimension : {2, 3, 4, 5}) {
    const std::size_t n = dimension < 4 ? 24000 : (dimension == 4 ? 6000 : 3600);
    for (const PointSet& points : {uniform(dimension, n, 1), with_random_weights(uniform(dimension, n, 2), 3)}) {
      AnyTriangulation t = build(rows(points, 0, n / 3 * 2).view());
      std::vector<Index> gone;
      for (Index row = 0; row < n / 4; row += 5) gone.push_back(row);
      remove(t, gone);
      insert(t, rows(points, n / 3 * 2, n).view(), {.threads = 3});
      EXPECT_EQ(broken_invariant(t), "") << points.name << dimension;
      PointSet left = rows(points, n / 4, n);
      for (Index row = 0; row < n / 4; ++row) {
        if (row % 5 == 0) continue;
        const auto x = points.view()[row];
        left.coordinates.insert(left.coordinates.end(), x.begin(), x.end());
        if (!left.weights.empty()) left.weights.push_back(points.weights[row]);
      }
      EXPECT_EQ(canonical_hash(t), canonical_hash(build(left.view()))) << points.name << dimension;
      if (points.weights.empty()) {  // with weights whoever was hidden is known by now, and kept so by one thread
        EXPECT_GT(t.statistics().put_off, 0U) << points.name << dimension;
      }
    }
  }
}

TEST(InParts, repeated_rows_are_named_as_ever) {
  PointSet points = uniform(3, 40000, 1);
  points.coordinates.insert(points.coordinates.end(), points.coordinates.begin(), points.coordinates.end());
  const AnyTriangulation t = build(points.view(), {.threads = 2});
  EXPECT_EQ(t.duplicate_count(), 40000U);
  EXPECT_EQ(t.status(40007), (RowStatus{Status::duplicate, 7}));
  EXPECT_EQ(description(t), description(build(points.view())));
}

TEST(InParts, heavy_sites_hide_others_across_sides_of_boxes) {
  PointSet points = uniform(3, 12000, 1);
  points.weights.assign(points.size(), 0.0);
  for (std::size_t row = 0; row < points.size(); row += 50) points.weights[row] = 0.01;
  const AnyTriangulation t = build(points.view(), {.threads = 4});
  EXPECT_GT(t.hidden_count(), 1000U);
  EXPECT_EQ(broken_invariant(t), "");
  EXPECT_EQ(description(t), description(build(points.view())));
}

TEST(InParts, all_points_in_one_place_but_a_few) {
  PointSet points = uniform(3, 100, 1);
  for (int i = 0; i < 20000; ++i) points.coordinates.insert(points.coordinates.end(), {0.5, 0.25, 0.125});
  EXPECT_EQ(description(build(points.view(), {.threads = 3})), description(build(points.view())));
}

TEST(InParts, a_caller_may_cancel_all_threads) {
  const PointSet points = uniform(3, 70000, 1);
  EXPECT_THROW(build(points.view(), {.threads = 2, .progress = [](double done) { return done < 0.3; }}), Cancelled);
}

TEST(InParts, what_a_caller_throws_arrives) {
  struct Mine {};
  const PointSet points = uniform(3, 70000, 1);
  const Progress progress = [](double done) { return done < 0.3 ? true : throw Mine(); };
  for (int i = 0; i < 5; ++i) EXPECT_THROW(build(points.view(), {.threads = 3, .progress = progress}), Mine);
}

TEST(InParts, boxes_may_grow_in_number_from_round_to_round) {
  const PointSet points = uniform(3, 70000, 1);
  const AnyTriangulation t = build(points.view(), {.threads = 64});
  EXPECT_EQ(broken_invariant(t), "");
  EXPECT_EQ(canonical_hash(t), canonical_hash(build(points.view())));
  EXPECT_LT(t.statistics().in_turn, points.size() / 2);
}

TEST(InParts, progress_stays_below_one_where_boxes_differ) {
  PointSet points = uniform(3, 2000, 1);
  for (int i = 0; i < 20000; ++i) points.coordinates.insert(points.coordinates.end(), {0.5, 0.25, 0.125});
  for (const int threads : {2, 3}) {
    build(points.view(), {.threads = threads, .progress = [](double done) {
                            EXPECT_LE(done, 1.0);
                            return true;
                          }});
  }
}

TEST(InParts, progress_rises) {
  const PointSet points = uniform(3, 70000, 1);
  double last = 0.0;
  int calls = 0;
  build(points.view(), {.threads = 2, .progress = [&](double done) {
                          EXPECT_GE(done, last);
                          EXPECT_LE(done, 1.0);
                          last = done;
                          ++calls;
                          return true;
                        }});
  EXPECT_GT(calls, 20);
  EXPECT_GT(last, 0.8);
}

}  // namespace
}  // namespace delone
