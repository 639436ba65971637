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
  const VertexId v = mesh.sites.vertex(row);
  mesh.sites.prefetch_row(v);
  mesh.complex.prefetch_cell_at(v);
  Removed removed{t.status(row).status};
  mesh.sites.reserve_empty(1);
  if (mesh.duplicates.vertex_of(v) != kGhost) {
    mesh.duplicates.take(v, row);
  } else if (!mesh.duplicates.at(v).empty()) {
    Duplicates::Node entry;
    hand_over(mesh, v, entry);
    if (removed.was == Status::vertex) removed.heir = entry.value().second;
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

/// Removes rows along the curve. False when that is more work than building the rest: when many cells change, or all.
bool remove_one_by_one(AnyTriangulation& t, std::span<const Index> rows, const Progress& progress) {
  constexpr std::size_t kTick = 1024;
  std::vector<Index> order(rows.begin(), rows.end());
  std::ranges::sort(order, {}, [&](Index row) { return t.vertex(row); });
  std::size_t left = 4 * t.complex().live_count();  // cells that may be made
  bool rebuilt = false;
  const Listener listen = [&](const Edit& edit) {
    left -= std::min(left, edit.created.size());
    rebuilt = edit.rebuilt;
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % kTick == 0 && progress && !progress(static_cast<double>(i) / static_cast<double>(order.size()))) {
      throw Cancelled();
    }
    remove_row(t, order[i], listen);
    if ((rebuilt || left == 0) && i + 1 < order.size()) return false;
  }
  return true;
}

}  // namespace

Removed remove(AnyTriangulation& t, Index row, const RemoveOptions& options) {
  const ExactEnvironment environment;
  require_present(t, row);
  return remove_row(t, row, options.on_edit);
}

void remove(AnyTriangulation& t, std::span<const Index> rows, const Progress& progress) {
  const ExactEnvironment environment;
  std::vector<bool> goes(t.row_count(), false);
  for (const Index row : rows) {
    require_present(t, row);
    if (goes[row]) throw InputError("row " + std::to_string(row) + ": it is to be removed twice");
    goes[row] = true;
  }
  if (rows.empty()) return;
  AnyTriangulation rest(t.dimension());
  if (2 * rows.size() >= t.sites().present_count() || !remove_one_by_one(rest = t, rows, progress)) {
    std::vector<Index> kept = t.present_rows();
    std::erase_if(kept, [&](Index row) { return goes[row]; });
    rest = triangulated_anew(t, points_of(t, std::move(kept)), t.row_count(), 1, progress);
  }
  std::swap(t, rest);
}

}  // namespace delone
