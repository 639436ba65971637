// Misses of the last-level cache in this process, where the processor counts them and the system lets us ask.
#pragma once

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <optional>

namespace delone::bench {

class CacheMisses {
 public:
  /// The counter of this process.
  static const CacheMisses& here() {
    static const CacheMisses counter;
    return counter;
  }
  ~CacheMisses() {
    if (file_ >= 0) close(file_);
  }
  CacheMisses(const CacheMisses&) = delete;
  CacheMisses& operator=(const CacheMisses&) = delete;

  /// From now on, threads that begin later included.
  void start() const {
    if (file_ < 0) return;
    ioctl(file_, PERF_EVENT_IOC_RESET, 0);
    ioctl(file_, PERF_EVENT_IOC_ENABLE, 0);
  }
  /// Since start(); nothing where there is no such counter.
  std::optional<std::uint64_t> count() const {
    std::uint64_t misses = 0;
    if (file_ < 0 || read(file_, &misses, sizeof misses) != static_cast<ssize_t>(sizeof misses)) return std::nullopt;
    return misses;
  }

 private:
  CacheMisses() {
    perf_event_attr event{};
    event.size = sizeof event;
    event.type = PERF_TYPE_HARDWARE;
    event.config = PERF_COUNT_HW_CACHE_MISSES;
    event.disabled = 1;
    event.inherit = 1;
    event.exclude_kernel = 1;
    event.exclude_hv = 1;
    file_ = static_cast<int>(syscall(SYS_perf_event_open, &event, 0, -1, -1, 0));
  }

  int file_;
};

}  // namespace delone::bench
