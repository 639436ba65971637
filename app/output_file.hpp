// A file that appears complete or not at all: written beside its place and renamed into it.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>

namespace delone::cli {

class OutputFile {
 public:
  /// "-" is standard output; devices and pipes are written in place.
  /// @throws std::runtime_error when the file cannot be made
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// @throws std::runtime_error when the disk is full or the like; a closed pipe at standard output is not an error
  void write(const void* data, std::size_t size);
  /// Puts the file into its place; without it the file leaves no trace.
  void finish();

 private:
  [[noreturn]] void fail(int error) const;

  std::string name_;              // what the user called it
  std::filesystem::path place_;   // where it belongs, links followed
  std::filesystem::path beside_;  // where it is written; empty when in place
  std::FILE* file_ = nullptr;
  bool unread_ = false;  // standard output, and its reader left
};

/// Refuses what can be seen to be unwritable before any work: no such folder, a folder in its place, no permission.
/// @throws UsageError
void require_writable(const std::string& path);

}  // namespace delone::cli
