// Numbers as bytes, of either byte order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace delone::io {

static_assert(std::endian::native == std::endian::little || std::endian::native == std::endian::big);

/// The number at the front of `bytes`, of which there are at least sizeof(T).
template <class T>
T load(const char* bytes, std::endian order) {
  char buffer[sizeof(T)];
  std::memcpy(buffer, bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(buffer, buffer + sizeof(T));
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return value;
}

}  // namespace delone::io
