#include "delone/topology/complex.hpp"

#include <algorithm>

#include "delone/base/errors.hpp"

namespace delone {

void Complex::reserve_more(std::size_t cells, std::size_t vertex_slots) {
  if (dimension_ >= 0) {
    cells -= std::min(cells, slot_count() - live_);  // those of dead cells are taken first
    if (slot_count() + cells > kDead / static_cast<std::size_t>(corners())) {
      throw InputError("the triangulation needs more cells than ids of this build can name: build with 64-bit ids");
    }
    ids_.reserve_more(cells * stride());
  }
  if (vertex_slots > incident_.size()) incident_.reserve_more(vertex_slots - incident_.size());
}

void Complex::shrink() {
  ids_.shrink_to_fit();
  incident_.shrink_to_fit();
}

void Complex::rebuild_incidence() {
  std::ranges::fill(incident_, kNone);
  for (std::size_t s = 0; s < slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    if (!is_live(c)) continue;
    for (int i = 0; i < corners(); ++i) {
      const VertexId v = vertex(c, i);
      if (v == kGhost) {
        ghost_cell_ = c;
      } else {
        incident_[raw(v)] = raw(c);
      }
    }
  }
}

}  // namespace delone
