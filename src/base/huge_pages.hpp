// Memory for large results.
#pragma once

#include <cstddef>
#include <vector>

namespace delone {

inline constexpr std::size_t kHugePage = std::size_t{1} << 21;  // bytes

/// Asks for huge pages where a block spans some, which saves most of the time that page faults and address translation
/// cost. Advice only: where it is not taken, pages stay small. It is given for all pages that the block touches, and
/// not only for those that can be huge, since the system moves no block whose pages differ (realloc would copy it).
void ask_for_huge_pages(void* block, std::size_t bytes);

template <class T>
void reserve_large(std::vector<T>& v, std::size_t size) {
  v.reserve(size);
  ask_for_huge_pages(v.data(), v.capacity() * sizeof(T));
}

}  // namespace delone
