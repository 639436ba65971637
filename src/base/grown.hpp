// An array that grows as far as somebody looks.
#pragma once

#include <cstddef>

#include "delone/base/buffer.hpp"

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

}  // namespace delone
