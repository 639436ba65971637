// SVG pictures. Coordinates are whole tenths of a pixel; faces of one colour make one path, edges of one opacity
// another. Where there are too many for a viewer, the picture is drawn here and the SVG holds it as an image.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <ranges>

#include "io/scene.hpp"

namespace delone::io {
namespace {

constexpr std::size_t kMostFaces = 60'000;
constexpr double kUnits = 10;  // per pixel

struct Spot {
  long x, y;
};

class Paths {
 public:
  Paths(const Scene& scene, Output& out) : scene_(scene), out_(out) {}

  /// M x y l dx dy dx dy: the first place, then steps.
  template <class Rows>
  void polyline(const Rows& rows) {
    Spot last{};
    std::size_t i = 0;
    for (const std::size_t row : rows) {
      const Spot spot{std::lround(scene_.at[row][0] * kUnits), std::lround(scene_.at[row][1] * kUnits)};
      if (i < 2) out_ << (i == 0 ? 'M' : 'l');
      number(spot.x - last.x, i >= 2);
      number(spot.y - last.y, true);
      last = spot;
      ++i;
    }
  }

  /// A triangle, or the loops of a polygon; holes run the other way round, so that they stay empty.
  void face(std::size_t face) {
    if (!scene_.triangles.empty()) {
      polyline(scene_.triangles[face]);
      out_ << 'z';
      return;
    }
    for (std::size_t loop = scene_.polygons[face]; loop < scene_.polygons[face + 1]; ++loop) {
      polyline(std::views::iota(scene_.loops[loop], scene_.loops[loop + 1]));
      out_ << 'z';
    }
  }

 private:
  /// A minus sign sets numbers apart as well as a blank does.
  void number(long value, bool follows) {
    if (follows && value >= 0) out_ << ' ';
    out_ << value;
  }

  const Scene& scene_;
  Output& out_;
};

std::string hex(Colour colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue); }

/// Near colours are made one, so that there are few paths.
Colour rounded(Colour colour) {
  const auto round = [](std::uint8_t x) { return static_cast<std::uint8_t>(std::min((x + 2) / 4 * 4, 255)); };
  return {round(colour.red), round(colour.green), round(colour.blue)};
}

void write_faces(const Scene& scene, Output& out) {
  std::map<std::string, std::vector<std::size_t>> groups;
  const Palette palette = scene.palette();
  for (std::size_t f = 0; f < scene.face_count(); ++f) groups[hex(rounded(scene.colour(f, palette)))].push_back(f);
  Paths paths(scene, out);
  out << "<g stroke-width=\"6\" stroke-linejoin=\"round\">\n";  // a stroke of its own colour closes the seams
  for (const auto& [colour, faces] : groups) {
    out.print("<path fill=\"{0}\" stroke=\"{0}\" d=\"", colour);
    for (const std::size_t f : faces) paths.face(f);
    out << "\"/>\n";
  }
  out << "</g>\n";
}

void write_edges(const Scene& scene, Output& out) {
  const auto groups = scene.edges_by_opacity();
  Paths paths(scene, out);
  out.print("<g fill=\"none\" stroke=\"{}\" stroke-width=\"{}\">\n", hex(kInk), std::lround(scene.edge_width * kUnits));
  for (std::size_t step = 1; step < groups.size(); ++step) {
    if (groups[step].empty()) continue;
    out.print("<path stroke-opacity=\"{}\" d=\"", static_cast<double>(step) / kOpacitySteps);
    for (const auto& edge : groups[step]) paths.polyline(edge);
    out << "\"/>\n";
  }
  out << "</g>\n";
}

/// Dots are lines of no length with round ends.
void write_dots(const Scene& scene, const std::vector<Index>& rows, Colour colour, Output& out) {
  if (rows.empty()) return;
  Paths paths(scene, out);
  out.print("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" d=\"", hex(colour),
            std::lround(2 * scene.dot_radius * kUnits));
  for (const Index row : rows) {
    paths.polyline(std::array{row});
    out << "h0";
  }
  out << "\"/>\n";
}

void write_base64(std::string_view bytes, Output& out) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out << (k <= count ? kDigits[word >> (18 - 6 * k) & 63U] : '=');
  }
  out << std::string_view();
}

}  // namespace

void write_svg(const std::string& path, const Scene& scene) {
  Output out(path);
  out.print("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {2} {3}\">\n",
            scene.width, scene.height, std::lround(scene.width * kUnits), std::lround(scene.height * kUnits));
  out.print("<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n", hex(kPaper));
  if (scene.face_count() + (scene.edges.size() + scene.rim.size()) / 2 > 2 * kMostFaces) {
    out << "<image width=\"100%\" height=\"100%\" href=\"data:image/png;base64,";
    write_base64(draw_png(scene), out);
    out << "\"/>\n";
  } else {
    write_faces(scene, out);
    write_edges(scene, out);
    write_dots(scene, scene.vertices, kInk, out);
    write_dots(scene, scene.hidden, kHiddenInk, out);
  }
  out << "</svg>\n";
  out.commit();
}

void write_svg(const std::string& path, const MeshView& mesh, const PictureOptions& picture) {
  write_svg(path, compose(mesh, picture, "svg"));
}

}  // namespace delone::io
