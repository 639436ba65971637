// Loops of the checker shared among threads; what is found is added up in order.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "base/chunks.hpp"
#include "check/violations.hpp"

namespace delone::check_detail {

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
