// How a long call tells its caller how far it is, and how the caller stops it.
#pragma once

#include <cstddef>
#include <functional>

#include "delone/base/errors.hpp"

namespace delone {

/// Called now and then with the share of the work that is done (0 to 1), from the thread that made the call.
/// Return false to cancel: the call then throws Cancelled and leaves every object as it was.
using Progress = std::function<bool(double done)>;

/// Tells a caller who wants to know, at every 4096th of `all` steps.  @throws Cancelled when it asks to stop
inline void tell(const Progress& progress, std::size_t done, std::size_t all) {
  if (done % 4096 == 0 && progress && !progress(static_cast<double>(done) / static_cast<double>(all)))
    throw Cancelled();
}

}  // namespace delone
