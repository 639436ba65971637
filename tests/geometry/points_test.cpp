#include "delone/geometry/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/build/insert.hpp"

namespace delone {
namespace {

template <class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing to complain about";
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(PointsView, rows_are_read_in_place) {
  const std::vector<double> x{1, 2, 3, 4, 5, 6};
  const std::vector<double> w{7, 8};
  const PointsView points(x, 3, w);
  EXPECT_EQ(points.size(), 2U);
  EXPECT_EQ(points[1].data(), x.data() + 3);
  EXPECT_EQ(points.weight(1), 8.0);
  EXPECT_EQ(PointsView(x, 2).weight(0), 0.0);
  const std::vector<std::array<double, 2>> pairs{{1, 2}, {3, 4}};
  EXPECT_EQ(PointsView(std::span(pairs)).dimension(), 2);
  EXPECT_EQ(PointsView(std::span(pairs))[1][1], 4.0);
  EXPECT_EQ(PointsView(pairs)[1][0], 3.0);
  EXPECT_TRUE(PointsView().empty());
}

TEST(PointsView, shapes_that_do_not_fit_are_refused_with_their_numbers) {
  const std::vector<double> x{1, 2, 3, 4, 5};
  EXPECT_EQ(complaint([&] { PointsView(x, 2); }), "5 coordinates do not make whole rows of 2");
  EXPECT_EQ(complaint([&] { PointsView(x, 5, std::span(x).first(2)); }),
            "2 weights for 1 points: expected one per point, or none");
  EXPECT_EQ(complaint([&] { PointsView(x, 0); }), "dimension 0: expected 1 to 8");
  EXPECT_EQ(complaint([&] { PointsView(x, 9); }), "dimension 9: expected 1 to 8");
  EXPECT_EQ(complaint([&] { PointsView(x, -1); }), "dimension -1: expected 1 to 8");
  EXPECT_EQ(complaint([] { AnyTriangulation(9); }), "dimension 9: expected 1 to 8");
}

TEST(RequireFinite, names_the_row_and_the_column) {
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    std::vector<double> x(12, 1.0);
    x[7] = bad;
    EXPECT_EQ(complaint([&] { build(PointsView(x, 3)); }), "row 2, column 1: coordinate is not finite");
    x[7] = 0.0;
    const std::vector<double> w{1, 2, 3, bad};
    EXPECT_EQ(complaint([&] { build(PointsView(x, 3, w)); }), "row 3: weight is not finite");
  }
}

TEST(RequireFinite, an_insertion_that_is_refused_changes_nothing) {
  const std::vector<double> x{0, 0, 1, 0, 0, 1};
  AnyTriangulation t = build(PointsView(x, 2));
  EXPECT_EQ(complaint([&] { insert(t, std::vector{0.5, kNaN}); }), "row 0, column 1: coordinate is not finite");
  EXPECT_EQ(complaint([&] { insert(t, std::vector{0.5}); }), "a point of 1 coordinates: expected 2");
  EXPECT_EQ(complaint([&] {
              insert(t, std::vector{0.5, 0.5}, 1.0);
            }),
            "weights: the triangulation was made without any");
  EXPECT_EQ(complaint([&] { insert(t, PointsView(x, 3)); }),
            "points of 3 coordinates: expected 2, as the triangulation has");
  EXPECT_EQ(complaint([&] { t.status(3); }), "row 3: there are only 3 rows");
  EXPECT_EQ(t.row_count(), 3U);
  EXPECT_EQ(t.cell_count(), 1U);
}

TEST(RequireRowCount, more_rows_than_ids_are_refused_before_any_is_read) {
#ifdef DELONE_WIDE_IDS
  GTEST_SKIP() << "64-bit ids name more rows than memory holds";
#else
  EXPECT_GT(max_row_count(2), 530'000'000U);
  EXPECT_GT(max_row_count(3), 158'000'000U);
  const std::vector<double> one(8);
  for (int dimension = 1; dimension <= kMaxDimension; ++dimension) {
    const std::size_t rows = max_row_count(dimension) + 1;
    // A span over memory that is not there: whoever reads it is caught by the machine.
    const PointsView beyond(std::span(one.data(), rows * static_cast<std::size_t>(dimension)), dimension);
    const std::string expected = std::to_string(rows) + " points in dimension " + std::to_string(dimension) +
                                 ": ids of this build name at most " + std::to_string(rows - 1) +
                                 ", build with 64-bit ids (DELONE_WIDE_IDS)";
    EXPECT_EQ(complaint([&] { build(beyond); }), expected);
    EXPECT_EQ(complaint([&] { require_row_count(rows - 1, dimension); }), "nothing to complain about");
    EXPECT_TRUE(dimension == 1 || rows - 1 < max_row_count(dimension - 1));
  }
#endif
}

}  // namespace
}  // namespace delone
