#include "delone/lab/optimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numbers>
#include <utility>

#include "delone/apps/equiangular.hpp"
#include "delone/base/errors.hpp"
#include "delone/base/random.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/mesh/export.hpp"
#include "lab/experiments.hpp"
#include "lab/plane.hpp"

namespace delone::lab {
namespace {

using Int128 = __int128;
using Vector = std::array<std::int64_t, 3>;

// Sites are integers: of up to 20 bits in the plane, where a dot product times a cross product stays below 2^84, and of
// up to 16 bits in space, where the largest product below stays below 2^110.
constexpr int kPlaneBits = 20, kSpaceBits = 16;

/// An angle of a triangle by its cotangent dot / cross, cross > 0. Larger angles are greater.
struct Angle {
  std::int64_t dot, cross;

  std::strong_ordering operator<=>(const Angle& other) const {
    return static_cast<Int128>(other.dot) * cross <=> static_cast<Int128>(dot) * other.cross;
  }
  bool operator==(const Angle& other) const { return (*this <=> other) == 0; }
  double degrees() const {
    return std::atan2(static_cast<double>(cross), static_cast<double>(dot)) * (180 / std::numbers::pi);
  }
};

Vector corner(PointsView points, Index row) {
  Vector x{};
  std::ranges::transform(points[row], x.begin(), [](double c) { return static_cast<std::int64_t>(c); });
  return x;
}
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Int128 dot(const Vector& a, const Vector& b) {
  Int128 sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) sum += static_cast<Int128>(a[axis]) * b[axis];
  return sum;
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::vector<Angle> sorted_angles(PointsView points, std::span<const Triangle> triangles) {
  std::vector<Angle> angles;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector p = corner(points, t[i]);
      const Vector a = corner(points, t[(i + 1) % 3]) - p, b = corner(points, t[(i + 2) % 3]) - p;
      angles.push_back({static_cast<std::int64_t>(dot(a, b)), std::abs(cross(a, b)[2])});
    }
  }
  std::ranges::sort(angles);
  return angles;
}

double square(double x) { return x * x; }
double number(Int128 x) { return static_cast<double>(x); }

/// Squared radius of the smallest ball that holds a triangle, in the plane or in space: about its longest edge when
/// the angle opposite is not acute, else about all three. Exact but for some roundings at the end.
double containment_of_triangle(const Vector& p, const Vector& q, const Vector& r) {
  std::array<Int128, 3> sides{dot(q - p, q - p), dot(r - q, r - q), dot(p - r, p - r)};
  std::ranges::sort(sides);
  if (sides[2] >= sides[0] + sides[1]) return number(sides[2]) / 4;
  const Vector n = cross(q - p, r - p);
  return number(sides[0]) * number(sides[1]) * number(sides[2]) / (4 * number(dot(n, n)));
}

/// Whether the fourth point is in the smallest ball about an acute triangle: p + c with
/// c = (|b|^2 c' x n + |c'|^2 n x b) / (2 n n), n = b x c' holds the centre, and d is inside when d d <= 2 d c.
bool holds(const Vector& p, const Vector& q, const Vector& r, const Vector& s) {
  const Vector b = q - p, c = r - p, d = s - p, n = cross(b, c);
  const Vector cn = cross(c, n), nb = cross(n, b);
  return dot(d, d) * dot(n, n) <= dot(b, b) * dot(cn, d) + dot(c, c) * dot(nb, d);
}

/// The same for a tetrahedron: the centre is in the middle of an edge, or in a facet, or equally far from all corners
/// ([For92] 3.1). Every ball that holds it is at least as large as the smallest of each facet and edge, so the first
/// that holds it is the one.
double containment_of_tetrahedron(const std::array<Vector, 4>& x) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      bool all = true;  // the others see the edge under a right angle or more
      for (std::size_t k = 0; k < 4; ++k) all = all && (k == i || k == j || dot(x[i] - x[k], x[j] - x[k]) <= 0);
      if (all) return number(dot(x[i] - x[j], x[i] - x[j])) / 4;
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector &p = x[(k + 1) % 4], &q = x[(k + 2) % 4], &r = x[(k + 3) % 4];
    const bool acute = dot(q - p, r - p) > 0 && dot(p - q, r - q) > 0 && dot(p - r, q - r) > 0;
    if (acute && holds(p, q, r, x[k])) return containment_of_triangle(p, q, r);
  }
  const Vector b = x[1] - x[0], c = x[2] - x[0], d = x[3] - x[0];
  const Vector cd = cross(c, d), db = cross(d, b), bc = cross(b, c);
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum += square(number(dot(b, b) * cd[axis] + dot(c, c) * db[axis] + dot(d, d) * bc[axis]));
  }
  return sum / (4 * square(number(dot(b, cd))));
}

double largest_radius(PointsView points, std::span<const Triangle> triangles) {
  double most = 0;
  for (const auto& [a, b, c] : triangles)
    most = std::max(most, containment_of_triangle(corner(points, a), corner(points, b), corner(points, c)));
  return std::sqrt(most);
}

double largest_radius_in_space(PointsView points, const CellTable& table) {
  double most = 0;
  for (std::size_t cell = 0; cell < table.size(); ++cell) {
    std::array<Vector, 4> x;
    std::ranges::transform(table[cell], x.begin(), [&](Index row) { return corner(points, row); });
    most = std::max(most, containment_of_tetrahedron(x));
  }
  return std::sqrt(most);
}

std::vector<Triangle> triangles_of(const CellTable& table) {
  std::vector<Triangle> triangles;
  for (std::size_t c = 0; c < table.size(); ++c) triangles.push_back({table[c][0], table[c][1], table[c][2]});
  return triangles;
}

double uniform(std::uint64_t seed, std::size_t i) { return static_cast<double>(mix(mix(seed) + i) >> 11) * 0x1p-53; }

/// The regular triangulation by heights |x|^2 + c (v x)^2. These are strictly convex, so no site is hidden but by
/// rounding.
AnyTriangulation stretched(PointsView points, double c, std::uint64_t seed) {
  std::array<double, 3> v{};
  for (std::size_t axis = 0; axis < 3; ++axis) v[axis] = uniform(seed, axis) - 0.5;
  std::vector<double> weights;
  for (std::size_t row = 0; row < points.size(); ++row) {
    double along = 0;
    for (std::size_t axis = 0; axis < points[row].size(); ++axis) along += v[axis] * points[row][axis];
    weights.push_back(-c * along * along);
  }
  return build(PointsView(points.coordinates(), points.dimension(), weights));
}

/// Random weights, halved until they hide no site.
AnyTriangulation randomly_weighted(PointsView points, double most, std::uint64_t seed) {
  for (;; most /= 2) {
    std::vector<double> weights;
    for (std::size_t row = 0; row < points.size(); ++row) weights.push_back(most * uniform(seed, row));
    AnyTriangulation t = build(PointsView(points.coordinates(), points.dimension(), weights));
    if (t.hidden_count() == 0 || most == 0) return t;
  }
}

/// `n` sites evenly in a square or cube, and others evenly on its border, as dense: without these the flattest cells
/// are those along the hull, which most triangulations share.
io::Generated framed(std::size_t n, int dimension, std::uint64_t seed, int bits) {
  io::Generated made = io::generate("uniform", n, dimension, seed, bits);
  const auto parts = static_cast<std::size_t>(std::ceil(std::pow(static_cast<double>(n), 1.0 / dimension)));
  const double step = std::floor((std::ldexp(1, bits) - 1) / static_cast<double>(parts));
  std::size_t places = 1;
  for (int axis = 0; axis < dimension; ++axis) places *= parts + 1;
  for (std::size_t place = 0; place < places; ++place) {
    std::vector<double> x;
    bool on_border = false;
    for (std::size_t rest = place; x.size() < static_cast<std::size_t>(dimension); rest /= parts + 1) {
      const std::size_t at = rest % (parts + 1);
      on_border = on_border || at == 0 || at == parts;
      x.push_back(at == parts ? std::ldexp(1, bits) - 1 : step * static_cast<double>(at));
    }
    if (on_border) made.coordinates.insert(made.coordinates.end(), x.begin(), x.end());
  }
  return made;
}

/// What is compared of one triangulation.
struct Quality {
  std::vector<Angle> angles;
  double radius = 0;
};

/// Gathers the runs of one comparison.
class Gathering {
 public:
  Gathering(std::string other, double flips, double extent) : extent_(extent) {
    result_.other = std::move(other);
    result_.flips = flips;
  }
  void add(const Quality& delaunay, const Quality& other) {
    ++result_.runs;
    if (!delaunay.angles.empty()) {
      result_.angle_at_least += delaunay.angles.front() >= other.angles.front() ? 1 : 0;
      result_.sequence_at_least += delaunay.angles >= other.angles ? 1 : 0;
      ours_.push_back(delaunay.angles.front().degrees());
      theirs_.push_back(other.angles.front().degrees());
    }
    // A radius is a root of products and quotients of at most a dozen rounded numbers: 2^-48 covers it by far.
    result_.radius_at_most += delaunay.radius <= other.radius * (1 + 0x1p-48) ? 1 : 0;
    our_radii_.push_back(delaunay.radius / extent_);
    their_radii_.push_back(other.radius / extent_);
  }
  Comparison result() {
    result_.delaunay_angle = estimate(ours_);
    result_.other_angle = estimate(theirs_);
    result_.delaunay_radius = estimate(our_radii_);
    result_.other_radius = estimate(their_radii_);
    return result_;
  }

 private:
  Comparison result_;
  double extent_;
  std::vector<double> ours_, theirs_, our_radii_, their_radii_;
};

Quality plane_quality(PointsView points, std::span<const Triangle> triangles) {
  return {sorted_angles(points, triangles), largest_radius(points, triangles)};
}

void tell_run(const ComparisonOptions& options, int run) {
  if (options.progress && !options.progress((run + 1.0) / options.runs)) throw Cancelled();
}

}  // namespace

std::vector<Comparison> compare_in_plane(const ComparisonOptions& options) {
  const double extent = std::ldexp(1, kPlaneBits) - 1;
  std::vector<Gathering> all{{"sorted from left to right", 0, extent}};
  for (const double flips : options.flips) all.emplace_back(fmt::format("{:g} n random flips", flips), flips, extent);
  for (const double c : options.stretches) all.emplace_back(fmt::format("stretched, c = {:g}", c), 0, extent);
  for (int run = 0; run < options.runs; ++run) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(run);
    const io::Generated made = framed(options.plane_sites, 2, seed, kPlaneBits);
    const PointsView points(made.coordinates, 2);
    const std::vector<Triangle> best = triangles_of(equiangular_cells(build(points), false));
    const Quality delaunay = plane_quality(points, best);
    std::size_t next = 0;
    all[next++].add(delaunay, plane_quality(points, sorted_triangles(points)));
    for (const double flips : options.flips) {
      Mesh mesh = closed_mesh(points, best);
      flip_at_random(mesh, static_cast<std::size_t>(std::ceil(flips * static_cast<double>(points.size()))), seed);
      all[next++].add(delaunay, plane_quality(points, triangles_of(mesh)));
    }
    for (const double c : options.stretches) {
      all[next++].add(delaunay, plane_quality(points, triangles_of(cells(stretched(points, c, seed), false))));
    }
    tell_run(options, run);
  }
  std::vector<Comparison> comparisons;
  for (Gathering& g : all) comparisons.push_back(g.result());
  return comparisons;
}

std::vector<Comparison> compare_in_space(const ComparisonOptions& options) {
  const double extent = std::ldexp(1, kSpaceBits) - 1;
  std::vector<Gathering> all{{"random weights", 0, extent}};
  for (const double c : options.stretches) all.emplace_back(fmt::format("stretched, c = {:g}", c), 0, extent);
  for (int run = 0; run < options.runs; ++run) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(run);
    const io::Generated made = framed(options.space_sites, 3, seed, kSpaceBits);
    const PointsView points(made.coordinates, 3);
    const auto quality = [&](const AnyTriangulation& t) {
      return Quality{{}, largest_radius_in_space(points, cells(t, false))};
    };
    const Quality delaunay = quality(build(points));
    const double spacing = extent / std::cbrt(static_cast<double>(options.space_sites));
    std::size_t next = 0;
    all[next++].add(delaunay, quality(randomly_weighted(points, spacing * spacing, seed)));
    for (const double c : options.stretches) all[next++].add(delaunay, quality(stretched(points, c, seed)));
    tell_run(options, run);
  }
  std::vector<Comparison> comparisons;
  for (Gathering& g : all) comparisons.push_back(g.result());
  return comparisons;
}

namespace {

/// Integer points of a circle about the origin.
io::Generated circle(std::int64_t radius) {
  io::Generated points{.dimension = 2, .coordinates = {}};
  for (std::int64_t x = -radius; x <= radius; ++x) {
    const auto y = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(radius * radius - x * x))));
    if (x * x + y * y != radius * radius) continue;
    for (const std::int64_t height : {y, -y}) {
      points.coordinates.push_back(static_cast<double>(x));
      points.coordinates.push_back(static_cast<double>(height));
      if (y == 0) break;
    }
  }
  return points;
}

Completion complete(const std::string& name, const io::Generated& made) {
  const PointsView points(made.coordinates, 2);
  const AnyTriangulation t = build(points);
  const auto canonical = sorted_angles(points, triangles_of(cells(t, false)));
  const auto equiangular = sorted_angles(points, triangles_of(equiangular_cells(t, false)));
  Completion result{.points = name, .n = points.size(), .canonical = {}, .equiangular = {}};
  const PolytopeTable polygons = merged_cells(t);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    result.polygons += polygons[i].size() > 3 ? 1 : 0;
    result.most_corners = std::max(result.most_corners, polygons[i].size());
  }
  result.at_least = equiangular >= canonical;
  for (std::size_t i = 0; i < canonical.size(); ++i) {
    result.canonical.push_back(canonical[i].degrees());
    result.equiangular.push_back(equiangular[i].degrees());
    if (result.differ_at != 0 || canonical[i] == equiangular[i]) continue;
    result.differ_at = i + 1;
    result.canonical_there = result.canonical.back();
    result.equiangular_there = result.equiangular.back();
  }
  return result;
}

}  // namespace

std::vector<Completion> compare_completions(std::uint64_t seed) {
  return {complete("square lattice", io::generate("lattice", 100)),
          complete("coarse grid, some sites", io::generate("uniform", 120, 2, seed, 4)),
          complete("circle of radius 5", circle(5)), complete("circle of radius 65", circle(65)),
          complete("circle of radius 325", circle(325))};
}

namespace {

LabTable plane_table(const std::vector<Comparison>& all, std::size_t n) {
  LabTable table{
      .title = fmt::format("{} sites in a square, others on its border: Delaunay's triangulation and others", n),
      .columns = {"other", "runs", "least angle", "+-", "other's", "+-", "not less", "sequence not less", "radius",
                  "+-", "other's", "+-", "not more"},
      .rows = {},
      .note = "Angles in degrees; the radius of the largest min-containment circle by the side of the square."};
  for (const Comparison& c : all) {
    table.rows.push_back({c.other, static_cast<double>(c.runs), c.delaunay_angle.mean, c.delaunay_angle.deviation,
                          c.other_angle.mean, c.other_angle.deviation, fmt::format("{}/{}", c.angle_at_least, c.runs),
                          fmt::format("{}/{}", c.sequence_at_least, c.runs), c.delaunay_radius.mean,
                          c.delaunay_radius.deviation, c.other_radius.mean, c.other_radius.deviation,
                          fmt::format("{}/{}", c.radius_at_most, c.runs)});
  }
  return table;
}

LabTable space_table(const std::vector<Comparison>& all, std::size_t n) {
  LabTable table{
      .title = fmt::format(
          "{} sites in a cube, others on its border: regular triangulations by other heights, no site hidden", n),
      .columns = {"other", "runs", "radius", "+-", "other's", "+-", "not more"},
      .rows = {},
      .note = {}};
  for (const Comparison& c : all) {
    table.rows.push_back({c.other, static_cast<double>(c.runs), c.delaunay_radius.mean, c.delaunay_radius.deviation,
                          c.other_radius.mean, c.other_radius.deviation,
                          fmt::format("{}/{}", c.radius_at_most, c.runs)});
  }
  return table;
}

LabTable completion_table(const std::vector<Completion>& all) {
  LabTable table{.title = "Cocircular sites: the usual completion, and that with the largest sequence of angles",
                 .columns = {"points", "n", "polygons", "most corners", "least angle", "differ at", "usual there",
                             "equiangular there", "not less"},
                 .rows = {},
                 .note = "The place is that in the ascending sequence of angles, where the two first differ."};
  for (const Completion& c : all) {
    table.rows.push_back({c.points, static_cast<double>(c.n), static_cast<double>(c.polygons),
                          static_cast<double>(c.most_corners), c.equiangular.front(),
                          c.differ_at == 0 ? Value("nowhere") : Value(static_cast<double>(c.differ_at)),
                          c.canonical_there, c.equiangular_there, c.at_least ? "yes" : "no"});
  }
  return table;
}

std::vector<Panel> panels_of(const std::vector<Comparison>& plane, const Completion& round) {
  Panel angle{"Smallest angle in the plane", {"random flips by site", true}, {"degrees", true}, {}};
  Panel radius{"Largest min-containment circle", {"random flips by site", true}, {"by the side of the square"}, {}};
  Series best{"Delaunay: the optimum", {}, true}, measured{"after random flips", {}};
  Series best_radius = best, measured_radius = measured;
  for (const Comparison& c : plane) {
    if (c.flips == 0) continue;
    best.points.push_back({c.flips, c.delaunay_angle.mean});
    measured.points.push_back({c.flips, c.other_angle.mean});
    best_radius.points.push_back({c.flips, c.delaunay_radius.mean});
    measured_radius.points.push_back({c.flips, c.other_radius.mean});
  }
  angle.series = {best, measured};
  radius.series = {best_radius, measured_radius};
  Panel completions{fmt::format("{} sites on a circle: angles", round.n), {"place"}, {"degrees"}, {}};
  Series canonical{"usual completion", {}}, equiangular{"equiangular completion", {}};
  for (std::size_t i = 0; i < 2 * round.canonical.size() / 3; ++i) {
    canonical.points.push_back({static_cast<double>(i + 1), round.canonical[i]});
    equiangular.points.push_back({static_cast<double>(i + 1), round.equiangular[i]});
  }
  completions.series = {canonical, equiangular};
  return {angle, radius, completions};
}

ComparisonOptions how(const LabOptions& options) {
  ComparisonOptions result;
  if (options.n != 0) result.plane_sites = result.space_sites = options.n;
  if (options.runs != 0) result.runs = options.runs;
  result.seed = options.seed;
  result.progress = options.progress;
  return result;
}

LabReport report(const LabOptions& options) {
  if (options.n != 0 && (options.n < 10 || options.n > 100000))
    throw InputError("lab optimal: 10 to 100000 sites are compared");
  const ComparisonOptions compare = how(options);
  const std::vector<Comparison> plane = compare_in_plane(compare);
  const std::vector<Comparison> space = compare_in_space(compare);
  const std::vector<Completion> completions = compare_completions(options.seed);
  LabReport report;
  report.heading =
      "[For92] lemma 3.1: of all triangulations of a planar set Delaunay's has the largest smallest angle, and the\n"
      "lexicographically largest sequence of angles, with Mount and Saalfeld's completion where sites are cocircular.\n"
      "Lemma 3.2: in any dimension its largest min-containment ball is the smallest.";
  report.tables = {plane_table(plane, compare.plane_sites), space_table(space, compare.space_sites),
                   completion_table(completions)};
  report.chart_title = "What the Delaunay triangulation is best at";
  report.panels = panels_of(plane, completions[3]);
  return report;
}

}  // namespace

Experiment optimal_experiment() {
  return {.name = "optimal",
          .text = "Angles and min-containment balls of Delaunay's triangulation against others",
          .seconds =
              [](const LabOptions& options) {
                const ComparisonOptions compare = how(options);
                return 0.1 + compare.runs * (1e-4 * static_cast<double>(compare.plane_sites) +
                                             3e-4 * static_cast<double>(compare.space_sites));
              },
          .run = report};
}

}  // namespace delone::lab
