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

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Bars, each_has_its_length_and_label_and_each_name_one_colour) {
  const std::vector<BarGroup> groups{{"2d", "9 points", {{"us", 1, 1, 1, "1 s"}, {"them", 2, 1.5, 4, "2 s"}}},
                                     {"3d", "9 points", {{"them", 3, 3, 3, "3 s"}}}};
  const std::vector<std::string> notes{"here & now"};
  const std::string svg = draw_bars("title", "times", groups, notes);
  for (const char* text : {"1 s", "2 s", "3 s", "us", "them", "2d", "3d", "times", "here &amp; now"})
    EXPECT_EQ(count(svg, ">" + std::string(text) + "<"), 1U) << text;
  EXPECT_EQ(count(svg, "#D55E00"), 3U);                                             // two bars of theirs and the legend
  EXPECT_THAT(svg, HasSubstr("width=\"260.0\" height=\"16.0\" fill=\"#D55E00\""));  // 2 of 4 on 520
}

TEST(Bars, nothing_to_draw_is_an_empty_chart) {
  EXPECT_THAT(draw_bars("title", "times", {}, {}), HasSubstr("</svg>"));
  EXPECT_THAT(draw_bars("title", "times", {}, {}), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace delone::lab
