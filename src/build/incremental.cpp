#include "build/incremental.hpp"

#include "delone/base/dispatch.hpp"
#include "delone/mesh/inserter.hpp"

namespace delone {
namespace {

constexpr std::size_t kTick = 4096;  // sites between two calls of the caller's progress function

/// Cells that a uniform set of n points needs, for one reservation up front; beyond dimension 3 too many to promise.
std::size_t expected_cells(int k, std::size_t n) { return k <= 3 ? (k == 3 ? 7 * n : 2 * n) + 64 : 64; }

template <int K>
void insert_sites(Mesh& mesh, std::size_t first, const std::function<void(std::size_t)>& tick) {
  Inserter<K> inserter(mesh);
  CellId near = mesh.complex.incident_cell(kGhost);
  for (std::size_t i = first; i < mesh.sites.size(); ++i) {
    if (i % kTick == 0) tick(i);
    inserter.insert(VertexId{static_cast<Index>(i)}, near);
    near = inserter.last_cell();
  }
}

/// Points that all stand at one place: the heaviest is the vertex.
template <>
void insert_sites<0>(Mesh& mesh, std::size_t first, const std::function<void(std::size_t)>& tick) {
  ComplexView<0> complex(mesh.complex);
  for (std::size_t i = first; i < mesh.sites.size(); ++i) {
    if (i % kTick == 0) tick(i);
    const VertexId q{static_cast<Index>(i)};
    const CellId c = complex.cell(complex.twin(mesh.complex.incident_cell(kGhost), 0));
    const VertexId v = complex.vertex(c, 0);
    mesh.reserve_duplicate();
    if (meet_at_same_place(mesh, q, v)) continue;
    complex.forget(v);
    complex.set_vertex(c, 0, q);
    complex.settle(c);
  }
}

}  // namespace

void insert_from(Mesh& mesh, std::size_t first, const std::function<void(std::size_t)>& tick) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  mesh.complex.reserve_more(expected_cells(k, mesh.sites.size() - first), mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { insert_sites<dimension>(mesh, first, tick); });
}

void insert_all(Mesh& mesh, const std::function<void(std::size_t)>& tick) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  mesh.complex.reserve_more(expected_cells(k, mesh.sites.size()), mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { make_first_cells<dimension>(mesh); });
  insert_from(mesh, static_cast<std::size_t>(k) + 1, tick);
}

}  // namespace delone
