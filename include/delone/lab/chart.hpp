// Charts as SVG: lines, a few panels beside each other with one legend; and horizontal bars in groups.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace delone::lab {

struct Series {
  std::string name;                           ///< of equal names in several panels one stands in the legend
  std::vector<std::array<double, 2>> points;  ///< x and y, in the order of the line
  bool dashed = false;
};

struct Axis {
  std::string title;
  bool logarithmic = false;
  double low = 0, high = 0;  ///< chosen from the points when equal
};

struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
};

/// The chart as an SVG file. Points that a logarithmic axis cannot show are left out.
std::string draw_chart(const std::string& title, std::span<const Panel> panels, std::size_t columns);

struct Bar {
  std::string name;  ///< equal names have one colour and one place in the legend
  double length = 0;
  double least = 0, most = 0;  ///< a whisker from here to there
  std::string label;           ///< at its end
};

struct BarGroup {
  std::string title, subtitle;
  std::vector<Bar> bars;
};

/// The groups below each other, bars from 0 on. @param notes  small lines at the foot: where and when
std::string draw_bars(const std::string& title, const std::string& axis, std::span<const BarGroup> groups,
                      std::span<const std::string> notes);

}  // namespace delone::lab
