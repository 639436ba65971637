#include "remove/detach.hpp"

#include <string>
#include <vector>

#include "delone/base/dispatch.hpp"
#include "remove/remover.hpp"

namespace delone {

void require_row(const AnyTriangulation& t, Index row) {
  if (t.status(row).status == Status::removed) {
    throw InputError("row " + std::to_string(row) + ": it was removed before");
  }
}

VertexId hand_over(Mesh& mesh, VertexId v, Duplicates::Node& entry) {
  const Index heir = mesh.duplicates.at(v).begin()->second;
  const VertexId site = mesh.sites.vertex(heir);
  entry = mesh.duplicates.take(site, heir);
  mesh.sites.swap_rows(site, v);
  return site;
}

bool detach(Mesh& mesh, VertexId v, Return back, const Listener& on_edit) {
  if (mesh.complex.dimension() == 0) return false;
  keep_hidden_sites(mesh);
  return with_dimension<1>(mesh.complex.dimension(), [&](auto k) {
    Remover<k> remover(mesh);
    if (!remover.plan(v, back == Return::possible)) return false;
    remover.carry_out(v);
    if (on_edit) on_edit(remover.edit(v));
    return true;
  });
}

bool move_in_place(Mesh& mesh, VertexId v, std::span<const double> point, double weight, const Listener& on_edit) {
  if (mesh.complex.dimension() == 0) return false;
  keep_hidden_sites(mesh);
  std::vector<double> old(point.size());
  mesh.sites.copy_point(v, old);
  const double old_weight = mesh.sites.weight(v);
  return with_dimension<1>(mesh.complex.dimension(), [&](auto k) {
    if (!Remover<k>(mesh).collect_inner_star(v)) return false;
    mesh.sites.move(v, point, weight);
    Remover<k> remover(mesh);  // knows the new numbers
    if (!remover.star_is_regular()) {
      mesh.sites.move(v, old, old_weight);
      return false;
    }
    if (on_edit) on_edit(remover.edit_in_place(v));
    return true;
  });
}

}  // namespace delone
