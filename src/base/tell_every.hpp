// Telling of progress where steps are not all as cheap as tell() takes them for.
#pragma once

#include <cstddef>

#include "delone/base/progress.hpp"

namespace delone {

/// Tells a caller who wants to know, at every so many of `all` steps.  @throws Cancelled when it asks to stop
inline void tell_every(std::size_t steps, const Progress& progress, std::size_t done, std::size_t all) {
  if (done % steps == 0 && progress && !progress(static_cast<double>(done) / static_cast<double>(all)))
    throw Cancelled();
}

/// How many insertions go by between two calls: few where one changes many cells.
constexpr std::size_t insertions_a_call(int dimension) { return dimension <= 3 ? 256 : 8; }

}  // namespace delone
