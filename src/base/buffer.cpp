#include "delone/base/buffer.hpp"

#include <new>

#include "base/huge_pages.hpp"

#ifdef __linux__
#include <malloc.h>
#endif

namespace delone {
namespace {

/// Of a block of malloc that holds `bytes`, what is added to them for its own ends included.
std::size_t whole_size([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  return malloc_usable_size(block);
#else
  return bytes;
#endif
}

}  // namespace

void* reallocate_block(void* block, std::size_t count, std::size_t element_size) {
  if (count > static_cast<std::size_t>(-1) / 2 / element_size) throw std::bad_alloc();
  void* moved = std::realloc(block, count * element_size);
  if (moved == nullptr) throw std::bad_alloc();
  ask_for_huge_pages(moved, whole_size(moved, count * element_size));
  return moved;
}

}  // namespace delone
