// Cells of every format, written out by hand.
#include "delone/io/cells_file.hpp"

#include <gtest/gtest.h>

#include "io/files.hpp"

namespace delone::io {
namespace {

using Ids = std::vector<Index>;

Ids cells(const std::string& name, const std::string& bytes, std::size_t point_count = 5) {
  return read_cells_from_memory(name, bytes, point_count).vertices;
}

std::string cells_refused(const std::string& name, const std::string& bytes, std::size_t point_count = 5) {
  return refusal([&] { read_cells_from_memory(name, bytes, point_count); });
}

TEST(CellsFile, rows_of_ids_with_or_without_a_header) {
  EXPECT_EQ(cells("a.cells", "0 1 2\n2 1 3\n"), (Ids{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(cells("a.csv", "v0,v1,v2\n0,1,2\n2,1,3\n"), (Ids{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(read_cells_from_memory("a.csv", "0,1,2,3\n", 4).corners, 4);
}

TEST(CellsFile, an_empty_file_has_no_cells) {
  for (const char* name : {"a.cells", "a.csv"}) {
    const CellTable table = read_cells_from_memory(name, "", 5);
    EXPECT_EQ(table.corners, 0);
    EXPECT_EQ(table.size(), 0u);
  }
}

TEST(CellsFile, ids_out_of_range_are_named) {
  EXPECT_EQ(cells_refused("a.cells", "0 1 2\n2 1 5\n"),
            "a.cells: line 2, column 3: expected a point id from 0 to 4, found 5");
  EXPECT_EQ(cells_refused("a.cells", "0 1 -2\n"),
            "a.cells: line 1, column 3: expected a point id from 0 to 4, found '-2'");
  EXPECT_EQ(cells_refused("a.cells", "0 1 2.0\n"),
            "a.cells: line 1, column 3: expected a point id from 0 to 4, found '2.0'");
  EXPECT_EQ(cells_refused("a.cells", "0 1 99999999999999999999\n"),
            "a.cells: line 1, column 3: expected a point id from 0 to 4, found '99999999999999999999'");
  EXPECT_EQ(cells_refused("a.cells", "0 1 2\n", 0),
            "a.cells: line 1, column 1: expected no cells, since there are no points, found 0");
}

TEST(CellsFile, ragged_rows_are_refused) {
  EXPECT_EQ(cells_refused("a.cells", "0 1 2\n2 1\n"), "a.cells: line 2: expected 3 columns, found 2");
}

TEST(CellsFile, ele_counts_from_its_first_row_number) {
  EXPECT_EQ(cells("a.ele", "2 3 0\n0 0 1 2\n1 2 1 3\n"), (Ids{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(cells("a.ele", "# t\n2 3 1\n1 1 2 3 7.5\n2 3 2 4 8\n"), (Ids{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(read_cells_from_memory("a.ele", "0 3 0\n", 5).corners, 3);
  EXPECT_EQ(cells_refused("a.ele", "2 3 0\n1 1 2 3\n2 3 2 0\n"),
            "a.ele: line 3, column 4: expected a point id from 1 to 5, found 0");
  EXPECT_EQ(cells_refused("a.ele", "2 3 0\n0 0 1 2\n"), "a.ele: expected 2 cells, found 1 before the end of the file");
}

TEST(CellsFile, faces_of_surface_formats) {
  EXPECT_EQ(cells("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n"), (Ids{0, 1, 2}));
  EXPECT_EQ(cells("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2//2 3\nf -3 -2 -1\n"), (Ids{0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(cells("a.obj", "l 1 2\nl 2 3\n"), (Ids{0, 1, 1, 2}));
  EXPECT_EQ(cells("a.ply",
                  "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement face 2\n"
                  "property list uchar int vertex_index\nend_header\n0\n3 0 1 2\n3 2 1 3\n"),
            (Ids{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(cells_refused("a.obj", "f 1 2 3\nf 0 1 2\n"),
            "a.obj: line 2, column 2: expected a point id from 1 to 5, found '0'");
  EXPECT_EQ(cells_refused("a.obj", "f 1 2 3\nf 1 2 3 4\n"), "a.obj: line 2: expected a cell of 3 corners, found 4");
}

TEST(CellsFile, edges_of_ply) {
  EXPECT_EQ(
      cells(
          "a.ply",
          "ply\nformat ascii 1.0\nelement edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n0 1\n1 2\n"),
      (Ids{0, 1, 1, 2}));
}

TEST(CellsFile, the_format_overrides_the_extension) {
  EXPECT_EQ(read_cells_from_memory("a.txt", "1 3 0\n1 1 2 3\n", 5, "ele").vertices, (Ids{0, 1, 2}));
  EXPECT_EQ(refusal([] { read_cells_from_memory("a.txt", "", 5, "docx"); }),
            "a.txt: there is no format of cells named 'docx'");
}

TEST(CellsFile, geojson_carries_rows_as_a_property) {
  EXPECT_EQ(cells("a.geojson", R"({"type":"FeatureCollection","features":[{"properties":{"rows":[0,1,2]}}]})"),
            (Ids{0, 1, 2}));
  EXPECT_EQ(cells_refused("a.geojson", "{"),
            "a.geojson: expected JSON, found something else or a file that is cut off");
  EXPECT_EQ(cells_refused("a.geojson", R"({"features":[{"properties":{"rows":[0,1,9]}}]})"),
            "a.geojson: feature 0: expected a point id from 0 to 4, found 9");
}

}  // namespace
}  // namespace delone::io
