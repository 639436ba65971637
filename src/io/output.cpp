#include "io/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace delone::io {

struct Output::Gzip {
  Gzip() {
    // 15: largest window; 16: gzip framing, whose header zlib fills without name or time.
    if (deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
  }
  ~Gzip() { deflateEnd(&stream); }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;

  z_stream stream{};
};

namespace {

/// `path` with symbolic links followed, so that renaming replaces the file and not a link to it.
std::string follow_links(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
  return real ? std::string(real.get()) : path;
}

/// Creates a file of a new name beside `target` and opens it.
int create_beside(const std::string& target, std::string& name) {
  for (unsigned attempt = 0; attempt < 1000; ++attempt) {
    name = fmt::format("{}.{}-{}.part", target, ::getpid(), attempt);
    const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

}  // namespace

Output::Output(const std::string& path) : path_(path) {
  if (path == "-") {
    file_ = STDOUT_FILENO;
    return;
  }
  target_ = follow_links(path);
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail(errno);
  } else {
    if (exists && ::access(target_.c_str(), W_OK) != 0) fail(errno);  // a file that is protected stays
    file_ = create_beside(target_, temporary_);
    if (file_ < 0) {
      const int error = errno;
      temporary_.clear();
      fail(error);
    }
    if (exists) static_cast<void>(::fchmod(file_, status.st_mode & 07777));  // best effort: the old file's permissions
  }
  if (path.ends_with(".gz")) gzip_ = std::make_unique<Gzip>();
}

Output::Output(Output&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      file_(std::exchange(other.file_, -1)),
      buffer_(std::move(other.buffer_)),
      gzip_(std::move(other.gzip_)) {}

Output::~Output() {
  if (file_ > STDERR_FILENO) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void Output::fail(int error) const {
  throw std::runtime_error(
      fmt::format("cannot write {}: {}", path_ == "-" ? "standard output" : path_, std::strerror(error)));
}

Output& Output::operator<<(double number) {
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
  return *this << std::string_view(digits, end);
}

void Output::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void Output::flush() {
  if (gzip_) {
    compress(buffer_, Z_NO_FLUSH);
  } else {
    write(buffer_);
  }
  buffer_.clear();
}

/// Writes `bytes` after what is buffered, without a copy.
Output& Output::pass(std::string_view bytes) {
  flush();
  for (; gzip_ && !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kFull)))
    compress(bytes.substr(0, kFull), Z_NO_FLUSH);
  write(bytes);
  return *this;
}

void Output::compress(std::string_view bytes, int mode) {
  z_stream& stream = gzip_->stream;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib's older interface
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::array<char, 1 << 16> packed;
  do {
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, mode);  // cannot fail: the stream is sound and has room
    write({packed.data(), packed.size() - stream.avail_out});
  } while (stream.avail_out == 0);
}

void Output::finish() {
  if (file_ < 0) return;
  flush();
  if (gzip_) compress({}, Z_FINISH);
  gzip_.reset();
  const int file = std::exchange(file_, -1);
  if (file > STDERR_FILENO && ::close(file) != 0) fail(errno);
}

void Output::commit() {
  finish();
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void commit_all(std::vector<Output>& outputs) {
  for (Output& output : outputs) output.finish();
  for (Output& output : outputs) output.commit();
}

}  // namespace delone::io
