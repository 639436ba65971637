#include "delone/lab/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace delone::lab {
namespace {

using testing::HasSubstr;
using testing::Not;

Panel panel(std::vector<Series> series) { return {"a < b", {"points", true}, {"seconds", true}, std::move(series)}; }

TEST(Chart, names_stand_once_in_the_legend_and_are_escaped) {
  const std::vector<Panel> panels{panel({{"walk", {{10, 1}, {100, 3}}}}), panel({{"walk", {{10, 2}, {100, 5}}}})};
  const std::string svg = draw_chart("title", panels, 2);
  EXPECT_THAT(svg, HasSubstr("a &lt; b"));
  const std::size_t first = svg.find(">walk<");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(svg.find(">walk<", first + 1), std::string::npos);
}

TEST(Chart, what_a_logarithm_cannot_show_is_left_out) {
  const std::vector<Panel> panels{
      panel({{"walk", {{10, 0}, {100, std::numeric_limits<double>::infinity()}, {1000, 5}}}})};
  const std::string svg = draw_chart("title", panels, 1);
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_EQ(svg.find("<circle"), svg.rfind("<circle"));
}

TEST(Chart, nothing_to_draw_is_an_empty_chart) {
  EXPECT_THAT(draw_chart("title", {}, 3), HasSubstr("</svg>"));
  const std::vector<Panel> panels{panel({})};
  EXPECT_THAT(draw_chart("title", panels, 3), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace delone::lab
