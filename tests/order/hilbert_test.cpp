#include "delone/order/hilbert.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

namespace delone {
namespace {

/// All grid points of `bits` bits by their distance; empty where a distance is missing.
template <int K>
std::vector<std::array<std::uint32_t, K>> along_the_curve(int bits) {
  const std::uint64_t count = std::uint64_t{1} << bits * K;
  std::vector<std::array<std::uint32_t, K>> points(count);
  std::vector<bool> seen(count, false);
  for (std::uint64_t code = 0; code < count; ++code) {
    std::array<std::uint32_t, K> x{};
    for (std::size_t j = 0; j < K; ++j) {
      x[j] = static_cast<std::uint32_t>(code >> static_cast<int>(j) * bits) & ((1U << bits) - 1);
    }
    const std::uint64_t h = HilbertCurve<K>::distance(x, bits);
    EXPECT_LT(h, count);
    EXPECT_FALSE(seen[h]) << "two points at distance " << h;
    seen[h] = true;
    points[h] = x;
  }
  return points;
}

template <int K>
void expect_a_curve(int bits) {
  const auto points = along_the_curve<K>(bits);
  for (std::size_t i = 1; i < points.size(); ++i) {
    int steps = 0;
    for (std::size_t j = 0; j < K; ++j) {
      steps += std::abs(static_cast<int>(points[i][j]) - static_cast<int>(points[i - 1][j]));
    }
    ASSERT_EQ(steps, 1) << "in dimension " << K << " after " << i - 1;
  }
}

TEST(Hilbert, consecutive_points_are_neighbours_and_each_is_met_once) {
  for (const int bits : {1, 2, 5}) expect_a_curve<1>(bits);
  for (const int bits : {1, 2, 3, 6}) expect_a_curve<2>(bits);
  for (const int bits : {1, 2, 3, 4}) expect_a_curve<3>(bits);
  for (const int bits : {1, 2, 3}) expect_a_curve<4>(bits);
  for (const int bits : {1, 2, 3}) expect_a_curve<5>(bits);
  for (const int bits : {1, 2}) expect_a_curve<6>(bits);
  for (const int bits : {1, 2}) expect_a_curve<7>(bits);
  for (const int bits : {1, 2}) expect_a_curve<8>(bits);
}

TEST(Hilbert, a_finer_curve_refines_the_coarser_one) {
  for (const auto& x : along_the_curve<3>(3)) {
    const std::array<std::uint32_t, 3> coarse{x[0] / 2, x[1] / 2, x[2] / 2};
    EXPECT_EQ(HilbertCurve<3>::distance(x, 3) / 8, HilbertCurve<3>::distance(coarse, 2));
  }
}

template <int K>
void expect_several_as_each_alone(int bits) {
  std::mt19937_64 random(K);
  std::array<typename HilbertCurve<K>::Place, 4> places;
  for (auto& place : places) {
    for (std::uint32_t& x : place) x = static_cast<std::uint32_t>(random() & ((std::uint64_t{1} << bits) - 1));
  }
  const auto together = HilbertCurve<K>::distances(places, bits);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(together[i], HilbertCurve<K>::distance(places[i], bits));
}

TEST(Hilbert, several_points_go_as_each_alone) {
  for (const int bits : {1, 5, 22, 31}) expect_several_as_each_alone<2>(bits);
  for (const int bits : {1, 6, 21}) expect_several_as_each_alone<3>(bits);
  expect_several_as_each_alone<4>(16);
}

TEST(Hilbert, uses_all_bits_of_long_coordinates) {
  const std::uint32_t largest = 0x7FFFFFFF;
  EXPECT_EQ(HilbertCurve<1>::distance({largest}, 31), largest);
  EXPECT_LT((HilbertCurve<2>::distance({largest, largest}, 31)), std::uint64_t{1} << 62);
  EXPECT_NE((HilbertCurve<2>::distance({largest, largest}, 31)),
            (HilbertCurve<2>::distance({largest, largest - 1}, 31)));
}

}  // namespace
}  // namespace delone
