// The ways to build a triangulation, and the orders in which points may be inserted. All ways lead to the same
// triangulation; they differ in what they cost, and in what they show.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "delone/base/ids.hpp"
#include "delone/order/order.hpp"

namespace delone {

enum class Method : std::uint8_t {
  automatic,       ///< what is fastest: gift wrapping of few points in the plane or in space, divide and conquer in the
                   ///< plane, if there are no weights; else, or in an order, cavity
  cavity,          ///< insert one by one: remove the cells in conflict, fill the hole [For92] 4.3
  divide_conquer,  ///< knit halves together [For92] 4.6
  flip,            ///< insert one by one: flip the facets of the link [ES96]
  flip_loop,       ///< the same in the plane, going round the point [GKS92] 3
  flip_legalize,   ///< the same in the plane, edge by edge [Slides]
  history_simplices,  ///< cavities, found through the simplices between all hulls so far [For92] 4.4
  conflict_graph,     ///< cavities, known beforehand for every point that is still to come [For92] 4.4
  lawson,             ///< triangulate from left to right, then flip [For92] 4.2
  sweep,              ///< a line sweeps the plane [For92] 4.5
  gift_wrap,          ///< from facet to facet [For92] 4.6
  shelling,           ///< cell by cell along a line through the lifted hull [For92] 4.6
};

/// What a method is called, and what it serves.
struct MethodInfo {
  Method method;
  const char* name;  ///< as on the command line
  const char* text;
  int least_dimension, most_dimension;
  bool weights;
  bool ordered;  ///< takes an order of insertion
};

/// All of them, the automatic one first.
std::span<const MethodInfo> methods();
const MethodInfo& info(Method method);
/// @throws InputError naming all methods
Method method_named(const std::string& name);

/// @throws InputError naming those that serve, unless `method` serves points of this dimension
void require_served(Method method, int dimension, bool weighted);
/// @throws InputError naming those that do, unless `method` takes an order of insertion, or none is asked for. Divide
/// and conquer takes two: along Hilbert's curve cuts are those of its boxes, in lexicographic order they are vertical.
/// By itself it chooses between boxes, with and without chains, and strips across either axis.
void require_ordered(Method method, Order order);

}  // namespace delone
