// What a check found wrong: all of it counted, the first of it in words.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone::check_detail {

class Violations {
 public:
  explicit Violations(std::size_t limit) : limit_(limit) {}

  /// `words()` makes the line; it is asked only while there is room.
  template <class Words>
  void add(Words&& words) {
    if (count_++ < limit_) lines_.push_back(words());
  }

  /// As if every violation of `later` had been added here.
  void append(Violations&& later) {
    for (std::string& line : later.lines_) {
      if (lines_.size() < limit_) lines_.push_back(std::move(line));
    }
    count_ += later.count_;
  }

  std::size_t count() const { return count_; }
  std::size_t limit() const { return limit_; }
  bool none() const { return count_ == 0; }
  std::vector<std::string> take_lines() { return std::move(lines_); }

 private:
  std::size_t limit_;
  std::size_t count_ = 0;
  std::vector<std::string> lines_;
};

/// "row 4", "rows 4 7 9", "no rows".
inline std::string in_words(std::span<const Index> rows) {
  if (rows.empty()) return "no rows";
  std::string words = rows.size() == 1 ? "row" : "rows";
  for (const Index row : rows) words += ' ' + std::to_string(row);
  return words;
}

}  // namespace delone::check_detail
