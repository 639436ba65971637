// Diagrams of order k: how many cells they have, and how few pairs of sites share one.
// Source: [GKS92] 4.2, lemma 4.3: the pairs that share a cell of an order up to k are O(nk), though the cells up to k
// are of the order of n k^2 (the remark after it).
//
// Pairs are counted by borders. Let X and Y share a cell of order k. A circle around a place of the cell through the
// further of the two, shrunk towards that one until it meets the other, has at most k - 2 sites inside. Its centre is
// any place of an interval, so it lies on a border where X and Y change places, of order k - 1 or less. The other way
// round, beside a border of order j between X and Y the nearest j + 1 sites are always the same, with both of them. So
// they are the pairs of the borders of all orders below k.
// With constants: of those sites inside let l lie on one side of XY and r on the other, l + r <= k - 2. Among all
// circles through X and Y one count falls where the other one grows, so where both are w, w is at most the larger of l
// and r. The symmetric scope is then at most k - 2, and lemma 2.5 bounds the number. (The proof of lemma 4.3 speaks of
// j - 1 sites inside for a pair that is new in order j; there are j - 2.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "delone/base/progress.hpp"
#include "delone/geometry/points.hpp"
#include "delone/lab/experiment.hpp"

namespace delone::lab {

/// Pairs of n sites that share a cell of an order up to k: at most as many as lemma 2.5 says of symmetric scope k - 2.
double pairs_bound(std::size_t n, int k);

/// [Lee82]: (2k - 1) n - (k^2 - 1) less the unbounded cells of all lower orders, for sites in general position.
double cells_by_lee(std::size_t n, int k, std::size_t lower_unbounded);

struct OrderCounts {
  int k = 1;
  std::size_t cells = 0, unbounded = 0, borders = 0, vertices = 0;
  std::size_t pairs = 0;  ///< that share a cell of this order or a lower one
};
/// Orders 1 to `most` of points that are not all on one line.
/// @throws InputError as for_orders() does; Cancelled
std::vector<OrderCounts> count_orders(PointsView points, int most, const Progress& progress = {});

struct PairsRow {
  std::string kind;
  std::size_t n = 0;
  int k = 1;
  Estimate cells, cells_so_far, pairs;  ///< of this order, of all orders up to it
};

struct PairsResult {
  std::vector<PairsRow> rows;
  std::vector<OrderCounts> first;  ///< all orders of the first run of the first kind
};

struct PairsOptions {
  std::vector<std::string> kinds{"uniform", "clusters", "circle", "lattice", "gks-figure1"};
  std::size_t n = 1000;
  std::vector<int> orders{1, 2, 3, 5, 10, 20};  ///< ascending
  int runs = 3;                                 ///< each with other points
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// By kind, then order. @throws InputError as for_orders() does; Cancelled
PairsResult run_pairs(const PairsOptions& options);

}  // namespace delone::lab
