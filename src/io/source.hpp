// The bytes of an input file, unpacked where they are compressed.
#pragma once

#include <string>
#include <string_view>

#include "delone/base/buffer.hpp"

namespace delone::io {

/// Bytes with the name that complaints call them by. Borrowed until they had to be unpacked or read.
class Source {
 public:
  /// Reads all of `path`; "-" is standard input. Gzip is known by its first bytes and unpacked.
  /// @throws InputError for a file that is missing, a directory, unreadable, or cut off within its compressed data
  static Source read(const std::string& path);

  /// The same from memory; `bytes` outlive the source.
  static Source borrow(std::string name, std::string_view bytes);

  /// Some of the bytes under the same name.
  Source part(std::string_view bytes) const;

  const std::string& name() const { return name_; }
  std::string_view bytes() const { return bytes_; }

  /// The extension in lower case without dot, a further ".gz" looked through: "a.b.CSV.gz" gives "csv".
  static std::string extension(const std::string& path);

 private:
  void unpack();

  std::string name_;
  std::string_view bytes_;
  Buffer<char> owned_;
};

}  // namespace delone::io
