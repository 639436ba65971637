// Which columns of a file are coordinates, weight and attributes, as the options ask for it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "delone/io/points_file.hpp"

namespace delone::io {

/// What a file offers.
struct Columns {
  std::vector<std::string> names;
  std::vector<bool> numeric;
  std::vector<std::size_t>
      usual;           ///< the coordinates of formats that say so; empty: all numeric columns but the weight
  bool named = false;  ///< false when names are just "1", "2", ...
  std::size_t first_attribute = 0;  ///< columns before it are never attributes: row numbers, keywords

  std::size_t size() const { return names.size(); }
  static Columns numbered(std::size_t count);
  /// `count` columns of which the first ones have names.
  static Columns with_names(std::vector<std::string> first, std::size_t count);
};

/// What is taken from it.
struct Choice {
  std::vector<std::size_t> coordinates;
  std::optional<std::size_t> weight;
  bool is_radius = false;
  std::vector<std::size_t> attributes;

  int dimension() const { return static_cast<int>(coordinates.size()); }
};

/// The column of weights or radii. @throws InputError when there is no such column
std::optional<std::size_t> weight_column(const std::string& file, const Columns& columns, const ReadOptions& options);

/// @throws InputError naming the file and what it has when a column does not exist, is ambiguous or taken twice, when
/// no or more than 8 columns are coordinates, or when their number is not the one demanded
Choice choose(const std::string& file, const Columns& columns, const ReadOptions& options);

/// True when the word can only be the name of a column: neither a number nor "last".
bool is_name(const std::string& column);

/// "expected a radius of at least 0, found '-1'" when `radius` is negative or its square overflows; empty when it is
/// fine.
std::string radius_fault(double radius, std::string_view text);

/// A table with everything named and nothing in it.
PointTable empty_table(const Columns& columns, const Choice& choice);

}  // namespace delone::io
