#include "io/source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>

#include "io/complain.hpp"

namespace delone::io {
namespace {

constexpr std::string_view kGzipMagic = "\x1f\x8b";

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ > STDIN_FILENO) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

Buffer<char> read_all(const std::string& name, int fd) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) complain(name, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) complain(name, "expected a file, found a directory");
  Buffer<char> bytes;
  if (S_ISREG(status.st_mode)) bytes.reserve(static_cast<std::size_t>(status.st_size) + 1);
  for (;;) {
    if (bytes.capacity() == bytes.size()) bytes.reserve_more(std::size_t{1} << 16);
    const ssize_t count = ::read(fd, bytes.end(), bytes.capacity() - bytes.size());
    if (count == 0) return bytes;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) complain(name, std::strerror(errno));
    bytes.resize(bytes.size() + static_cast<std::size_t>(count));
  }
}

/// Ends zlib's stream however the unpacking ends.
class Inflater {
 public:
  Inflater() {
    if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc();  // 15: any window; 16: gzip framing
  }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream stream{};
};

/// All members of a gzip file, one after the other; zero bytes after the last are padding.
Buffer<char> unpack_gzip(const std::string& name, std::string_view packed) {
  Buffer<char> bytes;
  bytes.reserve(packed.size() * 4 + 64);
  Inflater inflater;
  z_stream& stream = inflater.stream;
  constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
  std::size_t used = 0;
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    bytes.reserve_more(std::size_t{1} << 16);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + used));  // zlib's older interface
    stream.avail_in = static_cast<uInt>(std::min(packed.size() - used, kMost));
    stream.next_out = reinterpret_cast<Bytef*>(bytes.end());
    stream.avail_out = static_cast<uInt>(std::min(bytes.capacity() - bytes.size(), kMost));
    const uInt in = stream.avail_in;
    const uInt out = stream.avail_out;
    state = inflate(&stream, Z_NO_FLUSH);
    used += in - stream.avail_in;
    bytes.resize(bytes.size() + out - stream.avail_out);
    if (state == Z_BUF_ERROR) complain(name, "the compressed data are cut off");
    if (state == Z_MEM_ERROR) throw std::bad_alloc();
    if (state != Z_OK && state != Z_STREAM_END) complain(name, "the compressed data are damaged");
    if (state == Z_STREAM_END) {
      used = std::min(packed.find_first_not_of('\0', used), packed.size());
      if (used == packed.size()) break;
      if (!packed.substr(used).starts_with(kGzipMagic)) complain(name, "other data follow the compressed data");
      if (inflateReset(&stream) != Z_OK) throw std::bad_alloc();
      state = Z_OK;
    }
  }
  return bytes;
}

bool ends_in_gz(const std::string& path) { return path.size() > 3 && (path.ends_with(".gz") || path.ends_with(".GZ")); }

}  // namespace

void Source::unpack() {
  if (bytes_.starts_with(kGzipMagic)) {
    owned_ = unpack_gzip(name_, bytes_);
    bytes_ = {owned_.data(), owned_.size()};
  } else if (ends_in_gz(name_)) {
    complain(name_, "expected gzip data, as the name says");
  }
}

Source Source::read(const std::string& path) {
  const bool standard_input = path == "-";
  Source source;
  source.name_ = standard_input ? "standard input" : path;
  const Descriptor file(standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) complain(source.name_, std::strerror(errno));
  source.owned_ = read_all(source.name_, file.get());
  source.bytes_ = {source.owned_.data(), source.owned_.size()};
  source.unpack();
  return source;
}

Source Source::borrow(std::string name, std::string_view bytes) {
  Source source;
  source.name_ = std::move(name);
  source.bytes_ = bytes;
  source.unpack();
  return source;
}

Source Source::part(std::string_view bytes) const {
  Source source;
  source.name_ = name_;
  source.bytes_ = bytes;
  return source;
}

std::string Source::extension(const std::string& path) {
  std::string name = path.substr(path.find_last_of('/') + 1);
  if (ends_in_gz(name)) name.resize(name.size() - 3);
  const std::size_t dot = name.find_last_of('.');
  if (dot == std::string::npos) return {};
  name.erase(0, dot + 1);
  std::ranges::transform(name, name.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return name;
}

}  // namespace delone::io
