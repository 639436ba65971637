#include "base/huge_pages.hpp"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace delone {

void ask_for_huge_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  constexpr std::size_t kHugePage = std::size_t{1} << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  const std::size_t skip = (kHugePage - address % kHugePage) % kHugePage;
  if (bytes >= skip + kHugePage)
    madvise(static_cast<char*>(block) + skip, (bytes - skip) / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
}

}  // namespace delone
