// When a point that sinks along the vertical line through o crosses the lifted hyperplanes of cells: an order of cells,
// decided exactly.
//
// The point o is infinitely near site 0, moved by e towards site 1, by e^2 towards site 2, and so on, as everywhere in
// mesh/history.hpp. So heights at o compare as those at site 0, where these are equal as those at site 1, ..., and
// where they are equal at sites 0 to K the hyperplanes are the same. Heights of sites are perturbed by less than any
// power of e: of two cells in one hyperplane the first site, in lexicographic order, decides at which o has different
// barycentric coordinates in the two. Lowering a site lowers the hyperplane at o by that coordinate, which compares at
// o as it does at site 0, then at site 1, ... Two cells cannot agree in all of that: a vertex that only one of them has
// is where the other has 0, and o lies in no hyperplane of sites.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "delone/exact/determinant.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/geometry/sites.hpp"
#include "exact/integer.hpp"
#include "mesh/site_tree.hpp"

namespace delone {

/// A positive cell, and when its hyperplane is crossed.
template <int K>
struct Crossing {
  using Cell = typename Kernel<K>::Cell;
  using Integers = std::array<exact::BigInt, K + 1>;

  /// Integers over the common power of two of all sites. Made one by one when doubles leave two cells in doubt.
  struct Exact {
    exact::BigInt volume;
    Integers depths;                     ///< per site 0 to K how far it lies above the hyperplane, times the volume
    std::array<Integers, K + 1> shares;  ///< per slot the barycentric coordinates of sites 0 to K, times the volume
    std::array<bool, K + 1> deep{};      ///< which depths are known
    std::array<bool, K + 1> shared{};    ///< the slots of which the shares are known
  };

  Cell cell;
  /// How far sites 0 to K lie above the hyperplane; without error where the cell has the site.
  std::array<typename SiteTree<K>::Clearance, K + 1> depths;
  std::unique_ptr<Exact> exact;
};

template <int K>
class CrossingOrder {
  static constexpr std::size_t kCoordinates = K;
  static constexpr std::size_t kCorners = K + 1;
  using BigInt = exact::BigInt;
  using Cell = typename Kernel<K>::Cell;

 public:
  CrossingOrder(const SiteTree<K>& tree, Kernel<K>& kernel) : tree_(tree), sites_(tree.sites()), kernel_(kernel) {}

  Crossing<K> crossing(const Cell& cell) const {
    Crossing<K> c{cell, {}, nullptr};
    const Plane<K> plane = tree_.plane(cell);
    for (std::size_t k = 0; k < kCorners; ++k) {
      const VertexId v{static_cast<Index>(k)};
      if (std::ranges::find(cell, v) == cell.end()) c.depths[k] = tree_.clearance(plane, v);
    }
    return c;
  }

  /// Whether the hyperplane of a is crossed before that of b.
  bool before(Crossing<K>& a, Crossing<K>& b) {
    if (const int sign = later(a, b, 0); sign != 0) [[likely]]
      return sign < 0;
    if (same_cell(a.cell, b.cell)) return false;
    for (std::size_t k = 0; k < kCorners; ++k) {
      if (const int sign = compare_depths(a, b, k); sign != 0) return sign < 0;
    }
    return wins_tie(a, b);
  }

 private:
  static bool same_cell(Cell a, Cell b) {
    std::ranges::sort(a);
    std::ranges::sort(b);
    return a == b;
  }

  static double error(const Crossing<K>& a, const Crossing<K>& b, std::size_t k) {
    return 1.001 * (a.depths[k].error + b.depths[k].error);
  }
  /// Whether site k lies higher above the hyperplane of a, 1, or of b, -1; 0 where doubles do not tell.
  static int later(const Crossing<K>& a, const Crossing<K>& b, std::size_t k) {
    const double higher = a.depths[k].least - b.depths[k].least;
    return higher > error(a, b, k) ? 1 : (-higher > error(a, b, k) ? -1 : 0);
  }
  int compare_depths(Crossing<K>& a, Crossing<K>& b, std::size_t k) {
    if (const int sign = later(a, b, k); sign != 0) return sign;
    if (error(a, b, k) == 0.0) return 0;  // both cells have the site
    return compare(depth(a, k), exact(a), depth(b, k), exact(b));
  }

  /// Of two cells in the same hyperplane.
  bool wins_tie(Crossing<K>& a, Crossing<K>& b) {
    std::array<VertexId, 2 * kCorners> both;
    std::ranges::copy(b.cell, std::ranges::copy(a.cell, both.begin()).out);
    std::ranges::sort(both, [this](VertexId v, VertexId w) { return kernel_.before(v, w); });
    for (const VertexId v : both) {
      const auto& in_a = shares(a, v);
      const auto& in_b = shares(b, v);
      for (std::size_t k = 0; k < kCorners; ++k) {
        if (const int sign = compare(in_a[k], exact(a), in_b[k], exact(b)); sign != 0) return sign < 0;
      }
    }
    return false;  // not reached: the cells differ
  }

  /// Of the numbers that are x and y times the volumes of two cells.
  static int compare(const BigInt& x, const typename Crossing<K>::Exact& a, const BigInt& y,
                     const typename Crossing<K>::Exact& b) {
    return exact::sign(BigInt(x * b.volume - y * a.volume));
  }

  typename Crossing<K>::Exact& exact(Crossing<K>& c) {
    if (!c.exact) {
      c.exact = std::make_unique<typename Crossing<K>::Exact>();
      c.exact->volume = volume(c.cell);
    }
    return *c.exact;
  }

  const BigInt& depth(Crossing<K>& c, std::size_t k) {
    auto& e = exact(c);
    if (!std::exchange(e.deep[k], true)) e.depths[k] = depth(c.cell, VertexId{static_cast<Index>(k)});
    return e.depths[k];
  }

  /// Nothing but zeros where the cell does not have v.
  const typename Crossing<K>::Integers& shares(Crossing<K>& c, VertexId v) {
    const auto slot = static_cast<std::size_t>(std::ranges::find(c.cell, v) - c.cell.begin());
    if (slot == kCorners) return zeros_;
    auto& known = exact(c).shares[slot];
    if (!std::exchange(c.exact->shared[slot], true)) {
      for (std::size_t k = 0; k < kCorners; ++k) {
        Cell moved = c.cell;
        moved[slot] = VertexId{static_cast<Index>(k)};
        known[k] = volume(moved);
      }
    }
    return known;
  }

  BigInt volume(const Cell& cell) const {
    Matrix<K, BigInt> m;
    for (std::size_t i = 0; i < kCoordinates; ++i) {
      for (std::size_t j = 0; j < kCoordinates; ++j) {
        m[i][j] = integer(kernel_.at(cell[i + 1])[j]) - integer(kernel_.at(cell[0])[j]);
      }
    }
    return determinant<K>(m);
  }

  /// With q as the origin, of height 0, a hyperplane that passes it at height h makes the determinant of its K + 1
  /// lifted points (-1)^K h times the volume.
  BigInt depth(const Cell& cell, VertexId q) const {
    const auto others = static_cast<std::size_t>(sites_.dimension()) - kCoordinates;
    Matrix<K + 1, BigInt> m;
    for (std::size_t i = 0; i < kCorners; ++i) {
      BigInt lift = weight(q) - weight(cell[i]);
      for (std::size_t j = 0; j < kCoordinates; ++j) {
        m[i][j] = integer(kernel_.at(cell[i])[j]) - integer(kernel_.at(q)[j]);
        lift += m[i][j] * m[i][j];
      }
      for (std::size_t j = 0; j < others; ++j) {
        const BigInt d =
            integer(sites_.others()[raw(cell[i]) * others + j]) - integer(sites_.others()[raw(q) * others + j]);
        lift += d * d;
      }
      m[i][kCoordinates] = lift;
    }
    const BigInt h = determinant<K + 1>(m);
    return K % 2 == 0 ? BigInt(-h) : h;
  }

  BigInt integer(double x) const { return exact::to_integer<BigInt>(exact::decompose(x), sites_.range().unit); }
  BigInt weight(VertexId v) const {
    return exact::to_integer<BigInt>(exact::decompose(sites_.weight(v)), 2 * sites_.range().unit);
  }

  const SiteTree<K>& tree_;
  const Sites& sites_;
  Kernel<K>& kernel_;
  const typename Crossing<K>::Integers zeros_{};
};

}  // namespace delone
