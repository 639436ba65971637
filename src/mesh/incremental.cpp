#include "mesh/incremental.hpp"

#include "delone/base/dispatch.hpp"
#include "delone/base/errors.hpp"
#include "delone/mesh/inserter.hpp"

namespace delone {
namespace {

constexpr std::size_t kTick = 4096;  // sites between two calls of the caller's progress function

void tell(const Progress& progress, std::size_t done, std::size_t all) {
  if (progress && !progress(static_cast<double>(done) / static_cast<double>(all))) throw Cancelled();
}

/// Cells that a uniform set of n points needs, for one reservation up front; beyond dimension 3 too many to promise.
std::size_t expected_cells(int k, std::size_t n) { return k <= 3 ? (k == 3 ? 7 * n : 2 * n) + 64 : 64; }

template <int K>
void insert_sites(Mesh& mesh, std::size_t first, const Progress& progress) {
  Inserter<K> inserter(mesh);
  CellId near = mesh.complex.incident_cell(kGhost);
  for (std::size_t i = first; i < mesh.sites.size(); ++i) {
    if (i % kTick == 0) tell(progress, i - first, mesh.sites.size() - first);
    inserter.insert(VertexId{static_cast<Index>(i)}, near);
    near = inserter.last_cell();
  }
}

}  // namespace

void insert_from(Mesh& mesh, std::size_t first, const Progress& progress) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  mesh.complex.reserve_more(expected_cells(k, mesh.sites.size() - first), mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { insert_sites<dimension>(mesh, first, progress); });
}

void insert_all(Mesh& mesh, const Progress& progress) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  mesh.complex.reserve_more(expected_cells(k, mesh.sites.size()), mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { make_first_cells<dimension>(mesh); });
  insert_from(mesh, static_cast<std::size_t>(k) + 1, progress);
}

}  // namespace delone
