#include "io/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/complain.hpp"
#include "io/numbers.hpp"

namespace delone::io {
namespace {

/// Line breaks in a text: LF, CR LF and CR each count once.
std::size_t count_breaks(std::string_view text) {
  std::size_t breaks = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'))) ++breaks;
  }
  return breaks;
}

/// The first row that is neither blank nor a comment, without its quoted entries.
std::string bare_first_row(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  std::string row;
  bool within_quotes = false;
  bool comment = false;
  for (const char c : bytes) {
    const bool blank_so_far = row.find_first_not_of(" \t") == std::string::npos;
    if (within_quotes) {
      within_quotes = c != '"';
    } else if (c == '\n' || c == '\r') {
      if (!blank_so_far) break;
      row.clear();
      comment = false;
    } else if (comment || (c == '#' && blank_so_far)) {
      comment = true;
    } else {
      within_quotes =
          c == '"' && (row.empty() || std::string_view("\t;, \"").find(row.back()) != std::string_view::npos);
      row += c;
    }
  }
  return row;
}

/// "1<tab>2 3": numbers that blanks set apart, beside tabs that do.
bool blanks_delimit_too(std::string_view row) {
  while (!row.empty()) {
    const std::string_view entry = row.substr(0, row.find('\t'));
    row.remove_prefix(std::min(entry.size() + 1, row.size()));
    const std::size_t first = std::min(entry.find_first_not_of(' '), entry.size());
    const std::size_t blank = std::min(entry.find(' ', first), entry.size());
    const bool several = entry.find_first_not_of(' ', blank) != std::string_view::npos;
    if (several && looks_like_number(entry.substr(first, blank - first))) return true;
  }
  return false;
}

}  // namespace

std::string Field::text() const {
  std::string result(first, last);
  if (!quoted) return result;
  for (std::size_t at = result.find("\"\""); at != std::string::npos; at = result.find("\"\"", at + 1)) {
    result.erase(at, 1);
  }
  return result;
}

Rows::Rows(const Source& source, char delimiter)
    : source_(&source),
      cursor_(source.bytes().data()),
      end_(source.bytes().data() + source.bytes().size()),
      delimiter_(delimiter) {
  const std::string_view bytes = source.bytes();
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
    complain(source.name(), Place{.line = 1}, "expected UTF-8, found UTF-16");
  }
  if (bytes.starts_with("\xef\xbb\xbf")) cursor_ += 3;
  if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos) {
    complain(source.name(), Place{.line = 1 + count_breaks(bytes.substr(0, nul))}, "expected text, found a NUL byte");
  }
  stops_['\n'] = stops_['\r'] = true;
  stops_[static_cast<unsigned char>(delimiter)] = true;
  if (delimiter == kBlanks) stops_['\t'] = true;
}

void Rows::skip_blanks() {
  while (cursor_ != end_ && (*cursor_ == ' ' || (*cursor_ == '\t' && delimiter_ != '\t'))) ++cursor_;
}

void Rows::end_line() {
  if (cursor_ == end_) return;
  if (*cursor_ == '\r' && cursor_ + 1 != end_ && cursor_[1] == '\n') ++cursor_;
  ++cursor_;
  ++line_;
}

void Rows::skip_line() {
  while (!at_line_end()) ++cursor_;
  end_line();
}

bool Rows::next() {
  while (next_any()) {
    if (keyword_.empty() || fields_.front().view() == keyword_) return true;
  }
  return false;
}

bool Rows::next_any() {
  fields_.clear();
  for (;;) {
    skip_blanks();
    if (cursor_ == end_) return false;
    if (!at_line_end() && *cursor_ != '#') break;
    skip_line();
  }
  row_line_ = line_;
  row_first_ = cursor_;
  read_fields();
  end_line();
  return true;
}

bool Rows::next_numbers(std::span<double> numbers) {
  if (!keyword_.empty()) return false;
  const char* const first = cursor_;
  const auto leave_it = [&] {
    cursor_ = first;
    return false;
  };
  for (std::size_t column = 0; column < numbers.size(); ++column) {
    const char* const before = cursor_;
    skip_blanks();
    const bool apart =
        column == 0 || (delimiter_ == kBlanks ? cursor_ != before : cursor_ != end_ && *cursor_++ == delimiter_);
    if (!apart) return leave_it();
    if (delimiter_ != kBlanks) skip_blanks();
    const char* const end = parse_leading_number(cursor_, end_, numbers[column]);
    if (end == nullptr) return leave_it();
    cursor_ = end;
  }
  skip_blanks();
  if (!at_line_end()) return leave_it();
  end_line();
  return true;
}

void Rows::read_fields() {
  for (;;) {
    if (cursor_ != end_ && *cursor_ == '"') {
      read_quoted();
    } else {
      read_plain();
    }
    skip_blanks();
    if (delimiter_ == kBlanks) {
      if (at_line_end()) return;
      if (*cursor_ == '#') {
        while (!at_line_end()) ++cursor_;
        return;
      }
    } else {
      if (at_line_end()) return;
      ++cursor_;  // the delimiter
      skip_blanks();
    }
  }
}

void Rows::read_plain() {
  const char* const first = cursor_;
  while (cursor_ != end_ && !stops_[static_cast<unsigned char>(*cursor_)]) ++cursor_;
  const char* last = cursor_;
  while (last != first && (last[-1] == ' ' || last[-1] == '\t')) --last;
  fields_.push_back({first, last, false});
}

void Rows::read_quoted() {
  const char* const first = ++cursor_;
  for (;; cursor_ += 2) {  // over a doubled mark
    const std::size_t mark = std::string_view(cursor_, end_).find('"');
    if (mark == std::string_view::npos) {
      complain(source_->name(), Place{.line = line_, .column = fields_.size() + 1},
               "the quotation mark is never closed");
    }
    cursor_ += mark;
    if (cursor_ + 1 == end_ || cursor_[1] != '"') break;
  }
  fields_.push_back({first, cursor_, true});
  line_ += count_breaks(fields_.back().view());
  ++cursor_;
  const char* const after = cursor_;
  skip_blanks();
  const bool apart = delimiter_ == kBlanks ? cursor_ != after : cursor_ != end_ && *cursor_ == delimiter_;
  if (!at_line_end() && !apart) {
    complain(source_->name(), Place{.line = line_, .column = fields_.size()},
             "expected the end of the entry after its closing quotation mark");
  }
}

double Rows::number(std::size_t column) const {
  double value = 0;
  if (parse_number(fields_[column].view(), value) != NumberFault::none) refuse_number(column);
  return value;
}

void Rows::refuse_number(std::size_t column) const {
  double value = 0;
  const std::string_view text = fields_[column].view();
  refuse(column, explain(parse_number(text, value), text));
}

std::uint64_t Rows::whole(std::size_t column, std::string_view what) const {
  std::uint64_t value = 0;
  if (column >= fields_.size()) refuse_row(fmt::format("expected {}, found the end of the line", what));
  if (!parse_whole(fields_[column].view(), value)) {
    refuse(column, fmt::format("expected {}, found {}", what, quoted(fields_[column].view())));
  }
  return value;
}

std::size_t Rows::line_of(const Field& field) const {
  return row_line_ + count_breaks(std::string_view(row_first_, field.first));
}

void Rows::refuse(std::size_t column, std::string_view message) const {
  complain(source_->name(),
           Place{.line = line_of(fields_[column]),
                 .column = column + 1,
                 .column_name = column < names_.size() ? std::string_view(names_[column]) : std::string_view()},
           message);
}

void Rows::refuse_row(std::string_view message) const { complain(source_->name(), Place{.line = row_line_}, message); }

void Rows::refuse_size(std::size_t count) const {
  refuse_row(fmt::format("expected {}, found {}", counted(count, "column"), fields_.size()));
}

char detect_delimiter(const Source& source) {
  const std::string row = bare_first_row(source.bytes());
  if (row.find('\t') != std::string::npos) return blanks_delimit_too(row) ? kBlanks : '\t';
  if (row.find(';') != std::string::npos) return ';';
  if (row.find(',') != std::string::npos) return ',';
  return kBlanks;
}

}  // namespace delone::io
