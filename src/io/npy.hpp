// NumPy's array files: the header, and entries of any plain type.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/source.hpp"

namespace delone::io {

/// A .npy file of one or two dimensions: magic and versions 1 to 3 as in numpy.lib.format.
struct NpyArray {
  char kind = 'f';  ///< 'f' floats, 'i' signed and 'u' unsigned integers
  std::size_t item = 8;
  bool big_endian = false;
  bool by_columns = false;  ///< Fortran order
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::string_view data;  ///< rows x columns items

  const char* at(std::size_t row, std::size_t column) const {
    return data.data() + item * (by_columns ? column * rows + row : row * columns + column);
  }
};

/// @throws InputError for other types and shapes, and when the file is cut off
NpyArray parse_npy(const Source& source);

/// Magic and header of a little-endian array in rows: "<f8", n x columns. Its length is a multiple of 64.
std::string npy_header(std::string_view type, std::size_t rows, std::size_t columns);

}  // namespace delone::io
