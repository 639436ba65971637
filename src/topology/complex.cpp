#include "delone/topology/complex.hpp"

#include <algorithm>
#include <utility>

#include "delone/base/errors.hpp"

namespace delone {

void Complex::reserve_more(std::size_t cells, std::size_t vertex_slots) {
  if (supply_.step != 0) {
    while (supply_.drawn - live_ < cells) {
      if (supply_.next + supply_.row > supply_.end) throw NoMoreSlots();
      add_dead_row();
    }
    return;
  }
  if (dimension_ >= 0) {
    cells -= std::min(cells, slot_count() - live_);  // those of dead cells are taken first
    if (slot_count() + cells > nameable_slots()) {
      throw InputError("the triangulation needs more cells than ids of this build can name: build with 64-bit ids");
    }
    ids_.reserve_more(cells * stride());
  }
  if (vertex_slots > incident_.size()) incident_.reserve_more(vertex_slots - incident_.size());
}

void Complex::add_dead_row() {
  for (std::size_t slot = supply_.next + supply_.row; slot-- > supply_.next;) {
    ids_[slot * stride()] = kDead;
    ids_[slot * stride() + 1] = std::exchange(free_, static_cast<Index>(slot));
  }
  supply_.next += supply_.step;
  supply_.drawn += supply_.row;
}

Complex Complex::part(std::size_t which, std::size_t count, std::size_t row, std::size_t end) {
  Complex part(dimension_);
  part.ids_ = ids_.lent();
  part.ids_.resize(end * stride());
  part.incident_ = incident_.lent();
  part.supply_ = {.next = slot_count() + which * row, .step = count * row, .row = row, .end = end};
  return part;
}

std::vector<std::array<CellId, 2>> Complex::end_parts(std::span<Complex* const> parts) {
  std::size_t used = slot_count();
  for (const Complex* part : parts) used = std::max(used, part->supply_.drawn_end());
  ids_.resize(used * stride());
  for (Complex* part : parts) {
    while (part->supply_.next < used) part->add_dead_row();
    live_ += part->live_;
    ghosts_ += part->ghosts_;
    if (part->ghost_cell_ != kNoCell) ghost_cell_ = part->ghost_cell_;
  }
  std::vector<std::array<CellId, 2>> moves;
  fill_gaps(free_, moves);
  for (const Complex* part : parts) fill_gaps(part->free_, moves);
  ids_.resize(live_ * stride());
  free_ = kNone;
  return moves;
}

void Complex::fill_gaps(Index gap, std::vector<std::array<CellId, 2>>& moves) {
  for (Index next; gap != kNone; gap = next) {
    next = ids_[gap * stride() + 1];
    if (gap >= live_) continue;
    std::size_t last = slot_count() - 1;
    while (ids_[last * stride()] == kDead) --last;
    std::copy_n(ids_.data() + last * stride(), stride(), ids_.data() + gap * stride());
    ids_.resize(last * stride());
    const CellId c{gap};
    moves.push_back({CellId{static_cast<Index>(last)}, c});
    for (int i = 0; i < corners(); ++i) {
      const FacetId f = twin(c, i);
      ids_[raw(cell(f)) * stride() + static_cast<std::size_t>(corners() + slot(f))] =
          gap << slot_bits(corners()) | static_cast<Index>(i);
      if (vertex(c, i) == kGhost) {
        if (raw(ghost_cell_) == last) ghost_cell_ = c;
      } else if (Index& incident = incident_[raw(vertex(c, i))]; incident == last) {
        incident = gap;
      }
    }
  }
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
