// Delimited text: what every spreadsheet and program writes, and what is refused.
#include "delone/io/points_file.hpp"

#include <fenv.h>
#include <zlib.h>

#include <cmath>

#include "io/files.hpp"

namespace delone::io {
namespace {

std::string gzipped(const std::string& bytes) {
  const Directory directory;
  gzFile file = gzopen((directory / "a").c_str(), "wb");
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
  return contents(directory / "a");
}

TEST(TextPoints, header_names_the_axes) {
  const PointTable table = read("a.csv", "x,y\n1,2\n3,4\n");
  EXPECT_EQ(table.dimension, 2);
  EXPECT_EQ(table.size(), 2u);
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3, 4}));
  EXPECT_EQ(table.coordinate_names, (Names{"x", "y"}));
}

TEST(TextPoints, axes_without_a_header_are_numbered) {
  const PointTable table = read("a.txt", "1 2 3\n4 5 6\n");
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(table.coordinate_names, (Names{"1", "2", "3"}));
}

TEST(TextPoints, delimiters_are_told_from_the_first_row) {
  const Doubles expected{1, 2, 3, 4};
  EXPECT_EQ(read("a", "1,2\n3,4").coordinates, expected);
  EXPECT_EQ(read("a", "1;2\n3;4").coordinates, expected);
  EXPECT_EQ(read("a", "1\t2\n3\t4").coordinates, expected);
  EXPECT_EQ(read("a", "  1   2 \n\t3\t 4\n").coordinates, expected);
  EXPECT_EQ(read("a", "1 , 2\n3 ,4").coordinates, expected);
  EXPECT_EQ(read("a", "1\t2 3 4\n").coordinates, expected);
}

TEST(TextPoints, lines_end_in_any_way) {
  const Doubles expected{1, 2, 3, 4};
  EXPECT_EQ(read("a", "x,y\r\n1,2\r\n3,4\r\n").coordinates, expected);
  EXPECT_EQ(read("a", "x,y\r1,2\r3,4").coordinates, expected);
  EXPECT_EQ(read("a", "\xef\xbb\xbfx,y\n1,2\n\n   \n3,4\n\n").coordinates, expected);
  EXPECT_EQ(read("a", "\xef\xbb\xbfx,y\n1,2\n3,4").coordinate_names, (Names{"x", "y"}));
}

TEST(TextPoints, comments_are_passed_over) {
  const Doubles expected{1, 2, 3, 4};
  EXPECT_EQ(read("a", "# one \"quote\n1 2 # here\n  # there\n3 4 #\n").coordinates, expected);
  EXPECT_EQ(read("a", "#a;b\n# x,y\nx,y\n1,2\n#\n3,4\n").coordinates, expected);
}

TEST(TextPoints, quoted_texts_hold_delimiters_marks_and_line_breaks) {
  const PointTable table =
      read("a.csv", "name,x,y\n\"a,b\",1,2\n\"say \"\"hi\"\"\",3,4\n\"two\nlines\",5,6\n", {.attributes = true});
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3, 4, 5, 6}));
  ASSERT_EQ(table.attributes.size(), 1u);
  EXPECT_EQ(table.attributes[0].texts, (Names{"a,b", "say \"hi\"", "two\nlines"}));
  EXPECT_TRUE(table.attributes[0].numbers.empty());
}

TEST(TextPoints, quoted_numbers_are_numbers) {
  EXPECT_EQ(read("a.csv", "\"x\",\"y\"\n\"1\",\"2\"\n").coordinates, (Doubles{1, 2}));
}

TEST(TextPoints, gzip_is_known_by_its_first_bytes) {
  const std::string bytes = gzipped("x,y\n1,2\n");
  EXPECT_EQ(read("a.csv.gz", bytes).coordinates, (Doubles{1, 2}));
  EXPECT_EQ(read("a.csv", bytes).coordinates, (Doubles{1, 2}));
  EXPECT_EQ(read("a.csv.gz", bytes + gzipped("3,4\n") + std::string(9, '\0')).coordinates, (Doubles{1, 2, 3, 4}));
}

TEST(TextPoints, damaged_gzip_is_refused) {
  const std::string bytes = gzipped("x,y\n1,2\n3,4\n");
  EXPECT_EQ(refused("a.csv.gz", bytes.substr(0, bytes.size() - 1)), "a.csv.gz: the compressed data are cut off");
  EXPECT_EQ(refused("a.csv.gz", bytes.substr(0, 12)), "a.csv.gz: the compressed data are cut off");
  EXPECT_EQ(refused("a.csv.gz", bytes + "tail"), "a.csv.gz: other data follow the compressed data");
  EXPECT_EQ(refused("a.csv.gz", "x,y\n1,2\n"), "a.csv.gz: expected gzip data, as the name says");
  std::string changed = bytes;
  changed[changed.size() - 5] ^= 1;  // in the checksum
  EXPECT_EQ(refused("a.csv.gz", changed), "a.csv.gz: the compressed data are damaged");
}

TEST(TextPoints, columns_are_chosen_by_name_number_or_last) {
  const std::string text = "id,x,y,z\n7,1,2,3\n8,4,5,6\n";
  EXPECT_EQ(read("a", text, {.columns = {"z", "x"}}).coordinates, (Doubles{3, 1, 6, 4}));
  EXPECT_EQ(read("a", text, {.columns = {"2", "last"}}).coordinates, (Doubles{1, 3, 4, 6}));
  EXPECT_EQ(read("a", text, {.columns = {"2", "last"}}).coordinate_names, (Names{"x", "z"}));
}

TEST(TextPoints, a_name_goes_before_a_number) {
  EXPECT_EQ(read("a", "a,1\n5,6\n", {.columns = {"1", "a"}}).coordinates, (Doubles{6, 5}));
}

TEST(TextPoints, a_header_with_numbers_is_one_when_its_names_are_asked_for) {
  EXPECT_EQ(read("a", "x,y,2020\n1,2,3\n", {.columns = {"x", "y"}}).coordinates, (Doubles{1, 2}));
}

TEST(TextPoints, columns_that_do_not_exist_are_refused) {
  const std::string text = "x,y\n1,2\n";
  EXPECT_EQ(refused("a", text, {.columns = {"x", "q"}}), "a: there is no column 'q': the columns are x, y");
  EXPECT_EQ(refused("a", text, {.columns = {"3"}}), "a: there is no column '3': expected 1 to 2");
  EXPECT_EQ(refused("a", text, {.columns = {"0"}}), "a: there is no column '0': expected 1 to 2");
  EXPECT_EQ(refused("a", "1,2\n", {.columns = {"x"}}),
            "a: there is no column 'x': the file has 2 columns without names");
  EXPECT_EQ(refused("a", text, {.columns = {"x", "1"}}), "a: column 'x' is chosen twice");
  EXPECT_EQ(refused("a", "x,x\n1,2\n", {.columns = {"x"}}), "a: 2 columns are named 'x': choose by number");
}

TEST(TextPoints, weights_are_taken_as_they_stand) {
  const PointTable table = read("a", "x,y,w\n1,2,-3\n", {.weights = "w"});
  EXPECT_EQ(table.dimension, 2);
  EXPECT_EQ(table.weights, (Doubles{-3}));
}

TEST(TextPoints, the_weight_of_a_radius_is_its_rounded_square) {
  const PointTable table = read("a", "1,2,0.1\n3,4,0\n", {.radii = "last"});
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3, 4}));
  EXPECT_EQ(table.weights, (Doubles{0.1 * 0.1, 0}));
}

TEST(TextPoints, impossible_radii_are_refused) {
  EXPECT_EQ(refused("a", "x,y,r\n1,2,3\n1,2,-1\n", {.radii = "r"}),
            "a: line 3, column 3 (r): expected a radius of at least 0, found '-1'");
  EXPECT_EQ(refused("a", "1,2,1e200\n", {.radii = "3"}),
            "a: line 1, column 3: expected a radius whose square is within the range of double, found '1e200'");
  EXPECT_EQ(refused("a", "1,2,3\n", {.weights = "3", .radii = "3"}), "a: expected weights or radii, not both");
}

TEST(TextPoints, other_columns_are_kept_on_request) {
  const PointTable table = read("a", "x,y,z,note\n1,2,3,a\n4,5,6,7\n", {.columns = {"x", "y"}, .attributes = true});
  ASSERT_EQ(table.attributes.size(), 2u);
  EXPECT_EQ(table.attributes[0].name, "z");
  EXPECT_EQ(table.attributes[0].numbers, (Doubles{3, 6}));
  EXPECT_EQ(table.attributes[1].texts, (Names{"a", "7"}));
}

TEST(TextPoints, an_attribute_that_is_not_numeric_throughout_is_text) {
  const PointTable table = read("a", "x,h\n1,10\n2,\n3,n/a\n", {.columns = {"x"}, .attributes = true});
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3}));
  EXPECT_EQ(table.attributes[0].texts, (Names{"10", "", "n/a"}));
  EXPECT_TRUE(table.attributes[0].numbers.empty());
}

TEST(TextPoints, text_columns_are_no_coordinates) {
  EXPECT_EQ(read("a", "ring,part,lon,lat\n0,outer,180,-16\n1,outer,179,-17\n").dimension, 3);
}

TEST(TextPoints, a_bad_entry_is_named_by_line_and_column) {
  EXPECT_EQ(refused("p.csv", "x,y\n1,2\n3,abc\n"), "p.csv: line 3, column 2 (y): expected a number, found 'abc'");
  EXPECT_EQ(refused("p.csv", "1,2\n3,\n"), "p.csv: line 2, column 2: expected a number, found nothing");
  EXPECT_EQ(refused("p.csv", "1,,2\n"), "");  // a text column, empty throughout
  EXPECT_EQ(refused("p.csv", "1,2\n3,nan\n"), "p.csv: line 2, column 2: expected a finite number, found 'nan'");
  EXPECT_EQ(refused("p.csv", "1,2\n3,1e400\n"),
            "p.csv: line 2, column 2: expected a number within the range of double, found '1e400'");
  EXPECT_EQ(
      refused("p.csv", "1,2\n3,1e-400\n"),
      "p.csv: line 2, column 2: expected a number within the range of double, found '1e-400', which would become 0");
  EXPECT_EQ(refused("p.csv", "1 2\n3 1.0D5\n"),
            "p.csv: line 2, column 2: expected a number, found '1.0D5': write the exponent with e");
  EXPECT_EQ(
      refused("p.csv", "1;2\n3;1,5\n"),
      "p.csv: line 2, column 2: expected a number, found '1,5': write a decimal point, and nothing between thousands");
}

TEST(TextPoints, rows_of_plain_numbers_and_others_mix) {
  const PointTable table =
      read("a.csv", "x,y\n1,2\n3,4e0\n\"5\",6\n+7,8\n# none\n\n 9 ,\t0x1p1 \n0,-0.0\r\n11,12", {.attributes = true});
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3, 4, 5, 6, 7, 8, 9, 2, 0, 0, 11, 12}));
  EXPECT_FALSE(std::signbit(table.coordinates[10]));
  EXPECT_TRUE(std::signbit(table.coordinates[11]));
  EXPECT_EQ(read("a", "1 2\n 3\t4 \n5 6 # six\n7 8").coordinates, (Doubles{1, 2, 3, 4, 5, 6, 7, 8}));
  const PointTable all = read("a", "1,2,w\n3,4,5\n6,7,8\n", {.columns = {"2"}, .weights = "w", .attributes = true});
  EXPECT_EQ(all.coordinates, (Doubles{4, 7}));
  EXPECT_EQ(all.weights, (Doubles{5, 8}));
  EXPECT_EQ(all.attributes.at(0).numbers, (Doubles{3, 6}));
}

TEST(TextPoints, faults_after_rows_of_plain_numbers_are_named_by_their_line) {
  const std::string rows = "1,2\n3,4\r5,6\r\n7,8\n";
  EXPECT_EQ(refused("a", rows + "9,"), "a: line 5, column 2: expected a number, found nothing");
  EXPECT_EQ(refused("a", rows + "9\n"), "a: line 5: expected 2 columns, found 1");
  EXPECT_EQ(refused("a", rows + "9,10,11\n"), "a: line 5: expected 2 columns, found 3");
  EXPECT_EQ(refused("a", rows + "9,10\n,11\n"), "a: line 6, column 1: expected a number, found nothing");
  EXPECT_EQ(refused("a", rows + "9,1e999\n").substr(0, 19), "a: line 5, column 2");
  EXPECT_EQ(refused("a", rows + "9,0e5\n9,0.0001e-400\n").substr(0, 19), "a: line 6, column 2");
}

TEST(TextPoints, bad_numbers_in_the_first_row_are_not_taken_for_text) {
  EXPECT_EQ(refused("a", "nan,1,2\n"), "a: line 1, column 1: expected a finite number, found 'nan'");
  EXPECT_EQ(refused("a", "1,5;2,5\n").substr(0, 49), "a: line 1, column 1: expected a number, found '1,");
  EXPECT_EQ(refused("a", "x,y\n1,1e999\n").substr(0, 25), "a: line 2, column 2 (y): ");
  EXPECT_EQ(refused("a", "1,5 2,5\n3,5 4,5\n"),
            "a: line 1, column 2: expected a number, found '5 2': write decimal points, and one number per entry");
}

TEST(TextPoints, a_column_of_numbers_that_begins_with_text_is_refused) {
  EXPECT_EQ(refused("a", "x,y\nabc,1\n2,3\n4,5\n"),
            "a: line 2, column 1 (x): expected a number, found 'abc': other entries of this column are numbers; choose "
            "columns to leave it out");
  EXPECT_EQ(refused("a", "x,y,2020\n1,2,3\n4,5,6\n"),
            "a: line 1, column 1: expected a number, found 'x': other entries of this column are numbers; choose "
            "columns to leave it out");
}

TEST(TextPoints, a_column_of_texts_may_hold_some_numbers) {
  EXPECT_EQ(read("a", "house,x\n10B,1\n11,2\nold mill,3\n").coordinates, (Doubles{1, 2, 3}));
  EXPECT_NE(refused("a", "x,y\n1,abc\n2,3\n"), "");  // half of them
}

TEST(TextPoints, entries_are_quoted_short_and_on_one_line) {
  EXPECT_EQ(refused("a", "1,2\n3,\"b\nc\x01\"\n"), "a: line 2, column 2: expected a number, found 'b\\x0ac\\x01'");
  EXPECT_EQ(refused("a", "1,2\n3," + std::string(100, 'z') + "\n"),
            "a: line 2, column 2: expected a number, found '" + std::string(40, 'z') + "...'");
}

TEST(TextPoints, names_with_line_breaks_are_shown_on_one_line) {
  EXPECT_EQ(refused("a", "\"x\ny\"\n1\n", {.dimension = 2}), "a: expected 2 coordinates, found 1 (x\\x0ay)");
}

TEST(TextPoints, lines_are_counted_through_quoted_breaks) {
  EXPECT_EQ(refused("a", "n,x\n\"a\nb\",1\n\"c\nd\",z\n"), "a: line 5, column 2 (x): expected a number, found 'z'");
}

TEST(TextPoints, ragged_rows_are_refused) {
  EXPECT_EQ(refused("a", "x,y\n1,2\n3\n"), "a: line 3: expected 2 columns, found 1");
  EXPECT_EQ(refused("a", "x,y\n1,2,3\n"), "a: line 2: expected 2 columns, found 3");
  EXPECT_EQ(refused("a", "1 2\n3 4 5\n"), "a: line 2: expected 2 columns, found 3");
}

TEST(TextPoints, unfinished_quotes_are_refused) {
  EXPECT_EQ(refused("a", "x,n\n1,\"abc\n2,d\n"), "a: line 2, column 2: the quotation mark is never closed");
  EXPECT_EQ(refused("a", "x,n\n1,\"abc\"d\n"),
            "a: line 2, column 2: expected the end of the entry after its closing quotation mark");
}

TEST(TextPoints, nul_bytes_and_utf16_are_refused) {
  EXPECT_EQ(refused("a", std::string_view("1,2\n3,\0004\n", 9)), "a: line 2: expected text, found a NUL byte");
  EXPECT_EQ(refused("a", std::string_view("\xff\xfe\x31\x00", 4)), "a: line 1: expected UTF-8, found UTF-16");
}

TEST(TextPoints, a_demanded_dimension_is_checked) {
  EXPECT_EQ(refused("a", "x,y\n1,2\n", {.dimension = 3}), "a: expected 3 coordinates, found 2 (x, y)");
  EXPECT_EQ(read("a", "x,y\n1,2\n", {.dimension = 2}).dimension, 2);
}

TEST(TextPoints, more_than_eight_coordinates_are_refused) {
  EXPECT_EQ(refused("a", "1 2 3 4 5 6 7 8 9\n"),
            "a: expected at most 8 columns of coordinates, found 9: choose columns");
}

TEST(TextPoints, a_file_without_numbers_is_refused) {
  EXPECT_EQ(refused("a", "hello world\nfoo bar\n"),
            "a: expected at least one column of numbers for coordinates, found none");
}

TEST(TextPoints, no_rows_are_no_points) {
  EXPECT_EQ(read("a", "").dimension, 2);
  EXPECT_EQ(read("a", "", {.dimension = 3}).dimension, 3);
  EXPECT_EQ(read("a", "# only a comment\n", {.columns = {"x", "y", "z"}}).dimension, 3);
  const PointTable table = read("a", "x,y,z\n");
  EXPECT_EQ(table.dimension, 3);
  EXPECT_EQ(table.size(), 0u);
  EXPECT_EQ(table.view().size(), 0u);
  EXPECT_EQ(read("a", "x,y,r\n", {.radii = "r"}).dimension, 2);
  EXPECT_EQ(read("a", "x,y,name\n", {.dimension = 2}).dimension, 2);
  EXPECT_EQ(refused("a", "x,y\n", {.columns = {"q"}}), "a: there is no column 'q': the columns are x, y");
}

TEST(TextPoints, numbers_do_not_depend_on_the_rounding_mode) {
  fesetround(FE_UPWARD);
  const PointTable table = read("a", "0.1,0.3,1e22\n", {.radii = "1"});
  fesetround(FE_TONEAREST);
  EXPECT_EQ(table.coordinates, (Doubles{0.3, 1e22}));
  EXPECT_EQ(table.weights, (Doubles{0.1 * 0.1}));
}

TEST(PointsFile, missing_files_and_directories_are_refused) {
  const Directory directory;
  EXPECT_EQ(refusal([&] { read_points(directory / "none.csv"); }),
            (directory / "none.csv") + ": No such file or directory");
  EXPECT_EQ(refusal([&] { read_points(directory / "."); }), (directory / ".") + ": expected a file, found a directory");
}

TEST(PointsFile, the_extension_gives_the_format_and_an_option_overrides_it) {
  const Directory directory;
  put_contents(directory / "a.off", "OFF\n1 0 0\n1 2 3\n");
  EXPECT_EQ(read_points(directory / "a.off").coordinates, (Doubles{1, 2, 3}));
  put_contents(directory / "a.dat", "OFF\n1 0 0\n1 2 3\n");
  EXPECT_EQ(read_points(directory / "a.dat", {.format = PointFormat::off}).coordinates, (Doubles{1, 2, 3}));
  EXPECT_EQ(point_format("npy"), PointFormat::npy);
  EXPECT_EQ(point_format("csv"), PointFormat::text);
  EXPECT_EQ(point_format("docx"), std::nullopt);
}

}  // namespace
}  // namespace delone::io
