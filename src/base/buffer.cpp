#include "delone/base/buffer.hpp"

#include <new>

#include "base/huge_pages.hpp"

namespace delone {

void* reallocate_block(void* block, std::size_t count, std::size_t element_size) {
  if (count > static_cast<std::size_t>(-1) / 2 / element_size) throw std::bad_alloc();
  void* moved = std::realloc(block, count * element_size);
  if (moved == nullptr) throw std::bad_alloc();
  ask_for_huge_pages(moved);
  return moved;
}

}  // namespace delone
