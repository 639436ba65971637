#include "mesh/incremental.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>

#include "delone/base/dispatch.hpp"
#include "delone/mesh/inserter.hpp"

namespace delone {
namespace {

/// Makes room for n sites more and the cells that they make, if it is to be had: as many as of uniform points, which is
/// a guess. What is not used is no memory yet, but counts until the mesh is shrunk.
void reserve_expected(Mesh& mesh, std::size_t n) {
  constexpr std::array<std::size_t, kMaxDimension + 1> kCells{2, 2, 2, 7, 33, 190, 1300, 1300, 1300};  // a point
  Complex& complex = mesh.complex;
  const auto k = static_cast<std::size_t>(complex.dimension());
  const std::size_t nameable = complex.nameable_slots() - complex.slot_count();
  complex.reserve_more(std::min<std::size_t>(64, nameable), mesh.sites.size());
  try {
    const std::size_t cells = std::min(kCells[k] * n + 64, nameable);
    complex.reserve_more(cells, mesh.sites.size());
    mesh.scratch.expect_cells(complex.dimension(), complex.slot_count() + cells);
  } catch (const std::bad_alloc&) {  // it grows as cells come
  }
}

template <int K>
void insert_sites(Mesh& mesh, std::size_t first, std::size_t last, const Progress& progress) {
  Inserter<K> inserter(mesh);
  CellId near = mesh.complex.incident_cell(kGhost);
  for (std::size_t i = first; i < last; ++i) {
    tell(progress, i - first, last - first);
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

void insert_range(Mesh& mesh, std::size_t first, std::size_t last, const Progress& progress) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  reserve_expected(mesh, k <= 3 ? last - first : 0);  // above, they are too many to promise to a mesh that stays
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { insert_sites<dimension>(mesh, first, last, progress); });
  mesh.statistics.in_turn += last - first;
}

void insert_first(Mesh& mesh, std::size_t count, const Progress& progress) {
  const int k = mesh.complex.dimension();
  if (k < 0) return;
  reserve_expected(mesh, mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension(k, [&](auto dimension) { make_first_cells<dimension>(mesh); });
  insert_range(mesh, static_cast<std::size_t>(k) + 1, count, progress);
}

void insert_all(Mesh& mesh, const Progress& progress) { insert_first(mesh, mesh.sites.size(), progress); }

}  // namespace delone
