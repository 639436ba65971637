#include "delone/remove/remove.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"
#include "mesh/anew.hpp"
#include "remove/detach.hpp"

namespace delone {
namespace {

Removed remove_row(AnyTriangulation& t, Index row, const Listener& on_edit) {
  Mesh& mesh = t.mesh();
  Removed removed{t.status(row).status};
  mesh.sites.reserve_empty(1);
  const VertexId v = mesh.sites.vertex(row);
  if (mesh.duplicates.vertex_of(v) != kGhost) {
    mesh.duplicates.take(v, row);
  } else if (!mesh.duplicates.at(v).empty()) {
    Duplicates::Node entry;
    hand_over(mesh, v, entry);
    removed.heir = entry.value().second;
  } else if (mesh.complex.incident_cell(v) == kNoCell) {
    if (mesh.hidden.holds(v)) mesh.hidden.remove(v);
  } else if (!detach(mesh, v, Return::never, on_edit)) {
    std::vector<Index> rows = t.present_rows();
    std::erase(rows, row);
    AnyTriangulation anew = triangulated_anew(t, points_of(t, std::move(rows)), t.row_count());
    std::swap(t, anew);
    if (on_edit) on_edit({.rebuilt = true});
    return removed;
  }
  mesh.sites.remove(mesh.sites.vertex(row));
  return removed;
}

}  // namespace

Removed remove(AnyTriangulation& t, Index row, const RemoveOptions& options) {
  const ExactEnvironment environment;
  require_row(t, row);
  return remove_row(t, row, options.on_edit);
}

void remove(AnyTriangulation& t, std::span<const Index> rows, const Progress& progress) {
  constexpr std::size_t kTick = 1024;
  const ExactEnvironment environment;
  std::vector<bool> goes(t.row_count(), false);
  for (const Index row : rows) {
    require_row(t, row);
    if (goes[row]) throw InputError("row " + std::to_string(row) + ": it is to be removed twice");
    goes[row] = true;
  }
  if (rows.empty()) return;
  AnyTriangulation rest(t.dimension());
  if (2 * rows.size() >= t.sites().present_count()) {
    std::vector<Index> kept = t.present_rows();
    std::erase_if(kept, [&](Index row) { return goes[row]; });
    rest = triangulated_anew(t, points_of(t, std::move(kept)), t.row_count(), 1, progress);
  } else {
    rest = t;
    std::vector<Index> order(rows.begin(), rows.end());  // along the curve
    std::ranges::sort(order, {}, [&](Index row) { return t.vertex(row); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i % kTick == 0 && progress && !progress(static_cast<double>(i) / static_cast<double>(order.size()))) {
        throw Cancelled();
      }
      remove_row(rest, order[i], nullptr);
    }
  }
  std::swap(t, rest);
}

}  // namespace delone
