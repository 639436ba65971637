// Two things at once.
#pragma once

#include <exception>
#include <optional>
#include <system_error>
#include <thread>

namespace delone {

/// Calls first() here and second() on a thread of its own, if there are two; then what they threw is thrown here.
template <class First, class Second>
void both(int threads, const First& first, const Second& second) {
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      second();
    } catch (...) {
      failure = std::current_exception();
    }
  };
  {
    std::optional<std::jthread> helper;
    try {
      if (threads > 1) helper.emplace(guarded);
    } catch (const std::system_error&) {  // no thread to be had
    }
    first();
    if (!helper) second();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace delone
