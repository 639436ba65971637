// Pictures of diagrams: cells as polygons, what separates two cells as an edge, sites as dots.
#include <cmath>

#include "io/diagram_io.hpp"
#include "io/scene.hpp"

namespace delone::io {
namespace {

/// The corners and then the sites get their pixels; the picture has room for all corners.
void lay_out(const DiagramView& diagram, const PictureOptions& options, Scene& scene) {
  const std::vector<double>& corners = diagram.shapes.corners;
  std::array<Range, 2> ranges;
  for (std::size_t i = 0; i < corners.size(); ++i) ranges[i % 2].include(corners[i]);
  const Frame frame(ranges, options);
  scene.width = frame.width();
  scene.height = frame.height();
  scene.at.reserve((corners.size() + diagram.points.coordinates.size()) / 2);
  for (const auto* places : {&corners, &diagram.points.coordinates}) {
    for (std::size_t i = 0; i < places->size(); i += 2) scene.at.push_back(frame({(*places)[i], (*places)[i + 1]}));
  }
}

/// In square pixels; holes count against it.
double area(const Scene& scene, std::size_t polygon) {
  double doubled = 0;
  for (std::size_t loop = scene.polygons[polygon]; loop < scene.polygons[polygon + 1]; ++loop) {
    std::array<double, 2> before = scene.at[scene.loops[loop + 1] - 1];
    for (std::size_t corner = scene.loops[loop]; corner < scene.loops[loop + 1]; ++corner) {
      const std::array<double, 2> here = scene.at[corner];
      doubled += before[0] * here[1] - before[1] * here[0];
      before = here;
    }
  }
  return std::abs(doubled) / 2;
}

void add_polygons(const DiagramView& diagram, Scene& scene) {
  const CellShapes& shapes = diagram.shapes;
  scene.loops = shapes.loops;
  std::vector<float> sizes;
  for (std::size_t cell = 0; cell < shapes.size(); ++cell) {
    if (shapes.empty(cell)) continue;
    scene.polygons.push_back(shapes.cells[cell + 1]);
    sizes.push_back(static_cast<float>(std::log2(area(scene, sizes.size()) + 1e-6)));
    if (diagram.tone != nullptr) scene.tone.push_back((*diagram.tone)[cell]);
  }
  if (diagram.tone == nullptr) scene.tone = tones_of_sizes(sizes);
}

/// Each edge once: of two cells that share one, that of the lower row.
void add_edges(const CellShapes& shapes, Scene& scene) {
  for (std::size_t cell = 0; cell < shapes.size(); ++cell) {
    for (std::size_t loop = shapes.cells[cell]; loop < shapes.cells[cell + 1]; ++loop) {
      const std::size_t first = shapes.loops[loop];
      const std::size_t last = shapes.loops[loop + 1];
      for (std::size_t corner = first; corner < last; ++corner) {
        if (shapes.across[corner] < shapes.rows[cell]) continue;
        const std::size_t next = corner + 1 == last ? first : corner + 1;
        auto& edges = shapes.across[corner] == kNone ? scene.rim : scene.edges;
        edges.push_back({static_cast<Index>(corner), static_cast<Index>(next)});
      }
    }
  }
}

/// Sites that the picture has room for; those of duplicates are there already.
void add_sites(const DiagramView& diagram, Scene& scene) {
  choose_widths(diagram.points.size(), scene);
  if (scene.dot_radius == 0) return;
  const std::size_t first = diagram.shapes.corners.size() / 2;
  for (std::size_t row = 0; row < diagram.points.size(); ++row) {
    const auto& [x, y] = scene.at[first + row];
    if (!(x >= 0 && x <= scene.width && y >= 0 && y <= scene.height)) continue;
    const std::string status = diagram.row_status == nullptr ? "vertex" : (*diagram.row_status)[row];
    if (status == "vertex") scene.vertices.push_back(static_cast<Index>(first + row));
    if (status == "hidden") scene.hidden.push_back(static_cast<Index>(first + row));
  }
}

}  // namespace

Scene compose(const DiagramView& diagram, const PictureOptions& options) {
  Scene scene;
  lay_out(diagram, options, scene);
  add_polygons(diagram, scene);
  add_edges(diagram.shapes, scene);
  add_sites(diagram, scene);
  return scene;
}

void write_diagram_svg(const std::string& path, const DiagramView& diagram, const PictureOptions& picture) {
  write_svg(path, compose(diagram, picture));
}

void write_diagram_png(const std::string& path, const DiagramView& diagram, const PictureOptions& picture) {
  write_png(path, compose(diagram, picture));
}

}  // namespace delone::io
