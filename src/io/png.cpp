// PNG pictures: faces by our own scan conversion, which leaves no seams between them; edges and dots by Cairo.
#include <cairo.h>

#include <memory>
#include <numbers>
#include <stdexcept>

#include "io/scene.hpp"

namespace delone::io {
namespace {

struct Release {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, Release>;
using Context = std::unique_ptr<cairo_t, Release>;

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("drawing: ") + cairo_status_to_string(status));
}

/// Blends the image onto paper.
void put_image(const Image& image, cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  unsigned char* const data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < image.height; ++y) {
    auto* const row = reinterpret_cast<std::uint32_t*>(data + std::ptrdiff_t{y} * stride);  // Cairo aligns rows so
    for (int x = 0; x < image.width; ++x) {
      const std::uint32_t pixel = image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                               static_cast<std::size_t>(x)];
      const std::uint32_t alpha = pixel >> 24;
      std::uint32_t blended = 0;
      for (const auto& [shift, paper] :
           {std::pair{16, kPaper.red}, std::pair{8, kPaper.green}, std::pair{0, kPaper.blue}}) {
        const std::uint32_t colour = pixel >> shift & 0xFFU;
        blended |= (colour * alpha + paper * (255 - alpha) + 127) / 255 << shift;
      }
      row[x] = blended;
    }
  }
  cairo_surface_mark_dirty(surface);
}

void set_colour(cairo_t* context, Colour colour, double opacity) {
  cairo_set_source_rgba(context, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, opacity);
}

/// Long paths are slow to draw, many short ones as well: this many edges at a time.
constexpr int kBatch = 20'000;

void draw_edges(const Scene& scene, cairo_t* context) {
  cairo_set_line_width(context, scene.edge_width);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  const auto groups = scene.edges_by_opacity();
  for (std::size_t step = 1; step < groups.size(); ++step) {
    set_colour(context, kInk, static_cast<double>(step) / kOpacitySteps);
    int waiting = 0;
    for (const auto& [a, b] : groups[step]) {
      cairo_move_to(context, scene.at[a][0], scene.at[a][1]);
      cairo_line_to(context, scene.at[b][0], scene.at[b][1]);
      if (++waiting % kBatch == 0) cairo_stroke(context);
    }
    cairo_stroke(context);
  }
}

void draw_dots(const Scene& scene, const std::vector<Index>& rows, Colour colour, cairo_t* context) {
  set_colour(context, colour, 1);
  for (const Index row : rows) {
    cairo_new_sub_path(context);
    cairo_arc(context, scene.at[row][0], scene.at[row][1], scene.dot_radius, 0, 2 * std::numbers::pi);
  }
  cairo_fill(context);
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string draw_png(const Scene& scene) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, scene.width, scene.height));
  require(cairo_surface_status(surface.get()));
  put_image(fill_faces(scene), surface.get());
  const Context context(cairo_create(surface.get()));
  draw_edges(scene, context.get());
  draw_dots(scene, scene.vertices, kInk, context.get());
  draw_dots(scene, scene.hidden, kHiddenInk, context.get());
  require(cairo_status(context.get()));
  std::string bytes;
  require(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

void write_png(const std::string& path, const Scene& scene) {
  Output out(path);
  out << draw_png(scene);
  out.commit();
}

void write_png(const std::string& path, const MeshView& mesh, const PictureOptions& picture) {
  write_png(path, compose(mesh, picture, "png"));
}

}  // namespace delone::io
