#include "io/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/facets.hpp"

namespace delone::io {
namespace {

constexpr std::array kSizeStops{Colour{250, 246, 234}, Colour{222, 234, 220}, Colour{150, 203, 196},
                                Colour{66, 146, 172},  Colour{26, 82, 130},   Colour{16, 46, 92}};
constexpr std::array kHeightStops{Colour{38, 84, 102},   Colour{66, 136, 112}, Colour{150, 184, 122},
                                  Colour{232, 220, 160}, Colour{205, 156, 98}, Colour{150, 98, 74}};

/// The values below and above which lie 2 % of `numbers`.
Range without_outliers(std::vector<float> numbers) {
  Range range;
  if (numbers.empty()) return {0, 0};
  for (const double share : {0.02, 0.98}) {
    const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(numbers.size() - 1));
    std::ranges::nth_element(numbers, place);
    range.include(*place);
  }
  return range;
}

/// The sizes (logarithms of area) between which tones vary. Large: 8 % of the picture's area lies in larger triangles,
/// since area is what the eye sees. Small: midway between what the eye sees and what most triangles are, so that
/// neither the dense places nor the wide ones become all one colour.
Range range_of_sizes(const std::vector<float>& sizes) {
  constexpr std::size_t kEnough = 100'000;
  std::vector<float> sample;
  for (std::size_t i = 0; i < sizes.size(); i += sizes.size() / kEnough + 1) sample.push_back(sizes[i]);
  if (sample.empty()) return {0, 0};
  std::ranges::sort(sample);
  double total = 0;
  for (const float size : sample) total += std::exp2(double{size});
  const auto seen = [&](double share) {  // the size below which lies this share of the area
    double below = 0;
    return *std::ranges::find_if(sample,
                                 [&](float size) { return (below += std::exp2(double{size})) >= share * total; });
  };
  const double large = seen(0.92);
  const double small = (double{seen(0.02)} + double{sample[sample.size() / 20]}) / 2;
  // Sizes that differ little get tones that differ little.
  constexpr double kLeast = 5;  // a factor of 32
  const double middle = (small + large) / 2;
  return {std::min(small, middle - kLeast / 2), std::max(large, middle + kLeast / 2)};
}

float tone_within(const Range& range, double x) {
  const double length = range.high - range.low;
  return length > 0 ? static_cast<float>(std::clamp((x - range.low) / length, 0.0, 1.0)) : 0.5F;
}

/// Gives the scene its size and every row its pixel.
void lay_out(const MeshView& mesh, const PictureOptions& options, Scene& scene) {
  const auto dimension = static_cast<std::size_t>(mesh.points.dimension);
  const std::size_t n = mesh.points.size();
  const auto place = [&](std::size_t row) {
    const double* const x = &mesh.points.coordinates[row * dimension];
    return std::array{x[0], dimension == 2 ? x[1] : 0.0};
  };
  std::array<Range, 2> ranges;
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t axis = 0; axis < 2; ++axis) ranges[axis].include(place(row)[axis]);
  }
  const Frame frame(ranges, options);
  scene.width = frame.width();
  scene.height = frame.height();
  scene.at.reserve(n);
  for (std::size_t row = 0; row < n; ++row) scene.at.push_back(frame(place(row)));
}

double double_area(const Scene& scene, const std::array<Index, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return std::abs((scene.at[b][0] - scene.at[a][0]) * (scene.at[c][1] - scene.at[a][1]) -
                  (scene.at[b][1] - scene.at[a][1]) * (scene.at[c][0] - scene.at[a][0]));
}

/// Triangles, edges and sizes of a list of simplices.
void add_simplices(const CellTable& cells, Scene& scene, std::vector<float>& sizes) {
  const auto corners = static_cast<std::size_t>(cells.corners);
  if (corners == 2) {
    for (std::size_t cell = 0; cell < cells.size(); ++cell) scene.edges.push_back({cells[cell][0], cells[cell][1]});
  }
  if (corners != 3) return;
  scene.triangles.reserve(cells.size());
  scene.edges.reserve(cells.size() * 3 / 2);
  const std::vector<Index> neighbours = neighbours_of(cells);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    scene.triangles.push_back({cells[cell][0], cells[cell][1], cells[cell][2]});
    sizes.push_back(static_cast<float>(std::log2(double_area(scene, scene.triangles.back()) + 1e-6)));
    for (std::size_t i = 0; i < 3; ++i) {
      const Index across = neighbours[cell * 3 + i];
      if (across == kNone || across > cell) scene.edges.push_back({cells[cell][(i + 1) % 3], cells[cell][(i + 2) % 3]});
    }
  }
}

/// The same of merged polygons; the triangles of one polygon all have its size.
void add_polygons(const PolytopeTable& polygons, Scene& scene, std::vector<float>& sizes) {
  for (std::size_t cell = 0; cell < polygons.size(); ++cell) {
    const std::span<const Index> polygon = polygons[cell];
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Index a = polygon[i];
      const Index b = polygon[(i + 1) % polygon.size()];
      scene.edges.push_back({std::min(a, b), std::max(a, b)});
      if (i + 2 >= polygon.size()) continue;
      scene.triangles.push_back({polygon[0], polygon[i + 1], polygon[i + 2]});
      area += double_area(scene, scene.triangles.back());
    }
    sizes.resize(scene.triangles.size(), static_cast<float>(std::log2(area + 1e-6)));
  }
  std::ranges::sort(scene.edges);
  scene.edges.erase(std::unique(scene.edges.begin(), scene.edges.end()), scene.edges.end());
}

/// Height as tone, and light from the upper left on the surface, its slopes exaggerated to a legible mean.
void light(const std::vector<double>& elevation, Scene& scene) {
  const Range range = without_outliers({elevation.begin(), elevation.end()});
  scene.height_tone.reserve(elevation.size());
  for (const double height : elevation) scene.height_tone.push_back(tone_within(range, height));

  // Sum over the triangles around each row of area times gradient, in tones per pixel, y upwards.
  std::vector<std::array<double, 3>> sums(elevation.size());
  double slope_sum = 0;
  double area_sum = 0;
  for (const auto& [a, b, c] : scene.triangles) {
    const std::array<double, 2> u{scene.at[b][0] - scene.at[a][0], scene.at[a][1] - scene.at[b][1]};
    const std::array<double, 2> v{scene.at[c][0] - scene.at[a][0], scene.at[a][1] - scene.at[c][1]};
    const double area = u[0] * v[1] - u[1] * v[0];
    if (std::abs(area) < 1e-9) continue;
    const double du = double{scene.height_tone[b]} - double{scene.height_tone[a]};
    const double dv = double{scene.height_tone[c]} - double{scene.height_tone[a]};
    const double turned = area > 0 ? 1 : -1;
    const std::array<double, 2> gradient{turned * (du * v[1] - dv * u[1]), turned * (dv * u[0] - du * v[0])};
    slope_sum += std::hypot(gradient[0], gradient[1]);
    area_sum += std::abs(area);
    for (const Index row : {a, b, c}) {
      sums[row][0] += gradient[0];
      sums[row][1] += gradient[1];
      sums[row][2] += std::abs(area);
    }
  }
  const double steepness = slope_sum > 0 ? 0.6 * area_sum / slope_sum : 0;
  constexpr std::array<double, 3> kLight{-0.5, 0.5, 0.70710678};
  scene.shade.reserve(elevation.size());
  for (const auto& [gx, gy, area] : sums) {
    const double sx = area > 0 ? steepness * gx / area : 0;
    const double sy = area > 0 ? steepness * gy / area : 0;
    const double cosine = (-sx * kLight[0] - sy * kLight[1] + kLight[2]) / std::sqrt(sx * sx + sy * sy + 1);
    scene.shade.push_back(static_cast<float>(std::clamp(0.45 + 0.55 * cosine / kLight[2], 0.4, 1.2)));
  }
}

void choose_dots(const MeshView& mesh, Scene& scene) {
  const std::size_t n = mesh.points.size();
  choose_widths(n, scene);
  if (scene.dot_radius == 0) return;
  std::vector<bool> used(n, false);
  for (const Index row : mesh.cells.vertices) used[row] = true;
  for (std::size_t row = 0; row < n; ++row) {
    if (used[row]) {
      scene.vertices.push_back(static_cast<Index>(row));
    } else if (mesh.row_status != nullptr && (*mesh.row_status)[row] == "hidden") {
      scene.hidden.push_back(static_cast<Index>(row));
    }
  }
}

}  // namespace

Palette::Palette(std::span<const Colour> stops) {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    const float place = static_cast<float>(i) * static_cast<float>(stops.size() - 1) / 255.0F;
    const std::size_t below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const float share = place - static_cast<float>(below);
    const auto mix = [share](int a, int b) { return static_cast<float>(a) + share * static_cast<float>(b - a); };
    const Colour& low = stops[below];
    const Colour& high = stops[below + 1];
    table_[i] = {mix(low.red, high.red), mix(low.green, high.green), mix(low.blue, high.blue)};
  }
}

Colour Palette::operator()(float tone, float shade) const {
  const auto& [red, green, blue] = table_[static_cast<std::size_t>(tone * 255.0F + 0.5F)];
  const auto byte = [shade](float x) { return static_cast<std::uint8_t>(std::min(x * shade + 0.5F, 255.0F)); };
  return {byte(red), byte(green), byte(blue)};
}

Palette Scene::palette() const { return lit() ? Palette(kHeightStops) : Palette(kSizeStops); }

Colour Scene::colour(std::size_t face, const Palette& palette) const {
  if (!lit()) return palette(tone[face]);
  const auto& [a, b, c] = triangles[face];
  return palette((height_tone[a] + height_tone[b] + height_tone[c]) / 3, (shade[a] + shade[b] + shade[c]) / 3);
}

double Scene::length(std::array<Index, 2> edge) const {
  return std::hypot(at[edge[0]][0] - at[edge[1]][0], at[edge[0]][1] - at[edge[1]][1]);
}

double Scene::opacity(std::array<Index, 2> edge) const {
  // The number of edges in a place grows with the square of their shortness: fading them by their length keeps the ink
  // per pixel bounded.
  const double strongest = face_count() == 0 ? 1.0 : lit() ? 0.35 : 0.5;
  return strongest * std::min(1.0, length(edge) / 14.0);
}

std::array<std::vector<std::array<Index, 2>>, kOpacitySteps + 1> Scene::edges_by_opacity() const {
  std::array<std::vector<std::array<Index, 2>>, kOpacitySteps + 1> groups;
  for (const auto& edge : edges) groups[static_cast<std::size_t>(opacity(edge) * kOpacitySteps + 0.5)].push_back(edge);
  auto& middle = groups[kOpacitySteps / 2];
  middle.insert(middle.end(), rim.begin(), rim.end());
  return groups;
}

Frame::Frame(const std::array<Range, 2>& shown, const PictureOptions& options)
    : width_(std::clamp(options.width, 16, 16384)),
      middle_{shown[0].middle(), shown[1].middle()},
      half_(std::max({shown[0].half(), shown[1].half(), 0.0})) {
  const double margin = std::max(6.0, 0.025 * width_);
  const double inner_width = width_ - 2 * margin;
  const double across = half_ > 0 ? std::max(shown[0].half() / half_, 1e-9) : 1;  // shares of the larger extent
  const double along = half_ > 0 ? std::max(shown[1].half() / half_, 1e-9) : 1e-9;
  const double inner_height = inner_width * std::clamp(along / across, 0.2, 1.4);
  height_ = static_cast<int>(std::lround(inner_height + 2 * margin));
  scale_ = std::min(inner_width / (2 * across), inner_height / (2 * along));
}

std::array<double, 2> Frame::operator()(std::array<double, 2> place) const {
  const auto shift = [&](std::size_t axis) {
    return half_ > 0 ? scale_ * ((place[axis] - middle_[axis]) / half_) : 0.0;
  };
  return {width_ / 2.0 + shift(0), height_ / 2.0 - shift(1)};
}

std::vector<float> tones_of_sizes(const std::vector<float>& sizes) {
  const Range range = range_of_sizes(sizes);
  std::vector<float> tones;
  tones.reserve(sizes.size());
  for (const float size : sizes) tones.push_back(1 - tone_within(range, size));
  return tones;
}

void choose_widths(std::size_t points, Scene& scene) {
  const double spacing = std::sqrt(scene.width * static_cast<double>(scene.height) / static_cast<double>(points + 1));
  scene.edge_width = std::clamp(spacing / 50, 0.8, 2.0);
  scene.dot_radius = spacing < 14 ? 0 : std::clamp(spacing / 18, 1.2, 6.0);
}

Scene compose(const MeshView& mesh, const PictureOptions& options, std::string_view format) {
  if (mesh.points.dimension > 2) {
    refuse_mesh(format, fmt::format("show points of the plane, these have {} dimensions: write vtu or ply",
                                    mesh.points.dimension));
  }
  const Embedding points(mesh, format);
  Scene scene;
  lay_out(mesh, options, scene);
  std::vector<float> sizes;
  if (mesh.merged != nullptr && mesh.cells.corners == 3) {
    add_polygons(polygons_of(mesh, format), scene, sizes);
  } else {
    add_simplices(mesh.cells, scene, sizes);
  }
  if (points.elevation() != nullptr) {
    light(*points.elevation(), scene);
  } else if (mesh.tone != nullptr && mesh.merged == nullptr && mesh.tone->size() == scene.triangles.size()) {
    scene.tone = *mesh.tone;
  } else {
    scene.tone = tones_of_sizes(sizes);
  }
  choose_dots(mesh, scene);
  return scene;
}

}  // namespace delone::io
