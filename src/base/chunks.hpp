// A loop cut into chunks of fixed size and shared among threads. What is found is put together in the order of the
// chunks, so that no result depends on the number of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/base/progress.hpp"

namespace delone {

inline constexpr std::size_t kChunk = 4096;

/// A frame of the stack for f alone.
template <class F>
[[gnu::noinline]] void call_in_frame(const F& f) {
  f();
}

/// Calls f in a frame of the stack that shares no cache line with the caller's. What others read there would else
/// travel between their caches and that of a thread that writes its variables beside it: twice the time, all together.
template <class F>
[[gnu::noinline]] void call_apart(const F& f) {
  std::byte between[128];
  asm volatile("" : : "r"(&between) : "memory");  // or it would not be there
  call_in_frame(f);
  asm volatile("" : : "r"(&between) : "memory");
}

/// Calls work(begin, end, chunk) for every chunk of [0, count), of `size` each; the first exception is thrown again
/// here.
/// @param progress  called from this thread between its chunks  @throws Cancelled when it asks to stop
template <class Work>
void for_chunks(std::size_t count, int threads, const Work& work, const Progress& progress = {},
                std::size_t size = kChunk) {
  const std::size_t chunks = (count + size - 1) / size;
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto drain = [&](const Progress* tell) {
    try {
      for (std::size_t chunk = next++; chunk < chunks; chunk = next++) {
        work(chunk * size, std::min(count, (chunk + 1) * size), chunk);
        if (tell == nullptr || !*tell) continue;
        const double done = static_cast<double>(std::min(next.load(), chunks)) / static_cast<double>(chunks);
        if (!(*tell)(done)) throw Cancelled();
      }
    } catch (...) {
      next = chunks;
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(threads, 1)), chunks);
    try {
      for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back(drain, nullptr);
    } catch (const std::system_error&) {  // no more threads to be had: the ones that run do it all
    }
    call_apart([&] { drain(&progress); });
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace delone
