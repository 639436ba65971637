// Points of formats that are not plain tables: every file here is written out by hand.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "io/files.hpp"

namespace delone::io {
namespace {

template <class T>
std::string bytes_of(std::initializer_list<T> numbers, std::endian order = std::endian::little) {
  std::string result;
  for (const T number : numbers) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &number, sizeof(T));
    if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    result += bytes;
  }
  return result;
}

/// Version 1, with a header as short as it can be.
std::string npy(const std::string& type, const std::string& shape, const std::string& data, bool fortran = false) {
  const std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }\n";
  return "\x93NUMPY\x01" + std::string(1, '\0') + bytes_of<std::uint16_t>({static_cast<std::uint16_t>(header.size())}) +
         header + data;
}

TEST(Npy, doubles_in_rows_or_columns_of_either_byte_order) {
  const Doubles expected{1, 2.5, 3, -4, 5, 6};
  EXPECT_EQ(read("a.npy", npy("<f8", "(3, 2)", bytes_of<double>({1, 2.5, 3, -4, 5, 6}))).coordinates, expected);
  EXPECT_EQ(read("a.npy", npy("<f8", "(3, 2)", bytes_of<double>({1, 3, 5, 2.5, -4, 6}), true)).coordinates, expected);
  EXPECT_EQ(read("a.npy", npy(">f8", "(3, 2)", bytes_of<double>({1, 2.5, 3, -4, 5, 6}, std::endian::big))).coordinates,
            expected);
  EXPECT_EQ(read("a.npy", npy("<f8", "(3, 2)", bytes_of<double>({1, 2.5, 3, -4, 5, 6}))).dimension, 2);
}

TEST(Npy, floats_and_integers_of_every_size) {
  const Doubles expected{1, 100};
  EXPECT_EQ(read("a.npy", npy("<f4", "(1, 2)", bytes_of<float>({1, 100}))).coordinates, expected);
  EXPECT_EQ(read("a.npy", npy("|i1", "(1, 2)", bytes_of<std::int8_t>({1, 100}))).coordinates, expected);
  EXPECT_EQ(read("a.npy", npy("|u1", "(1, 2)", bytes_of<std::uint8_t>({1, 100}))).coordinates, expected);
  EXPECT_EQ(read("a.npy", npy(">i2", "(1, 2)", bytes_of<std::int16_t>({1, 100}, std::endian::big))).coordinates,
            expected);
  EXPECT_EQ(read("a.npy", npy("<u2", "(1, 2)", bytes_of<std::uint16_t>({1, 100}))).coordinates, expected);
  EXPECT_EQ(read("a.npy", npy("<i4", "(1, 2)", bytes_of<std::int32_t>({-1, 100}))).coordinates, (Doubles{-1, 100}));
  EXPECT_EQ(read("a.npy", npy("<u4", "(1, 2)", bytes_of<std::uint32_t>({4294967295U, 100}))).coordinates,
            (Doubles{4294967295.0, 100}));
  EXPECT_EQ(read("a.npy", npy(">i8", "(1, 2)", bytes_of<std::int64_t>({-1, 100}, std::endian::big))).coordinates,
            (Doubles{-1, 100}));
  EXPECT_EQ(read("a.npy", npy("<u8", "(1, 2)", bytes_of<std::uint64_t>({1, 100}))).coordinates, expected);
}

TEST(Npy, one_axis_makes_points_of_a_line) {
  const PointTable table = read("a.npy", npy("<f8", "(3,)", bytes_of<double>({1, 2, 3})));
  EXPECT_EQ(table.dimension, 1);
  EXPECT_EQ(table.size(), 3u);
}

TEST(Npy, versions_two_and_three_have_longer_lengths) {
  const std::string header = "{'shape': (1, 1), 'fortran_order': False, \"descr\" : '<f8'}";
  for (const char version : {'\x02', '\x03'}) {
    const std::string file = std::string("\x93NUMPY") + version + std::string(1, '\0') +
                             bytes_of<std::uint32_t>({static_cast<std::uint32_t>(header.size())}) + header +
                             bytes_of<double>({7});
    EXPECT_EQ(read("a.npy", file).coordinates, (Doubles{7}));
  }
}

TEST(Npy, no_rows_are_no_points) {
  EXPECT_EQ(read("a.npy", npy("<f8", "(0, 3)", "")).dimension, 3);
  EXPECT_EQ(read("a.npy", npy("<f8", "(0, 3)", "")).size(), 0u);
}

TEST(Npy, columns_are_chosen_by_number) {
  const PointTable table =
      read("a.npy", npy("<f8", "(1, 3)", bytes_of<double>({1, 2, 3})), {.columns = {"2", "1"}, .radii = "last"});
  EXPECT_EQ(table.coordinates, (Doubles{2, 1}));
  EXPECT_EQ(table.weights, (Doubles{9}));
}

TEST(Npy, integers_that_doubles_do_not_hold_are_refused) {
  const std::int64_t inexact = (std::int64_t{1} << 53) + 1;
  EXPECT_EQ(refused("a.npy", npy("<i8", "(1, 2)", bytes_of<std::int64_t>({1, -inexact}))),
            "a.npy: row 0, column 2: expected an integer that a double holds exactly, found '-9007199254740993'");
  EXPECT_EQ(read("a.npy", npy("<i8", "(1,)", bytes_of<std::int64_t>({INT64_MIN}))).coordinates, (Doubles{-0x1p63}));
}

TEST(Npy, what_is_not_finite_is_refused) {
  EXPECT_EQ(refused("a.npy", npy("<f8", "(2, 2)", bytes_of<double>({1, 2, 3, NAN}))),
            "a.npy: row 1, column 2: expected a finite number, found 'nan'");
}

TEST(Npy, cut_off_and_overlong_files_are_refused) {
  const std::string file = npy("<f8", "(3, 2)", bytes_of<double>({1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(refused("a.npy", file.substr(0, file.size() - 1)),
            "a.npy: expected 48 bytes of data for 3 x 2 entries, found 47");
  EXPECT_EQ(refused("a.npy", file + "x"), "a.npy: expected 48 bytes of data for 3 x 2 entries, found 49");
  EXPECT_EQ(refused("a.npy", file.substr(0, 20)), "a.npy: the header is cut off");
  EXPECT_EQ(refused("a.npy", "1,2\n"), "a.npy: expected a NumPy array, which begins with \\x93NUMPY");
}

TEST(Npy, other_types_and_shapes_are_refused) {
  EXPECT_EQ(refused("a.npy", npy("<c16", "(1, 1)", std::string(16, '\0'))),
            "a.npy: expected an array of 4- or 8-byte floats or of integers, found type '<c16'");
  EXPECT_EQ(refused("a.npy", npy("<f8", "(1, 1, 1)", std::string(8, '\0'))),
            "a.npy: expected an array of shape (n, d) or (n,), found '(1, 1, 1)'");
  EXPECT_NE(refused("a.npy", npy("<f8", "()", std::string(8, '\0'))), "");
  EXPECT_NE(refused("a.npy", npy("<f8", "(4611686018427387905, 4)", "")), "");
}

TEST(Node, counts_from_zero_or_one) {
  const PointTable zero = read("a.node", "2 2 0 0\n0 1 2\n1 3 4\n");
  EXPECT_EQ(zero.coordinates, (Doubles{1, 2, 3, 4}));
  EXPECT_FALSE(zero.one_based);
  const PointTable one = read("a.node", "# Triangle\n2 3 1 1 # counts\n\n1 1 2 3  0.5 0\n2 4 5 6  0.25 1\n# end\n");
  EXPECT_EQ(one.coordinates, (Doubles{1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(one.one_based);
}

TEST(Node, attributes_and_markers_have_names) {
  const std::string text = "1 2 2 1\n1 10 20 0.5 0.25 7\n";
  const PointTable table = read("a.node", text, {.weights = "attribute_2", .attributes = true});
  EXPECT_EQ(table.weights, (Doubles{0.25}));
  ASSERT_EQ(table.attributes.size(), 2u);
  EXPECT_EQ(table.attributes[0].name, "attribute_1");
  EXPECT_EQ(table.attributes[1].name, "marker");
}

TEST(Node, wrong_counts_are_refused) {
  EXPECT_EQ(refused("a.node", "3 2 0 0\n0 1 2\n1 3 4\n"),
            "a.node: expected 3 points, found 2 before the end of the file");
  EXPECT_EQ(refused("a.node", "1 2 0 0\n0 1 2\n1 3 4\n"), "a.node: line 3: expected the end of the file after 1 point");
  EXPECT_EQ(refused("a.node", "1 2 0 0\n0 1\n"), "a.node: line 2: expected 3 columns, found 2");
  EXPECT_EQ(refused("a.node", "2 2 0 0\n0 1 2\n2 3 4\n"), "a.node: line 3, column 1: expected row number 1, found 2");
  EXPECT_EQ(refused("a.node", "2 2 0 0\n5 1 2\n6 3 4\n"),
            "a.node: line 2, column 1: expected row number 0 or 1, found 5");
  EXPECT_EQ(refused("a.node", "1 9 0 0\n"), "a.node: line 1, column 2: expected 1 to 8 dimensions, found 9");
  EXPECT_EQ(
      refused("a.node", ""),
      "a.node: expected a first line with the counts of points, dimensions, attributes and markers, found nothing");
  EXPECT_EQ(refused("a.node", "1 2 0 0\n0 1 x\n"), "a.node: line 2, column 3 (y): expected a number, found 'x'");
}

TEST(Node, no_points_keep_their_dimension) { EXPECT_EQ(read("a.node", "0 3 0 0\n").dimension, 3); }

TEST(Xyz, chemistry_has_a_count_a_comment_and_elements) {
  const PointTable table = read("a.xyz", "2\n\nC 1 2 3\nO 4 5 6\n\n", {.attributes = true});
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3, 4, 5, 6}));
  ASSERT_EQ(table.attributes.size(), 1u);
  EXPECT_EQ(table.attributes[0].name, "element");
  EXPECT_EQ(table.attributes[0].texts, (Names{"C", "O"}));
  EXPECT_EQ(read("a.xyz", "1\n# 1 2 \"3\n8 1 2 3\n").coordinates, (Doubles{1, 2, 3}));  // elements by number
  EXPECT_EQ(read("a.xyz", "1\nradii\nC 1 2 3 0.5\n", {.radii = "last"}).weights, (Doubles{0.25}));
}

TEST(Xyz, plain_rows_are_a_table) { EXPECT_EQ(read("a.xyz", "1 2 3\n4 5 6\n").size(), 2u); }

TEST(Xyz, wrong_counts_are_refused) {
  EXPECT_EQ(refused("a.xyz", "3\nwater\nO 0 0 0\nH 1 0 0\n"),
            "a.xyz: expected 3 atoms, found 2 before the end of the file");
  EXPECT_EQ(refused("a.xyz", "1\nwater\nO 0 0 0\nH 1 0 0\n"),
            "a.xyz: line 4: expected the end of the file after 1 atom");
  EXPECT_EQ(refused("a.xyz", "1\n\nO 0 z 0\n"), "a.xyz: line 3, column 3 (y): expected a number, found 'z'");
}

const char* const kPlyHeader =
    "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(Ply, text_has_an_element_per_line) {
  const PointTable table =
      read("a.ply", std::string("ply\nformat ascii 1.0\ncomment hello\n") + kPlyHeader + "1 2 3 255\n4 5 6 0\n2 0 1\n",
           {.attributes = true});
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(table.coordinate_names, (Names{"x", "y", "z"}));
  ASSERT_EQ(table.attributes.size(), 1u);
  EXPECT_EQ(table.attributes[0].numbers, (Doubles{255, 0}));
}

TEST(Ply, binary_of_either_byte_order) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const std::string name = order == std::endian::little ? "little" : "big";
    const std::string file = "ply\nformat binary_" + name + "_endian 1.0\n" + kPlyHeader +
                             bytes_of<float>({1, 2, 3}, order) + "\xff" + bytes_of<float>({4, 5, 6}, order) + '\0' +
                             "\x02" + bytes_of<std::int32_t>({0, 1}, order);
    EXPECT_EQ(read("a.ply", file).coordinates, (Doubles{1, 2, 3, 4, 5, 6})) << name;
    EXPECT_EQ(read("a.ply", file, {.columns = {"red", "x"}}).coordinates, (Doubles{255, 1, 0, 4})) << name;
  }
}

TEST(Ply, elements_before_the_vertices_are_passed_over) {
  const std::string file =
      "ply\r\nformat binary_little_endian 1.0\r\nelement tag 1\r\nproperty list uchar short s\r\nproperty char c\r\n"
      "element vertex 1\r\nproperty double x\r\nproperty double y\r\nend_header\r\n";
  EXPECT_EQ(read("a.ply", file + "\x02" + "abcd" + "e" + bytes_of<double>({7, 8})).coordinates, (Doubles{7, 8}));
}

TEST(Ply, cut_off_and_damaged_files_are_refused) {
  const std::string binary = std::string("ply\nformat binary_little_endian 1.0\n") + kPlyHeader;
  EXPECT_EQ(refused("a.ply", binary + bytes_of<float>({1, 2, 3})),
            "a.ply: expected 2 items of element vertex, found 0 before the end of the file");
  EXPECT_EQ(refused("a.ply", binary + std::string(26, '\x01') + "\x03"),
            "a.ply: expected 1 item of element face, found 0 before the end of the file");
  EXPECT_EQ(refused("a.ply", binary + std::string(26, '\x01') + std::string(1, '\0') + "junk"),
            "a.ply: expected the end of the file after the last element, found 4 bytes");
  const std::string text = std::string("ply\nformat ascii 1.0\n") + kPlyHeader;
  EXPECT_EQ(refused("a.ply", text + "1 2 3 4\n"),
            "a.ply: expected 2 lines of element vertex, found 1 before the end of the file");
  EXPECT_EQ(refused("a.ply", text + "1 2 3 4\n1 2 x 4\n0\n"), "a.ply: line 12, column 3: expected a number, found 'x'");
  EXPECT_EQ(refused("a.ply", text + "1 2 3 4 5\n1 2 3 4\n0\n"), "a.ply: line 11: expected 4 columns, found 5");
  EXPECT_EQ(refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n"),
            "a.ply: expected end_header, found the end of the file");
  EXPECT_EQ(refused("a.ply", "solid\n"), "a.ply: line 1: expected ply");
  EXPECT_EQ(refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n1\n"),
            "a.ply: line 4, column 2: expected a type such as float or int, found 'quad'");
}

TEST(Obj, vertices_are_the_v_lines) {
  const PointTable table = read("a.obj", "# cube\nmtllib a.mtl\nv 1 2 3\nvn 0 0 1\nv 4 5 6\nf 1//1 2//1 1//1\n");
  EXPECT_EQ(table.coordinates, (Doubles{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(table.coordinate_names, (Names{"x", "y", "z"}));
  EXPECT_EQ(read("a.obj", "f 1 2 3\n").size(), 0u);
  EXPECT_EQ(read("a.obj", "f 1 2 3\n").dimension, 3);
  EXPECT_EQ(refused("a.obj", "v 1 2 3\nv 1 2\n"), "a.obj: line 2: expected 4 columns, found 3");
  EXPECT_EQ(refused("a.obj", "v 1 2 3\nv 1 b 3\n"), "a.obj: line 2, column 3 (y): expected a number, found 'b'");
}

TEST(Off, keyword_and_counts_stand_in_any_usual_way) {
  const Doubles expected{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(read("a.off", "OFF\n2 0 0\n1 2 3\n4 5 6\n").coordinates, expected);
  EXPECT_EQ(read("a.off", "OFF 2 1 0\n1 2 3\n4 5 6\n2 0 1\n").coordinates, expected);
  EXPECT_EQ(read("a.off", "2 0\n1 2 3\n4 5 6\n").coordinates, expected);
  EXPECT_EQ(read("a.off", "COFF\n# coloured\n2 0 0\n1 2 3 255 0 0 255\n4 5 6 0 0 0 0\n").coordinates, expected);
  EXPECT_EQ(read("a.off", "nOFF\n2\n2 0 0\n1 2\n3 4\n").coordinates, (Doubles{1, 2, 3, 4}));
  EXPECT_EQ(read("a.off", "4OFF\n1 0 0\n1 2 3 4\n").dimension, 4);
}

TEST(Off, cut_off_files_are_refused) {
  EXPECT_EQ(refused("a.off", "OFF\n2 0 0\n1 2 3\n"),
            "a.off: expected 2 vertex lines, found 1 before the end of the file");
  EXPECT_EQ(refused("a.off", "OFF\n1 1 0\n1 2 3\n"), "a.off: expected 1 face, found 0 before the end of the file");
  EXPECT_EQ(refused("a.off", "OFF\n1 0 0\n1 2 3\n4 5 6\n"),
            "a.off: line 4: expected the end of the file after 0 faces");
  EXPECT_EQ(refused("a.off", "OFX\n"),
            "a.off: line 1, column 1: expected OFF or counts of vertices and faces, found 'OFX'");
}

}  // namespace
}  // namespace delone::io
