#include "remove/detach.hpp"

#include <vector>

#include "delone/base/dispatch.hpp"
#include "mesh/incremental.hpp"
#include "remove/remover.hpp"

namespace delone {

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

void bring_back(Mesh& mesh, VertexId v, const Listener& on_edit) {
  with_dimension<1>(mesh.complex.dimension(), [&](auto k) {
    const Edit edit = Remover<k>(mesh).bring_back(v);
    if (on_edit) on_edit(edit);
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
    bool stays = false;
    try {
      stays = remover.star_is_regular();
    } catch (...) {
      mesh.sites.move(v, old, old_weight);
      throw;
    }
    if (!stays) {
      mesh.sites.move(v, old, old_weight);
      return false;
    }
    if (on_edit) on_edit(remover.edit_in_place(v));
    return true;
  });
}

}  // namespace delone
