// What the tests of four cells at once are sure of is so, and they are sure of most.
#include "geometry/four_conflicts.hpp"

#include <gtest/gtest.h>

#ifdef DELONE_FOURS

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "support/families.hpp"

namespace delone {
namespace {

using Cell = Kernel<3>::Cell;
using test::Random;
using test::unit_random;

/// Site 0 is the query. Then follow, for each cell, its four corners and their apexes.
constexpr VertexId kQuery{0};

struct Question {
  Cell cell, apexes;
};

/// @param expected  the question that sets bounds for the others, as long as these are not larger; null: none does
template <bool Weighted>
DELONE_BY_FOURS std::vector<FourAnswers> answers_of(const Kernel<3>& kernel, const std::vector<Question>& questions,
                                                    const Question* expected) {
  FourConflicts<Weighted> conflicts(kernel, kQuery);
  if (expected != nullptr) conflicts.expect(expected->cell);
  std::vector<FourAnswers> answers;
  for (const Question& q : questions) answers.push_back(conflicts(q.cell, q.apexes));
  return answers;
}
std::vector<FourAnswers> answers_of(const Kernel<3>& kernel, const std::vector<Question>& questions,
                                    const Question* expected) {
  return kernel.weighted() ? answers_of<true>(kernel, questions, expected)
                           : answers_of<false>(kernel, questions, expected);
}

Sites sites_of(const std::vector<double>& coordinates, const std::vector<double>& weights = {}) {
  Sites sites(3, !weights.empty(), Flat{3, {0, 1, 2}});
  const PointsView points(coordinates, 3, weights);
  sites.reserve_more(points.size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    sites.append(points[row], points.weight(row), static_cast<Index>(row));
  }
  return sites;
}

/// Positive cells only, in the order of their sites.
std::vector<Question> questions_of(const Sites& sites, const Kernel<3>& kernel) {
  std::vector<Question> questions;
  for (Index i = 1; i + 7 < sites.size(); i += 8) {
    Question q{{VertexId{i}, VertexId{i + 1}, VertexId{i + 2}, VertexId{i + 3}},
               {VertexId{i + 4}, VertexId{i + 5}, VertexId{i + 6}, VertexId{i + 7}}};
    const int side = kernel.exact_orient(q.cell);
    if (side < 0) std::swap(q.cell[0], q.cell[1]);
    if (side != 0) questions.push_back(q);
  }
  return questions;
}

struct Counts {
  int sure = 0;
  int ties = 0;
  int unsure = 0;
};

/// Compares the answers with integers. Where a cell across is turned around, its answer is that for the cell turned
/// back, reversed.
void expect_no_contradiction(const Kernel<3>& kernel, const std::vector<Question>& questions, const Question* expected,
                             Counts& counts) {
  const auto answers = answers_of(kernel, questions, expected);
  for (std::size_t n = 0; n < questions.size(); ++n) {
    for (std::size_t i = 0; i < 4; ++i) {
      Cell across = questions[n].cell;
      across[i] = questions[n].apexes[i];
      const int side = kernel.exact_orient(across);
      if (side == 0) continue;
      if (side < 0) std::swap(across[0], across[1]);
      const bool sure = (answers[n].sure >> i & 1) != 0;
      const bool tie = (answers[n].tie >> i & 1) != 0;
      ++(sure ? counts.sure : (tie ? counts.ties : counts.unsure));
      if (!sure && !tie) continue;
      const int truth = -side * kernel.slow_conflict_sign(across, kQuery).sign;
      ASSERT_EQ(truth == 0, tie);
      ASSERT_EQ(truth > 0, sure && (answers[n].conflict >> i & 1) != 0);
    }
  }
}
void expect_no_contradiction(const Sites& sites, Counts& counts) {
  const Kernel<3> kernel(sites);
  const auto questions = questions_of(sites, kernel);
  expect_no_contradiction(kernel, questions, nullptr, counts);
  for (const Question& expected : questions) expect_no_contradiction(kernel, questions, &expected, counts);
}

/// A coarse lattice, missed by the last bits or by some, off the origin.
std::vector<double> near_lattice(Random& random, std::size_t count, int exponent) {
  const double offset = random() % 2 == 0 ? 0.0 : 1000.0;
  const int miss = static_cast<int>(random() % 54);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    double x = offset + static_cast<double>(random() % 3);
    if (random() % 2 == 0) x += std::ldexp(unit_random(random) - 0.5, -miss);
    numbers.push_back(std::ldexp(x, exponent));
  }
  return numbers;
}

TEST(FourConflicts, never_contradict_integers_near_lattices) {
  if (!can_test_fours()) GTEST_SKIP() << "not on this processor";
  constexpr std::array<int, 8> kScales{0, 0, 60, 88, -60, -80, -100, -200};
  Random random(1);
  Counts counts;
  for (int trial = 0; trial < 30000; ++trial) {
    const int exponent = kScales[random() % kScales.size()];
    const auto weights = trial % 3 == 0 ? near_lattice(random, 9, 2 * exponent) : std::vector<double>();
    expect_no_contradiction(sites_of(near_lattice(random, 27, exponent), weights), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.sure, 2000);
  EXPECT_GT(counts.unsure, 2000);
}

/// Cells of different size, all with their neighbours on one sphere through the query, as closely as doubles tell; or
/// with weights that raise or lower what lies off the sphere to it.
TEST(FourConflicts, never_contradict_integers_near_spheres) {
  if (!can_test_fours()) GTEST_SKIP() << "not on this processor";
  Random random(2);
  Counts counts;
  const auto power = [&](int most) {
    return std::ldexp(1.0, -static_cast<int>(random() % static_cast<unsigned>(most)));
  };
  const auto signed_unit = [&] { return 2 * unit_random(random) - 1; };
  for (int trial = 0; trial < 60000; ++trial) {
    const bool weighted = trial % 2 == 0;
    const double radius = 1 / power(30);
    const double off = weighted ? power(40) : 0.0;
    const double far = trial % 3 == 0 ? 1000 * radius : radius;
    const std::array<double, 3> centre{far * signed_unit(), far * signed_unit(), far * signed_unit()};
    const std::array<double, 3> query{signed_unit(), signed_unit(), signed_unit()};  // as the centre sees it
    std::vector<double> coordinates, weights;
    const auto add_site = [&](double reach) {
      std::array<double, 3> n = query;
      for (double& x : n) x += reach * signed_unit();
      const double distance = radius * std::sqrt(1 + off * signed_unit());
      for (std::size_t j = 0; j < 3; ++j)
        coordinates.push_back(centre[j] + distance * n[j] / std::hypot(n[0], n[1], n[2]));
      weights.push_back(distance * distance - radius * radius);
    };
    add_site(0);
    for (int cell = 0; cell < 4; ++cell) {
      const double reach = power(25);
      const double reach_of_apexes = cell % 2 == 0 ? reach : power(25);
      for (int site = 0; site < 8; ++site) add_site(site < 4 ? reach : reach_of_apexes);
    }
    expect_no_contradiction(sites_of(coordinates, weighted ? weights : std::vector<double>()), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.sure, 20000);
  EXPECT_GT(counts.unsure, 20000);
}

/// Signed permutations of three integers up to a lie on one sphere. Differences reach 2 a, so squared lengths 12 a^2,
/// and all terms of a determinant stay below 2^53 while 4.8 (12 a^2)^(5/2) does: for a below 320.
TEST(FourConflicts, know_ties_of_small_integers) {
  if (!can_test_fours()) GTEST_SKIP() << "not on this processor";
  Random random(3);
  for (const double largest : {8.0, 100.0, 1e3, 1e4, 1e5}) {
    Counts counts;
    for (int trial = 0; trial < 3000; ++trial) {
      std::array<double, 3> numbers;
      for (double& x : numbers) x = 1 + std::floor(unit_random(random) * largest);
      std::vector<double> coordinates;
      for (int site = 0; site < 9; ++site) {
        std::ranges::shuffle(numbers, random);
        for (const double x : numbers) coordinates.push_back(random() % 2 == 0 ? x : -x);
        if (random() % 8 == 0) coordinates.back() += 1;
      }
      expect_no_contradiction(sites_of(coordinates), counts);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(counts.sure, 100);
    EXPECT_EQ(counts.ties > 100, largest < 1e4) << largest;
    EXPECT_EQ(counts.unsure == 0, largest < 1e3) << largest;
  }
}

/// Determinants are about 2^(5 exponent), and bounds never below 2^-447; coordinates of 2^99 and more are untame.
TEST(FourConflicts, are_not_sure_where_numbers_leave_the_range) {
  if (!can_test_fours()) GTEST_SKIP() << "not on this processor";
  Random random(4);
  for (const int exponent : {-1060, -540, -300, -100, -88, 97, 99, 100, 300, 1010}) {
    Counts counts;
    for (int trial = 0; trial < 300; ++trial) {
      expect_no_contradiction(sites_of(near_lattice(random, 27, exponent)), counts);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(counts.unsure, 0) << exponent;
    EXPECT_EQ(counts.sure > 0, exponent == -88 || exponent == 97) << exponent;
  }
}

TEST(FourConflicts, an_apex_far_away_has_a_bound_of_its_own) {
  if (!can_test_fours()) GTEST_SKIP() << "not on this processor";
  // The query lies on the sphere through corners 1 to 3 and apex 0, exactly.
  const Sites tie = sites_of({0,         0,        0,                                                       //
                              -3,        -5,       -400,     185,  -96, 549, 121, -65, 366, 113, -63, 349,  //
                              -39177751, 91491825, 29201173, -500, 300, 20,  1,   -2,  350, 20,  30,  -350});
  const Question question{{VertexId{1}, VertexId{2}, VertexId{3}, VertexId{4}},
                          {VertexId{5}, VertexId{6}, VertexId{7}, VertexId{8}}};
  for (const Question* expected : {&question, static_cast<const Question*>(nullptr)})
    EXPECT_EQ(answers_of(Kernel<3>(tie), {question}, expected).front().sure, 0b1110U);
}

}  // namespace
}  // namespace delone

#endif
