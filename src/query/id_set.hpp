// A small set of ids that is emptied in no time: open addressing, each entry stamped with the round it belongs to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone::query_detail {

/// Has no memory before it is first emptied, which must come before it is first used.
class IdSet {
 public:
  void clear() {
    size_ = 0;
    if (slots_.empty()) slots_.resize(256);
    if (++round_ == 0) {
      slots_.assign(slots_.size(), Slot{});
      round_ = 1;
    }
  }
  /// Whether `id` was not there yet.
  [[gnu::always_inline]] bool insert(Index id) {
    Slot* slot = place(id);
    while (slot->round == round_) {
      if (slot->id == id) return false;
      if (++slot == slots_.data() + slots_.size()) slot = slots_.data();
    }
    *slot = {id, round_};
    if (++size_ * 4 > slots_.size()) [[unlikely]]
      grow();
    return true;
  }

 private:
  struct Slot {
    Index id = 0;
    std::uint32_t round = 0;
  };
  /// Neighbouring cells have neighbouring ids as often as not: the product spreads them.
  Slot* place(Index id) { return slots_.data() + (static_cast<std::uint64_t>(id) * 0x9E3779B97F4A7C15U >> shift_); }
  [[gnu::noinline]] void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    --shift_;
    size_ = 0;
    for (const Slot& slot : old) {
      if (slot.round == round_) insert(slot.id);
    }
  }

  std::vector<Slot> slots_;
  int shift_ = 64 - 8;
  std::size_t size_ = 0;
  std::uint32_t round_ = 0;
};

}  // namespace delone::query_detail
