#include "output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "command.hpp"

namespace delone::cli {
namespace fs = std::filesystem;

namespace {

fs::path follow_links(const fs::path& path) {
  std::error_code ignored;
  return fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
}

bool is_special(const fs::path& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

}  // namespace

OutputFile::OutputFile(const std::string& path) : name_(path == "-" ? "standard output" : path) {
  if (path == "-") {
    file_ = stdout;
    return;
  }
  require_writable(path);
  place_ = follow_links(path);
  if (is_special(place_)) {
    file_ = std::fopen(place_.c_str(), "wb");
  } else {
    beside_ = place_;
    beside_ += ".part" + std::to_string(getpid());
    const int descriptor = open(beside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) file_ = fdopen(descriptor, "wb");
  }
  if (file_ == nullptr) {
    beside_.clear();
    fail(errno);
  }
}

OutputFile::~OutputFile() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  if (!beside_.empty()) unlink(beside_.c_str());
}

void OutputFile::write(const void* data, std::size_t size) {
  if (unread_ || size == 0 || std::fwrite(data, 1, size, file_) == size) return;
  const int error = errno;
  unread_ = file_ == stdout && (error == EPIPE || stdout_closed());
  if (!unread_) fail(error);
}

void OutputFile::finish() {
  if (file_ == stdout) {
    if (!unread_) print("");
    return;
  }
  const int result = std::fclose(file_);
  const int error = errno;
  file_ = nullptr;
  if (result != 0) fail(error);
  if (beside_.empty()) return;
  if (std::rename(beside_.c_str(), place_.c_str()) != 0) fail(errno);
  beside_.clear();
}

void OutputFile::fail(int error) const { throw std::runtime_error(name_ + ": cannot write: " + std::strerror(error)); }

void require_writable(const std::string& path) {
  if (path == "-") return;
  if (path.empty()) throw UsageError("-o: the name of the file is empty");
  const fs::path place = follow_links(path);
  const fs::path folder = folder_of(place);
  std::error_code ignored;
  if (fs::is_directory(place, ignored)) throw UsageError(path + ": cannot write: it is a folder");
  if (is_special(place)) {
    if (access(place.c_str(), W_OK) != 0) throw UsageError(path + ": cannot write: " + std::strerror(errno));
    return;
  }
  if (!fs::is_directory(folder, ignored))
    throw UsageError(path + ": cannot write: there is no folder " + folder.string());
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw UsageError(path + ": cannot write into folder " + folder.string() + ": " + std::strerror(errno));
}

}  // namespace delone::cli
