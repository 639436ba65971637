#include "delone/lab/fortune.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "delone/base/errors.hpp"

namespace delone::lab {
namespace {

TEST(Fortune, every_method_runs_where_it_serves_and_makes_the_same_cells) {
  const std::vector<MethodRun> runs = run_methods({.methods = all_methods(),
                                                   .kinds = {"uniform", "sphere"},
                                                   .dimensions = {2, 3},
                                                   .sizes = {100, 50},
                                                   .enough = 0});
  std::map<std::tuple<std::string, int, std::size_t>, std::size_t> cells;
  std::map<int, int> methods_of;
  for (const MethodRun& run : runs) {
    ASSERT_FALSE(run.skipped);
    EXPECT_GE(run.seconds, 0.0);
    const auto [known, is_new] = cells.emplace(std::tuple(run.kind, run.dimension, run.points), run.cells);
    EXPECT_EQ(known->second, run.cells) << info(run.method).name;
    ++methods_of[run.dimension];
  }
  EXPECT_EQ(methods_of[2], 11 * 2 * 2);
  EXPECT_EQ(methods_of[3], 6 * 2 * 2);
}

TEST(Fortune, what_would_take_too_long_is_left_out) {
  const std::vector<MethodRun> runs =
      run_methods({.methods = {Method::shelling}, .dimensions = {2}, .sizes = {50, 100000, 1000000}, .limit = 0.01});
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_FALSE(runs[0].skipped);
  EXPECT_TRUE(runs[2].skipped);
}

TEST(Fortune, the_figures_of_1992) {
  EXPECT_EQ(seconds_1992(Method::lawson, 2, 50000), 316.9);
  EXPECT_EQ(seconds_1992(Method::sweep, 2, 500), 1.2);
  EXPECT_EQ(seconds_1992(Method::history_simplices, 5, 500), 287.0);
  EXPECT_EQ(seconds_1992(Method::history_simplices, 5, 1000), 0.0);
  EXPECT_EQ(seconds_1992(Method::flip, 2, 500), 0.0);
  EXPECT_EQ(lines_1992(Method::divide_conquer), 900);
}

TEST(Fortune, every_method_has_lines_of_source) {
  for (const Method method : all_methods()) {
    EXPECT_GT(source_lines(method), 40) << info(method).name;
    EXPECT_LT(source_lines(method), 1000) << info(method).name;
  }
}

TEST(Fortune, an_unknown_kind_is_refused) {
  EXPECT_THROW(run_methods({.methods = {Method::flip}, .kinds = {"magic"}}), InputError);
}

}  // namespace
}  // namespace delone::lab
