#include "delone/io/generate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "delone/base/errors.hpp"
#include "delone/base/ids.hpp"
#include "io/npy.hpp"
#include "io/output.hpp"
#include "io/source.hpp"

namespace delone::io {
namespace {

/// xoshiro256** by Blackman and Vigna, its state filled by splitmix64 as they advise.
class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      seed += 0x9E37'79B9'7F4A'7C15ULL;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9ULL;
      z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBULL;
      word = z ^ (z >> 31);
    }
  }

  std::uint64_t next() {
    const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  /// A multiple of 2^-53 in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// In [-1, 1).
  double symmetric() { return 2 * uniform() - 1; }

  /// Standard normal, by Marsaglia's polar method.
  double normal() {
    double u, v, s;
    do {
      u = symmetric();
      v = symmetric();
      s = u * u + v * v;
    } while (s >= 1 || s == 0);
    return u * std::sqrt(-2 * logarithm(s) / s);
  }

  /// An evenly distributed point of the unit circle: the direction of a point of the disk, its angle doubled.
  std::array<double, 2> direction() {
    double u, v, s;
    do {
      u = symmetric();
      v = symmetric();
      s = u * u + v * v;
    } while (s > 1 || s == 0);
    return {(u * u - v * v) / s, 2 * u * v / s};
  }

 private:
  /// Natural logarithm by arithmetic alone, since the C library's differs between systems:
  /// ln m = 2 atanh((m - 1) / (m + 1)), and for m in [0.7, 1.42) the powers of its argument shrink by 0.03 each.
  static double logarithm(double x) {
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < 0.7) {
      m *= 2;
      --exponent;
    }
    const double s = (m - 1) / (m + 1);
    double sum = 0;
    for (int k = 25; k >= 1; k -= 2) sum = sum * (s * s) + 1.0 / k;
    return exponent * 0.69314718055994530942 + 2 * s * sum;
  }

  std::array<std::uint64_t, 4> state_{};
};

/// The rows to fill.
struct Rows {
  std::size_t n;
  std::size_t dimension;
  std::vector<double>& coordinates;

  std::span<double> operator[](std::size_t row) const {
    return std::span(coordinates).subspan(row * dimension, dimension);
  }
};

void uniform(Random& random, const Rows& rows) {
  for (double& x : rows.coordinates) x = random.uniform();
}

void gaussian(Random& random, const Rows& rows) {
  for (double& x : rows.coordinates) x = random.normal();
}

void clusters(Random& random, const Rows& rows) {
  std::size_t count = 1;  // 1 + floor(sqrt(n) / 10), without asking a square root for a whole number
  while (100 * count * count <= rows.n) ++count;
  std::vector<double> centres(count * rows.dimension);
  for (double& x : centres) x = random.uniform();
  for (std::size_t row = 0; row < rows.n; ++row) {
    const std::size_t first = static_cast<std::size_t>(random.next() % count) * rows.dimension;
    for (std::size_t axis = 0; axis < rows.dimension; ++axis)
      rows[row][axis] = centres[first + axis] + 0.01 * random.normal();
  }
}

/// Half axes 1 and 1/2. Even in arc length: a point at parameter angle t is kept with probability |d/dt|.
std::array<double, 2> on_ellipse(Random& random) {
  for (;;) {
    const auto [cosine, sine] = random.direction();
    if (random.uniform() < std::sqrt(sine * sine + 0.25 * cosine * cosine)) return {cosine, 0.5 * sine};
  }
}

void ellipse(Random& random, const Rows& rows) {
  for (std::size_t row = 0; row < rows.n; ++row) std::ranges::copy(on_ellipse(random), rows[row].begin());
}

void ellipse2(Random& random, const Rows& rows) {
  for (std::size_t row = 0; row < rows.n; ++row) {
    if (row % 20 == 19) {
      for (double& x : rows[row]) x = random.symmetric();
    } else {
      std::ranges::copy(on_ellipse(random), rows[row].begin());
    }
  }
}

void circle(Random& random, const Rows& rows) {
  for (std::size_t row = 0; row < rows.n; ++row) std::ranges::copy(random.direction(), rows[row].begin());
}

/// y = x^2 for x in [-1, 1), even in arc length: |d/dx|^2 = 1 + 4 x^2 is at most 5.
void parabola(Random& random, const Rows& rows) {
  for (std::size_t row = 0; row < rows.n; ++row) {
    double x, u;
    do {
      x = random.symmetric();
      u = random.uniform();
    } while (u * u * 5 >= 1 + 4 * (x * x));
    rows[row][0] = x;
    rows[row][1] = x * x;
  }
}

/// The first n points, x fastest, of the smallest cube-shaped grid that has so many.
void lattice(Random&, const Rows& rows) {
  const auto holds = [&](std::size_t side) {  // side^dimension >= n, stopping before it can overflow
    std::size_t product = 1;
    for (std::size_t axis = 0; axis < rows.dimension && product < rows.n; ++axis) product *= side;
    return product >= rows.n;
  };
  std::size_t side = 1;
  if (rows.dimension == 1) side = rows.n;
  while (!holds(side)) ++side;
  for (std::size_t row = 0; row < rows.n; ++row) {
    std::size_t rest = row;
    for (double& x : rows[row]) {
      x = static_cast<double>(rest % side);
      rest /= side;
    }
  }
}

void sphere(Random& random, const Rows& rows) {
  for (std::size_t row = 0; row < rows.n; ++row) {
    double square = 0;
    do {
      square = 0;
      for (double& x : rows[row]) {
        x = random.normal();
        square += x * x;
      }
    } while (square == 0);
    const double length = std::sqrt(square);
    for (double& x : rows[row]) x /= length;
  }
}

void moment(Random& random, const Rows& rows) {
  for (std::size_t row = 0; row < rows.n; ++row) {
    const double t = random.symmetric();
    double power = 1;
    for (double& x : rows[row]) x = power *= t;
  }
}

/// Alternately on the x axis and on the line x = 0, z = 1, which is parallel to the y axis.
void skew(Random& random, const Rows& rows) {
  for (std::size_t row = 0; row < rows.n; ++row) {
    rows[row][row % 2] = random.symmetric();
    rows[row][2] = static_cast<double>(row % 2);
  }
}

/// Source: [GKS92] section 2, figure 1: half of the points on the negative x axis, then the others on the positive part
/// of the line y = 1, from right to left. Inserted in this order every upper point meets every lower one.
void gks_figure1(Random&, const Rows& rows) {
  const std::size_t lower = (rows.n + 1) / 2;
  for (std::size_t row = 0; row < rows.n; ++row) {
    rows[row][0] = row < lower ? -static_cast<double>(row + 1) : static_cast<double>(rows.n - row);
    rows[row][1] = row < lower ? 0 : 1;
  }
}

/// Source: [GKS92] section 4.3: points on two skew lines, and in the last row zeta halfway between the lines.
/// Departure from [GKS92] section 4.3: the paper spaces the points "sufficiently far apart". What is needed is the
/// opposite, lines far apart for the length of the rows on them. The sphere through (a, 0, 0), (b, 0, 0), (0, c, 1) and
/// (0, d, 1) has zeta = (0, 0, 1/2) at power (ab + cd)/2 - 1/4, so it contains zeta for certain when a, b, c and d stay
/// below 1/2 in size; here they do, and the quadratic triangulation of the lines turns linear when zeta comes.
void gks_zeta(Random&, const Rows& rows) {
  if (rows.n == 0) return;
  const std::size_t on_x = rows.n / 2, on_y = (rows.n - 1) / 2;
  const auto place = [](std::size_t i, std::size_t count) {  // the middle of the i-th of `count` parts of [-1/2, 1/2]
    return (static_cast<double>(2 * i + 1) - static_cast<double>(count)) / static_cast<double>(2 * count);
  };
  for (std::size_t i = 0; i < on_x; ++i) rows[i][0] = place(i, on_x);
  for (std::size_t i = 0; i < on_y; ++i) {
    rows[on_x + i][1] = place(i, on_y);
    rows[on_x + i][2] = 1;
  }
  rows[rows.n - 1][2] = 0.5;
}

struct Kind {
  const char* name;
  int least, most, usual;
  void (*fill)(Random&, const Rows&);
  const char* text;
};

constexpr std::array<Kind, 13> kKinds{{
    {"uniform", 1, kMaxDimension, 2, uniform, "evenly in the unit cube"},
    {"gaussian", 1, kMaxDimension, 2, gaussian, "normal, standard deviation 1 on each axis"},
    {"clusters", 1, kMaxDimension, 2, clusters,
     "1 + sqrt(n)/10 clusters in the unit cube, each normal with standard deviation 0.01"},
    {"ellipse", 2, 2, 2, ellipse, "evenly on an ellipse of half axes 1 and 1/2 [Dev97]"},
    {"ellipse2", 2, 2, 2, ellipse2, "the ellipse, and every twentieth point evenly in the square around it [Dev97]"},
    {"circle", 2, 2, 2, circle, "evenly on the unit circle [Dev97]"},
    {"parabola", 2, 2, 2, parabola, "evenly on the parabola y = x^2, -1 <= x < 1 [Dev97]"},
    {"lattice", 1, kMaxDimension, 2, lattice, "integer grid, as near to a cube as n points can be, x fastest"},
    {"sphere", 2, kMaxDimension, 3, sphere, "evenly on the unit sphere"},
    {"moment", 2, kMaxDimension, 3, moment, "on the moment curve (t, t^2, t^3, ...), -1 <= t < 1"},
    {"skew", 3, 3, 3, skew, "on two skew lines; about n^2/4 tetrahedra"},
    {"gks-figure1", 2, 2, 2, gks_figure1, "figure 1 of [GKS92]: inserted in this order, about n^2/4 triangles appear"},
    {"gks-zeta", 3, 3, 3, gks_zeta,
     "section 4.3 of [GKS92]: about n^2/4 tetrahedra, until the last point makes them few"},
}};

const Kind& find(const std::string& name) {
  for (const Kind& kind : kKinds)
    if (name == kind.name) return kind;
  std::string names;
  for (const Kind& kind : kKinds) names += (names.empty() ? "" : ", ") + std::string(kind.name);
  throw InputError("no kind of points is called '" + name + "'; there are " + names);
}

int checked_dimension(const Kind& kind, int dimension) {
  if (dimension == 0) return kind.usual;
  if (dimension >= kind.least && dimension <= kind.most) return dimension;
  const std::string exists = kind.least == kind.most
                                 ? "only in dimension " + std::to_string(kind.least)
                                 : "in dimensions " + std::to_string(kind.least) + " to " + std::to_string(kind.most);
  throw InputError("points of the kind '" + std::string(kind.name) + "' exist " + exists + ", not in " +
                   std::to_string(dimension));
}

void round_to_bits(const Rows& rows, int bits) {
  const double top = std::ldexp(1.0, bits) - 1;
  std::vector<double> low(rows.dimension);
  double extent = 0;
  for (std::size_t axis = 0; axis < rows.dimension; ++axis) {
    double high = low[axis] = rows[0][axis];
    for (std::size_t row = 0; row < rows.n; ++row) {
      low[axis] = std::min(low[axis], rows[row][axis]);
      high = std::max(high, rows[row][axis]);
    }
    extent = std::max(extent, high - low[axis]);
  }
  double scale = extent > 0 ? top / extent : 1;
  if (scale >= 1) scale = std::floor(scale);
  for (std::size_t row = 0; row < rows.n; ++row)
    for (std::size_t axis = 0; axis < rows.dimension; ++axis) {
      double& x = rows[row][axis];
      x = std::min(top, std::floor((x - low[axis]) * scale + 0.5));
    }
}

}  // namespace

bool is_points_path(const std::string& path) {
  const std::string extension = Source::extension(path);
  return path == "-" || extension == "csv" || extension == "txt" || (extension == "npy" && path.ends_with("npy"));
}

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

KindInfo kind_info(const std::string& kind) {
  const Kind& found = find(kind);
  return {found.name, found.text, found.least, found.most, found.usual};
}

Generated generate(const std::string& kind, std::size_t n, int dimension, std::uint64_t seed, int bits) {
  const Kind& found = find(kind);
  if (bits < 0 || bits > 52) throw InputError("points can be rounded to 1 to 52 bits, not " + std::to_string(bits));
  Generated result;
  result.dimension = checked_dimension(found, dimension);
  if (n > result.coordinates.max_size() / static_cast<std::size_t>(kMaxDimension))
    throw InputError(std::to_string(n) + " points are more than memory can address");
  result.coordinates.resize(n * static_cast<std::size_t>(result.dimension));
  const Rows rows{n, static_cast<std::size_t>(result.dimension), result.coordinates};
  Random random(seed);
  found.fill(random, rows);
  if (bits > 0 && n > 0) round_to_bits(rows, bits);
  return result;
}

void write_points(const std::string& path, const Generated& points) {
  if (!is_points_path(path)) throw InputError(path + ": points are written as .csv, .txt or .npy");
  const auto width = static_cast<std::size_t>(points.dimension);
  Output output(path);
  if (Source::extension(path) == "npy") {
    output << npy_header("<f8", points.coordinates.size() / width, width);
    output.put_all<double>(points.coordinates);
  } else {
    for (std::size_t axis = 0; axis < width; ++axis) {
      if (axis > 0) output << ',';
      if (width <= 3) {
        output << "xyz"[axis];
      } else {
        output.print("x{}", axis + 1);
      }
    }
    output << '\n';
    for (std::size_t i = 0; i < points.coordinates.size(); ++i)
      output.print("{}{}", points.coordinates[i], i % width == width - 1 ? '\n' : ',');
  }
  output.commit();
}

}  // namespace delone::io
