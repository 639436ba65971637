// An allocator that fails when told to: operator new of this executable, and the realloc that Buffer grows by (the
// linker sends it here, see tests/CMakeLists.txt), so that sanitizers still see every block.
#pragma once

#include <cstddef>

namespace delone::test {

/// While it lives, the allocation after `allowed` ones fails, once; then all succeed again.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::size_t allowed);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  bool happened() const;
};

}  // namespace delone::test
