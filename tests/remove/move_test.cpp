#include "delone/remove/move.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"
#include "support/ledger.hpp"

namespace delone {
namespace {

using namespace test;

/// One operation after the other, chosen at random, with points from a pool, so that places and circles repeat.
class Sequence {
 public:
  Sequence(const PointSet& pool, std::uint64_t seed)
      : pool_(&pool),
        random_(seed),
        t_(pool.dimension, !pool.weights.empty()),
        ledger_{pool.dimension, !pool.weights.empty(), {}} {}

  void step() {
    const auto present = ledger_.present();
    const auto choice = random_() % 8;
    if (present.empty() || (choice < 3 && present.size() < pool_->size())) return insert_one();
    const Index row = present[random_() % present.size()];
    choice < 5 ? remove_one(row) : move_one(row, choice);
  }
  std::string fault() const { return differs_from_building(t_, ledger_); }
  const AnyTriangulation& triangulation() const { return t_; }

 private:
  Ledger::Entry draw() {
    const std::size_t row = random_() % pool_->size();
    const auto point = pool_->view()[row];
    return {{point.begin(), point.end()}, pool_->view().weight(random_() % pool_->size())};
  }
  void insert_one() {
    const auto entry = draw();
    insert(t_, entry.point, entry.weight);
    ledger_.rows.emplace_back(entry);
  }
  void remove_one(Index row) {
    remove(t_, row);
    ledger_.rows[row].reset();
  }
  void move_one(Index row, std::uint64_t choice) {
    auto entry = draw();
    if (choice == 7) {  // not far
      for (std::size_t axis = 0; axis < entry.point.size(); ++axis) {
        const double from = ledger_.rows[row]->point[axis];
        const double step = std::abs(entry.point[axis] - from) / 64;
        if (std::isfinite(step)) entry.point[axis] = from + step;
      }
      entry.weight = ledger_.rows[row]->weight;
      for (const double x : entry.point)
        if (!std::isfinite(x)) return;
    }
    const Moved moved = move(t_, row, entry.point, ledger_.weighted ? std::optional(entry.weight) : std::nullopt);
    ledger_.rows[row] = entry;
    EXPECT_EQ(moved.outcome == Outcome::inserted, t_.status(row).status == Status::vertex);
  }

  const PointSet* pool_;
  Random random_;
  AnyTriangulation t_;
  Ledger ledger_;
};

void run(const PointSet& pool, int steps, int look_every, std::uint64_t seed) {
  SCOPED_TRACE(pool.name);
  Sequence sequence(pool, seed);
  for (int step = 0; step < steps; ++step) {
    sequence.step();
    if (step % look_every == 0 || step + 1 == steps) {
      ASSERT_EQ(sequence.fault(), "") << "after step " << step << " of seed " << seed;
    }
  }
}

TEST(Move, any_sequence_of_edits_equals_building_from_the_final_set) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& pool : families(dimension, dimension < 4 ? 20 : 12, 21)) run(pool, 80, 2, 5);
  }
}

TEST(MoveSlow, thousands_of_edits_equal_building_from_the_final_set) {
  constexpr std::array<std::size_t, 7> kPool{0, 50, 50, 40, 14, 9, 8};
  constexpr std::array<int, 7> kSteps{0, 1500, 1500, 1000, 150, 40, 30};
  for (int dimension = 1; dimension <= 6; ++dimension) {
    const auto d = static_cast<std::size_t>(dimension);
    for (const PointSet& pool : families(dimension, kPool[d], 22)) run(pool, kSteps[d], 199, 6);
  }
}

TEST(Move, a_small_step_keeps_the_cells_and_tells_of_them) {
  const PointSet points = uniform(2, 200, 3);
  AnyTriangulation t = built(points);
  std::size_t in_place = 0;
  for (Index row = 0; row < 200; ++row) {
    std::vector<double> p = t.point(row);
    p[0] += 1e-9;
    const VertexId v = t.vertex(row);
    bool heard = false;
    const Moved moved = move(t, row, p, std::nullopt, {.on_edit = [&](const Edit& edit) {
                               heard = edit.gone.size() == 1 && edit.came.size() == 1 && edit.came.front() == v;
                             }});
    EXPECT_EQ(moved.outcome, Outcome::inserted);
    EXPECT_TRUE(heard || moved.motion != Motion::in_place);
    in_place += moved.motion == Motion::in_place ? 1 : 0;
  }
  EXPECT_GT(in_place, 150U);
  EXPECT_EQ(broken_invariant(t), "");
}

TEST(Move, a_point_that_leaves_or_enters_the_flat_of_the_others_changes_the_dimension) {
  AnyTriangulation t = built({"segment", 2, {0, 0, 1, 1, 3, 3}, {}});
  EXPECT_EQ(move(t, 1, std::vector<double>{1, 2}).motion, Motion::rebuilt);
  EXPECT_EQ(t.affine_dimension(), 2);
  EXPECT_EQ(move(t, 1, std::vector<double>{2, 2}).motion, Motion::rebuilt);
  EXPECT_EQ(t.affine_dimension(), 1);
  EXPECT_EQ(move(t, 2, std::vector<double>{0, 0}).outcome, Outcome::duplicate);
  EXPECT_EQ(move(t, 1, std::vector<double>{0, 0}).motion, Motion::rebuilt);
  EXPECT_EQ(t.affine_dimension(), 0);
}

TEST(Move, bad_points_are_refused_and_change_nothing) {
  AnyTriangulation t = built(uniform(2, 9, 1));
  const std::string before = description(t);
  EXPECT_THROW(move(t, 1, std::vector<double>{1}), InputError);
  EXPECT_THROW(move(t, 1, std::vector<double>{1, std::nan("")}), InputError);
  EXPECT_THROW(move(t, 1, std::vector<double>{1, 2}, 3.0), InputError);
  EXPECT_THROW(move(t, 9, std::vector<double>{1, 2}), InputError);
  EXPECT_EQ(description(t), before);
}

}  // namespace
}  // namespace delone
