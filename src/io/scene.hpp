// What a picture of a triangulation or a diagram of the plane shows, in pixels and colours, before it becomes PNG or
// SVG.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "delone/io/diagram_file.hpp"
#include "io/mesh_io.hpp"

namespace delone::io {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
};

/// A colour between stops at equal distances; `tone` from 0 to 1.
class Palette {
 public:
  explicit Palette(std::span<const Colour> stops);
  /// @param shade  1 leaves the colour as it is, less darkens, more brightens
  Colour operator()(float tone, float shade = 1) const;

 private:
  std::array<std::array<float, 3>, 256> table_;
};

inline constexpr int kOpacitySteps = 8;  ///< edges are drawn in so many groups of like opacity

/// Faces are triangles, or the polygons of a diagram, coloured by their size (small ones dark), or where there is an
/// elevation by height and light.
struct Scene {
  int width = 0;
  int height = 0;
  std::vector<std::array<double, 2>> at;  ///< pixels per row, of a diagram per corner and then per row; y downwards
  std::vector<std::array<Index, 3>> triangles;  ///< merged polygons as fans
  /// Polygon p is what an odd number of the loops polygons[p] to polygons[p + 1] goes around; loop l has the corners
  /// loops[l] to loops[l + 1].
  std::vector<std::size_t> polygons{0}, loops{0};
  std::vector<float> tone;                  ///< per face, without elevation
  std::vector<float> height_tone;           ///< per row, with elevation
  std::vector<float> shade;                 ///< per row, with elevation
  std::vector<std::array<Index, 2>> edges;  ///< each once
  std::vector<std::array<Index, 2>> rim;    ///< of a diagram: where its region ends
  std::vector<Index> vertices;              ///< rows to be drawn as dots; empty when there are too many
  std::vector<Index> hidden;                ///< rows without a place in the triangulation, drawn likewise
  double dot_radius = 0;
  double edge_width = 1;

  bool lit() const { return !height_tone.empty(); }
  std::size_t face_count() const { return triangles.size() + polygons.size() - 1; }
  Palette palette() const;
  /// One colour for the whole face.
  Colour colour(std::size_t face, const Palette& palette) const;
  double length(std::array<Index, 2> edge) const;
  /// How opaque an edge is, 0 to 1: short ones fade, so that dense places stay legible instead of turning black.
  double opacity(std::array<Index, 2> edge) const;
  /// Group i is to be drawn with opacity i / kOpacitySteps. The rim is drawn alike whatever the length of its edges:
  /// they follow one another, and are no denser where they are short.
  std::array<std::vector<std::array<Index, 2>>, kOpacitySteps + 1> edges_by_opacity() const;
};

inline constexpr Colour kPaper{255, 255, 255};
inline constexpr Colour kInk{27, 44, 66};
inline constexpr Colour kHiddenInk{192, 57, 43};

/// @throws InputError when the points have more than 2 dimensions
Scene compose(const MeshView& mesh, const PictureOptions& options, std::string_view format);
/// Of a diagram of the plane.
Scene compose(const DiagramView& diagram, const PictureOptions& options);

/// The numbers from low to high, and none where it was never told of one.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  // Halved before they meet, so that nothing overflows.
  double middle() const { return low / 2 + high / 2; }
  double half() const { return high / 2 - low / 2; }
};

/// From coordinates to pixels: equal scales on both axes, a margin around.
class Frame {
 public:
  /// @param shown  what to make room for on either axis
  Frame(const std::array<Range, 2>& shown, const PictureOptions& options);
  int width() const { return width_; }
  int height() const { return height_; }
  std::array<double, 2> operator()(std::array<double, 2> place) const;

 private:
  int width_, height_;
  std::array<double, 2> middle_;
  double half_, scale_;
};

/// Tones for faces of these sizes, logarithms to base 2 of their areas: small ones dark.
std::vector<float> tones_of_sizes(const std::vector<float>& sizes);

/// Widths of lines and dots for a picture of `points` points; no dots where they would be too many.
void choose_widths(std::size_t points, Scene& scene);

/// The scene as the bytes of a PNG file.
std::string draw_png(const Scene& scene);

void write_png(const std::string& path, const Scene& scene);
void write_svg(const std::string& path, const Scene& scene);

/// Red, green, blue and coverage of each pixel, 8 bits each from the top of the word: 0xAARRGGBB, not premultiplied.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
};

/// The scene's faces without seams: every sample belongs to exactly one of them.
Image fill_faces(const Scene& scene);

}  // namespace delone::io
