#include "delone/base/buffer.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include "base/huge_pages.hpp"

#ifdef __linux__
#include <malloc.h>
#endif

namespace delone {
namespace {

/// Whether a new block starts and ends with a huge page. Large ones do not, since malloc moves none that is aligned by
/// remapping it: the advice on what lies before it differs; nor small ones, which would leave much of a page over.
constexpr bool is_aligned(std::size_t bytes) { return bytes >= kHugePage * 3 / 2 && bytes <= 15 * kHugePage; }

#ifdef __linux__

/// Of a block of malloc that holds `bytes`, what is added to them for its own ends included.
std::size_t whole_size(void* block, std::size_t /*bytes*/) { return malloc_usable_size(block); }

/// What malloc writes in front of a block that is not aligned makes small pages of all that would be its first huge
/// one; and so does realloc where it copies to a new block before that could ask.
void* reallocate(void* block, std::size_t held, std::size_t bytes) {
  if (block == nullptr && is_aligned(bytes)) return std::aligned_alloc(kHugePage, whole_block(bytes, 1));
  const bool aligned = block != nullptr && reinterpret_cast<std::uintptr_t>(block) % kHugePage == 0;
  if (!aligned || bytes <= held) return std::realloc(block, bytes);
  void* moved = reallocate(nullptr, 0, bytes);
  if (moved == nullptr) return nullptr;
  ask_for_huge_pages(moved, whole_size(moved, bytes));
  std::memcpy(moved, block, held);
  std::free(block);
  return moved;
}

#else

std::size_t whole_size(void* /*block*/, std::size_t bytes) { return bytes; }
void* reallocate(void* block, std::size_t /*held*/, std::size_t bytes) { return std::realloc(block, bytes); }

#endif

}  // namespace

void* reallocate_block(void* block, std::size_t held, std::size_t count, std::size_t element_size) {
  if (count > static_cast<std::size_t>(-1) / 2 / element_size) throw std::bad_alloc();
  void* moved = reallocate(block, held * element_size, count * element_size);
  if (moved == nullptr) throw std::bad_alloc();
  ask_for_huge_pages(moved, whole_size(moved, count * element_size));
  return moved;
}

std::size_t whole_block(std::size_t count, std::size_t element_size) {
  const std::size_t bytes = count * element_size;
  return is_aligned(bytes) ? std::max(count, (bytes + kHugePage - 1) / kHugePage * kHugePage / element_size) : count;
}

}  // namespace delone
