#include "base/huge_pages.hpp"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace delone {

void ask_for_huge_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  const auto start = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t end = start + bytes;
  const std::uintptr_t skip = (kHugePage - start % kHugePage) % kHugePage;
  if (end < start + skip + kHugePage) return;
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::uintptr_t first = start / page * page;
  madvise(static_cast<char*>(block) - (start - first), (end - first + page - 1) / page * page, MADV_HUGEPAGE);
#endif
}

}  // namespace delone
