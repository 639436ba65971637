#include "mesh/incremental.hpp"

#include <algorithm>

#include "delone/base/dispatch.hpp"
#include "delone/mesh/inserter.hpp"

namespace delone {
namespace {

/// Cells that a uniform set of n points needs, for one reservation up front; beyond dimension 3 too many to promise.
std::size_t expected_cells(int k, std::size_t n) { return k <= 3 ? (k == 3 ? 7 * n : 2 * n) + 64 : 64; }

template <int K>
void insert_sites(Mesh& mesh, std::size_t first, const Progress& progress) {
  Inserter<K> inserter(mesh);
  CellId near = mesh.complex.incident_cell(kGhost);
  for (std::size_t i = first; i < mesh.sites.size(); ++i) {
    tell(progress, i - first, mesh.sites.size() - first);
    inserter.insert(VertexId{static_cast<Index>(i)}, near);
    near = inserter.last_cell();
  }
}

template <int K>
void find_hidden_sites(Mesh& mesh) {
  const ComplexView<K> complex(mesh.complex);
  Kernel<K> kernel(mesh.sites);
  mesh.hidden.reserve(mesh.sites.size(), mesh.complex.slot_count());
  WalkStats walked;
  CellId near = complex.incident_cell(kGhost);
  for (std::size_t i = 0; i < mesh.sites.size(); ++i) {
    const VertexId v{static_cast<Index>(i)};
    if (complex.has_vertex(v) || mesh.sites.is_empty(v) || mesh.duplicates.vertex_of(v) != kGhost) continue;
    near = walk(complex, kernel, kernel.at(v), near, walked);
    mesh.hidden.add(v, near);
  }
}

}  // namespace

void keep_hidden_sites(Mesh& mesh) {
  if (mesh.hidden.kept() || !mesh.sites.weighted() || mesh.complex.dimension() < 1) return;
  try {
    with_dimension<1>(mesh.complex.dimension(), [&](auto dimension) { find_hidden_sites<dimension>(mesh); });
  } catch (...) {
    mesh.hidden = {};
    throw;
  }
  mesh.hidden.keep();
}

void insert_from(Mesh& mesh, std::size_t first, const Progress& progress) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  mesh.complex.reserve_more(expected_cells(k, mesh.sites.size() - first), mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { insert_sites<dimension>(mesh, first, progress); });
}

void insert_all(Mesh& mesh, const Progress& progress, std::size_t room) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  room = std::max(room, mesh.sites.size());
  mesh.complex.reserve_more(expected_cells(k, room), room);
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { make_first_cells<dimension>(mesh); });
  insert_from(mesh, static_cast<std::size_t>(k) + 1, progress);
}

}  // namespace delone
