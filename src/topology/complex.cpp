#include "delone/topology/complex.hpp"

#include <algorithm>
#include <utility>

#include "base/chunks.hpp"
#include "delone/base/errors.hpp"

namespace delone {

void Complex::reserve_more(std::size_t cells, std::size_t vertex_slots) {
  if (dimension_ >= 0) {
    cells -= std::min(cells, slot_count() - live_);  // those of dead cells are taken first
    if (slot_count() + cells > nameable_slots()) {
      throw InputError("the triangulation needs more cells than ids of this build can name: build with 64-bit ids");
    }
    ids_.reserve_more(cells * stride());
  }
  if (vertex_slots > incident_.size()) incident_.reserve_more(vertex_slots - incident_.size());
}

void Complex::append(const Complex& other, int threads) {
  DELONE_ASSERT(other.dimension_ == dimension_, "cells of the same kind");
  const std::size_t dead = slot_count() - live_;  // none of these is taken
  reserve_more(other.slot_count() + dead, vertex_slots() + other.vertex_slots());
  const auto cells = static_cast<Index>(slot_count());
  const auto facets = static_cast<Index>(facet_slots());
  const auto vertices = static_cast<Index>(vertex_slots());
  const auto shifted = [](Index id, Index by) { return id == kNone ? kNone : id + by; };
  const auto width = static_cast<std::size_t>(corners());
  Index* const to = ids_.extend(other.ids_.size());
  for_chunks(other.slot_count(), threads, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin * stride(); i < end * stride(); i += stride()) {
      for (std::size_t j = 0; j < width; ++j) to[i + j] = shifted(other.ids_[i + j], vertices);
      for (std::size_t j = width; j < 2 * width; ++j) to[i + j] = other.ids_[i + j] + facets;
    }
  });
  for (Index c = other.free_; c != kNone; c = other.ids_[c * stride() + 1]) {
    to[c * stride()] = kDead;
    to[c * stride() + 1] = std::exchange(free_, c + cells);
  }
  for (const Index c : other.incident_) incident_.push_back(shifted(c, cells));
  live_ += other.live_;
  ghosts_ += other.ghosts_;
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
