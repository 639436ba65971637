// Files that are written beside their target and renamed when complete, so that a failure leaves the old file alone.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <memory>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace delone::io {

/// One file on its way. Text and bytes go through a buffer; a name that ends in ".gz" is compressed.
class Output {
 public:
  /// Opens a temporary file in the directory of `path`. "-" is standard output; a device or pipe is written in place.
  /// @throws std::runtime_error naming the file and why it cannot be written; so do all others
  explicit Output(const std::string& path);
  /// Removes the temporary file unless it was committed.
  ~Output();
  Output(Output&&) noexcept;
  Output& operator=(Output&&) = delete;

  Output& operator<<(std::string_view text) {
    if (text.size() >= kFull) return pass(text);
    buffer_.append(text);
    return flush_if_full();
  }
  Output& operator<<(char c) {
    buffer_.push_back(c);
    return *this;
  }
  /// The shortest decimal that reads back as the same double.
  Output& operator<<(double number);
  template <std::integral Integer>
  Output& operator<<(Integer number) {
    const fmt::format_int digits(number);
    return *this << std::string_view(digits.data(), digits.size());
  }
  template <class... Arguments>
  Output& print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
    return flush_if_full();
  }
  /// The bytes of a number, little-endian.
  template <class T>
  void put(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof(T));
    buffer_.append(bytes, sizeof(T));
    flush_if_full();
  }
  /// The same of many, each as a T. Arrays that are laid out so already go out as they are.
  template <class T, std::ranges::input_range Numbers>
  void put_all(const Numbers& numbers) {
    using Number = std::ranges::range_value_t<Numbers>;
    constexpr bool kSame = sizeof(T) == sizeof(Number) && std::integral<T> == std::integral<Number>;
    if constexpr (kSame && std::endian::native == std::endian::little && std::ranges::contiguous_range<Numbers>) {
      const auto bytes = std::as_bytes(std::span(numbers));
      *this << std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    } else {
      for (const auto number : numbers) put(static_cast<T>(number));
    }
  }

  /// Writes what is buffered and closes; the file still has its temporary name.
  void finish();
  /// Finishes if need be and gives the file its name.
  void commit();

  const std::string& path() const { return path_; }

 private:
  struct Gzip;
  Output& flush_if_full() {
    if (buffer_.size() >= kFull) flush();
    return *this;
  }
  void flush();
  Output& pass(std::string_view bytes);
  void compress(std::string_view bytes, int mode);
  void write(std::string_view bytes);
  [[noreturn]] void fail(int error) const;

  static constexpr std::size_t kFull = std::size_t{1} << 20;
  std::string path_;       // as given
  std::string target_;     // with symbolic links followed
  std::string temporary_;  // empty when writing in place
  int file_ = -1;
  std::string buffer_;
  std::unique_ptr<Gzip> gzip_;
};

/// Gives all files their names, after all of them are complete.
void commit_all(std::vector<Output>& outputs);

}  // namespace delone::io
