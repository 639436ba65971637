#include "delone/base/buffer.hpp"

#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace delone {

void* reallocate_block(void* block, std::size_t count, std::size_t element_size) {
  if (count > static_cast<std::size_t>(-1) / 2 / element_size) throw std::bad_alloc();
  const std::size_t bytes = count * element_size;
  void* moved = std::realloc(block, bytes);
  if (moved == nullptr) throw std::bad_alloc();
#ifdef __linux__
  constexpr std::size_t kHugePage = std::size_t{1} << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(moved);
  const std::size_t skip = (kHugePage - address % kHugePage) % kHugePage;
  if (bytes >= skip + kHugePage) {
    // Advice only: where it is not taken, pages stay small.
    madvise(static_cast<char*>(moved) + skip, (bytes - skip) / kHugePage * kHugePage, MADV_HUGEPAGE);
  }
#endif
  return moved;
}

}  // namespace delone
