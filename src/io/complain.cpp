#include "io/complain.hpp"

#include <fmt/format.h>

#include "delone/base/errors.hpp"

namespace delone::io {

namespace {

/// Control bytes, line breaks among them, as \x0a.
std::string on_one_line(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::size_t length = std::min(text.size(), kLongest);
  while (length < text.size() && length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
  return fmt::format("'{}{}'", on_one_line(text.substr(0, length)), length < text.size() ? "..." : "");
}

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void complain(std::string_view file, Place place, std::string_view message) {
  std::string text(file);
  text += ": ";
  if (place.line != 0) text += fmt::format("line {}", place.line);
  if (place.column != 0) text += fmt::format("{}column {}", place.line != 0 ? ", " : "", place.column);
  if (place.column != 0 && !place.column_name.empty()) text += fmt::format(" ({})", place.column_name);
  if (place.line != 0 || place.column != 0) text += ": ";
  throw InputError(on_one_line(text.append(message)));
}

}  // namespace delone::io
