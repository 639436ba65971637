// Memory may run out at any allocation, and the caller may cancel at any tick: the object is as it was, and usable.
#include <gtest/gtest.h>

#include <cstddef>
#include <new>
#include <sstream>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/build/insert.hpp"
#include "delone/mesh/archive.hpp"
#include "delone/remove/move.hpp"
#include "delone/remove/remove.hpp"
#include "memory/failing_allocator.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// Calls `change` on copies of `before`, with the first allocation failing, then the second, ... until none fails.
/// @return how many failed
template <class Change>
std::size_t fail_every_allocation(const AnyTriangulation& before, const Change& change) {
  const std::string as_it_was = description(before);
  AnyTriangulation after = before;
  change(after);
  const std::string as_it_should_be = description(after);
  AnyTriangulation t = before;  // the same object all the time: what one failure spoils, the next calls show
  for (std::size_t allowed = 0;; ++allowed) {
    bool thrown = false;
    bool happened = false;
    {
      const FailingAllocation failing(allowed);
      try {
        change(t);
      } catch (const std::bad_alloc&) {
        thrown = true;
      }
      happened = failing.happened();
    }
    EXPECT_TRUE(thrown || !happened || description(t) == as_it_should_be);
    if (!thrown) {
      EXPECT_EQ(description(t), as_it_should_be);
      EXPECT_EQ(broken_invariant(t), "");
      return allowed;
    }
    if (description(t) != as_it_was) {
      ADD_FAILURE() << "changed by the failure of allocation " << allowed;
      return allowed;
    }
    EXPECT_EQ(broken_invariant(t), "");
    if (allowed % 8 == 0) {
      AnyTriangulation usable = t;
      change(usable);
      EXPECT_EQ(description(usable), as_it_should_be) << "after the failure of allocation " << allowed;
    }
  }
}

std::vector<PointSet> some_families(int dimension) {
  std::vector<PointSet> some{uniform(dimension, 24, 1), lattice(dimension, 24, 3, 2), flat(dimension, 1, 12, 3),
                             lattice(dimension, 24, 2, 4), cospherical(dimension, 24, 5)};
  some.push_back(with_random_weights(some[0], 6));
  some.push_back(with_random_weights(some[1], 7));
  return some;
}

TEST(Allocation, building_survives_the_failure_of_each) {
  std::size_t failures = 0;
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : some_families(dimension)) {
      SCOPED_TRACE(points.name);
      const AnyTriangulation before(dimension, !points.weights.empty());
      failures += fail_every_allocation(before, [&](AnyTriangulation& t) { t = build(points.view()); });
    }
  }
  EXPECT_GT(failures, 500U);
}

TEST(Allocation, inserting_a_point_survives_the_failure_of_each) {
  std::size_t failures = 0;
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : some_families(dimension)) {
      SCOPED_TRACE(points.name);
      AnyTriangulation t(dimension, !points.weights.empty());
      for (std::size_t row = 0; row < points.size(); ++row) {
        const auto change = [&](AnyTriangulation& changed) {
          insert(changed, points.view()[row], points.view().weight(row));
        };
        failures += fail_every_allocation(t, change);
        change(t);
      }
      EXPECT_EQ(description(t), description(built(points)));
    }
  }
  EXPECT_GT(failures, 1000U);
}

TEST(Allocation, inserting_a_point_that_somebody_listens_to_survives_the_failure_of_each) {
  std::size_t failures = 0;
  for (const PointSet& points : some_families(3)) {
    SCOPED_TRACE(points.name);
    AnyTriangulation t(3, !points.weights.empty());
    std::size_t heard = 0;
    InsertOptions options;
    options.on_edit = [&heard](const Edit& edit) { heard += edit.removed.size() + edit.created.size(); };
    for (std::size_t row = 0; row < points.size(); ++row) {
      const auto change = [&](AnyTriangulation& changed) {
        insert(changed, points.view()[row], points.view().weight(row), options);
      };
      failures += fail_every_allocation(t, change);
      change(t);
    }
    EXPECT_TRUE(heard > 0 || t.affine_dimension() < 3);
  }
  EXPECT_GT(failures, 200U);
}

TEST(Allocation, inserting_a_batch_survives_the_failure_of_each) {
  std::size_t failures = 0;
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : some_families(dimension)) {
      SCOPED_TRACE(points.name);
      const std::size_t n = points.size();
      for (const std::size_t first : {std::size_t{0}, n / 4, n - 4}) {
        const PointSet batch = rows(points, first, n);
        AnyTriangulation before(dimension, !points.weights.empty());
        if (first != 0) before = built(rows(points, 0, first));
        failures += fail_every_allocation(before, [&](AnyTriangulation& t) { insert(t, batch.view()); });
      }
    }
  }
  EXPECT_GT(failures, 1000U);
}

/// Changes every row of every family, one after the other, each with every allocation failing once: change(t, row).
/// @return how many failed
template <class Change>
std::size_t fail_for_every_row(const Change& change) {
  std::size_t failures = 0;
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : some_families(dimension)) {
      SCOPED_TRACE(points.name);
      AnyTriangulation t = built(points);
      for (std::size_t row = 0; row < points.size(); ++row) {
        const auto change_row = [&](AnyTriangulation& changed) { change(changed, static_cast<Index>(row)); };
        failures += fail_every_allocation(t, change_row);
        change_row(t);
      }
    }
  }
  return failures;
}

TEST(Allocation, removing_a_point_survives_the_failure_of_each) {
  EXPECT_GT(fail_for_every_row([](AnyTriangulation& t, Index row) { remove(t, row); }), 1000U);
}

TEST(Allocation, moving_a_point_survives_the_failure_of_each) {
  const auto onto_another = [](AnyTriangulation& t, Index row) {
    move(t, row, t.point(static_cast<Index>((row * 7 + 3) % t.row_count())));
  };
  EXPECT_GT(fail_for_every_row(onto_another), 1000U);
}

/// A lattice about a heavy point that hides five light ones, so close to the origin that predicates need integers of
/// any size, which they allocate.
PointSet wide_numbers() {
  PointSet points{"wide numbers", 2, {}, {}};
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      const bool centre = x == 0 && y == 0;
      points.coordinates.push_back(centre ? 1e-300 : x);
      points.coordinates.push_back(centre ? 1e-300 : y);
      points.weights.push_back(centre ? 3.0 : 0.0);
    }
  }
  for (const double t : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    points.coordinates.push_back(t * 1e-300);
    points.coordinates.push_back(t * t * 1e-301);
    points.weights.push_back(-4.0);
  }
  return points;
}

TEST(Allocation, predicates_that_allocate_may_fail_as_well) {
  constexpr Index kCentre = 12;
  const auto remove_centre = [](AnyTriangulation& t) { remove(t, kCentre); };
  const auto insert_heavier = [](AnyTriangulation& t) { insert(t, std::vector{1e-300, 3e-300}, 9.0); };
  const auto move_a_little = [](AnyTriangulation& t) { move(t, kCentre, std::vector{1e-290, -1e-300}); };
  const auto move_away = [](AnyTriangulation& t) { move(t, kCentre, std::vector{1e-300, 1.0}); };
  const auto move_onto_another = [](AnyTriangulation& t) { move(t, kCentre, std::vector{1.0, 1.0}); };
  for (const bool weighted : {true, false}) {
    PointSet points = wide_numbers();
    if (!weighted) points.weights.clear();
    AnyTriangulation hidden_unknown = built(points);
    AnyTriangulation hidden_known = hidden_unknown;
    remove(hidden_known, 0);
    for (const AnyTriangulation& t : {hidden_unknown, hidden_known}) {
      EXPECT_GT(fail_every_allocation(t, remove_centre), 0U);
      EXPECT_GT(fail_every_allocation(t, move_a_little), 0U);
      EXPECT_GT(fail_every_allocation(t, move_away), 0U);
      EXPECT_GT(fail_every_allocation(t, move_onto_another), 0U);
      if (!weighted) continue;
      EXPECT_GT(fail_every_allocation(t, insert_heavier), 0U);
    }
  }
}

TEST(Allocation, removing_a_batch_survives_the_failure_of_each) {
  std::size_t failures = 0;
  for (const PointSet& points : some_families(2)) {
    SCOPED_TRACE(points.name);
    const std::vector<Index> few{1, 4, 9}, most{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    failures += fail_every_allocation(built(points), [&](AnyTriangulation& t) { remove(t, few); });
    failures += fail_every_allocation(built(points), [&](AnyTriangulation& t) { remove(t, most); });
  }
  EXPECT_GT(failures, 100U);
}

TEST(Allocation, loading_survives_the_failure_of_each) {
  for (const PointSet& points : some_families(3)) {
    std::ostringstream out;
    save(built(points), out);
    const AnyTriangulation before(3, !points.weights.empty());
    fail_every_allocation(before, [&](AnyTriangulation& t) {
      std::istringstream in(out.str());
      t = load(in);
    });
  }
}

TEST(Allocation, cancelling_at_any_tick_leaves_the_object_as_it_was) {
  const PointSet points = uniform(2, 20000, 1);
  const PointSet batch = uniform(2, 9000, 2);
  std::vector<double> ticks;
  const BuildOptions counting{.progress = [&](double done) {
    ticks.push_back(done);
    return true;
  }};
  AnyTriangulation t = build(points.view(), counting);
  EXPECT_TRUE(std::ranges::is_sorted(ticks));
  EXPECT_GT(ticks.size(), 2U);
  const std::string before = description(t);
  for (std::size_t tick = 0; tick < ticks.size(); ++tick) {
    std::size_t left = tick;
    EXPECT_THROW(t = build(points.view(), {.progress = [&](double) { return left-- != 0; }}), Cancelled);
  }
  EXPECT_EQ(description(t), before);

  ticks.clear();
  AnyTriangulation grown = t;
  insert(grown, batch.view(), counting);
  EXPECT_GT(ticks.size(), 1U);
  for (std::size_t tick = 0; tick < ticks.size(); ++tick) {
    std::size_t left = tick;
    EXPECT_THROW(insert(t, batch.view(), {.progress = [&](double) { return left-- != 0; }}), Cancelled);
    EXPECT_EQ(description(t), before);
  }
  insert(t, batch.view());
  EXPECT_EQ(description(t), description(grown));
}

}  // namespace
}  // namespace delone
