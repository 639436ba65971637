// DELONE_ASSERT(condition, "I3 ...") names the invariant that a caller broke. Release builds leave it out.
#pragma once

#include <cassert>

#ifdef NDEBUG
#define DELONE_ASSERT(condition, invariant) static_cast<void>(0)
#else
#define DELONE_ASSERT(condition, invariant) assert((condition) && (invariant))
#endif
