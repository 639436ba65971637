// Facets by their vertices: where two cells that share one are not known to each other yet.
// Open addressing in a buffer that is kept, so that nothing is allocated after warm-up.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"
#include "delone/base/random.hpp"

namespace delone {

template <int K>
class FacetTable {
  static constexpr std::size_t kStride = K + 1;  // a value, then K vertices
  static constexpr std::size_t kKey = K;

 public:
  using Key = std::array<VertexId, K>;

  /// Empty, with room for about `facets` before it grows. The buffer is its own as long as it lives.
  FacetTable(Buffer<Index>& words, std::size_t facets) : words_(&words) {
    clear(std::bit_ceil(std::max<std::size_t>(2 * facets, 16)));
  }

  /// The facet of a cell opposite slot i.
  static Key key(const std::array<VertexId, K + 1>& cell, int i) {
    Key key;
    for (std::size_t j = 0; j < kKey; ++j) key[j] = cell[static_cast<int>(j) == i ? kKey : j];
    for (std::size_t j = 1; j < kKey; ++j) {
      for (std::size_t place = j; place > 0 && key[place] < key[place - 1]; --place) {
        std::swap(key[place], key[place - 1]);
      }
    }
    return key;
  }

  /// What is kept for the facet, or kNone.
  Index at(const Key& key) { return *find(key); }
  /// What is kept for the facet; kNone, which the caller may replace, when it is new. Valid until the next call.
  Index& operator[](const Key& key) {
    if (2 * count_ >= slots_) grow();
    Index* const entry = find(key);
    if (*entry == kNone) {
      ++count_;
      for (std::size_t j = 0; j < kKey; ++j) entry[1 + j] = raw(key[j]);
    }
    return *entry;
  }

 private:
  void clear(std::size_t slots) {
    slots_ = slots;
    count_ = 0;
    words_->clear();
    words_->resize(slots * kStride);
    for (std::size_t s = 0; s < slots; ++s) (*words_)[s * kStride] = kNone;
  }
  Index* find(const Key& key) {
    std::uint64_t hash = raw(key[0]);
    for (std::size_t j = 1; j < kKey; ++j) hash = hash * 0x9E3779B97F4A7C15U + raw(key[j]);
    for (std::size_t s = mix(hash) & (slots_ - 1);; s = (s + 1) & (slots_ - 1)) {
      Index* const entry = words_->data() + s * kStride;
      if (*entry == kNone) return entry;
      bool same = true;
      for (std::size_t j = 0; j < kKey; ++j) same &= entry[1 + j] == raw(key[j]);
      if (same) return entry;
    }
  }
  void grow() {
    const Buffer<Index> old = *words_;
    const std::size_t old_slots = slots_;
    const std::size_t old_count = count_;
    clear(2 * old_slots);
    for (std::size_t s = 0; s < old_slots; ++s) {
      const Index* const entry = old.data() + s * kStride;
      if (*entry == kNone) continue;
      Key key;
      for (std::size_t j = 0; j < kKey; ++j) key[j] = VertexId{entry[1 + j]};
      std::copy_n(entry, kStride, find(key));
    }
    count_ = old_count;
  }

  Buffer<Index>* words_;
  std::size_t slots_ = 0;
  std::size_t count_ = 0;
};

}  // namespace delone
