// A small set of ids that is emptied in no time: open addressing, each entry stamped with the round it belongs to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone::query_detail {

class IdSet {
 public:
  void clear() {
    size_ = 0;
    if (++round_ == 0) {
      slots_.assign(slots_.size(), Slot{});
      round_ = 1;
    }
  }
  /// Whether `id` was not there yet.
  bool insert(Index id) {
    std::size_t i = place(id);
    for (; slots_[i].round == round_; i = (i + 1) & mask()) {
      if (slots_[i].id == id) return false;
    }
    slots_[i] = {id, round_};
    if (++size_ * 2 > slots_.size()) [[unlikely]]
      grow();
    return true;
  }

 private:
  struct Slot {
    Index id = 0;
    std::uint32_t round = 0;
  };
  std::size_t mask() const { return slots_.size() - 1; }
  /// Neighbouring cells have neighbouring ids as often as not: the product spreads them.
  std::size_t place(Index id) const {
    return static_cast<std::size_t>((static_cast<std::uint64_t>(id) * 0x9E3779B97F4A7C15U) >> 32) & mask();
  }
  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    size_ = 0;
    for (const Slot& slot : old) {
      if (slot.round == round_) insert(slot.id);
    }
  }

  std::vector<Slot> slots_ = std::vector<Slot>(128);
  std::size_t size_ = 0;
  std::uint32_t round_ = 1;
};

}  // namespace delone::query_detail
