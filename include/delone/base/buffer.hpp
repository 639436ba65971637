// A growing array of plain numbers that is not zeroed when it grows, and where it is large not copied: on Linux such
// blocks move by remapping pages, so a triangulation of a gigabyte grows without touching what it holds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace delone {

/// realloc, from `held` elements to `count`, and for blocks of many pages a request for huge ones, which saves most of
/// the time that page faults and address translation cost. @throws std::bad_alloc, and the block is as it was
void* reallocate_block(void* block, std::size_t held, std::size_t count, std::size_t element_size);

/// How many elements to make room for where `count` are needed: as many, or so many more that a block of some huge
/// pages ends with one.
std::size_t whole_block(std::size_t count, std::size_t element_size);

template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  explicit Buffer(std::size_t size) { resize(size); }
  Buffer(const Buffer& other) {
    resize(other.size_);
    if (size_ != 0) std::memcpy(data_, other.data_, size_ * sizeof(T));
  }
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer other) noexcept {
    swap(other);
    return *this;
  }
  ~Buffer() {
    if (!lent_) std::free(data_);
  }

  void swap(Buffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    std::swap(lent_, other.lent_);
  }
  /// Another buffer over the same block, which it neither frees nor grows, good until this one grows or goes.
  Buffer lent() {
    Buffer other;
    other.data_ = data_;
    other.size_ = size_;
    other.capacity_ = capacity_;
    other.lent_ = true;
    return other;
  }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

  /// Room for `capacity` elements; on std::bad_alloc nothing has changed.
  void reserve(std::size_t capacity) {
    if (capacity > capacity_) reallocate(whole_block(capacity, sizeof(T)));
  }
  /// Room for `extra` more elements, growing by half so that repeated calls cost O(1) each.
  void reserve_more(std::size_t extra) {
    if (size_ + extra > capacity_) reserve(std::max(size_ + extra, capacity_ + capacity_ / 2));
  }
  /// New elements are not initialised.
  void resize(std::size_t size) {
    reserve(size);
    size_ = size;
  }
  void resize(std::size_t size, T value) {
    const std::size_t old = size_;
    resize(size);
    if (old < size) std::fill(data_ + old, data_ + size, value);
  }
  void push_back(T value) {
    if (size_ == capacity_) [[unlikely]]
      reserve_more(1);
    data_[size_++] = value;
  }
  /// `count` more elements, not initialised; returns the first.
  T* extend(std::size_t count) {
    reserve_more(count);
    size_ += count;
    return data_ + (size_ - count);
  }
  T& front() { return data_[0]; }
  const T& front() const { return data_[0]; }
  void clear() { size_ = 0; }
  /// Gives back what is spare, unless it is little: malloc asks the system anew for each block that is larger than all
  /// that it got back so far, and who builds again and again would wait for fresh pages each time.
  void shrink_to_fit() {
    constexpr std::size_t kLittle = std::size_t{1} << 18;  // bytes
    const std::size_t spare = capacity_ - size_;
    if (size_ == 0) {
      Buffer().swap(*this);
    } else if (spare > capacity_ / 8 || spare * sizeof(T) > kLittle) {
      reallocate(size_);
    }
  }

 private:
  void reallocate(std::size_t capacity) {
    if (lent_) throw std::bad_alloc();
    data_ = static_cast<T*>(reallocate_block(data_, capacity_, capacity, sizeof(T)));
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  bool lent_ = false;  ///< the block belongs to another buffer
};

/// Fills a buffer from its start; its place stands in registers, and the buffer learns its size at the end.
template <class T>
class Refill {
 public:
  explicit Refill(Buffer<T>& buffer) : buffer_(&buffer), next_(buffer.data()), end_(next_ + buffer.capacity()) {}
  ~Refill() { buffer_->resize(size()); }
  Refill(const Refill&) = delete;
  Refill& operator=(const Refill&) = delete;

  std::size_t size() const { return static_cast<std::size_t>(next_ - buffer_->data()); }
  bool empty() const { return next_ == buffer_->data(); }
  T operator[](std::size_t i) const { return buffer_->data()[i]; }
  /// Room for `count` more; on std::bad_alloc nothing has changed.
  void make_room(std::size_t count) {
    if (static_cast<std::size_t>(end_ - next_) < count) [[unlikely]]
      grow(count);
  }
  // These need room.
  void push(T value) { *next_++ = value; }
  /// Without a branch.
  void push_if(bool really, T value) {
    *next_ = value;
    next_ += really ? 1 : 0;
  }
  /// Where the next goes; and keeps `count` that have been written from there.
  T* place() { return next_; }
  void keep(std::size_t count) { next_ += count; }
  T pop() { return *--next_; }

 private:
  void grow(std::size_t count) {
    const std::size_t used = size();
    buffer_->resize(used);
    buffer_->reserve_more(used + count);
    next_ = buffer_->data() + used;
    end_ = buffer_->data() + buffer_->capacity();
  }

  Buffer<T>* buffer_;
  T* next_;
  T* end_;
};

}  // namespace delone
