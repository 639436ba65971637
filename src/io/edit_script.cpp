#include "delone/io/edit_script.hpp"

#include <fmt/format.h>

#include "delone/base/errors.hpp"
#include "io/rows.hpp"
#include "io/source.hpp"

namespace delone::io {
namespace {

/// The point and perhaps the weight from column `first` on.
void read_point(const Rows& rows, std::size_t first, int dimension, bool weighted, Operation& operation) {
  const std::size_t least = first + static_cast<std::size_t>(dimension);
  if (rows.size() != least && !(weighted && rows.size() == least + 1)) {
    rows.refuse_row(fmt::format("{} takes {}{} coordinates{}, found {} entries behind it", rows[0],
                                first == 2 ? "a row and " : "", dimension, weighted ? " and perhaps a weight" : "",
                                rows.size() - 1));
  }
  for (std::size_t column = first; column < least; ++column) operation.point.push_back(rows.number(column));
  if (rows.size() > least) operation.weight = rows.number(least);
}

Operation read_operation(const Rows& rows, int dimension, bool weighted) {
  Operation operation{Operation::Verb::insert, rows.line(), kNone, {}, std::nullopt};
  if (rows[0] == "insert") {
    read_point(rows, 1, dimension, weighted, operation);
    return operation;
  }
  if (rows[0] == "remove") {
    operation.verb = Operation::Verb::remove;
    if (rows.size() != 2) rows.refuse_row("remove takes one row");
  } else if (rows[0] == "move") {
    operation.verb = Operation::Verb::move;
    read_point(rows, 2, dimension, weighted, operation);
  } else {
    rows.refuse(0, fmt::format("expected insert, remove or move, found '{}'", rows[0]));
  }
  const std::uint64_t row = rows.whole(1, "a row");
  if (row >= kNone) rows.refuse(1, fmt::format("there is no row {}", row));
  operation.row = static_cast<Index>(row);
  return operation;
}

}  // namespace

EditScript read_edit_script(const std::string& path, int dimension, bool weighted) {
  const Source source = Source::read(path);
  EditScript script{source.name(), {}, {}};
  try {
    Rows rows(source, kBlanks);
    while (rows.next()) script.operations.push_back(read_operation(rows, dimension, weighted));
  } catch (const InputError& error) {
    script.fault = error.what();
  }
  return script;
}

}  // namespace delone::io
