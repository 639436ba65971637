// Diagrams as files: cells, numbers and expectations are written by hand.
#include "delone/io/diagram_file.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <regex>
#include <set>

#include "io/diagram_io.hpp"
#include "io/files.hpp"
#include "io/scene.hpp"

namespace delone::io {
namespace {

using Json = nlohmann::json;

/// Cells with the view that the writers take.
struct Diagram {
  PointTable points;
  CellShapes shapes;
  CellMeasures measures;
  Names status;
  std::vector<float> tone;
  PolytopeTable subsets;

  DiagramView view() const {
    return {points,
            shapes,
            measures,
            status.empty() ? nullptr : &status,
            tone.empty() ? nullptr : &tone,
            subsets.size() == 0 ? nullptr : &subsets};
  }
  std::string text(const std::string& extension) const {
    const Directory directory;
    write_diagram(directory / ("a." + extension), *diagram_format(extension), view(), {.width = 200});
    return contents(directory / ("a." + extension));
  }
  void add_loop(const Doubles& corners) {
    shapes.corners.insert(shapes.corners.end(), corners.begin(), corners.end());
    shapes.loops.push_back(shapes.corners.size() / static_cast<std::size_t>(shapes.dimension));
  }
  void end_cell(Index row) {
    shapes.cells.push_back(shapes.loops.size() - 1);
    shapes.rows.push_back(row);
  }
};

/// Row 0 has a square with a square hole, row 1 what fills the hole and a triangle beside, row 2 is hidden.
Diagram plane() {
  Diagram d;
  d.points.dimension = 2;
  d.points.coordinate_names = {"x", "y"};
  d.points.coordinates = {0.5, 0.5, 1.5, 1.5, 2, 3};
  d.points.attributes = {{"people", {10, 20, 30}, {}}, {"na\"me", {}, {"Ulm, old", "\"K\u00f6ln\"", ""}}};
  d.status = {"vertex", "vertex", "hidden"};
  d.add_loop({0, 0, 4, 0, 4, 4, 0, 4});
  d.add_loop({1, 1, 1, 2, 2, 2, 2, 1});
  d.end_cell(0);
  d.add_loop({1, 1, 2, 1, 2, 2, 1, 2});
  d.add_loop({5, 0, 6, 0, 6, 1});
  d.end_cell(1);
  d.end_cell(2);
  d.shapes.across = {kNone, kNone, kNone, kNone, 1, 1, 1, 1, 0, 0, 0, 0, kNone, kNone, kNone};
  d.measures.volume = {15, 1.5, 0};
  d.measures.surface = {20, 7.5, 0};
  d.measures.boundary = {16, 3.5, 0};
  d.measures.centroid = {2.0625, 2.0625, 2.75, 1.125, 2, 3};
  d.measures.second_moment = {0.1, 1e300, 0};
  d.measures.offsets = {0, 1, 2, 2};
  d.measures.neighbours = {1, 0};
  d.measures.shared = {4, 4};
  return d;
}

/// Row 1 has the unit cube, its faces equal up to rounding; row 0 nothing.
Diagram cube() {
  Diagram d;
  d.points.dimension = 3;
  d.points.coordinate_names = {"x", "y", "z"};
  d.points.coordinates = {9, 9, 9, 0.5, 0.5, 0.5};
  d.points.weights = {-1, 2};
  d.shapes.dimension = d.measures.dimension = 3;
  d.end_cell(0);
  for (const Doubles& face :
       {Doubles{0, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, Doubles{0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1},
        Doubles{0, 0, 0, 1, 0, 0, 1, 0, 1, -0.0, 0, 1}, Doubles{0, 1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0},
        Doubles{0, 0, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0}, Doubles{1 + 0x1p-52, 0, 0, 1, 1, 0, 1, 1, 1, 1, -0x1p-54, 1}})
    d.add_loop(face);
  d.end_cell(1);
  d.shapes.across.assign(6, kNone);
  d.measures.volume = {0, 1};
  d.measures.surface = {0, 6};
  d.measures.boundary = {0, 6};
  d.measures.centroid = {9, 9, 9, 0.5, 0.5, 0.5};
  d.measures.second_moment = {0, 0.25};
  d.measures.offsets = {0, 0, 0};
  return d;
}

/// The arrays of a VTK file by name, each a string of bytes, with its type.
struct Vtu {
  explicit Vtu(const std::string& file) {
    const std::regex tag("<DataArray type=\"(\\w+)\" Name=\"([^\"]*)\"[^>]*offset=\"(\\d+)\"");
    const std::size_t data = file.find("encoding=\"raw\">\n_") + 17;
    for (std::sregex_iterator match(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(data), tag), end;
         match != end; ++match) {
      const std::size_t at = data + std::stoul((*match)[3]);
      std::uint64_t length = 0;
      std::memcpy(&length, file.data() + at, 8);
      types[(*match)[2]] = (*match)[1];
      bytes[(*match)[2]] = file.substr(at + 8, length);
    }
  }
  template <class T>
  std::vector<T> get(const std::string& name) const {
    std::vector<T> numbers(bytes.at(name).size() / sizeof(T));
    std::memcpy(numbers.data(), bytes.at(name).data(), bytes.at(name).size());
    return numbers;
  }
  std::vector<std::int64_t> whole(const std::string& name) const {
    EXPECT_EQ(types.at(name), "Int64") << name;
    return get<std::int64_t>(name);
  }
  Doubles numbers(const std::string& name) const {
    EXPECT_EQ(types.at(name), "Float64") << name;
    return get<double>(name);
  }

  std::map<std::string, std::string> types, bytes;
};

/// The signed area of the loop through these corners.
template <class Corners>
double area(const Doubles& coordinates, const Corners& corners, std::size_t stride) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double* const a = &coordinates[static_cast<std::size_t>(corners[i]) * stride];
    const double* const b = &coordinates[static_cast<std::size_t>(corners[(i + 1) % corners.size()]) * stride];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum / 2;
}

TEST(DiagramFile, formats_are_known_by_name_and_extension) {
  EXPECT_EQ(diagram_format("vtu"), DiagramFormat::vtu);
  EXPECT_EQ(diagram_format("json"), DiagramFormat::geojson);
  EXPECT_EQ(diagram_format("off"), std::nullopt);
  EXPECT_EQ(diagram_format_of_path("a.b/c.GeoJSON.gz"), DiagramFormat::geojson);
  EXPECT_EQ(diagram_format_of_path("c.png.gz"), std::nullopt);
  EXPECT_EQ(diagram_format_of_path("csv"), std::nullopt);
  EXPECT_TRUE(holds_space(DiagramFormat::csv));
  EXPECT_FALSE(holds_space(DiagramFormat::svg));
}

TEST(DiagramFile, csv_has_a_line_per_row) {
  EXPECT_EQ(plane().text("csv"),
            "x,y,people,\"na\"\"me\",area,perimeter,boundary,neighbours,cx,cy,second_moment\n"
            "0.5,0.5,10,\"Ulm, old\",15,20,16,1,2.0625,2.0625,0.1\n"
            "1.5,1.5,20,\"\"\"K\u00f6ln\"\"\",1.5,7.5,3.5,1,2.75,1.125,1e+300\n"
            "2,3,30,\"\",0,0,0,0,2,3,0\n");
  EXPECT_EQ(cube().text("csv"),
            "x,y,z,weight,volume,surface,boundary,neighbours,cx,cy,cz,second_moment\n"
            "9,9,9,-1,0,0,0,0,9,9,9,0\n"
            "0.5,0.5,0.5,2,1,6,6,0,0.5,0.5,0.5,0.25\n");
}

TEST(DiagramFile, csv_is_read_back_as_points_with_attributes) {
  ReadOptions options;
  options.columns = {"x", "y"};
  options.attributes = true;
  const PointTable table = read("a.csv", plane().text("csv"), options);
  EXPECT_EQ(table.coordinates, plane().points.coordinates);
  EXPECT_EQ(table.attributes[1].texts, plane().points.attributes[1].texts);
  EXPECT_EQ(table.attributes[2].numbers, plane().measures.volume);
}

TEST(DiagramFile, rows_without_a_cell_are_zero_in_csv_and_cells_may_come_in_any_order) {
  Diagram d = plane();
  d.shapes.rows = {2, 0, 1};  // row 0 gets the second cell
  const std::string text = d.text("csv");
  EXPECT_NE(text.find("0.5,0.5,10,\"Ulm, old\",1.5,7.5,"), std::string::npos);
  d.points.coordinates.insert(d.points.coordinates.end(), {7, 7});
  d.points.attributes.clear();
  EXPECT_NE(d.text("csv").find("\n7,7,0,0,0,0,0,0,0\n"), std::string::npos);
}

TEST(DiagramFile, names_that_attributes_have_are_lengthened) {
  Diagram d = plane();
  d.points.attributes = {{"area", {1, 2, 3}, {}}, {"cell_area", {4, 5, 6}, {}}, {"row", {7, 8, 9}, {}}};
  d.points.coordinate_names = {"cx", "y"};
  EXPECT_TRUE(
      d.text("csv").starts_with("cx,y,area,cell_area,row,cell_cell_area,perimeter,boundary,neighbours,cell_cx,"));
  const Json properties = Json::parse(d.text("geojson"))["features"][1]["properties"];
  EXPECT_EQ(properties["row"], 8);
  EXPECT_EQ(properties["cell_row"], 1);
  EXPECT_EQ(properties["cell_cell_area"], 1.5);
}

TEST(DiagramFile, geojson_has_polygons_with_holes_and_multipolygons) {
  const Json document = Json::parse(plane().text("geojson"));
  EXPECT_EQ(document["type"], "FeatureCollection");
  const Json& features = document["features"];
  ASSERT_EQ(features.size(), 3u);
  EXPECT_EQ(features[0]["geometry"], Json::parse(R"({"type":"Polygon","coordinates":
      [[[0,0],[4,0],[4,4],[0,4],[0,0]],[[1,1],[1,2],[2,2],[2,1],[1,1]]]})"));
  EXPECT_EQ(features[1]["geometry"], Json::parse(R"({"type":"MultiPolygon","coordinates":
      [[[[1,1],[2,1],[2,2],[1,2],[1,1]]],[[[5,0],[6,0],[6,1],[5,0]]]]})"));
  EXPECT_TRUE(features[2]["geometry"].is_null());
}

TEST(DiagramFile, geojson_carries_attributes_and_measures) {
  Diagram d = plane();
  d.points.weights = {0.25, 0, -1};
  d.measures.volume[1] = std::numeric_limits<double>::infinity();  // huge coordinates can bring that about
  const Json features = Json::parse(d.text("geojson"))["features"];
  EXPECT_EQ(features[0]["properties"], Json::parse(R"({"row":0,"people":10,"na\"me":"Ulm, old","weight":0.25,
      "area":15,"perimeter":20,"boundary":16,"neighbours":1,"cx":2.0625,"cy":2.0625,"second_moment":0.1})"));
  EXPECT_EQ(features[1]["properties"]["na\"me"], "\"K\u00f6ln\"");
  EXPECT_TRUE(features[1]["properties"]["area"].is_null());
  EXPECT_EQ(features[1]["properties"]["second_moment"], 1e300);
}

TEST(DiagramFile, vtu_has_a_polygon_per_piece_with_holes_bridged) {
  Diagram d = plane();
  d.points.weights = {0.25, 0, -1};
  const std::string file = d.text("vtu");
  EXPECT_NE(file.find("<Piece NumberOfPoints=\"15\" NumberOfCells=\"3\">"), std::string::npos);
  const Vtu vtu(file);
  EXPECT_EQ(vtu.whole("offsets"), (std::vector<std::int64_t>{10, 14, 17}));
  EXPECT_EQ(vtu.get<unsigned char>("types"), (std::vector<unsigned char>{7, 7, 7}));
  EXPECT_EQ(vtu.whole("row"), (std::vector<std::int64_t>{0, 1, 1}));
  EXPECT_EQ(vtu.whole("neighbours"), (std::vector<std::int64_t>{1, 1, 1}));
  EXPECT_EQ(vtu.numbers("area"), (Doubles{15, 1.5, 1.5}));
  EXPECT_EQ(vtu.numbers("people"), (Doubles{10, 20, 20}));
  EXPECT_EQ(vtu.numbers("weight"), (Doubles{0.25, 0, 0}));
  EXPECT_FALSE(vtu.types.contains("na&quot;me"));
  const Doubles points = vtu.numbers("Points");
  const std::vector<std::int64_t> ids = vtu.whole("connectivity");
  const std::vector<std::int64_t> first(ids.begin(), ids.begin() + 10);
  EXPECT_EQ(area(points, first, 3), 15);
  EXPECT_EQ(area(points, std::vector(ids.begin() + 14, ids.end()), 3), 0.5);
}

TEST(DiagramFile, vtu_has_polyhedra_whose_faces_share_points) {
  const std::string file = cube().text("vtu");
  EXPECT_NE(file.find("<Piece NumberOfPoints=\"8\" NumberOfCells=\"1\">"), std::string::npos);
  const Vtu vtu(file);
  EXPECT_EQ(vtu.get<unsigned char>("types"), std::vector<unsigned char>{42});
  EXPECT_EQ(vtu.whole("connectivity"), (std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(vtu.whole("faceoffsets"), std::vector<std::int64_t>{31});
  EXPECT_EQ(vtu.whole("row"), std::vector<std::int64_t>{1});
  EXPECT_EQ(vtu.numbers("weight"), Doubles{2});
  const std::vector<std::int64_t> faces = vtu.whole("faces");
  ASSERT_EQ(faces.size(), 31u);
  EXPECT_EQ(faces[0], 6);
  // Six times the volume, from the planes through the faces: the sum of det(a, b, c) over triangles of fans.
  const Doubles x = vtu.numbers("Points");
  double volume = 0;
  std::set<std::array<std::int64_t, 2>> edges;
  for (std::size_t face = 1; face < faces.size(); face += 5) {
    ASSERT_EQ(faces[face], 4);
    const auto at = [&](std::size_t i) { return &x[static_cast<std::size_t>(faces[face + 1 + i]) * 3]; };
    for (std::size_t i = 0; i < 4; ++i) edges.insert({faces[face + 1 + i], faces[face + 1 + (i + 1) % 4]});
    for (const std::size_t i : {1u, 2u}) {
      const double *a = at(0), *b = at(i), *c = at(i + 1);
      volume +=
          a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  EXPECT_NEAR(volume, 6, 1e-15);
  EXPECT_TRUE(std::ranges::all_of(edges, [&](const auto& edge) { return edges.contains({edge[1], edge[0]}); }));
}

TEST(DiagramFile, cells_of_several_rows_go_with_them) {
  Diagram d = plane();
  d.subsets.offsets = {0, 2, 4, 6};
  d.subsets.vertices = {0, 1, 1, 2, 0, 2};
  EXPECT_TRUE(d.text("csv").starts_with(
      "rows,area,perimeter,boundary,neighbours,cx,cy,second_moment\n0 1,15,20,16,1,2.0625,2.0625,0.1\n1 2,1.5,"));
  const Json properties = Json::parse(d.text("geojson"))["features"][1]["properties"];
  EXPECT_EQ(properties["rows"], (std::vector{1, 2}));
  EXPECT_FALSE(properties.contains("people"));
  const Vtu vtu(d.text("vtu"));
  EXPECT_EQ(vtu.whole("rows"), (std::vector<std::int64_t>{0, 1, 1, 2, 1, 2}));
  EXPECT_FALSE(vtu.types.contains("people"));
}

TEST(DiagramFile, cells_of_space_are_refused_where_a_format_has_no_room) {
  for (const std::string format : {"geojson", "svg", "png"}) {
    EXPECT_EQ(refusal([&] { cube().text(format); }),
              format + " files hold cells of the plane, these are of space: write vtu or csv");
  }
  const Directory directory;
  EXPECT_EQ(refusal([&] { write_diagram(directory / "a.png.gz", DiagramFormat::png, plane().view()); }),
            "png files are not compressed: leave out .gz");
}

TEST(DiagramFile, no_cells_are_written_as_none) {
  Diagram d;
  d.points.dimension = 2;
  d.points.coordinate_names = {"x", "y"};
  for (const char* format : {"vtu", "geojson", "svg", "png"}) EXPECT_NO_THROW(d.text(format)) << format;
  EXPECT_EQ(d.text("csv"), "x,y,area,perimeter,boundary,neighbours,cx,cy,second_moment\n");
  EXPECT_TRUE(Json::parse(d.text("geojson"))["features"].empty());
}

TEST(DiagramFile, files_are_the_same_each_time_and_compressed_where_the_name_says_so) {
  const Directory directory;
  for (const char* name : {"a.geojson.gz", "b.geojson.gz"})
    write_diagram(directory / name, *diagram_format_of_path(name), plane().view());
  EXPECT_EQ(contents(directory / "a.geojson.gz"), contents(directory / "b.geojson.gz"));
  EXPECT_EQ(contents(directory / "a.geojson.gz").substr(0, 2), "\x1f\x8b");
}

// --- bridges

/// Do the open segments ab and cd cross each other? Coordinates are small multiples of 1/8, so that this is exact.
bool cross(const Doubles& x, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  const auto side = [&](std::size_t p, std::size_t q, std::size_t r) {
    const double det =
        (x[2 * q] - x[2 * p]) * (x[2 * r + 1] - x[2 * p + 1]) - (x[2 * q + 1] - x[2 * p + 1]) * (x[2 * r] - x[2 * p]);
    return (det > 0) - (det < 0);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// The first loop with all others as holes, as one loop of the same area that crosses itself nowhere.
std::vector<std::size_t> joined(const Diagram& d) {
  std::vector<std::size_t> corners;
  const std::size_t loops = d.shapes.loops.size() - 1;
  append_bridged(d.shapes, 0, loops, corners);
  EXPECT_EQ(corners.size(), d.shapes.corners.size() / 2 + 2 * (loops - 1));
  double expected = 0;
  for (std::size_t loop = 0; loop < loops; ++loop) {
    std::vector<std::size_t> ring(d.shapes.loops[loop + 1] - d.shapes.loops[loop]);
    std::iota(ring.begin(), ring.end(), d.shapes.loops[loop]);
    expected += area(d.shapes.corners, ring, 2);
    EXPECT_EQ(loop == 0, area(d.shapes.corners, ring, 2) > 0) << "the test's own loop " << loop;
  }
  EXPECT_EQ(area(d.shapes.corners, corners, 2), expected);
  const auto next = [&](std::size_t i) { return corners[(i + 1) % corners.size()]; };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(cross(d.shapes.corners, corners[i], next(i), corners[k], next(k))) << i << ' ' << k;
  }
  return corners;
}

/// The corner from which the way leads to this one, the first corner of a hole that it comes to.
std::size_t joined_to(const Diagram& d, std::size_t hole_corner) {
  const std::vector<std::size_t> corners = joined(d);
  return *(std::ranges::find(corners, hole_corner) - 1);
}

TEST(Bridge, many_holes_that_line_up_are_joined_without_crossings) {
  std::mt19937 random(7);
  for (int round = 0; round < 30; ++round) {
    Diagram d;
    d.add_loop({-4, -4, 44, -4, 44, 44, 20, 12 + double(round % 20), -4, 44});  // the fourth corner dents it
    for (int y = 0; y < 8; y += 4) {
      for (int x = 0; x < 40; x += 4) {
        if (random() % 3 == 0) continue;
        random() % 2 == 0 ? d.add_loop({x + 0.0, y + 0.0, x + 0.0, y + 3.0, x + 3.0, y + 0.0})
                          : d.add_loop({x + 0.0, y + 0.0, x + 1.0, y + 1.0, x + 0.0, y + 3.0, x + 2.0, y + 1.0});
      }
    }
    joined(d);
  }
}

TEST(Bridge, a_corner_behind_a_wall_is_not_the_nearest) {
  Diagram d;  // a wall hangs down at x = 5; behind it a tip points at the hole
  d.add_loop({0, 0, 10, 0, 10, 4, 5.5, 5, 10, 6, 10, 10, 5.25, 10, 5.25, 1, 5, 1, 5, 10, 0, 10});
  d.add_loop({4.75, 5, 4, 4, 4, 6});
  EXPECT_EQ(joined_to(d, 11), 8u);  // the foot of the wall
}

TEST(Bridge, a_corner_behind_the_hole_itself_is_not_the_nearest) {
  Diagram d;
  d.add_loop({0, 0, 10, 0, 10, 10, 0, 10, 0, 5});
  d.add_loop({1, 5, 0.5, 4, 0.5, 6});
  EXPECT_GE(d.shapes.corners[2 * joined_to(d, 5)], 1);
}

TEST(Bridge, a_tip_is_seen_from_above_and_below) {
  for (const double y : {4.25, 5.75}) {
    Diagram d;
    d.add_loop({0, 0, 10, 0, 10, 4, 5.5, 5, 10, 6, 10, 10, 0, 10});
    d.add_loop({5.375, y, 4, y - 0.25, 4, y + 0.25});
    EXPECT_EQ(joined_to(d, 7), 3u) << y;
  }
}

TEST(Bridge, an_edge_on_the_same_line_but_elsewhere_is_no_wall) {
  Diagram d;
  d.add_loop({0, 0, 10, 0, 10, 4, 6, 5, 10, 6, 10, 10, 0, 10, 0, 5, 1, 5, 1, 4, 0, 4});
  d.add_loop({4, 5, 3, 4.5, 3, 5.5});
  EXPECT_EQ(joined_to(d, 11), 3u);
}

TEST(Bridge, a_corner_that_two_holes_are_joined_to_keeps_them_in_their_order) {
  for (const bool upper_first : {true, false}) {
    Diagram d;  // corner 2 at (10, 5) is the nearest of both; the hole that lies further right comes first
    d.add_loop({0, 0, 10, 0, 10, 5, 10, 10, 0, 10});
    d.add_loop({upper_first ? 9.5 : 8.0, 6, 7, 6, 7, 6.5});
    d.add_loop({upper_first ? 8.0 : 9.5, 4, 7, 4, 7, 4.5});
    const std::vector<std::size_t> corners = joined(d);
    // Going up the right side, the lower hole is met before the upper one.
    EXPECT_LT(std::ranges::find(corners, 8u), std::ranges::find(corners, 5u)) << upper_first;
    EXPECT_EQ(std::ranges::count(corners, 2u), 3) << upper_first;
  }
}

TEST(Bridge, a_hole_that_touches_the_outer_loop_is_joined_there) {
  Diagram d;
  d.add_loop({0, 0, 8, 0, 8, 4, 8, 8, 0, 8});
  d.add_loop({8, 4, 4, 2, 2, 4});
  EXPECT_EQ(joined_to(d, 5), 2u);
}

// --- pictures

TEST(DiagramPicture, pixels_within_cells_have_their_colours) {
  Diagram d = plane();
  d.tone = {0, 1, 0};
  const Scene scene = compose(d.view(), {.width = 400});
  const Image image = fill_faces(scene);
  const Frame frame({Range{0, 6}, Range{0, 4}}, {.width = 400});
  const auto pixel = [&](double x, double y) {
    const auto [px, py] = frame({x, y});
    return image
        .pixels[static_cast<std::size_t>(py) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(px)];
  };
  const auto colour = [&](float tone) {
    const Colour c = scene.palette()(tone);
    return 0xFF00'0000U | std::uint32_t{c.red} << 16 | std::uint32_t{c.green} << 8 | c.blue;
  };
  EXPECT_EQ(pixel(3, 3), colour(0));
  EXPECT_EQ(pixel(0.5, 1.5), colour(0));
  EXPECT_EQ(pixel(1.5, 1.5), colour(1));  // within the hole
  EXPECT_EQ(pixel(5.8, 0.5), colour(1));  // the other piece
  EXPECT_EQ(pixel(5, 2), 0u);
}

TEST(DiagramPicture, cells_fill_their_region_without_seams) {
  Diagram d = plane();
  const Scene scene = compose(d.view(), {.width = 401});
  const double unit = scene.at[1][0] / 4 - scene.at[0][0] / 4;  // pixels
  std::size_t opaque = 0;
  std::size_t partial = 0;
  for (const std::uint32_t pixel : fill_faces(scene).pixels) {
    opaque += (pixel >> 24) == 255 ? 1U : 0U;
    partial += (pixel >> 24) != 255 && (pixel >> 24) != 0 ? 1U : 0U;
  }
  EXPECT_NEAR(static_cast<double>(opaque), 16.5 * unit * unit, 12 * unit);
  EXPECT_LT(static_cast<double>(partial), 20 * unit);  // on the rim only: 16 + 2 + sqrt(2) units long
}

TEST(DiagramPicture, small_cells_are_dark_and_edges_come_once) {
  const Scene scene = compose(plane().view(), {.width = 400});
  ASSERT_EQ(scene.face_count(), 2u);
  EXPECT_LT(scene.tone[0], scene.tone[1]);
  EXPECT_EQ(scene.edges.size(), 4u);  // round the hole
  EXPECT_EQ(scene.rim.size(), 7u);    // of the square and of the triangle
}

TEST(DiagramPicture, hidden_sites_are_told_apart_and_those_outside_are_not_shown) {
  Diagram d = plane();
  d.points.coordinates = {0.5, 0.5, 100, 1.5, 2, 3};
  const Scene scene = compose(d.view(), {.width = 400});
  EXPECT_EQ(scene.vertices, std::vector<Index>{15});
  EXPECT_EQ(scene.hidden, std::vector<Index>{17});
}

TEST(DiagramPicture, huge_and_tiny_coordinates_fit) {
  for (const double unit : {2.9e307, 1e-310}) {
    Diagram d = plane();
    for (double& x : d.shapes.corners) x *= unit;
    for (double& x : d.points.coordinates) x *= unit;
    const Scene scene = compose(d.view(), {.width = 400});
    for (const auto& [x, y] : scene.at) {
      EXPECT_GE(x, 0) << unit;
      EXPECT_LE(x, 400) << unit;
    }
  }
}

TEST(DiagramPicture, svg_has_paths_and_png_is_a_png) {
  const std::string svg = plane().text("svg");
  EXPECT_EQ(svg.find("<image"), std::string::npos);
  // 188 pixels for 6 units, margins of 6: a square of 125.33 pixels whose middle is at 137 / 2.
  EXPECT_NE(svg.find("viewBox=\"0 0 2000 1370\""), std::string::npos);
  EXPECT_NE(svg.find("M60 1312l1253 0 0-1254-1253 0z"), std::string::npos);
  EXPECT_EQ(plane().text("png").substr(0, 8), "\x89PNG\r\n\x1a\n");
}

}  // namespace
}  // namespace delone::io
