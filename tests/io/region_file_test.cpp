// Regions from files: what is read is written here by hand; what is refused names its place.
#include "delone/io/region_file.hpp"

#include <algorithm>

#include "io/files.hpp"
#include "io/output.hpp"

namespace delone::io {
namespace {

Region region(std::string_view bytes, int dimension = 2, const std::string& name = "r.csv") {
  return read_region_from_memory(name, bytes, dimension);
}

std::string refused_region(std::string_view bytes, int dimension = 2, const std::string& name = "r.csv") {
  return refusal([&] { region(bytes, dimension, name); });
}

/// A ring from its lexicographically smallest corner on, as a region turns rings its own way.
Ring from_smallest(Ring ring) {
  std::ranges::rotate(ring, std::ranges::min_element(ring));
  return ring;
}

const Ring kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(RegionFile, two_columns_are_one_ring) {
  for (const char* text : {"0,0\n4,0\n4,4\n0,4\n", "x,y\n0,0\n4,0\n4,4\n0,4\n", "0 0\n4 0\n4 4\n0 4",
                           "# corners\nlon;lat\n0;0\n\n4;0\n4;4\n0;4\n"}) {
    const Region square = region(text);
    EXPECT_EQ(square.dimension(), 2) << text;
    ASSERT_EQ(square.rings().size(), 1u) << text;
    EXPECT_EQ(from_smallest(square.rings()[0]), kSquare) << text;
    EXPECT_EQ(square.measure(), 16) << text;
  }
}

TEST(RegionFile, rows_of_one_name_are_one_ring_and_a_text_between_is_passed_over) {
  const Region holed = region(
      "ring,part,lon,lat\n7,outer,0,0\n7,outer,4,0\n7,outer,4,4\n7,outer,0,4\n"
      "\"7, inner\",hole,1,1\n\"7, inner\",hole,2,1\n\"7, inner\",hole,1,2\n");
  ASSERT_EQ(holed.rings().size(), 2u);
  EXPECT_EQ(holed.measure(), 15.5);
  const Region two = region("a 0 0\na 1 0\na 0 1\nb 5 5\nb 6 5\nb 5 6\n");
  EXPECT_EQ(two.rings().size(), 2u);
  EXPECT_EQ(two.measure(), 1);
}

TEST(RegionFile, repeated_corners_are_dropped) {
  const Region square = region("0,0\n0,0\n4,0\n4,4\n4,4\n0,4\n-0,0\n0,0\n");
  EXPECT_EQ(from_smallest(square.rings()[0]), kSquare);
}

TEST(RegionFile, half_spaces_are_known_by_their_header) {
  for (const char* header : {"a,b,d", "nx,ny,offset"}) {
    const Region triangle = region(std::string(header) + "\n-1,0,0\n0,-1,0\n2,2,4\n");
    EXPECT_TRUE(triangle.convex());
    EXPECT_NEAR(triangle.measure(), 2, 1e-15) << header;
  }
  const std::string simplex = "-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n1 1 1 1\n";
  for (const char* header : {"a b c d", "nx ny nz offset"}) {
    const Region solid = region(std::string(header) + "\n" + simplex, 3);
    EXPECT_EQ(solid.dimension(), 3);
    EXPECT_NEAR(solid.measure(), 1 / 6.0, 1e-15) << header;
  }
}

TEST(RegionFile, geojson_gives_the_rings_of_all_its_polygons) {
  const std::string polygon =
      R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4,9],[0,4],[0,0]],[[1,1],[1,2],[2,1],[1,1]]]})";
  const std::string both =
      R"({"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[4,4],[0,4]]],[[[9,9],[10,9],[9,10]]]]})";
  const std::string feature = R"({"type":"Feature","properties":null,"geometry":)";
  const std::string point = R"({"type":"Point","coordinates":[1,2]})";
  const std::string island = R"({"type":"Polygon","coordinates":[[[6,6],[8,6],[6,8]]]})";
  EXPECT_EQ(region(polygon).measure(), 15.5);
  EXPECT_EQ(region(" \n" + both, 2, "standard input").measure(), 16.5);
  EXPECT_EQ(region(feature + polygon + "}").rings().size(), 2u);
  EXPECT_EQ(region(R"({"type":"FeatureCollection","features":[)" + feature + "null}," + feature + point + "}," +
                   feature + polygon + "}," + feature + island + "}]}")
                .measure(),
            17.5);
}

TEST(RegionFile, compressed_files_are_looked_through) {
  const Directory directory;
  Output out(directory / "r.csv.gz");
  out << "0,0\n4,0\n4,4\n0,4\n";
  out.commit();
  EXPECT_EQ(read_region(directory / "r.csv.gz", 2).measure(), 16);
}

TEST(RegionFile, faults_of_text_name_line_column_and_ring) {
  EXPECT_EQ(refused_region("x,y\n0,0\n1,east\n0,1\n"), "r.csv: line 3, column 2: expected a number, found 'east'");
  EXPECT_EQ(refused_region("0,0\n1,0,5\n0,1\n"), "r.csv: line 2: expected 2 columns, found 3");
  EXPECT_EQ(refused_region("a,0,0\na,1,0\na,0,1\nb,1,1\nb,2,2\nb,1,1\n"),
            "r.csv: line 4: ring 'b': expected at least 3 different corners, found 2");
  EXPECT_EQ(refused_region("0,0\n1,nan\n0,1\n"), "r.csv: line 2, column 2: expected a finite number, found 'nan'");
  EXPECT_EQ(refused_region("a,b,d\n1,0,0\n0,x,1\n"), "r.csv: line 3, column 2 (b): expected a number, found 'x'");
  EXPECT_EQ(refused_region("1\n2\n"), "r.csv: line 1: expected the two coordinates of a corner, found 1 column");
}

TEST(RegionFile, files_without_a_region_are_refused) {
  EXPECT_EQ(refused_region(""), "r.csv: expected a region, found nothing");
  EXPECT_EQ(refused_region("x,y\n"), "r.csv: expected at least one ring, found none");
  EXPECT_EQ(refused_region(R"({"type":"FeatureCollection","features":[]})"),
            "r.csv: expected at least one ring, found none");
  EXPECT_NE(refused_region("a,b,d\n").find("r.csv: "), std::string::npos);
  EXPECT_NE(refusal([] { read_region("/no/such/file.csv", 2); }).find("/no/such/file.csv: "), std::string::npos);
}

TEST(RegionFile, regions_of_another_dimension_are_refused) {
  EXPECT_EQ(refused_region("0,0\n4,0\n4,4\n", 3),
            "r.csv: rings bound regions of the plane; of space expected half-spaces under a header a,b,c,d or "
            "nx,ny,nz,offset");
  EXPECT_EQ(refused_region("a,b,c,d\n1,0,0,1\n"),
            "r.csv: expected half-spaces of dimension 2, as the points have; found columns a, b, c, d");
}

TEST(RegionFile, faults_of_geojson_name_ring_and_corner) {
  EXPECT_EQ(refused_region("{"), "r.csv: expected JSON, found something else or a file that is cut off");
  EXPECT_EQ(refused_region("{\"kind\":1}"), "r.csv: expected an object of GeoJSON with its \"type\"");
  EXPECT_EQ(refused_region(R"({"type":"Polygon"})"), "r.csv: Polygon has no 'coordinates'");
  EXPECT_EQ(refused_region(R"({"type":"FeatureCollection","features":7})"),
            "r.csv: ring 0: expected a list, found number");
  EXPECT_EQ(refused_region(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1]],[[0,0],[1,"a"],[2,2]]]})"),
            "r.csv: ring 1, corner 1: expected two numbers");
  EXPECT_EQ(refused_region(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,0]]]})"),
            "r.csv: ring 0: expected at least 3 different corners, found 2");
}

TEST(RegionFile, what_a_region_is_refused_for_is_told_with_the_file) {
  const std::string bow_tie = refused_region("0,0\n2,2\n2,0\n0,2\n");
  EXPECT_TRUE(bow_tie.starts_with("r.csv: ")) << bow_tie;
  EXPECT_NE(bow_tie.find("ring 0"), std::string::npos) << bow_tie;
}

}  // namespace
}  // namespace delone::io
