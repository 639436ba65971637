#include "memory/failing_allocator.hpp"

#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

std::size_t left = kNever;
bool failed = false;

bool must_fail() {
  if (left == kNever) return false;
  if (left-- != 0) return false;
  left = kNever;
  failed = true;
  return true;
}

}  // namespace

namespace delone::test {

FailingAllocation::FailingAllocation(std::size_t allowed) {
  left = allowed;
  failed = false;
}
FailingAllocation::~FailingAllocation() { left = kNever; }
bool FailingAllocation::happened() const { return failed; }

}  // namespace delone::test

extern "C" {
void* __real_realloc(void* block, std::size_t size);
void* __wrap_realloc(void* block, std::size_t size) { return must_fail() ? nullptr : __real_realloc(block, size); }
}

void* operator new(std::size_t size) {
  void* const block = must_fail() ? nullptr : std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return must_fail() ? nullptr : std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { std::free(block); }
