#include "lab/growth.hpp"

#include <cmath>
#include <limits>

namespace delone::lab {

double harmonic(std::size_t n) {
  double sum = 0;
  for (std::size_t i = n; i > 0; --i) sum += 1.0 / static_cast<double>(i);
  return sum;
}

std::vector<std::size_t> sizes_up_to(std::size_t most, std::size_t least, std::size_t factor) {
  std::vector<std::size_t> sizes;
  for (std::size_t n = least; n < most; n *= factor) sizes.push_back(n);
  sizes.push_back(most);
  return sizes;
}

Line fitted_line(std::span<const std::array<double, 2>> points) {
  const auto count = static_cast<double>(points.size());
  double x_mean = 0, y_mean = 0;
  for (const auto& [x, y] : points) {
    x_mean += x / count;
    y_mean += y / count;
  }
  double products = 0, squares = 0;
  for (const auto& [x, y] : points) {
    products += (x - x_mean) * (y - y_mean);
    squares += (x - x_mean) * (x - x_mean);
  }
  const double slope = squares > 0 ? products / squares : std::numeric_limits<double>::quiet_NaN();
  return {slope, y_mean - slope * x_mean};
}

double exponent(std::span<const std::array<double, 2>> points) {
  std::vector<std::array<double, 2>> logarithms;
  for (const auto& [x, y] : points) logarithms.push_back({std::log(x), std::log(y)});
  return fitted_line(logarithms).slope;
}

}  // namespace delone::lab
