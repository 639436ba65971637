// Orders of insertion by name.
// Sources: [For92] 4.3 (theorem 4.2: lexicographic order; buckets; the quaternary order of [OIM84]), 4.4 (random
// order), 4.6 (the buckets of [BWY80]).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "delone/base/ids.hpp"
#include "delone/geometry/points.hpp"

namespace delone {

enum class Order : std::uint8_t {
  automatic,      ///< the usual one of the method
  brio,           ///< random rounds of growing size, each along Hilbert's curve
  hilbert,        ///< along the curve, without rounds
  random,         ///< every permutation as likely as any other
  lexicographic,  ///< by the first coordinate, then the second, ...
  input,          ///< by row
  bucket,         ///< through the cells of a grid, row after row, there and back
  quaternary,     ///< through the boxes of a 2^D-ary tree, level by level: of each box one point
};

struct OrderInfo {
  Order order;
  const char* name;  ///< as on the command line
  const char* text;
};

/// All of them, the automatic one first.
std::span<const OrderInfo> orders();
/// @throws InputError naming all orders
Order order_named(const std::string& name);

/// The rows of `points` in an order, but the automatic one.
/// @param axes  the coordinate axes that span the points
/// @param seed  of the random order
/// Cost: O(n), sorting by coordinates O(n log n).
std::vector<Index> ordered_rows(Order order, PointsView points, std::span<const int> axes, std::uint64_t seed = 1,
                                int threads = 1);

}  // namespace delone
