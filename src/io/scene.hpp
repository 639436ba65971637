// What a picture of a triangulation of the plane shows, in pixels and colours, before it becomes PNG or SVG.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

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

/// Faces are triangles coloured by their size (small ones dark), or where there is an elevation by height and light.
struct Scene {
  int width = 0;
  int height = 0;
  std::vector<std::array<double, 2>> at;        ///< pixels per row, y downwards
  std::vector<std::array<Index, 3>> triangles;  ///< merged polygons as fans
  std::vector<float> tone;                      ///< per triangle, without elevation
  std::vector<float> height_tone;               ///< per row, with elevation
  std::vector<float> shade;                     ///< per row, with elevation
  std::vector<std::array<Index, 2>> edges;      ///< each once
  std::vector<Index> vertices;                  ///< rows to be drawn as dots; empty when there are too many
  std::vector<Index> hidden;                    ///< rows without a place in the triangulation, drawn likewise
  double dot_radius = 0;
  double edge_width = 1;

  bool lit() const { return !height_tone.empty(); }
  Palette palette() const;
  /// One colour for the whole triangle.
  Colour colour(std::size_t triangle, const Palette& palette) const;
  double length(std::array<Index, 2> edge) const;
  /// How opaque an edge is, 0 to 1: short ones fade, so that dense places stay legible instead of turning black.
  double opacity(std::array<Index, 2> edge) const;
};

inline constexpr Colour kPaper{255, 255, 255};
inline constexpr Colour kInk{27, 44, 66};
inline constexpr Colour kHiddenInk{192, 57, 43};
inline constexpr int kOpacitySteps = 8;  ///< edges are drawn in so many groups of like opacity

/// @throws InputError when the points have more than 2 dimensions
Scene compose(const MeshView& mesh, const PictureOptions& options, std::string_view format);

/// The scene as the bytes of a PNG file.
std::string draw_png(const Scene& scene);

/// Red, green, blue and coverage of each pixel, 8 bits each from the top of the word: 0xAARRGGBB, not premultiplied.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
};

/// The scene's triangles without seams: every sample belongs to exactly one of them.
Image fill_triangles(const Scene& scene);

}  // namespace delone::io
