// Pictures: that they show the right thing in the right place, not how they look.
#include <gtest/gtest.h>

#include "io/files.hpp"
#include "io/scene.hpp"

namespace delone::io {
namespace {

struct Drawing {
  PointTable points;
  CellTable cells;
  Scene scene(int width = 400) const {
    return compose({points, cells, 2, nullptr, nullptr, ""}, {.width = width}, "png");
  }
};

/// A lattice of k x k unit squares, each cut in two.
Drawing lattice(Index k) {
  Drawing drawing;
  drawing.points.dimension = 2;
  drawing.cells.corners = 3;
  const Index side = k + 1;
  for (Index y = 0; y < side; ++y) {
    for (Index x = 0; x < side; ++x) {
      drawing.points.coordinates.insert(drawing.points.coordinates.end(), {double(x), double(y)});
      if (x == k || y == k) continue;
      const Index a = y * side + x;
      for (const Index row : {a, a + 1, a + side, a + 1, a + side + 1, a + side}) drawing.cells.vertices.push_back(row);
    }
  }
  return drawing;
}

TEST(Scene, both_axes_have_one_scale_and_y_points_up) {
  Drawing drawing = lattice(1);
  drawing.points.coordinates = {0, 0, 200, 0, 0, 100, 200, 100};
  const Scene scene = drawing.scene(400);
  EXPECT_EQ(scene.width, 400);
  const double width = scene.at[1][0] - scene.at[0][0];
  EXPECT_NEAR(width, 380, 1e-9);  // margins of 2.5 %
  EXPECT_NEAR(scene.at[0][1] - scene.at[2][1], width / 2, 1e-9);
  EXPECT_NEAR(scene.height, width / 2 + 20, 1);
}

TEST(Scene, huge_and_tiny_coordinates_fit) {
  for (const double unit : {1.7e308, 1e-310}) {
    Drawing drawing = lattice(1);
    drawing.points.coordinates = {-unit, -unit, unit, -unit, -unit, unit, unit, unit};
    for (const auto& [x, y] : drawing.scene().at) {
      EXPECT_GE(x, 0) << unit;
      EXPECT_LE(x, 400) << unit;
      EXPECT_GE(y, 0) << unit;
      EXPECT_LE(y, 400) << unit;
    }
  }
}

TEST(Scene, every_edge_comes_once) { EXPECT_EQ(lattice(4).scene().edges.size(), 56u); }  // 20 + 20 + 16

TEST(Raster, triangles_cover_their_union_without_seams) {
  const Scene scene = lattice(7).scene(401);
  const Image image = fill_faces(scene);
  ASSERT_EQ(image.width, 401);
  std::size_t opaque = 0;
  std::size_t partial = 0;
  for (const std::uint32_t pixel : image.pixels) {
    opaque += (pixel >> 24) == 255 ? 1U : 0U;
    partial += (pixel >> 24) != 255 && (pixel >> 24) != 0 ? 1U : 0U;
  }
  const double side = scene.at[7][0] - scene.at[0][0];
  EXPECT_NEAR(static_cast<double>(opaque), side * side, 2.1 * side);
  EXPECT_LE(static_cast<double>(partial), 4 * side + 8);  // on the rim only
}

TEST(Raster, large_triangles_are_light_and_small_ones_dark) {
  Drawing drawing = lattice(1);
  drawing.points.coordinates = {0, 0, 10, 0, 0, 10, 10, 1};
  const Scene scene = drawing.scene();
  EXPECT_LT(scene.tone[0], scene.tone[1]);
  const Palette palette = scene.palette();
  EXPECT_GT(scene.colour(0, palette).green, scene.colour(1, palette).green);
}

TEST(Scene, short_edges_fade) {
  const Scene scene = lattice(100).scene();
  EXPECT_LT(scene.opacity(scene.edges.front()), lattice(1).scene().opacity({0, 1}));
}

TEST(Png, is_a_png_and_the_same_each_time) {
  const std::string bytes = draw_png(lattice(3).scene());
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
  EXPECT_EQ(bytes, draw_png(lattice(3).scene()));
}

TEST(Svg, few_triangles_are_paths_and_many_are_an_image) {
  const Directory directory;
  const Drawing few = lattice(2);
  write_svg(directory / "few.svg", {few.points, few.cells, 2, nullptr, nullptr, ""}, {.width = 200});
  const std::string text = contents(directory / "few.svg");
  EXPECT_EQ(text.find("<image"), std::string::npos);
  EXPECT_NE(text.find("viewBox=\"0 0 2000 2000\""), std::string::npos);
  EXPECT_NE(text.find("M60 1940l940 0-940-940z"), std::string::npos);
  const Drawing many = lattice(250);
  write_svg(directory / "many.svg", {many.points, many.cells, 2, nullptr, nullptr, ""}, {.width = 200});
  EXPECT_NE(contents(directory / "many.svg")
                .find("<image width=\"100%\" height=\"100%\" href=\"data:image/png;base64,iVBORw0KGgo"),
            std::string::npos);
}

}  // namespace
}  // namespace delone::io
