#include "io/point_rows.hpp"

#include <algorithm>
#include <cstdint>

#include "io/complain.hpp"
#include "io/numbers.hpp"

namespace delone::io {
namespace {

/// A text column that may after all be one of numbers with a bad first entry.
struct Suspect {
  std::size_t column;
  std::size_t numbers = 0;
};

/// Fills a table row by row.
class TextPoints {
 public:
  TextPoints(const Columns& columns, const Choice& choice, bool watch_texts)
      : choice_(choice), table_(empty_table(columns, choice)), width_(columns.size()) {
    for (const std::size_t column : choice.attributes) is_text_.push_back(!columns.numeric[column]);
    if (!choice.is_radius && std::ranges::find(columns.numeric, false) == columns.numeric.end()) plain_.resize(width_);
    for (std::size_t column = 0; watch_texts && column < width_; ++column) {
      if (!columns.numeric[column]) suspects_.push_back({column});
    }
  }

  void reserve(std::size_t rows) {
    table_.coordinates.reserve(rows * choice_.coordinates.size());
    if (choice_.weight) table_.weights.reserve(rows);
  }

  /// False when a numeric attribute turns out to be text: demoted() tells which.
  bool add(const Rows& row) {
    row.require_size(width_);
    for (const std::size_t column : choice_.coordinates) table_.coordinates.push_back(row.number(column));
    if (choice_.weight) table_.weights.push_back(weight(row));
    for (std::size_t k = 0; k < choice_.attributes.size(); ++k) {
      if (!add_attribute(row, k)) return false;
    }
    for (Suspect& suspect : suspects_) suspect.numbers += looks_like_number(row[suspect.column]) ? 1U : 0U;
    return true;
  }

  /// Adds the rows that follow as long as they are plain numbers, at most `most`, and says how many. @see next_numbers
  std::size_t add_plain(Rows& rows, std::size_t most) {
    std::size_t count = 0;
    for (; !plain_.empty() && count != most && rows.next_numbers(plain_); ++count) {
      for (const std::size_t column : choice_.coordinates) table_.coordinates.push_back(plain_[column]);
      if (choice_.weight) table_.weights.push_back(plain_[*choice_.weight]);
      for (std::size_t k = 0; k < choice_.attributes.size(); ++k)
        table_.attributes[k].numbers.push_back(plain_[choice_.attributes[k]]);
    }
    return count;
  }

  std::size_t demoted() const { return demoted_; }
  const std::vector<Suspect>& suspects() const { return suspects_; }
  PointTable take() { return std::move(table_); }

 private:
  double weight(const Rows& row) const {
    const double number = row.number(*choice_.weight);
    if (!choice_.is_radius) return number;
    const std::string fault = radius_fault(number, row[*choice_.weight]);
    if (!fault.empty()) row.refuse(*choice_.weight, fault);
    return number * number;
  }

  bool add_attribute(const Rows& row, std::size_t k) {
    const std::size_t column = choice_.attributes[k];
    Attribute& attribute = table_.attributes[k];
    if (is_text_[k]) {
      attribute.texts.push_back(row.field(column).text());
      return true;
    }
    double value = 0;
    if (parse_number(row[column], value) != NumberFault::none) {
      demoted_ = column;
      return false;
    }
    attribute.numbers.push_back(value);
    return true;
  }

  const Choice& choice_;
  PointTable table_;
  std::size_t width_;
  std::vector<bool> is_text_;  // per attribute
  std::vector<double> plain_;  // a row, where all columns are numbers and none wants a second look
  std::vector<Suspect> suspects_;
  std::size_t demoted_ = 0;
};

void require_no_hidden_numbers(const TextPoints& points, const Rows& first_row, std::size_t row_count) {
  for (const Suspect& suspect : points.suspects()) {
    if (suspect.numbers == 0 || suspect.numbers * 2 < row_count) continue;
    const std::string_view found = first_row[suspect.column];
    first_row.refuse(suspect.column, explain(found.empty() ? NumberFault::empty : NumberFault::text, found) +
                                         ": other entries of this column are numbers; choose columns to leave it out");
  }
}

}  // namespace

PointTable read_point_rows(Rows& rows, Columns& columns, const ReadOptions& options,
                           std::optional<std::size_t> row_count) {
  if (columns.named) rows.set_names(columns.names);
  rows.require_size(columns.size());
  for (std::size_t column = 0; column < rows.size(); ++column)
    columns.numeric[column] = looks_like_number(rows[column]);
  const Choice choice = choose(rows.source().name(), columns, options);

  const Rows first_row = rows;
  for (;;) {
    const bool by_kind = options.columns.empty() && columns.usual.empty();
    TextPoints points(columns, choice, by_kind);
    const std::size_t most = row_count.value_or(SIZE_MAX);
    std::size_t count = 0;
    bool complete = true;
    points.reserve(std::min(most, rows.rows_left() + 1));
    do {
      complete = points.add(rows);
      ++count;
      if (complete) count += points.add_plain(rows, most - count);
    } while (complete && count != most && rows.next());
    if (complete) {
      require_no_hidden_numbers(points, first_row, count);
      return points.take();
    }
    columns.numeric[points.demoted()] = false;
    rows = first_row;
  }
}

}  // namespace delone::io
