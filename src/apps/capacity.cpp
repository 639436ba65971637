// Source: [AHA98] for the function, [KMT19] algorithm 1 for the steps.
//
// Let m_i(w) be the measure of the cell of site p_i, v_i the wanted one. The function
//   sum over i of  (integral over cell i of |x - p_i|^2 - w_i)  +  w_i v_i
// of the weights is concave, and its gradient is v - m(w): where it is greatest, the measures are the wanted ones. The
// face F between the cells of i and j lies where 2 x . (p_j - p_i) = |p_j|^2 - w_j - |p_i|^2 + w_i, so it moves by
// 1 / (2 |p_i - p_j|) when w_i grows by 1, and
//   d m_i / d w_j = -|F| / (2 |p_i - p_j|),     d m_i / d w_i = sum over j of |F| / (2 |p_i - p_j|):
// the Laplacian of a graph whose edges are the faces. A Newton step solves Laplacian * step = v - m. The same step for
// all sites of a connected part of the graph changes no face, so one site of each part is held: a spring, something
// positive on its diagonal entry, takes up the sum of v - m over the part, which is 0, and so the step there is 0.
//
// [KMT19]: the step is halved until no cell is smaller than half of the least at the start or wanted, and v - m has
// become shorter by at least half of the part of the step that is left.
//
// All cells have to have a measure at the start. On an axis alone, let sites a < b on a line meet at x: then
//   w_b = w_a + 2 (b - a) ((a + b) / 2 - x),
// so weights that cut a segment into given pieces follow one from the other. Let the weight of a site be the sum of
// those of its coordinates, each on its axis. So is its power, hence where all its coordinates have the least power,
// the site has: its cell contains the product of its pieces, a box, however close to each other the sites stand.
// Departure from [KMT19]: of this start and that with weights 0, the one with the larger least cell is taken.
#include "delone/apps/capacity.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "apps/box_within.hpp"
#include "apps/plain_sites.hpp"
#include "base/groups.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/dual/clip.hpp"

namespace delone {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

Eigen::Map<const Vector> vector_of(std::span<const double> v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}
std::span<const double> span_of(const Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

void require_capacities(std::span<const double> wanted, std::size_t sites, double measure) {
  if (wanted.size() != sites) {
    throw InputError(std::to_string(wanted.size()) + " capacities for " + std::to_string(sites) +
                     " sites: expected one per site");
  }
  for (std::size_t row = 0; row < wanted.size(); ++row) {
    if (!(wanted[row] > 0)) {
      throw InputError("row " + std::to_string(row) + ": capacity is not positive; leave out what is to have no cell");
    }
  }
  const double sum = std::reduce(wanted.begin(), wanted.end());
  if (!(std::abs(sum / measure - 1) <= 1e-6)) {
    std::ostringstream message;
    message.precision(9);
    message << "capacities sum to " << sum << ", but the region measures " << measure << ": scale them";
    throw InputError(message.str());
  }
}

void require_distinct(PointsView sites) {
  std::vector<Index> rows(sites.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  const auto before = [&](Index a, Index b) { return std::ranges::lexicographical_compare(sites[a], sites[b]); };
  std::ranges::stable_sort(rows, before);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!before(rows[i - 1], rows[i])) {
      throw InputError("rows " + std::to_string(rows[i - 1]) + " and " + std::to_string(rows[i]) +
                       " are one place: leave one out");
    }
  }
}

/// Weights of coordinates on a line, so that the pieces of a segment nearest to them are as long as they are wanted;
/// equal coordinates share one piece.
Vector cut_segment(const Vector& x, const Vector& wanted, double low, double high) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(x.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::sort(order, {}, [&](Eigen::Index i) { return x[i]; });
  const double total = wanted.sum();
  Vector weights = Vector::Zero(x.size());
  double before = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Eigen::Index a = order[k - 1];
    const Eigen::Index b = order[k];
    before += wanted[a];
    const double cut = low + before / total * (high - low);
    weights[b] = weights[a] + 2 * (x[b] - x[a]) * ((x[a] + x[b]) / 2 - cut);
  }
  return weights;
}

/// Weights with which every cell contains a box within the region.
Vector boxed(PointsView sites, const Region& region, const Vector& wanted) {
  const Box box = box_within(region);
  Vector weights = Vector::Zero(wanted.size());
  for (std::size_t axis = 0; axis < sites[0].size(); ++axis) {
    const Eigen::Map<const Vector, 0, Eigen::InnerStride<>> x(sites[0].data() + axis, wanted.size(),
                                                              Eigen::InnerStride<>(sites.dimension()));
    weights += cut_segment(x, wanted, box.low[axis], box.high[axis]);
  }
  return weights;
}

/// A step of less than this part of what Newton asks for leads nowhere: rounding is in the way.
constexpr double kShortest = 1e-6;
/// Of conjugate gradients, over the right side: so little that Newton's steps converge as with exact ones.
constexpr double kResidual = 1e-11;

/// The lower half of the Laplacian of the faces, with one site of each connected part held by a spring.
Matrix laplacian(PointsView sites, const CellMeasures& cells) {
  const auto n = static_cast<Eigen::Index>(sites.size());
  std::vector<Eigen::Triplet<double>> entries;
  Groups parts(sites.size());
  Vector diagonal = Vector::Zero(n);
  for (Index i = 0; i < sites.size(); ++i) {
    for (std::size_t k = cells.offsets[i]; k < cells.offsets[i + 1]; ++k) {
      const Index j = cells.neighbours[k];
      if (j > i) continue;
      const double entry = cells.shared[k] / (2 * distance(sites[i], sites[j]));
      entries.emplace_back(i, j, -entry);
      diagonal[i] += entry;
      diagonal[j] += entry;
      parts.unite(i, j);
    }
  }
  for (Index i = 0; i < sites.size(); ++i) {
    const double spring = diagonal[i] > 0 ? diagonal[i] : 1;
    entries.emplace_back(i, i, parts.find(i) == i ? diagonal[i] + spring : diagonal[i]);
  }
  Matrix lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

/// In the plane a factorisation is quicker than conjugate gradients; in space it fills up. NaN if there is none.
Vector solved(const Matrix& lower, const Vector& right, int dimension) {
  if (dimension == 2) {
    const Eigen::SimplicialLDLT<Matrix> factors(lower);
    if (factors.info() == Eigen::Success) return factors.solve(right);
  } else {
    Eigen::ConjugateGradient<Matrix, Eigen::Lower, Eigen::IncompleteCholesky<double>> solver(lower);
    solver.setTolerance(kResidual);
    if (solver.info() == Eigen::Success) return solver.solve(right);
  }
  return Vector::Constant(right.size(), std::numeric_limits<double>::quiet_NaN());
}

class Fit {
 public:
  Fit(PointsView sites, const Region& region, std::span<const double> wanted, const CapacityOptions& options)
      : sites_(sites), region_(&region), options_(&options), wanted_(vector_of(wanted)) {
    wanted_ *= region.measure() / wanted_.sum();
  }

  Capacities run() {
    State now = start();
    const double first = error(now);
    floor_ = std::min(now.least(), wanted_.minCoeff()) / 2;
    int steps = 0;
    for (; error(now) > options_->tolerance && steps < options_->steps; ++steps) {
      std::optional<State> next = advanced(now);
      if (!next) break;
      now = *std::move(next);
      done_ = std::max(done_, std::log(first / error(now)) / std::log(first / options_->tolerance));
    }
    return {.weights = {now.weights.begin(), now.weights.end()},
            .measures = std::move(now.cells.volume),
            .steps = steps,
            .error = error(now),
            .converged = error(now) <= options_->tolerance};
  }

 private:
  /// Weights, and what their cells measure.
  struct State {
    Vector weights;
    CellMeasures cells;
    Vector missing;  ///< what is wanted, less what is there
    double least() const { return *std::ranges::min_element(cells.volume); }
  };

  State at(Vector weights) const {
    weights.array() -= weights.mean();
    Progress progress;
    if (options_->progress) progress = [this](double) { return options_->progress(std::min(done_, 1.0)); };
    const PointsView sites(sites_.coordinates(), sites_.dimension(), span_of(weights));
    const AnyTriangulation t = build(sites, {.threads = options_->threads, .progress = progress});
    CellMeasures cells = measure_cells(t, *region_, {.threads = options_->threads, .progress = progress});
    Vector missing = wanted_ - vector_of(cells.volume);
    return {std::move(weights), std::move(cells), std::move(missing)};
  }

  State start() const {
    State plain = at(Vector::Zero(wanted_.size()));
    State box = at(boxed(sites_, *region_, wanted_));
    return plain.least() < box.least() ? std::move(box) : std::move(plain);
  }

  double error(const State& state) const { return state.missing.lpNorm<Eigen::Infinity>() / wanted_.mean(); }

  /// After a step that is as long as it may be, or nothing.
  std::optional<State> advanced(const State& now) const {
    const Vector balanced = now.missing.array() - now.missing.mean();  // else one cell takes what sums are off by
    const Vector step = solved(laplacian(sites_, now.cells), balanced, sites_.dimension());
    for (double part = 1; step.allFinite() && part > kShortest; part /= 2) {
      State next = at(now.weights + part * step);
      if (next.least() >= floor_ && next.missing.norm() <= (1 - part / 2) * now.missing.norm()) return next;
    }
    return {};
  }

  PointsView sites_;
  const Region* region_;
  const CapacityOptions* options_;
  Vector wanted_;
  double floor_ = 0;  ///< no cell becomes smaller
  double done_ = 0;   ///< of the way, counted in digits of the error
};

}  // namespace

Capacities fit_capacities(PointsView sites, const Region& region, std::span<const double> wanted,
                          const CapacityOptions& options) {
  require_plain_sites(sites, region);
  require_steps(options.steps, options.tolerance);
  require_capacities(wanted, sites.size(), region.measure());
  require_distinct(sites);
  const ExactEnvironment environment;
  return Fit(sites, region, wanted, options).run();
}

}  // namespace delone
