// Meshes as files: every expectation is written by hand, byte for byte where the format is text.
#include "delone/io/mesh_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <cstring>

#include "delone/io/cells_file.hpp"
#include "io/files.hpp"

namespace delone::io {
namespace {

/// Points and cells with the view that the writers take.
struct Mesh {
  PointTable points;
  CellTable cells;
  Names status;
  PolytopeTable merged;
  std::string elevation;

  MeshView view() const {
    return {points,
            cells,
            static_cast<std::size_t>(std::max(cells.corners - 1, 0)),
            status.empty() ? nullptr : &status,
            merged.size() == 0 ? nullptr : &merged,
            elevation};
  }
  std::string text(const std::string& extension) const {
    const Directory directory;
    write_mesh(directory / ("a." + extension), *mesh_format(extension), view());
    return contents(directory / ("a." + extension));
  }
  std::string refused(const std::string& extension) const {
    return refusal([&] { text(extension); });
  }
};

PointTable points_of(int dimension, Doubles coordinates) {
  PointTable table;
  table.dimension = dimension;
  table.coordinates = std::move(coordinates);
  return table;
}

/// The unit square cut by its diagonal from row 0 to row 3.
Mesh square() {
  Mesh mesh;
  mesh.points = points_of(2, {0, 0, 1, 0, 0, 1, 1, 1});
  mesh.cells = {3, {0, 1, 3, 0, 3, 2}, {kNone, 1, kNone, kNone, kNone, 0}};
  return mesh;
}

Mesh tetrahedron() {
  Mesh mesh;
  mesh.points = points_of(3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  mesh.cells = {4, {0, 1, 2, 3}, {kNone, kNone, kNone, kNone}};
  return mesh;
}

/// The square as one polygon, and a centre that is inside and a point within an edge, as weights can bring about.
Mesh merged_square() {
  Mesh mesh = square();
  mesh.points.coordinates.insert(mesh.points.coordinates.end(), {0.5, 0.5, 1, 0.5});
  mesh.merged.offsets = {0, 6};
  mesh.merged.vertices = {0, 1, 2, 3, 4, 5};
  return mesh;
}

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

TEST(MeshFile, formats_are_known_by_name_and_extension) {
  EXPECT_EQ(mesh_format("vtu"), MeshFormat::vtu);
  EXPECT_EQ(mesh_format("docx"), std::nullopt);
  EXPECT_EQ(mesh_format_of_path("a/b.c/d.NODE"), MeshFormat::node_ele);
  EXPECT_EQ(mesh_format_of_path("d.ele"), MeshFormat::node_ele);
  EXPECT_EQ(mesh_format_of_path("d.geojson.gz"), MeshFormat::geojson);
  EXPECT_EQ(mesh_format_of_path("d.vtu.gz"), std::nullopt);
  EXPECT_EQ(mesh_format_of_path("vtu"), std::nullopt);
}

TEST(MeshFile, csv_has_a_header_and_cells_has_none) {
  EXPECT_EQ(square().text("csv"), "v0,v1,v2\n0,1,3\n0,3,2\n");
  EXPECT_EQ(square().text("cells"), "0 1 3\n0 3 2\n");
}

TEST(MeshFile, off_and_obj_hold_triangles) {
  EXPECT_EQ(square().text("off"), "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 3\n3 0 3 2\n");
  EXPECT_EQ(square().text("obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4\nf 1 4 3\n");
}

TEST(MeshFile, off_and_obj_hold_the_surface_of_tetrahedra_seen_from_outside) {
  EXPECT_EQ(tetrahedron().text("obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 3 4\nf 1 4 3\nf 1 2 4\nf 1 3 2\n");
  EXPECT_EQ(tetrahedron().text("off"), "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 1 2 3\n3 0 3 2\n3 0 1 3\n3 0 2 1\n");
}

TEST(MeshFile, neighbours_are_found_where_they_are_not_given) {
  Mesh mesh = tetrahedron();
  mesh.points.coordinates.insert(mesh.points.coordinates.end(), {1, 1, 1});
  mesh.cells = {4, {0, 1, 2, 3, 1, 2, 3, 4}, {}};
  const Directory directory;
  write_mesh(directory / "a.node", MeshFormat::node_ele, mesh.view());
  EXPECT_EQ(contents(directory / "a.neigh"), "2 4\n0 1 -1 -1 -1\n1 -1 -1 -1 0\n");
}

TEST(MeshFile, node_ele_and_neigh_count_from_zero) {
  Mesh mesh = square();
  mesh.points.weights = {0.5, 1, 2, 0.1};
  const Directory directory;
  EXPECT_EQ(write_mesh(directory / "a.ele", MeshFormat::node_ele, mesh.view()),
            (Names{directory / "a.node", directory / "a.ele", directory / "a.neigh"}));
  EXPECT_EQ(contents(directory / "a.node"), "4 2 1 0\n0 0 0 0.5\n1 1 0 1\n2 0 1 2\n3 1 1 0.1\n");
  EXPECT_EQ(contents(directory / "a.ele"), "2 3 0\n0 0 1 3\n1 0 3 2\n");
  EXPECT_EQ(contents(directory / "a.neigh"), "2 3\n0 -1 1 -1\n1 -1 -1 0\n");
}

TEST(MeshFile, npy_is_a_pair) {
  const Directory directory;
  EXPECT_EQ(write_mesh(directory / "a.npy", MeshFormat::npy, square().view()),
            (Names{directory / "a_points.npy", directory / "a_cells.npy"}));
  const std::string points = contents(directory / "a_points.npy");
  EXPECT_EQ(points.substr(0, 10), std::string("\x93NUMPY\x01\0\x76\0", 10));
  EXPECT_EQ(points.substr(10, 61), "{'descr': '<f8', 'fortran_order': False, 'shape': (4, 2), }  ");
  ASSERT_EQ(points.size(), 128 + 64u);
  EXPECT_EQ(points[127], '\n');
  EXPECT_EQ(number_at<double>(points, 128 + 7 * 8), 1.0);
  EXPECT_EQ(read_cells(directory / "a_cells.npy", 4).vertices, square().cells.vertices);
}

TEST(MeshFile, geojson_rings_are_closed_and_counter_clockwise) {
  EXPECT_EQ(
      square().text("geojson"),
      "{\"type\":\"FeatureCollection\",\"features\":[\n"
      "{\"type\":\"Feature\",\"properties\":{\"rows\":[0,1,3]},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":"
      "[[[0,0],[1,0],[1,1],[0,0]]]}},\n"
      "{\"type\":\"Feature\",\"properties\":{\"rows\":[0,3,2]},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":"
      "[[[0,0],[1,1],[0,1],[0,0]]]}}\n]}\n");
}

TEST(MeshFile, vtu_is_what_the_vtk_documentation_says) {
  Mesh mesh = square();
  mesh.status = {"vertex", "vertex", "duplicate", "hidden"};
  mesh.points.attributes = {{"a<b", {1, 2, 3, 4}, {}}, {"name", {}, {"p", "q", "r", "s"}}};
  const std::string file = mesh.text("vtu");
  EXPECT_NE(file.find("<Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">"), std::string::npos);
  EXPECT_NE(file.find("type=\"Int32\" Name=\"connectivity\" format=\"appended\" offset=\"104\""), std::string::npos);
  EXPECT_NE(file.find("Name=\"offsets\" format=\"appended\" offset=\"136\""), std::string::npos);
  EXPECT_NE(file.find("Name=\"types\" format=\"appended\" offset=\"152\""), std::string::npos);
  EXPECT_NE(file.find("Name=\"a&lt;b\" format=\"appended\" offset=\"162\""), std::string::npos);
  EXPECT_NE(file.find("type=\"UInt8\" Name=\"status\" format=\"appended\" offset=\"202\""), std::string::npos);
  EXPECT_EQ(file.find("name=\"name\""), std::string::npos);
  const std::size_t data = file.find("encoding=\"raw\">\n_") + 17;
  EXPECT_EQ(number_at<std::uint64_t>(file, data), 4 * 3 * 8u);
  EXPECT_EQ(number_at<double>(file, data + 8 + 3 * 8), 1.0);  // x of row 1
  EXPECT_EQ(number_at<std::uint64_t>(file, data + 104), 6 * 4u);
  EXPECT_EQ(number_at<std::int32_t>(file, data + 112 + 2 * 4), 3);
  EXPECT_EQ(number_at<std::int32_t>(file, data + 144), 3);
  EXPECT_EQ(number_at<std::int32_t>(file, data + 148), 6);
  EXPECT_EQ(file.substr(data + 160, 2), "\x05\x05");
  EXPECT_EQ(number_at<double>(file, data + 170 + 8), 2.0);
  EXPECT_EQ(file.substr(data + 210, 4), std::string("\0\0\1\2", 4));
  EXPECT_EQ(file.substr(data + 214), "\n  </AppendedData>\n</VTKFile>\n");
}

TEST(MeshFile, ply_is_binary_with_attributes) {
  Mesh mesh = square();
  mesh.points.attributes = {{"z", {1, 2, 3, 4}, {}}};
  const std::string file = mesh.text("ply");
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double "
      "z\n"
      "property double z_\nelement face 2\nproperty list int int vertex_indices\nend_header\n";
  ASSERT_EQ(file.substr(0, header.size()), header);
  ASSERT_EQ(file.size(), header.size() + 4 * 32 + 2 * 16);
  EXPECT_EQ(number_at<double>(file, header.size() + 24), 1.0);
  EXPECT_EQ(number_at<std::int32_t>(file, header.size() + 128), 3);
  EXPECT_EQ(number_at<std::int32_t>(file, header.size() + 140), 3);
}

TEST(MeshFile, elevation_lifts_points_of_the_plane) {
  Mesh mesh = square();
  mesh.points.attributes = {{"z", {5, 6, 7, 8}, {}}};
  mesh.elevation = "z";
  EXPECT_EQ(mesh.text("off").substr(0, 36), "OFF\n4 2 0\n0 0 5\n1 0 6\n0 1 7\n1 1 8\n3 ");
  mesh.elevation = "h";
  EXPECT_EQ(mesh.refused("off"), "elevation 'h': expected the name of an attribute of numbers");
}

TEST(MeshFile, written_points_and_cells_read_back_the_same) {
  Mesh mesh = tetrahedron();
  mesh.points.coordinates[3] = 0.1;
  mesh.points.coordinates[7] = 4.9406564584124654e-324;
  mesh.points.coordinates[11] = 1.7976931348623157e308;
  const Directory directory;
  for (const char* extension : {"vtu", "ply", "csv", "cells", "node"}) {
    write_mesh(directory / (std::string("a.") + extension), *mesh_format(extension), mesh.view());
  }
  for (const char* name : {"a.vtu", "a.ply", "a.csv", "a.cells", "a.ele"}) {
    const CellTable table = read_cells(directory / name, 4);
    EXPECT_EQ(table.corners, 4) << name;
    EXPECT_EQ(table.vertices, mesh.cells.vertices) << name;
  }
  write_mesh(directory / "b.obj", MeshFormat::obj, mesh.view());
  write_mesh(directory / "b.off", MeshFormat::off, mesh.view());
  for (const char* name : {"a.ply", "a.node", "b.obj", "b.off"}) {
    EXPECT_EQ(read_points(directory / name).coordinates, mesh.points.coordinates) << name;
  }
}

TEST(MeshFile, compressed_files_read_back_and_are_the_same_each_time) {
  const Directory directory;
  write_mesh(directory / "a.cells.gz", MeshFormat::cells, square().view());
  write_mesh(directory / "b.cells.gz", MeshFormat::cells, square().view());
  EXPECT_EQ(read_cells(directory / "a.cells.gz", 4).vertices, square().cells.vertices);
  EXPECT_EQ(contents(directory / "a.cells.gz"), contents(directory / "b.cells.gz"));
  EXPECT_EQ(contents(directory / "a.cells.gz").substr(0, 8),
            std::string("\x1f\x8b\x08\0\0\0\0\0", 8));  // no name, no time
  EXPECT_EQ(refusal([&] { write_mesh(directory / "a.vtu.gz", MeshFormat::vtu, square().view()); }),
            "vtu files are not compressed: leave out .gz");
}

TEST(MeshFile, merged_polygons_go_round_their_boundary) {
  EXPECT_EQ(merged_square().text("cells"), "0 1 2 3 4 5\n");
  EXPECT_EQ(merged_square().text("csv"), "v0,v1,v2,v3,v4,v5\n0,1,2,3,4,5\n");
  const std::string obj = merged_square().text("obj");
  EXPECT_EQ(obj.substr(obj.find('f')), "f 1 2 6 4 3\n");
  const std::string vtu = merged_square().text("vtu");
  EXPECT_NE(vtu.find("NumberOfCells=\"1\""), std::string::npos);
  EXPECT_EQ(merged_square().refused("node"), "node files cannot hold merged polytopes: write cells or csv");
  EXPECT_EQ(merged_square().refused("npy"), "npy files cannot hold merged polytopes: write cells or csv");
  Mesh solid = tetrahedron();
  solid.points.coordinates.insert(solid.points.coordinates.end(), {1, 1, 1});
  solid.merged.offsets = {0, 5};
  solid.merged.vertices = {0, 1, 2, 3, 4};
  EXPECT_EQ(solid.refused("vtu"), "vtu files hold merged polytopes only of points in the plane: write cells or csv");
}

TEST(MeshFile, merged_simplices_are_simplices) {
  Mesh mesh = tetrahedron();
  mesh.merged.offsets = {0, 4};
  mesh.merged.vertices = {0, 1, 2, 3};
  EXPECT_EQ(mesh.text("off"), tetrahedron().text("off"));
}

TEST(MeshFile, dimensions_that_a_format_cannot_hold_are_refused) {
  Mesh mesh;
  mesh.points = points_of(5, {0, 0, 0, 0, 0});
  mesh.cells = {1, {0}, {kNone}};
  for (const char* extension : {"vtu", "ply", "obj", "off"}) {
    EXPECT_EQ(
        mesh.refused(extension),
        std::string(extension) + " files hold at most 3 dimensions, the points have 5: write cells, csv, npy or node");
  }
  EXPECT_EQ(mesh.refused("png"), "png files show points of the plane, these have 5 dimensions: write vtu or ply");
  EXPECT_EQ(mesh.refused("geojson"), "geojson files hold points of the plane, these have 5 dimensions");
  EXPECT_EQ(mesh.text("node"), "1 5 0 0\n0 0 0 0 0 0\n");
  EXPECT_EQ(mesh.text("cells"), "0\n");
}

TEST(MeshFile, flat_and_empty_triangulations_are_written) {
  Mesh line;
  line.points = points_of(2, {0, 0, 1, 1, 2, 2});
  line.cells = {2, {0, 1, 1, 2}, {1, kNone, kNone, 0}};
  EXPECT_EQ(line.text("obj"), "v 0 0 0\nv 1 1 0\nv 2 2 0\nl 1 2\nl 2 3\n");
  EXPECT_NE(line.text("ply").find("element edge 2\nproperty int vertex1"), std::string::npos);
  Mesh empty;
  empty.points.dimension = 2;
  for (const char* extension : {"vtu", "ply", "obj", "off", "node", "csv", "cells", "geojson", "svg", "png"}) {
    EXPECT_EQ(empty.refused(extension), "") << extension;
  }
  EXPECT_EQ(empty.text("off"), "OFF\n0 0 0\n");
  EXPECT_EQ(empty.text("csv"), "");
}

TEST(MeshFile, a_failed_write_leaves_the_old_file_and_nothing_else) {
  const Directory directory;
  put_contents(directory / "a.vtu", "old");
  Mesh mesh;
  mesh.points = points_of(2, Doubles(400'000));
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  const rlimit limit{1'500'000, old_limit.rlim_max};
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::string message;
  try {
    write_mesh(directory / "a.vtu", MeshFormat::vtu, mesh.view());
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(message, "cannot write " + directory / "a.vtu" + ": File too large");
  EXPECT_EQ(contents(directory / "a.vtu"), "old");
  EXPECT_EQ(directory.names(), Names{"a.vtu"});
}

TEST(MeshFile, a_file_that_cannot_be_made_leaves_its_sisters_alone) {
  const Directory directory;
  put_contents(directory / "a.node", "old");
  std::filesystem::create_directory(directory / "a.neigh");
  EXPECT_THROW(write_mesh(directory / "a.node", MeshFormat::node_ele, square().view()), std::runtime_error);
  EXPECT_EQ(contents(directory / "a.node"), "old");
  EXPECT_EQ(directory.names(), (Names{"a.neigh", "a.node"}));
}

TEST(MeshFile, errors_name_the_file) {
  const Directory directory;
  const auto message = [&](const std::string& path) -> std::string {
    try {
      write_mesh(path, MeshFormat::cells, square().view());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(directory / "none" + "/a.cells"),
            "cannot write " + directory / "none" + "/a.cells: No such file or directory");
  EXPECT_EQ(message(directory / "."), "cannot write " + directory / "." + ": Is a directory");
  EXPECT_EQ(message("/dev/full"), "cannot write /dev/full: No space left on device");
}

TEST(MeshFile, links_are_followed_and_permissions_kept) {
  const Directory directory;
  put_contents(directory / "real", "old");
  chmod((directory / "real").c_str(), 0640);
  std::filesystem::create_symlink("real", directory / "link.cells");
  write_mesh(directory / "link.cells", MeshFormat::cells, square().view());
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "link.cells"));
  EXPECT_EQ(contents(directory / "real"), "0 1 3\n0 3 2\n");
  struct stat status {};
  stat((directory / "real").c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

}  // namespace
}  // namespace delone::io
