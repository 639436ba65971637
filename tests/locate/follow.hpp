// Drives a locator beside a triangulation, and compares what it says with looking at every cell.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "delone/base/dispatch.hpp"
#include "delone/build/build.hpp"
#include "delone/locate/locator.hpp"
#include "delone/mesh/walk.hpp"
#include "delone/remove/move.hpp"
#include "delone/remove/remove.hpp"
#include "support/families.hpp"

namespace delone::test {

/// Whether the closed cell contains q, or, for a ghost cell, whether q lies strictly beyond its facet.
template <int K>
bool contains(const ComplexView<K>& complex, Kernel<K>& kernel, CellId c, const double* q) {
  const int ghost = complex.ghost_slot(c);
  for (int i = 0; i <= K; ++i) {
    if (ghost >= 0 && i != ghost) continue;
    if (kernel.orient(complex.vertices(c), i, q) < (ghost >= 0 ? 1 : 0)) return false;
  }
  return true;
}

/// Whether `hint` is live, and a walk from it arrives where looking at every cell does.
template <int K>
bool leads_to(AnyTriangulation& t, CellId hint, std::span<const double> point) {
  const ComplexView<K> complex(t.mesh().complex);
  if (raw(hint) >= complex.slot_count() || !complex.is_live(hint)) return false;
  std::vector<double> q;
  for (std::size_t i = 0; i < std::size_t{K}; ++i) {
    q.push_back(point[static_cast<std::size_t>(t.sites().flat().axes[i])]);
  }
  q.push_back(0.0);
  NumberRange range = t.sites().range();
  range.include(point);
  Kernel<K> kernel(t.sites(), range);
  WalkStats stats;
  const CellId found = walk(complex, kernel, q.data(), hint, stats);
  const CellId exhaustive = exhaustive_locate(complex, kernel, q.data());
  return stats.fallbacks == 0 && contains(complex, kernel, found, q.data()) &&
         complex.is_ghost(found) == complex.is_ghost(exhaustive);
}

template <class L>
void expect_good_hint(L& locator, AnyTriangulation& t, std::span<const double> q) {
  const CellId hint = locator.hint(t, q);
  if (t.affine_dimension() < 0) {
    EXPECT_EQ(hint, kNoCell);
  } else if (t.affine_dimension() == 0) {
    EXPECT_TRUE(t.complex().is_live(hint));
  } else {
    EXPECT_TRUE(with_dimension<1>(t.affine_dimension(), [&](auto k) { return leads_to<k>(t, hint, q); }));
  }
}

/// Queries at rows of `points`, halfway between two rows, outside, and far outside.
inline std::vector<std::vector<double>> queries_about(const PointSet& points, std::size_t count, Random& random) {
  const auto d = static_cast<std::size_t>(points.dimension);
  std::vector<std::vector<double>> queries;
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = points.view()[random() % points.size()];
    const auto b = points.view()[random() % points.size()];
    std::vector<double> q(a.begin(), a.end());
    if (i % 4 > 0) {
      for (std::size_t j = 0; j < d; ++j) q[j] = 0.5 * a[j] + 0.5 * b[j];
    }
    if (i % 4 == 2) q[random() % d] += 3.0;
    if (i % 4 == 3) q[random() % d] = random() % 2 == 0 ? -1e305 : 1e200;
    queries.push_back(q);
  }
  return queries;
}

/// Inserts all points one by one where `locator` says, removes and moves some, with queries in between.
template <class L>
void expect_to_follow(L locator, const PointSet& points, std::uint64_t seed) {
  SCOPED_TRACE(testing::Message() << points << ", seed " << seed);
  Random random(seed);
  AnyTriangulation t(points.dimension, !points.weights.empty());
  const std::size_t first = random() % 2 == 0 ? 0 : points.size() / 2;
  if (first > 0) t = build(rows(points, 0, first).view());
  attach(locator, t);
  const auto listen = [&](const Edit& e) { locator.update(t, e); };
  const auto any_row = [&] {
    const std::vector<Index> present = t.present_rows();
    return present[random() % present.size()];
  };
  for (std::size_t row = first; row < points.size(); ++row) {
    insert(t, points.view()[row], points.view().weight(row), locator);
    if (row % 3 == 1) remove(t, any_row(), {.on_edit = listen});
    if (row % 5 == 4) move(t, any_row(), points.view()[random() % row], std::nullopt, {.on_edit = listen});
    if (row % 7 != 0 && row + 1 != points.size()) continue;
    for (const auto& q : queries_about(points, 4, random)) expect_good_hint(locator, t, q);
  }
  while (t.row_count() > t.removed_count()) {
    remove(t, any_row(), {.on_edit = listen});
    if (random() % 4 == 0) expect_good_hint(locator, t, points.view()[0]);
  }
  expect_good_hint(locator, t, points.view()[0]);
}

/// The same for every family of hard points. @param make  makes a locator to try
template <class Make>
void expect_to_follow_every_family(Make make) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : families(dimension, dimension < 4 ? 24 : 14, 7)) {
      expect_to_follow(make(), points, 11);
      if (testing::Test::HasFailure()) return;
    }
  }
}

/// The same for fewer and smaller families, for variants of a locator.
template <class Make>
void expect_to_follow_small_families(Make make) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const PointSet& points : unweighted_families(dimension, 20, 8)) {
      expect_to_follow(make(), points, 12);
      expect_to_follow(make(), with_random_weights(points, 13), 14);
      if (testing::Test::HasFailure()) return;
    }
  }
}

/// Steps that the callers' walks take from the hints for random points, on average, when n uniform points are there.
template <class L>
double mean_steps(L& locator, AnyTriangulation& t, std::size_t queries, std::uint64_t seed) {
  const PointSet at = uniform(t.dimension(), queries, seed);
  std::uint64_t steps = 0;
  with_dimension<1>(t.affine_dimension(), [&](auto k) {
    const ComplexView<k> complex(t.mesh().complex);
    Kernel<k> kernel(t.sites());
    for (std::size_t i = 0; i < queries; ++i) {
      WalkStats stats;
      walk(complex, kernel, at.view()[i].data(), locator.hint(t, at.view()[i]), stats);
      steps += stats.steps;
    }
  });
  return static_cast<double>(steps) / static_cast<double>(queries);
}

}  // namespace delone::test
