// Line charts as SVG: a few panels beside each other with one legend.
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

}  // namespace delone::lab
