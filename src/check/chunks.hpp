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

#include "check/violations.hpp"

namespace delone::check_detail {

inline constexpr std::size_t kChunk = 4096;

/// Calls work(begin, end, chunk) for every chunk of [0, count); the first exception is thrown again here.
template <class Work>
void for_chunks(std::size_t count, int threads, const Work& work) {
  const std::size_t chunks = (count + kChunk - 1) / kChunk;
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto drain = [&] {
    try {
      for (std::size_t chunk = next++; chunk < chunks; chunk = next++) {
        work(chunk * kChunk, std::min(count, (chunk + 1) * kChunk), chunk);
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
      for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back(drain);
    } catch (const std::system_error&) {  // no more threads to be had: the ones that run do it all
    }
    drain();
  }
  if (failure) std::rethrow_exception(failure);
}

/// Calls work(i, violations) for every i in [0, count), and adds up what is found in the order of i.
template <class Work>
void check_each(std::size_t count, int threads, Violations& violations, const Work& work) {
  std::vector<Violations> found((count + kChunk - 1) / kChunk, Violations(violations.limit()));
  for_chunks(count, threads, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    for (std::size_t i = begin; i < end; ++i) work(i, found[chunk]);
  });
  for (Violations& some : found) violations.append(std::move(some));
}

}  // namespace delone::check_detail
