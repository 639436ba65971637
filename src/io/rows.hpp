// Rows of fields in text: what .csv, .node, .off, .obj and their like have in common. Nothing is copied.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/source.hpp"

namespace delone::io {

/// One entry of a row, without its blanks and quotation marks.
struct Field {
  const char* first = nullptr;
  const char* last = nullptr;
  bool quoted = false;

  std::string_view view() const { return {first, last}; }
  /// With doubled quotation marks made single.
  std::string text() const;
};

inline constexpr char kBlanks = ' ';  ///< the delimiter that stands for any run of blanks and tabs

/// Walks over the rows of a text. Blank lines and lines that begin with '#' are no rows; between blanks a field that
/// begins with '#' ends its row. A line ends with LF, CR LF or CR. Fields may be quoted, and then hold line breaks.
class Rows {
 public:
  /// @throws InputError naming the line of a NUL byte, or for UTF-16
  Rows(const Source& source, char delimiter);

  /// Goes to the next row; false when there is none.
  /// @throws InputError for quotation marks that do not match
  bool next();

  /// Goes to the next row and reads it where it is plain: nothing but `numbers.size()` ordinary numbers. Anything else,
  /// a fault too, is left to next(), and false is returned. size(), [] and the complaints go on about the row before.
  bool next_numbers(std::span<double> numbers);

  /// From now on only rows that begin with this entry count.
  void keep_only(std::string_view keyword) { keyword_ = keyword; }

  /// Skips the rest of the line at hand whatever it holds: the comment line of an XYZ file.
  void skip_line();

  std::size_t line() const { return row_line_; }
  std::size_t size() const { return fields_.size(); }
  std::string_view operator[](std::size_t column) const { return fields_[column].view(); }
  const Field& field(std::size_t column) const { return fields_[column]; }
  /// About how many rows like the one at hand follow.
  std::size_t rows_left() const {
    return static_cast<std::size_t>(end_ - cursor_) / (static_cast<std::size_t>(cursor_ - row_first_) + 1);
  }

  /// The entry as a finite double. @throws InputError naming line and column
  double number(std::size_t column) const;

  /// The entry as a whole number of at least 0. @throws InputError: "expected `what`, found ..."
  std::uint64_t whole(std::size_t column, std::string_view what) const;

  /// @throws InputError unless the row at hand has `count` entries
  void require_size(std::size_t count) const {
    if (fields_.size() != count) refuse_size(count);
  }

  /// Names of columns for complaints; borrowed.
  void set_names(std::span<const std::string> names) { names_ = names; }

  [[noreturn]] void refuse(std::size_t column, std::string_view message) const;
  [[noreturn]] void refuse_row(std::string_view message) const;

  const Source& source() const { return *source_; }

 private:
  [[noreturn]] void refuse_size(std::size_t count) const;
  [[noreturn]] void refuse_number(std::size_t column) const;
  bool at_line_end() const { return cursor_ == end_ || *cursor_ == '\n' || *cursor_ == '\r'; }
  bool next_any();
  void skip_blanks();
  void end_line();
  void read_fields();
  void read_quoted();
  void read_plain();
  std::size_t line_of(const Field& field) const;

  const Source* source_;
  const char* cursor_;
  const char* end_;
  char delimiter_;
  std::array<bool, 256> stops_{};  ///< bytes that end a plain field
  std::size_t line_ = 1;           ///< of the cursor
  std::size_t row_line_ = 0;       ///< of the row at hand
  const char* row_first_ = nullptr;
  std::vector<Field> fields_;
  std::span<const std::string> names_;
  std::string_view keyword_;
};

/// The delimiter of a delimited text, told from its first row: tab, semicolon, comma, else blanks.
char detect_delimiter(const Source& source);

}  // namespace delone::io
