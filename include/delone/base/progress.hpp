// How a long call tells its caller how far it is, and how the caller stops it.
#pragma once

#include <functional>

namespace delone {

/// Called now and then with the share of the work that is done (0 to 1), from the thread that made the call.
/// Return false to cancel: the call then throws Cancelled and leaves every object as it was.
using Progress = std::function<bool(double done)>;

}  // namespace delone
