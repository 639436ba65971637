// Arrays that grow as far as somebody looks, and ids that may run out.
#pragma once

#include <cstddef>

#include "delone/base/buffer.hpp"
#include "delone/base/errors.hpp"
#include "delone/base/ids.hpp"

namespace delone {

/// Element i, after making the array longer where it ends before, by `fill`. Growth by half, so O(1) each on average.
template <class T>
T& grown(Buffer<T>& buffer, std::size_t i, T fill = {}) {
  if (i >= buffer.size()) {
    buffer.reserve_more(i + 1 - buffer.size());
    buffer.resize(i + 1, fill);
  }
  return buffer[i];
}

/// The id of the next of so many things. @throws InputError when ids have run out
inline Index next_id(std::size_t count) {
  if (count >= kNone) throw InputError("more cells than this build can number; build with DELONE_WIDE_IDS");
  return static_cast<Index>(count);
}

}  // namespace delone
