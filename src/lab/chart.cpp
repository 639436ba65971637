#include "delone/lab/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace delone::lab {
namespace {

constexpr double kPanelWidth = 380, kOnlyPanelWidth = 640, kPanelHeight = 300;
constexpr double kLeft = 62, kRight = 14, kTop = 34, kBottom = 48;  // between a panel's edge and its axes
constexpr double kHead = 40, kLegendRow = 22, kDigitWidth = 6.5;

/// Told apart also by readers who see few colours: six of Okabe and Ito, then others for charts of many lines.
constexpr std::array<const char*, 12> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
                                               "#000000", "#882255", "#999933", "#332288", "#8C564B", "#7F7F7F"};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

/// 12000 as "12,000"; small numbers with as many digits as they need.
std::string tick_label(double value) {
  if (value < 1000) return fmt::format("{:g}", value);
  std::string text = fmt::format("{:.0f}", value);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

/// An axis with its ends known, laid along `length` pixels.
class Scale {
 public:
  Scale(const Axis& axis, std::span<const Series> series, std::size_t coordinate, double length)
      : axis_(axis), length_(length) {
    if (axis_.low < axis_.high) return;
    axis_.low = std::numeric_limits<double>::infinity();
    axis_.high = 0;
    for (const Series& line : series) {
      for (const auto& point : line.points) {
        if (!shows(point[coordinate])) continue;
        axis_.low = std::min(axis_.low, point[coordinate]);
        axis_.high = std::max(axis_.high, point[coordinate]);
      }
    }
    if (!(axis_.low < std::numeric_limits<double>::infinity())) axis_.low = axis_.high = 1;
    if (axis_.logarithmic) {
      axis_.low /= 1.3;
      axis_.high *= 1.3;
    } else {
      axis_.low = 0;
      axis_.high *= 1.08;
    }
  }

  bool shows(double value) const { return std::isfinite(value) && (!axis_.logarithmic || value > 0); }
  double at(double value) const {
    const double part = axis_.logarithmic ? std::log(value / axis_.low) / std::log(axis_.high / axis_.low)
                                          : (value - axis_.low) / (axis_.high - axis_.low);
    return part * length_;
  }
  std::vector<double> ticks() const { return axis_.logarithmic ? logarithmic_ticks() : linear_ticks(); }

 private:
  std::vector<double> linear_ticks() const {
    const double rough = (axis_.high - axis_.low) / 5;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    const double step = power * (rough < 1.5 * power ? 1 : rough < 3.5 * power ? 2 : rough < 7.5 * power ? 5 : 10);
    std::vector<double> ticks;
    for (double x = std::ceil(axis_.low / step) * step; x <= axis_.high; x += step) ticks.push_back(x);
    return ticks;
  }
  std::vector<double> logarithmic_ticks() const {
    const bool few = axis_.high / axis_.low > 2000;
    std::vector<double> ticks;
    for (double power = std::pow(10, std::floor(std::log10(axis_.low))); power <= axis_.high; power *= 10) {
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double x = power * digit;
        if ((digit == 1.0 || !few) && x >= axis_.low && x <= axis_.high) ticks.push_back(x);
      }
    }
    return ticks;
  }

  Axis axis_;
  double length_;
};

/// The drawing so far.
class Canvas {
 public:
  void label(double x, double y, const std::string& text, const char* anchor, const std::string& more = "") {
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, anchor, more,
                         escaped(text));
  }
  void line(double x0, double y0, double x1, double y1, const char* colour) {
    text_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\"/>\n", x0, y0, x1, y1, colour);
  }
  void box(double x, double y, double width, double height, const char* colour) {
    text_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n", x, y,
                         width, height, colour);
  }
  void add(const std::string& element) { text_ += element; }

  std::string svg(double width, double height) const {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
               "{1:.0f}\" "
               "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
               width, height) +
           text_ + "</svg>\n";
  }

 private:
  std::string text_;
};

constexpr const char* kTitle = "font-size=\"15\" font-weight=\"bold\"";

class Drawing {
 public:
  Drawing(std::span<const Panel> panels, std::size_t columns)
      : panels_(panels), columns_(std::clamp<std::size_t>(columns, 1, std::max<std::size_t>(panels.size(), 1))) {
    for (const Panel& panel : panels) {
      for (const Series& line : panel.series) {
        if (std::ranges::find(names_, line.name) != names_.end()) continue;
        names_.push_back(line.name);
        dashed_.push_back(line.dashed);
      }
    }
  }

  std::string svg(const std::string& title) {
    const std::size_t rows = (panels_.size() + columns_ - 1) / columns_;
    const double width = panel_width_ * static_cast<double>(columns_);
    const double panels_end = kHead + kPanelHeight * static_cast<double>(rows);
    const double height = panels_end + kLegendRow * static_cast<double>((names_.size() + 1) / 2) + 12;
    canvas_.label(width / 2, 24, title, "middle", kTitle);
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      draw(panels_[i], panel_width_ * static_cast<double>(i % columns_),
           kHead + kPanelHeight * static_cast<double>(i / columns_));
    }
    for (std::size_t i = 0; i < names_.size(); ++i) draw_key(i, width, panels_end);
    return canvas_.svg(width, height);
  }

 private:
  std::size_t index_of(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
  }

  void draw(const Panel& panel, double left, double top) {
    const double x0 = left + kLeft, x1 = left + panel_width_ - kRight;
    const double y0 = top + kPanelHeight - kBottom, y1 = top + kTop;
    const Scale x(panel.x, panel.series, 0, x1 - x0);
    const Scale y(panel.y, panel.series, 1, y0 - y1);
    canvas_.label((x0 + x1) / 2, y1 - 10, panel.title, "middle", "font-weight=\"bold\"");
    double free_from = left;  // labels must not touch each other
    for (const double tick : x.ticks()) {
      canvas_.line(x0 + x.at(tick), y0, x0 + x.at(tick), y1, "#DDDDDD");
      const std::string text = tick_label(tick);
      const double half = 0.5 * kDigitWidth * static_cast<double>(text.size());
      if (x0 + x.at(tick) - half < free_from) continue;
      canvas_.label(x0 + x.at(tick), y0 + 16, text, "middle");
      free_from = x0 + x.at(tick) + half + 4;
    }
    for (const double tick : y.ticks()) {
      canvas_.line(x0, y0 - y.at(tick), x1, y0 - y.at(tick), "#DDDDDD");
      canvas_.label(x0 - 6, y0 - y.at(tick) + 4, tick_label(tick), "end");
    }
    canvas_.line(x0, y0, x1, y0, "black");
    canvas_.line(x0, y0, x0, y1, "black");
    canvas_.label((x0 + x1) / 2, y0 + 36, panel.x.title, "middle");
    const double middle = (y0 + y1) / 2;
    canvas_.label(left + 14, middle, panel.y.title, "middle",
                  fmt::format("transform=\"rotate(-90 {:.1f} {:.1f})\"", left + 14, middle));
    for (const Series& series : panel.series) draw(series, x, y, x0, y0);
  }

  void draw(const Series& series, const Scale& x, const Scale& y, double x0, double y0) {
    const std::size_t index = index_of(series.name);
    std::string path, dots;
    for (const auto& point : series.points) {
      if (!x.shows(point[0]) || !y.shows(point[1])) continue;
      const double px = x0 + x.at(point[0]), py = y0 - y.at(point[1]);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px, py);
      if (!series.dashed) dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>", px, py);
    }
    if (!path.empty()) stroke(index, path);
    canvas_.add(fmt::format("<g fill=\"{}\">{}</g>\n", kColours[index % kColours.size()], dots));
  }

  void stroke(std::size_t index, const std::string& path) {
    canvas_.add(fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", path,
                            kColours[index % kColours.size()], dashed_[index] ? " stroke-dasharray=\"6 4\"" : ""));
  }

  void draw_key(std::size_t index, double width, double top) {
    const double x = index % 2 == 0 ? 20 : width / 2 + 20;
    const double y = top + 10 + kLegendRow * static_cast<double>(index / 2);
    stroke(index, fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", x, y, x + 30, y));
    canvas_.label(x + 38, y + 4, names_[index], "start");
  }

  std::span<const Panel> panels_;
  std::size_t columns_;
  std::vector<std::string> names_;
  std::vector<bool> dashed_;
  double panel_width_ = columns_ == 1 ? kOnlyPanelWidth : kPanelWidth;
  Canvas canvas_;
};

/// Groups of horizontal bars below each other.
class BarDrawing {
 public:
  explicit BarDrawing(std::span<const BarGroup> groups) : groups_(groups), axis_(axis_of(groups), {}, 0, kBars) {
    for (const BarGroup& group : groups) {
      for (const Bar& bar : group.bars) {
        if (std::ranges::find(names_, bar.name) == names_.end()) names_.push_back(bar.name);
      }
      height_ += kGap + kBarRow * static_cast<double>(group.bars.size());
    }
  }

  std::string svg(const std::string& title, const std::string& axis, std::span<const std::string> notes) {
    const double bottom = kTopOfBars + height_;
    canvas_.label(kWidth / 2, 24, title, "middle", kTitle);
    double x = kNames;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      canvas_.box(x, 40, 12, 12, colour(i));
      canvas_.label(x + 18, 50, names_[i], "start");
      x += 42 + kDigitWidth * static_cast<double>(names_[i].size());
    }
    for (const double tick : axis_.ticks()) {
      canvas_.line(kNames + axis_.at(tick), kTopOfBars, kNames + axis_.at(tick), bottom, "#DDDDDD");
      canvas_.label(kNames + axis_.at(tick), bottom + 16, tick_label(tick), "middle");
    }
    canvas_.label(kNames + kBars / 2, bottom + 36, axis, "middle");
    double y = kTopOfBars + kGap / 2;
    for (const BarGroup& group : groups_) {
      draw(group, y);
      y += kGap + kBarRow * static_cast<double>(group.bars.size());
    }
    canvas_.line(kNames, kTopOfBars, kNames, bottom, "black");
    y = bottom + 44;
    for (const std::string& note : notes) canvas_.label(kWidth / 2, y += 16, note, "middle", kSmall);
    return canvas_.svg(kWidth, y + 14);
  }

 private:
  static constexpr double kWidth = 800, kNames = 150, kBars = 520;  // what is left is for the labels of the bars
  static constexpr double kTopOfBars = 64, kBarRow = 19, kGap = 16;
  static constexpr const char* kSmall = "font-size=\"11\" fill=\"#555555\"";

  static Axis axis_of(std::span<const BarGroup> groups) {
    double most = 0;
    for (const BarGroup& group : groups) {
      for (const Bar& bar : group.bars) most = std::max({most, bar.length, bar.most});
    }
    return {.title = "", .low = 0, .high = most > 0 ? most : 1};
  }
  static const char* colour(std::size_t index) { return kColours[index % kColours.size()]; }

  void draw(const BarGroup& group, double y) {
    const double middle = y + kBarRow * static_cast<double>(group.bars.size()) / 2;
    canvas_.label(kNames - 10, middle - 2, group.title, "end", "font-weight=\"bold\"");
    canvas_.label(kNames - 10, middle + 12, group.subtitle, "end", kSmall);
    for (const Bar& bar : group.bars) {
      const auto index = static_cast<std::size_t>(std::ranges::find(names_, bar.name) - names_.begin());
      const double least = kNames + axis_.at(bar.least), most = kNames + axis_.at(bar.most);
      const double end = kNames + axis_.at(bar.length);
      canvas_.box(kNames, y + 1, end - kNames, kBarRow - 3, colour(index));
      canvas_.line(least, y + kBarRow / 2, most, y + kBarRow / 2, "#333333");
      for (const double tip : {least, most}) canvas_.line(tip, y + 5, tip, y + kBarRow - 6, "#333333");
      canvas_.label(std::max(end, most) + 6, y + 13, bar.label, "start");
      y += kBarRow;
    }
  }

  std::span<const BarGroup> groups_;
  Scale axis_;
  std::vector<std::string> names_;
  double height_ = 0;
  Canvas canvas_;
};

}  // namespace

std::string draw_chart(const std::string& title, std::span<const Panel> panels, std::size_t columns) {
  return Drawing(panels, columns).svg(title);
}

std::string draw_bars(const std::string& title, const std::string& axis, std::span<const BarGroup> groups,
                      std::span<const std::string> notes) {
  return BarDrawing(groups).svg(title, axis, notes);
}

}  // namespace delone::lab
