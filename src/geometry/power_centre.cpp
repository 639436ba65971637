// Source: [Ede87] 13 for the power centre as the point where the bisectors meet. In a flat it is written
//   c = p_0 + sum m_i d_i / 2  with  d_i = p_i - p_0  and  G m = b,  G_ij = d_i . d_j,  b_i = |d_i|^2 - w_i + w_0,
// which needs no axes: what is orthogonal to a flat falls out of the same matrix G.
#include "delone/geometry/power_centre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delone/base/arithmetic.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/exact/determinant.hpp"
#include "delone/exact/double_double.hpp"
#include "exact/gram.hpp"
#include "exact/integer.hpp"
#include "exact/quotient.hpp"

namespace delone {
namespace {

using exact::BigInt;
using exact::dot;
using exact::Integers;
using exact::Scaled;
using exact::solve_gram;

/// Sites as integers times 2^unit, their weights as integers times 2^(2 unit).
struct ExactSites {
  ExactSites(const Sites& sites, std::span<const VertexId> of) {
    const auto dimension = static_cast<std::size_t>(sites.dimension());
    unit = std::numeric_limits<int>::max();
    const auto each = [&](const auto& coordinate, const auto& weight) {
      for (std::size_t i = 0; i < of.size(); ++i) {
        for (std::size_t j = 0; j < dimension; ++j)
          coordinate(i, j, exact::decompose(sites.coordinate(of[i], static_cast<int>(j))));
        weight(i, exact::decompose(sites.weight(of[i])));
      }
    };
    each([&](std::size_t, std::size_t, Scaled x) { exact::lower_unit(unit, x); },
         [&](std::size_t, Scaled w) { exact::lower_unit(unit, w, 2); });
    if (unit == std::numeric_limits<int>::max()) unit = 0;  // all is zero
    at.assign(of.size(), Integers(dimension));
    weights.resize(of.size());
    each([&](std::size_t i, std::size_t j, Scaled x) { at[i][j] = exact::to_integer<BigInt>(x, unit); },
         [&](std::size_t i, Scaled w) { weights[i] = exact::to_integer<BigInt>(w, 2 * unit); });
  }

  /// From the first site to each other one.
  std::vector<Integers> edges() const {
    std::vector<Integers> d;
    for (std::size_t i = 1; i < at.size(); ++i) {
      d.push_back(at[i]);
      for (std::size_t j = 0; j < at[i].size(); ++j) d.back()[j] -= at[0][j];
    }
    return d;
  }

  int unit;
  std::vector<Integers> at;
  Integers weights;
};

/// The centre, or its offset from the first site, as numerators over one denominator, times 2^unit.
struct ExactCentre {
  Integers numerators;
  BigInt denominator;
  int unit;
};

ExactCentre exact_centre(const Sites& sites, std::span<const VertexId> cell, bool offset) {
  const ExactSites p(sites, cell);
  const std::vector<Integers> edges = p.edges();
  Integers b;
  for (std::size_t i = 0; i < edges.size(); ++i) b.push_back(dot(edges[i], edges[i]) - p.weights[i + 1] + p.weights[0]);
  const auto [m, determinant] = solve_gram(edges, b);
  ExactCentre centre{{}, 2 * determinant, p.unit};
  for (std::size_t j = 0; j < p.at[0].size(); ++j) {
    BigInt sum = offset ? BigInt(0) : BigInt(centre.denominator * p.at[0][j]);
    for (std::size_t i = 0; i < edges.size(); ++i) sum += m[i] * edges[i][j];
    centre.numerators.push_back(std::move(sum));
  }
  return centre;
}

Vector rounded(const ExactCentre& centre) {
  Vector x{};
  for (std::size_t j = 0; j < centre.numerators.size(); ++j)
    x[j] = exact::nearest_double(centre.numerators[j], centre.denominator, centre.unit);
  return x;
}

/// A positive multiple of the part of `v` that is orthogonal to the edges, scaled to a largest component of 1 or -1.
Vector orthogonal_part(const Integers& v, const std::vector<Integers>& edges) {
  Integers b;
  for (const Integers& edge : edges) b.push_back(dot(edge, v));
  const auto [m, determinant] = solve_gram(edges, b);
  Integers part;
  BigInt largest = 0;
  for (std::size_t j = 0; j < v.size(); ++j) {
    part.push_back(determinant * v[j]);
    for (std::size_t i = 0; i < edges.size(); ++i) part[j] -= m[i] * edges[i][j];
    largest = std::max(largest, BigInt(abs(part[j])));
  }
  Vector x{};
  for (std::size_t j = 0; j < v.size(); ++j) x[j] = exact::nearest_double(part[j], largest, 0);
  return x;
}

DoubleDouble quotient(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble first(a.high() / b.high());
  const DoubleDouble rest = a - b * first;
  const DoubleDouble second(rest.high() / b.high());
  return first + second + DoubleDouble((rest - b * second).high() / b.high());
}

/// The centre by Cramer's rule in double-doubles, where all sites have K = D independent axes; false where they do not
/// tell how it rounds.
///   d_i . (c - p_0) = b_i / 2, so (c - p_0)_j = (-1)^(K - 1 - j) [minor without column j] / (2 [minor without b])
/// of the rows (d_i, b_i). The error of a minor, in units of u^2 and of its permanent, as in exact_predicates.cpp: K
/// products of 7, K (K - 1) / 2 sums of 6, and 13 (K + 1) for an entry b; the factor 4 covers the second order. A
/// quotient adds 40 of itself (three divisions, each corrected by the next, [JMP17]), the last sum 6 of its terms.
template <int K>
bool centre_by_pairs(const Sites& sites, std::span<const VertexId> cell, bool offset_only, Vector& centre) {
  constexpr auto n = static_cast<std::size_t>(K);
  constexpr double kUnit = 0x1p-106;
  std::array<std::array<DoubleDouble, n + 1>, n> rows;
  std::array<double, n + 1> largest{};
  const double* origin = sites.at(cell[0]);
  for (std::size_t i = 0; i < n; ++i) {
    const double* p = sites.at(cell[i + 1]);
    DoubleDouble b = DoubleDouble::difference(sites.weight(cell[0]), sites.weight(cell[i + 1]));
    double size = std::abs(b.high());
    for (std::size_t j = 0; j < n; ++j) {
      const DoubleDouble d = rows[i][j] = DoubleDouble::difference(p[j], origin[j]);
      b = b + d * d;
      size += d.high() * d.high();
      largest[j] = std::max(largest[j], std::abs(d.high()));
    }
    rows[i][n] = b;
    largest[n] = std::max(largest[n], size);
  }
  double permanents = 4 * kUnit * (7 * K + 3 * K * (K - 1) + 13 * (K + 1));
  for (std::size_t j = 0; j <= n; ++j) {
    if (!(largest[j] > 0x1p-100 && largest[j] < 0x1p100)) return false;
    permanents *= largest[j] * static_cast<double>(j + 1);  // in the end (K + 1)!, enough for K!
  }
  const auto entry = [&](std::size_t i, std::size_t j) -> const DoubleDouble& { return rows[i][j]; };
  const auto minors = detail::minors<K, K + 1, true, DoubleDouble>(entry);
  constexpr std::size_t kAll = (std::size_t{2} << n) - 1;
  const DoubleDouble denominator = minors[kAll ^ (std::size_t{1} << n)] * DoubleDouble(2.0);
  const double denominator_error = 2 * permanents / largest[n];
  const double least = std::abs(denominator.high()) - 2 * denominator_error;
  if (!(least > 0)) return false;
  for (std::size_t j = 0; j < n; ++j) {
    const DoubleDouble numerator = minors[kAll ^ (std::size_t{1} << j)];
    const DoubleDouble offset = quotient((n - 1 - j) % 2 == 0 ? numerator : -numerator, denominator);
    const double from = offset_only ? 0.0 : origin[j];
    const DoubleDouble x = DoubleDouble(from) + offset;
    const double size = std::abs(offset.high());
    const double error = 1.01 * ((permanents / largest[j] + size * denominator_error) / least +
                                 kUnit * (50 * size + 8 * std::abs(from)));
    const double low = (x - DoubleDouble(x.high())).high();
    const double up = x.high() + (low + error);
    const double down = x.high() + (low - error);
    if (up != down || !(std::abs(up) > 0x1p-900)) return false;
    centre[j] = up;
  }
  return true;
}

Vector rounded_centre(const Sites& sites, std::span<const VertexId> cell, bool offset) {
  const ExactEnvironment environment;
  Vector centre{};
  const int k = static_cast<int>(cell.size()) - 1;
  const bool done = k == sites.dimension() && k == sites.flat().dimension && with_dimension<1>(k, [&](auto dimension) {
                      return centre_by_pairs<dimension>(sites, cell, offset, centre);
                    });
  return done ? centre : rounded(exact_centre(sites, cell, offset));
}

}  // namespace

Vector power_centre(const Sites& sites, std::span<const VertexId> cell) { return rounded_centre(sites, cell, false); }

Vector power_centre_offset(const Sites& sites, std::span<const VertexId> cell) {
  return rounded_centre(sites, cell, true);
}

std::vector<Rational> exact_power_centre(const Sites& sites, std::span<const VertexId> cell) {
  const ExactCentre centre = exact_centre(sites, cell, false);
  std::vector<Rational> result;
  for (BigInt top : centre.numerators) {
    BigInt bottom = centre.denominator;
    (centre.unit > 0 ? top : bottom) <<= std::abs(centre.unit);
    const BigInt common = top == 0 ? bottom : BigInt(gcd(top, bottom));
    result.push_back({BigInt(top / common).str(), BigInt(bottom / common).str()});
  }
  return result;
}

Vector outward_normal(const Sites& sites, std::span<const VertexId> facet, VertexId apex) {
  std::vector<VertexId> all(facet.begin(), facet.end());
  all.push_back(apex);
  const ExactSites p(sites, all);
  std::vector<Integers> edges = p.edges();
  Integers away;
  for (const BigInt& x : edges.back()) away.push_back(-x);
  edges.pop_back();
  return orthogonal_part(away, edges);
}

std::vector<Vector> orthogonal_directions(const Sites& sites, std::span<const VertexId> cell) {
  const std::vector<Integers> edges = ExactSites(sites, cell).edges();
  const Flat& flat = sites.flat();
  const auto independent = std::span(flat.axes).first(static_cast<std::size_t>(flat.dimension));
  std::vector<Vector> directions;
  for (int axis = 0; axis < sites.dimension(); ++axis) {
    if (std::ranges::find(independent, axis) != independent.end()) continue;
    Integers unit(static_cast<std::size_t>(sites.dimension()));
    unit[static_cast<std::size_t>(axis)] = 1;
    directions.push_back(orthogonal_part(unit, edges));
  }
  return directions;
}

}  // namespace delone
