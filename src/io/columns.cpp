#include "io/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "delone/base/ids.hpp"
#include "io/complain.hpp"
#include "io/numbers.hpp"

namespace delone::io {
namespace {

std::string offer(const Columns& columns) {
  if (!columns.named) return fmt::format("the file has {} without names", counted(columns.size(), "column"));
  return "the columns are " + listed(columns.names);
}

/// A name first, then a number from 1, then "last".
std::size_t find(const std::string& file, const Columns& columns, const std::string& wanted) {
  if (columns.named) {
    const auto matches = std::ranges::count(columns.names, wanted);
    if (matches > 1) complain(file, fmt::format("{} columns are named {}: choose by number", matches, quoted(wanted)));
    if (matches == 1) {
      return static_cast<std::size_t>(std::ranges::find(columns.names, wanted) - columns.names.begin());
    }
  }
  std::uint64_t number = 0;
  if (parse_whole(wanted, number)) {
    if (number >= 1 && number <= columns.size()) return static_cast<std::size_t>(number - 1);
    complain(file, fmt::format("there is no column {}: expected 1 to {}", quoted(wanted), columns.size()));
  }
  if (wanted == "last") return columns.size() - 1;
  complain(file, fmt::format("there is no column {}: {}", quoted(wanted), offer(columns)));
}

std::vector<std::size_t> coordinates_of(const std::string& file, const Columns& columns, const ReadOptions& options,
                                        std::optional<std::size_t> weight) {
  std::vector<std::size_t> chosen;
  if (!options.columns.empty()) {
    for (const std::string& wanted : options.columns) {
      const std::size_t column = find(file, columns, wanted);
      if (std::ranges::find(chosen, column) != chosen.end()) {
        complain(file, fmt::format("column {} is chosen twice", quoted(columns.names[column])));
      }
      chosen.push_back(column);
    }
    return chosen;
  }
  if (!columns.usual.empty()) return columns.usual;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (columns.numeric[column] && column != weight) chosen.push_back(column);
  }
  return chosen;
}

}  // namespace

Columns Columns::numbered(std::size_t count) {
  Columns columns;
  for (std::size_t column = 1; column <= count; ++column) columns.names.push_back(std::to_string(column));
  columns.numeric.assign(count, true);
  return columns;
}

Columns Columns::with_names(std::vector<std::string> first, std::size_t count) {
  Columns columns = numbered(count);
  columns.named = true;
  std::ranges::move(first, columns.names.begin());
  return columns;
}

bool is_name(const std::string& column) {
  std::uint64_t number = 0;
  return column != "last" && !parse_whole(column, number);
}

std::optional<std::size_t> weight_column(const std::string& file, const Columns& columns, const ReadOptions& options) {
  if (!options.weights.empty() && !options.radii.empty()) complain(file, "expected weights or radii, not both");
  const std::string& weight = options.weights.empty() ? options.radii : options.weights;
  if (weight.empty()) return std::nullopt;
  return find(file, columns, weight);
}

Choice choose(const std::string& file, const Columns& columns, const ReadOptions& options) {
  Choice choice;
  choice.weight = weight_column(file, columns, options);
  choice.is_radius = !options.radii.empty();
  choice.coordinates = coordinates_of(file, columns, options, choice.weight);

  std::vector<std::string> names;
  for (const std::size_t column : choice.coordinates) names.push_back(columns.names[column]);
  const std::size_t count = names.size();
  if (count == 0) complain(file, "expected at least one column of numbers for coordinates, found none");
  if (options.dimension != 0 && static_cast<std::size_t>(options.dimension) != count) {
    complain(file,
             fmt::format("expected {}, found {} ({})",
                         counted(static_cast<std::size_t>(options.dimension), "coordinate"), count, listed(names)));
  }
  if (count > kMaxDimension) {
    complain(file,
             fmt::format("expected at most {} columns of coordinates, found {}: choose columns", kMaxDimension, count));
  }
  if (!options.attributes) return choice;
  for (std::size_t column = columns.first_attribute; column < columns.size(); ++column) {
    const bool taken =
        column == choice.weight || std::ranges::find(choice.coordinates, column) != choice.coordinates.end();
    if (!taken) choice.attributes.push_back(column);
  }
  return choice;
}

std::string radius_fault(double radius, std::string_view text) {
  if (radius < 0.0) return "expected a radius of at least 0, found " + quoted(text);
  if (std::isfinite(radius * radius)) return {};
  return "expected a radius whose square is within the range of double, found " + quoted(text);
}

PointTable empty_table(const Columns& columns, const Choice& choice) {
  PointTable table;
  table.dimension = choice.dimension();
  for (const std::size_t column : choice.coordinates) table.coordinate_names.push_back(columns.names[column]);
  for (const std::size_t column : choice.attributes) table.attributes.push_back({columns.names[column], {}, {}});
  return table;
}

}  // namespace delone::io
