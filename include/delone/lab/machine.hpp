// The machine that something is measured on, and the day.
#pragma once

#include <string>

namespace delone::lab {

/// "AMD EPYC, 2 processors, 24 GiB, Debian GNU/Linux 12 (bookworm)".
std::string machine();

/// "2026-11-22", in universal time.
std::string today();

}  // namespace delone::lab
