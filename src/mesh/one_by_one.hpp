// What methods that insert one by one have in common: the first cells, then one site after the other.
#pragma once

#include <cstddef>

#include "base/tell_every.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/base/progress.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// Makes the first cells of a mesh without cells, as distinct_sites makes it, and gives sites K + 1 to count - 1, in
/// their order, to a Method<K>(mesh, arguments...).
template <template <int> class Method, class... Arguments>
void insert_one_by_one(Mesh& mesh, std::size_t count, const Progress& progress, const Arguments&... arguments) {
  with_dimension<1>(mesh.complex.dimension(), [&](auto dimension) {
    constexpr int kDimension = dimension;
    mesh.complex.reserve_more(kDimension + 2, mesh.sites.size());
    mesh.complex.grow_vertices(mesh.sites.size());
    make_first_cells<kDimension>(mesh);
    Method<kDimension> method(mesh, arguments...);
    for (std::size_t i = kDimension + 1; i < count; ++i) {
      tell_every(insertions_a_call(kDimension), progress, i, count);
      method.insert(VertexId{static_cast<Index>(i)});
    }
  });
}

}  // namespace delone
