// From a dimension known at run time to one known to the compiler: the one switch at the door of a verb.
#pragma once

#include <type_traits>

#include "delone/base/assert.hpp"
#include "delone/base/ids.hpp"

namespace delone {

/// Calls f(std::integral_constant<int, k>) for First <= k <= kMaxDimension.
template <int First = 0, class F>
decltype(auto) with_dimension(int k, F&& f) {
  DELONE_ASSERT(k >= First && k <= kMaxDimension, "dimension out of range");
  if constexpr (First < kMaxDimension) {
    if (k > First) return with_dimension<First + 1>(k, static_cast<F&&>(f));
  }
  return f(std::integral_constant<int, First>{});
}

}  // namespace delone
