#include "delone/base/buffer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#endif

#include <cstddef>
#include <cstring>
#include <limits>
#include <new>
#include <utility>
#include <vector>

namespace delone {
namespace {

using ::testing::ElementsAre;

Buffer<int> filled(int n) {
  Buffer<int> buffer;
  for (int i = 0; i < n; ++i) buffer.push_back(i);
  return buffer;
}

std::vector<int> list(const Buffer<int>& buffer) { return {buffer.begin(), buffer.end()}; }

TEST(Buffer, keeps_its_elements_while_it_grows) {
  const Buffer<int> buffer = filled(100000);
  ASSERT_EQ(buffer.size(), 100000U);
  for (std::size_t i = 0; i < buffer.size(); ++i) ASSERT_EQ(buffer[i], static_cast<int>(i));
}

TEST(Buffer, growing_one_by_one_moves_it_rarely) {
  Buffer<int> buffer;
  int moves = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::size_t before = buffer.capacity();
    buffer.push_back(i);
    moves += buffer.capacity() != before ? 1 : 0;
  }
  EXPECT_LT(moves, 40);
}

TEST(Buffer, a_copy_is_another_and_a_move_leaves_nothing) {
  Buffer<int> first = filled(3);
  Buffer<int> second = first;
  second[0] = 9;
  EXPECT_THAT(list(first), ElementsAre(0, 1, 2));
  EXPECT_THAT(list(second), ElementsAre(9, 1, 2));
  const Buffer<int> third = std::move(second);
  EXPECT_THAT(list(third), ElementsAre(9, 1, 2));
  EXPECT_TRUE(second.empty());  // NOLINT(bugprone-use-after-move): what a move leaves is the point
  first = third;
  EXPECT_THAT(list(first), ElementsAre(9, 1, 2));
  const Buffer<int> empty_copy = Buffer<int>();
  EXPECT_TRUE(Buffer<int>(empty_copy).empty());
}

TEST(Buffer, resizing_fills_only_what_is_new) {
  Buffer<int> buffer = filled(2);
  buffer.resize(4, 7);
  EXPECT_THAT(list(buffer), ElementsAre(0, 1, 7, 7));
  buffer.resize(1);
  EXPECT_THAT(list(buffer), ElementsAre(0));
}

TEST(Buffer, gives_back_what_it_does_not_need) {
  Buffer<int> buffer = filled(1000);
  buffer.resize(10);
  buffer.shrink_to_fit();
  EXPECT_EQ(buffer.capacity(), 10U);
  EXPECT_EQ(buffer[9], 9);
  buffer.clear();
  buffer.shrink_to_fit();
  EXPECT_EQ(buffer.capacity(), 0U);
}

TEST(Buffer, keeps_what_is_little) {
  Buffer<int> buffer(1000);
  buffer.resize(900);
  buffer.shrink_to_fit();
  EXPECT_EQ(buffer.capacity(), 1000U);
  buffer.resize(800);
  buffer.shrink_to_fit();
  EXPECT_EQ(buffer.capacity(), 800U);
  Buffer<int> large(1 << 20);  // an eighth of it is not little
  large.resize(large.size() - (1 << 17));
  large.shrink_to_fit();
  EXPECT_EQ(large.capacity(), (1U << 20) - (1U << 17));
}

TEST(Buffer, whole_blocks_leave_less_than_a_huge_page_over) {
  constexpr std::size_t kPage = std::size_t{1} << 21;
  for (const std::size_t element : {1U, 4U, 12U, 24U, 48U, 4096U}) {
    for (std::size_t bytes = 1; bytes < 40 * kPage; bytes += 1 + bytes / 7) {
      const std::size_t count = (bytes + element - 1) / element;
      EXPECT_GE(whole_block(count, element), count);
      EXPECT_LT(whole_block(count, element), count + kPage / element) << bytes;
    }
  }
  constexpr std::size_t kMany = (std::size_t{1} << 62) + (std::size_t{1} << 21);  // 8 MiB, as its bytes wrap around
  EXPECT_GE(whole_block(kMany, 4), kMany);
}

TEST(Buffer, keeps_its_elements_where_blocks_become_large) {
  for (const std::size_t count : {1000000U, 2500000U, 7800000U, 7900000U, 9000000U}) {
    Buffer<int> buffer(count);
    buffer[0] = 1;
    buffer[count - 1] = 2;
    buffer.reserve(2 * count);
    buffer.reserve(3 * count);
    EXPECT_EQ(buffer[0], 1);
    EXPECT_EQ(buffer[count - 1], 2);
    buffer.shrink_to_fit();
    EXPECT_EQ(buffer[count - 1], 2);
  }
}

TEST(Buffer, a_request_beyond_memory_throws_and_changes_nothing) {
  Buffer<double> buffer(3);
  buffer[2] = 5.0;
  const std::size_t most = std::numeric_limits<std::size_t>::max();
  EXPECT_THROW(buffer.reserve(most), std::bad_alloc);
  EXPECT_THROW(buffer.reserve(most / sizeof(double) + 2), std::bad_alloc);  // its bytes would wrap around
  EXPECT_EQ(buffer.size(), 3U);
  EXPECT_EQ(buffer[2], 5.0);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Page faults during work().
template <class Work>
long page_faults(const Work& work) {
  const auto until_now = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
  };
  const long before = until_now();
  work();
  return until_now() - before;
}

TEST(Buffer, grows_large_blocks_without_touching_them_whatever_their_size) {
  constexpr std::size_t kLarge = std::size_t{40} << 20;
  prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);  // small pages only, so that faults tell how much is touched
  for (const std::size_t odd : {0U, 8U, 2048U, 4064U, 4072U, 4080U, 4088U}) {  // where blocks of malloc end
    const std::size_t bytes = kLarge + odd;
    Buffer<char> buffer;
    const std::size_t mapped = mallinfo2().hblkhd;
    const long touching = page_faults([&] { buffer.resize(bytes, 'x'); });
    if (touching < 1000 || mallinfo2().hblkhd < mapped + kLarge) {
      prctl(PR_SET_THP_DISABLE, 0, 0, 0, 0);
      GTEST_SKIP() << "another malloc, or faults not told";
    }
    EXPECT_LT(page_faults([&] { buffer.reserve(2 * bytes); }), 100) << bytes << " bytes were copied";
    EXPECT_EQ(buffer[bytes - 1], 'x');
  }
  prctl(PR_SET_THP_DISABLE, 0, 0, 0, 0);
}

TEST(Buffer, blocks_of_some_huge_pages_consist_of_them) {
  constexpr std::size_t kMost = std::size_t{32} << 20;
  void* const probe = mmap(nullptr, kMost, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(probe, MAP_FAILED);
  const bool advised = madvise(probe, kMost, MADV_HUGEPAGE) == 0;
  const long faults = page_faults([&] { std::memset(probe, 1, kMost); });
  munmap(probe, kMost);
  if (!advised || faults > 600) GTEST_SKIP() << "few huge pages, or none";
  for (const std::size_t bytes : {std::size_t{4000000}, std::size_t{8} << 20, std::size_t{20000000}}) {
    Buffer<char> buffer;
    const std::size_t mapped = mallinfo2().hblkhd;
    const long first = page_faults([&] { buffer.resize(bytes, 'x'); });
    if (mallinfo2().hblkhd < mapped + bytes) GTEST_SKIP() << "another malloc, or memory that was used before";
    EXPECT_LT(first, 40) << bytes;
    EXPECT_GE(buffer.capacity(), bytes);
    EXPECT_LT(buffer.capacity(), bytes + (std::size_t{1} << 21));
    EXPECT_LT(page_faults([&] { buffer.resize(bytes + bytes / 2, 'y'); }), 80) << bytes << " and half of it more";
    EXPECT_EQ(buffer[bytes - 1], 'x');
    buffer.resize(bytes / 2);
    buffer.shrink_to_fit();
    EXPECT_EQ(buffer.capacity(), bytes / 2);
    EXPECT_EQ(buffer[bytes / 2 - 1], 'x');
  }
}

TEST(Buffer, pages_are_not_asked_for_again_and_again) {
  constexpr std::size_t kBytes = std::size_t{600} << 10;
  const auto use = [] {
    Buffer<char> buffer;
    buffer.reserve(kBytes);
    buffer.resize(kBytes - (kBytes >> 4));
    for (std::size_t i = 0; i < buffer.size(); i += 4096) static_cast<volatile char&>(buffer[i]) = 'x';
    buffer.shrink_to_fit();
  };
  if (page_faults(use) < 100) GTEST_SKIP() << "another malloc, or faults not told";
  use();
  EXPECT_LT(page_faults(use), 20);
}
#endif

TEST(Refill, starts_anew_and_tells_the_buffer_its_size_at_the_end) {
  Buffer<int> buffer = filled(5);
  {
    Refill refill(buffer);
    EXPECT_TRUE(refill.empty());
    refill.make_room(3);
    refill.push(7);
    refill.push(8);
    refill.push(9);
    EXPECT_EQ(refill.pop(), 9);
    EXPECT_EQ(refill.size(), 2U);
    EXPECT_EQ(refill[1], 8);
  }
  EXPECT_THAT(list(buffer), ElementsAre(7, 8));
}

TEST(Refill, keeps_what_is_meant_while_it_grows) {
  Buffer<int> buffer;
  {
    Refill refill(buffer);
    for (int i = 0; i < 1000; ++i) {
      refill.make_room(1);
      refill.push_if(i % 3 == 0, i);
    }
  }
  ASSERT_EQ(buffer.size(), 334U);
  for (std::size_t i = 0; i < buffer.size(); ++i) ASSERT_EQ(buffer[i], 3 * static_cast<int>(i));
}

}  // namespace
}  // namespace delone
