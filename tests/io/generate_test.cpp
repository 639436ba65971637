#include "delone/io/generate.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/io/points_file.hpp"

namespace delone::io {
namespace {

constexpr std::size_t kMany = 20'000;

std::size_t count(const Generated& points) {
  return points.coordinates.size() / static_cast<std::size_t>(points.dimension);
}

double at(const Generated& points, std::size_t row, std::size_t axis) {
  return points.coordinates[row * static_cast<std::size_t>(points.dimension) + axis];
}

/// Share of the rows for which `holds`.
template <class Holds>
double share(const Generated& points, Holds holds) {
  std::size_t hits = 0;
  for (std::size_t row = 0; row < count(points); ++row) hits += holds(row) ? 1U : 0U;
  return static_cast<double>(hits) / static_cast<double>(count(points));
}

/// Four standard deviations of the share of kMany independent draws.
double spread(double expected) { return 4 * std::sqrt(expected * (1 - expected) / kMany); }

TEST(Generate, every_kind_gives_as_many_finite_points_as_asked_in_each_of_its_dimensions) {
  for (const std::string& kind : kinds()) {
    const KindInfo info = kind_info(kind);
    for (int d = info.least_dimension; d <= info.most_dimension; ++d) {
      for (const std::size_t n : {0U, 1U, 2U, 3U, 17U, 100U}) {
        const Generated points = generate(kind, n, d, 5);
        EXPECT_EQ(points.dimension, d) << kind;
        EXPECT_EQ(count(points), n) << kind << ' ' << d;
        EXPECT_TRUE(std::ranges::all_of(points.coordinates, [](double x) { return std::isfinite(x); })) << kind;
      }
    }
    EXPECT_EQ(generate(kind, 3).dimension, info.usual_dimension) << kind;
    EXPECT_EQ(generate(kind, 50, 0, 9).coordinates, generate(kind, 50, 0, 9).coordinates) << kind;
  }
}

// Computed by another program from the published definitions of splitmix64 and xoshiro256**.
TEST(Generate, random_numbers_are_those_of_xoshiro) {
  EXPECT_EQ(generate("uniform", 2, 2, 1).coordinates,
            (std::vector<double>{0.7029218331588505, 0.5204366199388569, 0.5741057000197225, 0.39132860204190445}));
  EXPECT_EQ(generate("uniform", 4, 1, 7).coordinates,
            (std::vector<double>{0.7005764821796896, 0.2787512294737843, 0.8396274618764198, 0.9810977250149351}));
}

TEST(Generate, an_unknown_kind_or_dimension_is_refused) {
  EXPECT_THROW(generate("hexagon", 3), InputError);
  EXPECT_THROW(kind_info(""), InputError);
  EXPECT_THROW(generate("circle", 3, 3), InputError);
  EXPECT_THROW(generate("moment", 3, 1), InputError);
  EXPECT_THROW(generate("uniform", 3, 9), InputError);
  EXPECT_THROW(generate("uniform", 3, -1), InputError);
  EXPECT_THROW(generate("uniform", 3, 2, 1, 53), InputError);
}

TEST(Generate, uniform_fills_every_quarter_of_the_square_alike) {
  const Generated points = generate("uniform", kMany);
  for (const double x : {0.0, 0.5})
    for (const double y : {0.0, 0.5})
      EXPECT_NEAR(share(points,
                        [&](std::size_t row) {
                          return at(points, row, 0) >= x && at(points, row, 0) < x + 0.5 && at(points, row, 1) >= y &&
                                 at(points, row, 1) < y + 0.5;
                        }),
                  0.25, spread(0.25));
}

TEST(Generate, gaussian_has_the_shares_of_the_normal_distribution) {
  const Generated points = generate("gaussian", kMany, 1);
  for (const double bound : {-2.0, -1.0, -0.3, 0.0, 0.5, 1.0, 2.0}) {
    const double expected = 0.5 * std::erfc(-bound / std::numbers::sqrt2);
    EXPECT_NEAR(share(points, [&](std::size_t row) { return at(points, row, 0) < bound; }), expected, spread(expected));
  }
}

TEST(Generate, circle_and_sphere_lie_on_it_evenly) {
  const Generated circle = generate("circle", kMany);
  for (std::size_t row = 0; row < kMany; ++row)
    EXPECT_NEAR(std::hypot(at(circle, row, 0), at(circle, row, 1)), 1.0, 4e-16);
  for (const double angle : {-2.5, -1.0, 0.1, 1.4, 3.0}) {
    const double expected = (angle + std::numbers::pi) / (2 * std::numbers::pi);
    EXPECT_NEAR(
        share(circle, [&](std::size_t row) { return std::atan2(at(circle, row, 1), at(circle, row, 0)) < angle; }),
        expected, spread(expected));
  }
  const Generated sphere = generate("sphere", kMany, 3);
  for (std::size_t row = 0; row < kMany; ++row)
    EXPECT_NEAR(std::hypot(at(sphere, row, 0), at(sphere, row, 1), at(sphere, row, 2)), 1.0, 1e-15);
  for (const double height : {-0.7, 0.0, 0.4})  // Archimedes: caps of a sphere have areas like their heights
    EXPECT_NEAR(share(sphere, [&](std::size_t row) { return at(sphere, row, 1) < height; }), (height + 1) / 2,
                spread((height + 1) / 2));
}

TEST(Generate, ellipse_and_parabola_are_even_in_arc_length) {
  const Generated ellipse = generate("ellipse", kMany);
  double low = 0, all = 0;  // arc length where |y| < 0.3, and of all, by the midpoint rule over the parameter
  for (int i = 0; i < 100'000; ++i) {
    const double t = (i + 0.5) / 100'000 * 2 * std::numbers::pi;
    const double piece = std::hypot(std::sin(t), 0.5 * std::cos(t));
    all += piece;
    if (std::abs(0.5 * std::sin(t)) < 0.3) low += piece;
  }
  EXPECT_NEAR(share(ellipse, [&](std::size_t row) { return std::abs(at(ellipse, row, 1)) < 0.3; }), low / all,
              spread(low / all));
  for (std::size_t row = 0; row < kMany; ++row)
    EXPECT_NEAR(std::hypot(at(ellipse, row, 0), 2 * at(ellipse, row, 1)), 1.0, 4e-16);

  const Generated parabola = generate("parabola", kMany);
  // The length from 0 to x is (x sqrt(1 + 4 x^2) + asinh(2 x) / 2) / 2.
  const auto length = [](double x) { return (x * std::sqrt(1 + 4 * x * x) + std::asinh(2 * x) / 2) / 2; };
  const double expected = length(0.5) / length(1.0);
  EXPECT_NEAR(share(parabola, [&](std::size_t row) { return std::abs(at(parabola, row, 0)) < 0.5; }), expected,
              spread(expected));
  for (std::size_t row = 0; row < kMany; ++row) {
    EXPECT_EQ(at(parabola, row, 1), at(parabola, row, 0) * at(parabola, row, 0));
  }
}

TEST(Generate, ellipse2_has_a_twentieth_beside_the_ellipse) {
  const Generated points = generate("ellipse2", 1000);
  EXPECT_NEAR(share(points,
                    [&](std::size_t row) {
                      return std::abs(std::hypot(at(points, row, 0), 2 * at(points, row, 1)) - 1) > 1e-9;
                    }),
              0.05, 1e-9);
}

TEST(Generate, lattice_is_a_cut_cube_in_scan_order) {
  EXPECT_EQ(generate("lattice", 5, 2).coordinates, (std::vector<double>{0, 0, 1, 0, 2, 0, 0, 1, 1, 1}));
  EXPECT_EQ(generate("lattice", 3, 1).coordinates, (std::vector<double>{0, 1, 2}));
  const Generated cube = generate("lattice", 27, 3);
  std::set<std::vector<double>> distinct;
  for (std::size_t row = 0; row < 27; ++row) distinct.insert({at(cube, row, 0), at(cube, row, 1), at(cube, row, 2)});
  EXPECT_EQ(distinct.size(), 27U);
  EXPECT_EQ(*std::ranges::max_element(cube.coordinates), 2.0);
}

TEST(Generate, clusters_keep_together) {
  const Generated points = generate("clusters", 99, 3, 4);  // 1 + floor(sqrt(99) / 10): one cluster
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t row = 1; row < 99; ++row) EXPECT_NEAR(at(points, row, axis), at(points, 0, axis), 0.1);
}

TEST(Generate, bits_round_to_integers_that_use_the_whole_range) {
  for (const char* kind : {"uniform", "circle", "parabola", "gaussian", "moment"}) {
    for (const int bits : {1, 8, 24, 52}) {
      const Generated points = generate(kind, 500, 2, 3, bits);
      const double top = std::ldexp(1.0, bits) - 1;
      for (const double x : points.coordinates) {
        EXPECT_EQ(x, std::floor(x));
        EXPECT_GE(x, 0.0);
        EXPECT_LE(x, top);
      }
      EXPECT_EQ(*std::ranges::min_element(points.coordinates), 0.0);
      EXPECT_GT(*std::ranges::max_element(points.coordinates), 0.49 * top) << kind << ' ' << bits;
    }
  }
  EXPECT_EQ(generate("lattice", 4, 2, 1, 3).coordinates, (std::vector<double>{0, 0, 7, 0, 0, 7, 7, 7}));
  EXPECT_EQ(generate("uniform", 1, 2, 1, 8).coordinates, (std::vector<double>{0, 0}));
}

// The sphere through (a,0,0), (b,0,0), (0,c,1), (0,d,1) is |p|^2 - (a+b) x - (c+d) y + (cd - ab - 1) z + ab = 0, so
// zeta = (0, 0, 1/2) has the power 1/4 + (cd - ab - 1)/2 + ab, which is negative when zeta lies inside.
TEST(Generate, zeta_lies_in_every_ball_of_the_two_lines) {
  const Generated points = generate("gks-zeta", 42);
  std::vector<double> on_x, on_y;
  for (std::size_t row = 0; row + 1 < 42; ++row) {
    if (at(points, row, 2) == 0) {
      EXPECT_EQ(at(points, row, 1), 0.0);
      on_x.push_back(at(points, row, 0));
    } else {
      EXPECT_EQ(at(points, row, 0), 0.0);
      EXPECT_EQ(at(points, row, 2), 1.0);
      on_y.push_back(at(points, row, 1));
    }
  }
  EXPECT_EQ(on_x.size(), 21U);
  EXPECT_EQ(on_y.size(), 20U);
  for (const double a : on_x)
    for (const double b : on_x)
      for (const double c : on_y)
        for (const double d : on_y) EXPECT_LT(0.25 + (c * d - a * b - 1) / 2 + a * b, 0.0);
  EXPECT_EQ(at(points, 41, 0), 0.0);
  EXPECT_EQ(at(points, 41, 1), 0.0);
  EXPECT_EQ(at(points, 41, 2), 0.5);
}

TEST(Generate, figure_1_has_its_lower_points_first_and_its_upper_ones_from_right_to_left) {
  EXPECT_EQ(generate("gks-figure1", 5).coordinates, (std::vector<double>{-1, 0, -2, 0, -3, 0, 2, 1, 1, 1}));
}

TEST(Generate, written_points_read_back_the_same) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("delone-generate-test-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const Generated points = generate("gaussian", 300, 4, 2);
  for (const char* name : {"points.csv", "points.txt", "points.csv.gz", "points.npy"}) {
    const std::string path = (folder / name).string();
    ASSERT_TRUE(is_points_path(path));
    write_points(path, points);
    EXPECT_EQ(read_points(path).coordinates, points.coordinates) << name;
  }
  EXPECT_EQ(read_points((folder / "points.csv").string()).coordinate_names,
            (std::vector<std::string>{"x1", "x2", "x3", "x4"}));
  for (const char* name : {"points.pdf", "points", "points.npy.gz"}) EXPECT_FALSE(is_points_path(name)) << name;
  EXPECT_THROW(write_points((folder / "points.pdf").string(), points), InputError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace delone::io
