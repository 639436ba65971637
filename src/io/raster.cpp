// Faces into samples: each row of samples is cut at the same places by both faces of an edge, and a span takes its left
// end and leaves its right one, so that faces neither overlap nor leave gaps. Then samples are averaged.
#include <algorithm>
#include <cmath>
#include <utility>

#include "io/scene.hpp"

namespace delone::io {
namespace {

constexpr int kSamples = 3;  // per pixel and axis

std::uint32_t opaque(Colour colour) {
  return 0xFF00'0000U | std::uint32_t{colour.red} << 16 | std::uint32_t{colour.green} << 8 | colour.blue;
}

struct Place {
  double x, y;
};

/// Where the edge crosses the height y; ends are ordered first, so that both its triangles get the same answer.
double crossing(Place a, Place b, double y) {
  if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(a, b);
  return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
}

/// The first sample whose centre is not left of (above) x.
int first_sample(double x, int count) {
  return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(count)));
}

class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width * kSamples),
        height_(height * kSamples),
        samples_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {}

  /// @param shade  shade(x, y, count, out) colours `count` samples from centre (x, y) on
  template <class Shade>
  void fill(std::array<Place, 3> p, Shade shade) {
    std::ranges::sort(p, {}, &Place::y);
    const int last = first_sample(p[2].y, height_);
    for (int row = first_sample(p[0].y, height_); row < last; ++row) {
      const double y = row + 0.5;
      const double one = crossing(p[0], p[2], y);
      const double other = y < p[1].y ? crossing(p[0], p[1], y) : crossing(p[1], p[2], y);
      const int left = first_sample(std::min(one, other), width_);
      const int right = first_sample(std::max(one, other), width_);
      if (left < right) shade(left + 0.5, y, right - left, &samples_[index(left, row)]);
    }
  }

  /// Lets an edge of a polygon cross the rows; fill_crossed() then fills what an odd number of its loops goes around.
  void cross(Place a, Place b) {
    const int last = first_sample(std::max(a.y, b.y), height_);
    for (int row = first_sample(std::min(a.y, b.y), height_); row < last; ++row)
      crossings_.emplace_back(row, crossing(a, b, row + 0.5));
  }
  void fill_crossed(std::uint32_t colour) {
    std::ranges::sort(crossings_);
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      const auto& [row, x] = crossings_[i];
      const int left = first_sample(x, width_);
      const int right = first_sample(crossings_[i + 1].second, width_);
      if (left < right) std::fill_n(&samples_[index(left, row)], right - left, colour);
    }
    crossings_.clear();
  }

  Image average() const {
    Image image{width_ / kSamples, height_ / kSamples, {}};
    image.pixels.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    for (int y = 0; y < height_; y += kSamples) {
      for (int x = 0; x < width_; x += kSamples) image.pixels.push_back(average(x, y));
    }
    return image;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  std::uint32_t average(int x, int y) const {
    std::uint32_t covered = 0, red = 0, green = 0, blue = 0;
    for (int i = 0; i < kSamples * kSamples; ++i) {
      const std::uint32_t sample = samples_[index(x + i % kSamples, y + i / kSamples)];
      if (sample == 0) continue;
      ++covered;
      red += sample >> 16 & 0xFFU;
      green += sample >> 8 & 0xFFU;
      blue += sample & 0xFFU;
    }
    if (covered == 0) return 0;
    const std::uint32_t alpha = covered * 255 / (kSamples * kSamples);
    return alpha << 24 | red / covered << 16 | green / covered << 8 | blue / covered;
  }

  int width_, height_;
  std::vector<std::uint32_t> samples_;
  std::vector<std::pair<int, double>> crossings_;  ///< of the polygon at hand: rows and x, an even number in each row
};

/// A number given at three corners, linear between them.
class Plane {
 public:
  Plane(const std::array<Place, 3>& p, float a, float b, float c) : x_(p[0].x), y_(p[0].y), value_(a) {
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0) return;
    const double ab = double{b} - double{a};
    const double ac = double{c} - double{a};
    dx_ = (ab * (p[2].y - p[0].y) - ac * (p[1].y - p[0].y)) / area;
    dy_ = (ac * (p[1].x - p[0].x) - ab * (p[2].x - p[0].x)) / area;
    low_ = std::min({a, b, c});
    high_ = std::max({a, b, c});
  }
  float operator()(double x, double y) const {
    const double value = value_ + dx_ * (x - x_) + dy_ * (y - y_);
    return static_cast<float>(std::clamp(value, low_, high_));
  }

 private:
  double x_, y_, value_;
  double dx_ = 0, dy_ = 0;
  double low_ = 0, high_ = 1;
};

void fill_triangles(const Scene& scene, const Palette& palette, Canvas& canvas) {
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto& corners = scene.triangles[t];
    std::array<Place, 3> places;
    for (std::size_t i = 0; i < 3; ++i) {
      places[i] = {scene.at[corners[i]][0] * kSamples, scene.at[corners[i]][1] * kSamples};
    }
    if (!scene.lit()) {
      const std::uint32_t colour = opaque(scene.colour(t, palette));
      canvas.fill(places, [colour](double, double, int count, std::uint32_t* out) { std::fill_n(out, count, colour); });
      continue;
    }
    const auto& [a, b, c] = corners;
    const Plane tone(places, scene.height_tone[a], scene.height_tone[b], scene.height_tone[c]);
    const Plane shade(places, scene.shade[a], scene.shade[b], scene.shade[c]);
    canvas.fill(places, [&](double x, double y, int count, std::uint32_t* out) {
      for (int i = 0; i < count; ++i) out[i] = opaque(palette(tone(x + i, y), shade(x + i, y)));
    });
  }
}

void fill_polygons(const Scene& scene, const Palette& palette, Canvas& canvas) {
  const auto place = [&](std::size_t corner) {
    return Place{scene.at[corner][0] * kSamples, scene.at[corner][1] * kSamples};
  };
  for (std::size_t polygon = 0; polygon + 1 < scene.polygons.size(); ++polygon) {
    for (std::size_t loop = scene.polygons[polygon]; loop < scene.polygons[polygon + 1]; ++loop) {
      Place before = place(scene.loops[loop + 1] - 1);
      for (std::size_t corner = scene.loops[loop]; corner < scene.loops[loop + 1]; ++corner)
        canvas.cross(std::exchange(before, place(corner)), place(corner));
    }
    canvas.fill_crossed(opaque(scene.colour(polygon, palette)));
  }
}

}  // namespace

Image fill_faces(const Scene& scene) {
  Canvas canvas(scene.width, scene.height);
  const Palette palette = scene.palette();
  fill_triangles(scene, palette, canvas);
  fill_polygons(scene, palette, canvas);
  return canvas.average();
}

}  // namespace delone::io
