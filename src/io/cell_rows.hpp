// Cells gathered id by id, each id checked against the number of points.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "delone/mesh/cell_table.hpp"
#include "io/complain.hpp"
#include "io/rows.hpp"

namespace delone::io {

class CellRows {
 public:
  /// @param base  the id of the first point in the file: 0 or 1
  explicit CellRows(std::size_t point_count, std::size_t base = 0) : point_count_(point_count), base_(base) {}

  bool holds(std::uint64_t id) const { return id >= base_ && id - base_ < point_count_; }

  /// "an id from 0 to 99"
  std::string expectation() const {
    if (point_count_ == 0) return "no cells, since there are no points";
    return fmt::format("a point id from {} to {}", base_, base_ + point_count_ - 1);
  }

  /// Appends an id that holds().
  void push(std::uint64_t id) { table_.vertices.push_back(static_cast<Index>(id - base_)); }

  /// Appends the id in a column of the row at hand. @throws InputError naming line and column
  void add(const Rows& rows, std::size_t column) {
    const std::uint64_t id = rows.whole(column, expectation());
    if (!holds(id)) rows.refuse(column, fmt::format("expected {}, found {}", expectation(), id));
    push(id);
  }

  /// Ends a cell. False when it has another number of corners than those before.
  bool end(std::size_t corners) {
    if (table_.corners == 0) table_.corners = static_cast<int>(corners);
    return table_.corners == static_cast<int>(corners);
  }
  void end(const Rows& rows, std::size_t corners) {
    if (!end(corners)) rows.refuse_row(fmt::format("expected a cell of {} corners, found {}", table_.corners, corners));
  }

  /// For formats that tell the corners of a list that may be empty.
  void set_corners(std::size_t corners) { table_.corners = static_cast<int>(corners); }

  CellTable take() { return std::move(table_); }

 private:
  CellTable table_;
  std::size_t point_count_;
  std::size_t base_;
};

}  // namespace delone::io
