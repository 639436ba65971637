// PLY, the Stanford polygon format: a text header, then elements as text or as binary numbers of either byte order.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/source.hpp"

namespace delone::io {

struct PlyProperty {
  std::string name;
  std::string type;        // "float", "int32", ...
  std::string count_type;  // empty unless a list
  bool is_list() const { return !count_type.empty(); }
};

/// An element of a file with its data: plain numbers in rows, and the lists of one property.
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  std::vector<double> numbers;  ///< count x (properties that are no lists)
  std::vector<std::size_t> list_ends;
  std::vector<double> list_items;
};

/// Reads the elements that `wanted` names; the others are checked to be complete and passed over.
/// @param list  of the lists of a wanted element only this property is kept
/// @throws InputError naming the line, or the element in binary files
std::vector<PlyElement> parse_ply(const Source& source, const std::function<bool(const PlyElement&)>& wanted,
                                  const std::function<bool(const PlyProperty&)>& list = {});

}  // namespace delone::io
