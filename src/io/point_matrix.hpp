// Points from a matrix of doubles: shared by the binary formats.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "io/columns.hpp"
#include "io/complain.hpp"

namespace delone::io {

/// Takes the chosen columns of `rows` rows.
/// @param value  value(row, column) is the entry as a double
/// @param what   what the format calls a row, for complaints: "row", "vertex"; rows count from 0
template <class Value>
PointTable take_points(const std::string& file, const Columns& columns, const ReadOptions& options, std::size_t rows,
                       std::string_view what, Value value) {
  const Choice choice = choose(file, columns, options);
  PointTable table = empty_table(columns, choice);
  table.coordinates.resize(rows * choice.coordinates.size());
  const auto refuse = [&](std::size_t row, std::size_t column, const std::string& message) {
    const std::string name = columns.named ? fmt::format(" ({})", columns.names[column]) : std::string();
    complain(file, fmt::format("{} {}, column {}{}: {}", what, row, column + 1, name, message));
  };
  const auto finite = [&](std::size_t row, std::size_t column) {
    const double number = value(row, column);
    if (!std::isfinite(number)) refuse(row, column, fmt::format("expected a finite number, found '{}'", number));
    return number;
  };
  auto* out = table.coordinates.data();
  for (std::size_t row = 0; row < rows; ++row) {
    for (const std::size_t column : choice.coordinates) *out++ = finite(row, column);
  }
  if (choice.weight) {
    table.weights.reserve(rows);
    for (std::size_t row = 0; row < rows; ++row) {
      const double number = finite(row, *choice.weight);
      const std::string fault = choice.is_radius ? radius_fault(number, fmt::format("{}", number)) : std::string();
      if (!fault.empty()) refuse(row, *choice.weight, fault);
      table.weights.push_back(choice.is_radius ? number * number : number);
    }
  }
  for (std::size_t k = 0; k < choice.attributes.size(); ++k) {
    Attribute& attribute = table.attributes[k];
    attribute.numbers.reserve(rows);
    for (std::size_t row = 0; row < rows; ++row) attribute.numbers.push_back(value(row, choice.attributes[k]));
    if (std::ranges::all_of(attribute.numbers, [](double number) { return std::isfinite(number); })) continue;
    for (const double number : attribute.numbers) attribute.texts.push_back(fmt::format("{}", number));
    attribute.numbers.clear();
  }
  return table;
}

}  // namespace delone::io
