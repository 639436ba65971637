// The loop of the incremental method, one instantiation per dimension.
#pragma once

#include <functional>

#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Makes the first simplex from sites 0 to k of a mesh without cells, then inserts all other sites in their order.
/// @param tick  called now and then with the number of sites done; may throw to stop
void insert_all(Mesh& mesh, const std::function<void(std::size_t)>& tick);

/// Inserts the sites from `first` on, in their order, into a mesh that has cells.
void insert_from(Mesh& mesh, std::size_t first, const std::function<void(std::size_t)>& tick);

}  // namespace delone
