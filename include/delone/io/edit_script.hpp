// A text of changes: insert, remove and move, a line each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone::io {

struct Operation {
  enum class Verb : std::uint8_t { insert, remove, move };

  Verb verb;
  std::size_t line;              ///< of the file, counted from 1
  Index row = kNone;             ///< what is removed or moved
  std::vector<double> point;     ///< where to
  std::optional<double> weight;  ///< where the points have weights
};

struct EditScript {
  std::string name;  ///< of the file, for complaints
  std::vector<Operation> operations;
  std::string fault;  ///< of the line after them, naming it, where it cannot be read; the rest is not read either
};

/// Reads lines `insert X Y ... [WEIGHT]`, `remove ROW` and `move ROW X Y ... [WEIGHT]`, between blanks; '#' begins a
/// comment. "-" is standard input.
/// @throws InputError when the file cannot be read
EditScript read_edit_script(const std::string& path, int dimension, bool weighted);

}  // namespace delone::io
