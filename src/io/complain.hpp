// One shape for every complaint about a file: "file: line 17, column 3 (y): expected a number, found 'abc'".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace delone::io {

/// Where in a file; lines and columns count from 1, 0 leaves them out.
struct Place {
  std::size_t line = 0;
  std::size_t column = 0;
  std::string_view column_name = {};
};

/// `text` between single quotes, shortened and with control bytes escaped, so that a complaint stays one line.
std::string quoted(std::string_view text);

/// "1 point", "2 points".
std::string counted(std::size_t count, std::string_view noun);

/// "a, b, c".
template <class Names>
std::string listed(const Names& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

/// @throws InputError "file: line L, column C (name): message"
[[noreturn]] void complain(std::string_view file, Place place, std::string_view message);
[[noreturn]] inline void complain(std::string_view file, std::string_view message) { complain(file, {}, message); }

}  // namespace delone::io
