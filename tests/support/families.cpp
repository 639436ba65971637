#include "support/families.hpp"

#include <algorithm>
#include <cmath>
#include <ios>
#include <limits>
#include <numeric>
#include <utility>

namespace delone::test {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

std::size_t size(int n) { return static_cast<std::size_t>(n); }

template <class Number>
PointSet filled(std::string name, int dimension, std::size_t n, const Number& number) {
  PointSet points{std::move(name), dimension, {}, {}};
  for (std::size_t i = 0; i < n * size(dimension); ++i) points.coordinates.push_back(number());
  return points;
}

/// Row by row: `point` sets the coordinates it is given.
template <class Point>
PointSet by_rows(std::string name, int dimension, std::size_t n, const Point& point) {
  PointSet points{std::move(name), dimension, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> x(size(dimension), 0.0);
    point(x);
    points.coordinates.insert(points.coordinates.end(), x.begin(), x.end());
  }
  return points;
}

double pick(Random& random, std::initializer_list<double> values) {
  return *(values.begin() + random() % values.size());
}

template <class Weight>
PointSet with_weights(PointSet points, const std::string& name, const Weight& weight) {
  points.name += ", " + name;
  for (std::size_t i = 0; i < points.size(); ++i) points.weights.push_back(weight());
  return points;
}

}  // namespace

double unit_random(Random& random) { return std::ldexp(static_cast<double>(random() >> 11), -53); }

std::ostream& operator<<(std::ostream& out, const PointSet& points) {
  out << points.name << ", dimension " << points.dimension << std::hexfloat;
  for (std::size_t row = 0; row < points.size(); ++row) {
    out << (row == 0 ? ": " : "; ");
    for (const double x : points.view()[row]) out << x << ' ';
    if (!points.weights.empty()) out << "weight " << points.weights[row];
  }
  return out << std::defaultfloat;
}

PointSet uniform(int dimension, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  return filled("uniform", dimension, n, [&] { return unit_random(random); });
}

PointSet lattice(int dimension, std::size_t n, int side, std::uint64_t seed) {
  Random random(seed);
  return filled("lattice of side " + std::to_string(side), dimension, n,
                [&] { return static_cast<double>(random() % static_cast<std::uint64_t>(side)); });
}

PointSet cospherical(int dimension, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  return by_rows("cospherical", dimension, n, [&](std::vector<double>& x) {
    std::iota(x.begin(), x.end(), 1.0);
    for (std::size_t i = x.size(); i-- > 1;) std::swap(x[i], x[random() % (i + 1)]);
    for (double& value : x) value = random() % 2 == 0 ? value : -value;
  });
}

PointSet flat(int dimension, int rank, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  return by_rows("flat of rank " + std::to_string(rank), dimension, n, [&](std::vector<double>& x) {
    std::iota(x.begin(), x.end(), 5.0);
    for (int direction = 0; direction < rank; ++direction) {
      const auto step = static_cast<double>(random() % 4);
      for (int axis = 0; axis < dimension; ++axis) {
        x[size(axis)] += step * static_cast<double>((axis + 1) * (direction + 2) % 5 + (axis == direction ? 1 : 0));
      }
    }
  });
}

PointSet circle_of_24_bits(int dimension, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  constexpr double kRadius = 0x1p23;
  return by_rows("circle of 24 bits", dimension, n, [&](std::vector<double>& x) {
    const double angle = 6.283185307179586 * unit_random(random);
    x[0] = std::nearbyint(kRadius * std::cos(angle));
    if (dimension > 1) x[1] = std::nearbyint(kRadius * std::sin(angle));
    for (std::size_t axis = 2; axis < x.size(); ++axis) x[axis] = static_cast<double>(random() % 2);
  });
}

PointSet with_random_weights(PointSet points, std::uint64_t seed) {
  Random random(seed);
  return with_weights(std::move(points), "random weights", [&] { return unit_random(random); });
}

std::vector<PointSet> unweighted_families(int dimension, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  return {
      uniform(dimension, n, random()),
      lattice(dimension, n, 2, random()),
      lattice(dimension, n, 3, random()),
      cospherical(dimension, n, random()),
      flat(dimension, 1, n, random()),
      flat(dimension, std::max(1, dimension - 1), n, random()),
      circle_of_24_bits(dimension, n, random()),
      filled("1e300", dimension, n, [&] { return 1e300 * (unit_random(random) - 0.5); }),
      filled("lattice of the largest doubles", dimension, n,
             [&] {
               return kLargest * pick(random, {-1.0, 0.0, 0.5, 1.0});
             }),
      filled("1e-300", dimension, n, [&] { return 1e-300 * unit_random(random); }),
      filled("denormals", dimension, n, [&] { return kDenormal * static_cast<double>(random() % 50); }),
      filled("mixture of exponents", dimension, n,
             [&] {
               return pick(random, {1e300, -1e300, 1.0, 1e-300, kDenormal, 0.0}) * static_cast<double>(random() % 3);
             }),
      filled("mixture of bits", dimension, n,
             [&] {
               return pick(random, {1.0, 0x1p-30, 0x1p-50}) * unit_random(random);
             }),
      filled("lattice, just missed", dimension, n,
             [&] {
               return std::nextafter(static_cast<double>(random() % 4), pick(random, {-9.0, 9.0, 0.0}));
             }),
      filled("decimal grid far from the origin", dimension, n,
             [&] { return 500000.0 + static_cast<double>(random() % 4) * 0.1; }),
      filled("all equal", dimension, n, [] { return 0.1; }),
  };
}

std::vector<PointSet> families(int dimension, std::size_t n, std::uint64_t seed) {
  Random random(seed + 77);
  std::vector<PointSet> all;
  for (const PointSet& plain : unweighted_families(dimension, n, seed)) {
    all.push_back(plain);
    all.push_back(with_weights(plain, "equal weights", [] { return 2.5; }));
    all.push_back(with_weights(plain, "weights with ties", [&] { return static_cast<double>(random() % 3); }));
    all.push_back(with_weights(plain, "random weights", [&] { return unit_random(random); }));
    all.push_back(with_weights(plain, "extreme weights", [&] {
      return pick(random, {0.0, 1.0, -1.0, kLargest, -kLargest, kDenormal, -kDenormal});
    }));
  }
  return all;
}

PointSet permuted(const PointSet& points, const std::vector<std::size_t>& order) {
  PointSet result{points.name + ", permuted", points.dimension, {}, {}};
  for (const std::size_t row : order) {
    const auto x = points.view()[row];
    result.coordinates.insert(result.coordinates.end(), x.begin(), x.end());
    if (!points.weights.empty()) result.weights.push_back(points.weights[row]);
  }
  return result;
}

std::vector<std::size_t> random_permutation(std::size_t n, Random& random) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = n; i-- > 1;) std::swap(order[i], order[random() % (i + 1)]);
  return order;
}

PointSet rows(const PointSet& points, std::size_t first, std::size_t last) {
  std::vector<std::size_t> chosen(last - first);
  std::iota(chosen.begin(), chosen.end(), first);
  PointSet result = permuted(points, chosen);
  result.name = points.name + ", rows " + std::to_string(first) + " to " + std::to_string(last);
  return result;
}

}  // namespace delone::test
