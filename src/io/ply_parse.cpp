#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/bytes.hpp"
#include "io/complain.hpp"
#include "io/ply.hpp"
#include "io/rows.hpp"

namespace delone::io {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct TypeName {
  std::string_view name;
  Type type;
};

constexpr std::array kTypes{
    TypeName{"char", Type::int8},       TypeName{"int8", Type::int8},       TypeName{"uchar", Type::uint8},
    TypeName{"uint8", Type::uint8},     TypeName{"short", Type::int16},     TypeName{"int16", Type::int16},
    TypeName{"ushort", Type::uint16},   TypeName{"uint16", Type::uint16},   TypeName{"int", Type::int32},
    TypeName{"int32", Type::int32},     TypeName{"uint", Type::uint32},     TypeName{"uint32", Type::uint32},
    TypeName{"float", Type::float32},   TypeName{"float32", Type::float32}, TypeName{"double", Type::float64},
    TypeName{"float64", Type::float64},
};

std::optional<Type> type_of(std::string_view name) {
  const auto* const found = std::ranges::find(kTypes, name, &TypeName::name);
  if (found == kTypes.end()) return std::nullopt;
  return found->type;
}

struct Header {
  std::string encoding;
  std::vector<PlyElement> elements;
};

void parse_property(const Rows& rows, PlyElement& element) {
  const bool is_list = rows.size() == 5 && rows[1] == "list";
  if (!is_list && rows.size() != 3)
    rows.refuse_row("expected \"property TYPE NAME\" or \"property list COUNT TYPE NAME\"");
  for (std::size_t column = is_list ? 2 : 1; column + 1 < rows.size(); ++column) {
    if (!type_of(rows[column]))
      rows.refuse(column, "expected a type such as float or int, found " + quoted(rows[column]));
  }
  const std::size_t last = rows.size() - 1;
  element.properties.push_back({.name = std::string(rows[last]),
                                .type = std::string(rows[last - 1]),
                                .count_type = is_list ? std::string(rows[2]) : std::string()});
}

/// Leaves `rows` on the line "end_header".
Header parse_header(Rows& rows) {
  const std::string& file = rows.source().name();
  if (!rows.next() || rows[0] != "ply") complain(file, Place{.line = 1}, "expected ply");
  Header header;
  while (rows.next()) {
    const std::string_view keyword = rows[0];
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "end_header") {
      if (header.encoding.empty()) rows.refuse_row("expected a line \"format ...\" before the end of the header");
      return header;
    }
    if (keyword == "format" && rows.size() >= 2) {
      header.encoding = rows[1];
      constexpr std::array kEncodings{"ascii", "binary_little_endian", "binary_big_endian"};
      if (std::ranges::find(kEncodings, rows[1]) == kEncodings.end()) {
        rows.refuse(1, "expected ascii, binary_little_endian or binary_big_endian, found " + quoted(rows[1]));
      }
    } else if (keyword == "element" && rows.size() == 3) {
      PlyElement element;
      element.name = rows[1];
      element.count = static_cast<std::size_t>(rows.whole(2, "a count"));
      header.elements.push_back(std::move(element));
    } else if (keyword == "property" && !header.elements.empty()) {
      parse_property(rows, header.elements.back());
    } else {
      rows.refuse_row("expected format, element, property or end_header, found " + quoted(keyword));
    }
  }
  complain(file, "expected end_header, found the end of the file");
}

/// Items of a text body: every element of a PLY file stands on a line of its own.
class TextItems {
 public:
  explicit TextItems(Rows& rows) : rows_(rows) {}

  void begin(const PlyElement& element, std::size_t done) {
    if (!rows_.next()) {
      complain(rows_.source().name(), fmt::format("expected {} of element {}, found {} before the end of the file",
                                                  counted(element.count, "line"), element.name, done));
    }
    column_ = 0;
  }
  double item(Type) {
    if (column_ >= rows_.size()) rows_.refuse_row(fmt::format("expected more than {}", counted(rows_.size(), "item")));
    return rows_.number(column_++);
  }
  [[noreturn]] void refuse_count() const { rows_.refuse(column_ - 1, "expected the length of a list"); }
  void end() {
    if (column_ != rows_.size()) rows_.require_size(column_);
  }
  void end_file() {
    if (rows_.next()) rows_.refuse_row("expected the end of the file after the last element");
  }

 private:
  Rows& rows_;
  std::size_t column_ = 0;
};

class BinaryItems {
 public:
  BinaryItems(const std::string& file, std::string_view bytes, std::endian order)
      : file_(file), bytes_(bytes), order_(order) {}

  void begin(const PlyElement& element, std::size_t done) {
    element_ = &element;
    done_ = done;
  }
  double item(Type type) {
    switch (type) {
      case Type::int8:
        return take<std::int8_t>();
      case Type::uint8:
        return take<std::uint8_t>();
      case Type::int16:
        return take<std::int16_t>();
      case Type::uint16:
        return take<std::uint16_t>();
      case Type::int32:
        return take<std::int32_t>();
      case Type::uint32:
        return take<std::uint32_t>();
      case Type::float32:
        return double{take<float>()};
      case Type::float64:
        return take<double>();
    }
    return 0;
  }
  [[noreturn]] void refuse_count() const {
    complain(file_, fmt::format("{} {}: expected the length of a list", element_->name, done_));
  }
  void end() {}
  void end_file() {
    const std::size_t rest = bytes_.size() - std::min(bytes_.find_first_not_of("\r\n \t"), bytes_.size());
    if (rest != 0)
      complain(file_,
               fmt::format("expected the end of the file after the last element, found {}", counted(rest, "byte")));
  }

 private:
  template <class T>
  T take() {
    if (bytes_.size() < sizeof(T)) {
      complain(file_, fmt::format("expected {} of element {}, found {} before the end of the file",
                                  counted(element_->count, "item"), element_->name, done_));
    }
    const T value = load<T>(bytes_.data(), order_);
    bytes_.remove_prefix(sizeof(T));
    return value;
  }

  const std::string& file_;
  std::string_view bytes_;
  std::endian order_;
  const PlyElement* element_ = nullptr;
  std::size_t done_ = 0;
};

struct Step {
  Type type = Type::float64;
  std::optional<Type> count;  // of a list
  bool keep = false;
};

template <class Items>
void read_element(Items& items, PlyElement& element, bool wanted, const std::function<bool(const PlyProperty&)>& list) {
  if (element.properties.empty()) return;
  std::vector<Step> steps;
  for (const PlyProperty& property : element.properties) {
    const bool keep = wanted && (!property.is_list() || (list && list(property)));
    steps.push_back({*type_of(property.type), type_of(property.count_type), keep});
  }
  for (std::size_t done = 0; done < element.count; ++done) {
    items.begin(element, done);
    for (const Step& step : steps) {
      if (!step.count) {
        const double number = items.item(step.type);
        if (step.keep) element.numbers.push_back(number);
        continue;
      }
      const double length = items.item(*step.count);
      if (length < 0 || length != std::floor(length) || length > 0x1p32) items.refuse_count();
      for (double k = 0; k < length; ++k) {
        const double number = items.item(step.type);
        if (step.keep) element.list_items.push_back(number);
      }
      if (step.keep) element.list_ends.push_back(element.list_items.size());
    }
    items.end();
  }
}

template <class Items>
std::vector<PlyElement> read_body(Items items, Header& header, const std::function<bool(const PlyElement&)>& wanted,
                                  const std::function<bool(const PlyProperty&)>& list) {
  std::vector<PlyElement> elements;
  for (PlyElement& element : header.elements) {
    const bool keep = wanted(element);
    read_element(items, element, keep, list);
    if (keep) elements.push_back(std::move(element));
  }
  items.end_file();
  return elements;
}

/// Where the body of a binary file begins: behind the line "end_header".
std::size_t body_start(const Source& source) {
  const std::string_view bytes = source.bytes();
  constexpr std::string_view kEnd = "\nend_header";
  std::size_t at = bytes.find(kEnd);
  if (at == std::string_view::npos) complain(source.name(), "expected end_header, found the end of the file");
  at = bytes.find('\n', at + kEnd.size());
  return at == std::string_view::npos ? bytes.size() : at + 1;
}

}  // namespace

std::vector<PlyElement> parse_ply(const Source& source, const std::function<bool(const PlyElement&)>& wanted,
                                  const std::function<bool(const PlyProperty&)>& list) {
  const std::string_view bytes = source.bytes();
  const std::string_view header_text = bytes.substr(0, bytes.find("\nend_header"));
  if (header_text.find("\nformat binary") == std::string_view::npos) {
    Rows rows(source, kBlanks);
    Header header = parse_header(rows);
    return read_body(TextItems(rows), header, wanted, list);
  }
  const std::size_t body = body_start(source);
  const Source head = source.part(bytes.substr(0, body));
  Rows rows(head, kBlanks);
  Header header = parse_header(rows);
  const std::endian order = header.encoding == "binary_big_endian" ? std::endian::big : std::endian::little;
  return read_body(BinaryItems(source.name(), bytes.substr(body), order), header, wanted, list);
}

}  // namespace delone::io
