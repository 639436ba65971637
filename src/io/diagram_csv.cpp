// Diagrams as text: a line per input row with what its cell measures, or a line per subset.
#include "io/diagram_io.hpp"
#include "io/output.hpp"

namespace delone::io {
namespace {

/// In quotation marks where a reader would take it for something else.
std::string entry(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_of("\",;\t\r\n#") == std::string::npos && text.front() != ' ' &&
                     text.back() != ' ';
  if (plain) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

void put_header(Output& out, const DiagramView& diagram, const std::vector<CellNumbers>& measures) {
  std::vector<std::string> names;
  if (diagram.subsets != nullptr) {
    names.push_back("rows");
  } else {
    names = diagram.points.coordinate_names;
    if (!diagram.points.weights.empty()) names.push_back(free_name(diagram.points, "weight"));
    for (const Attribute& attribute : diagram.points.attributes) names.push_back(attribute.name);
  }
  for (const CellNumbers& column : measures) names.push_back(column.name);
  for (std::size_t i = 0; i < names.size(); ++i) out << (i == 0 ? "" : ",") << entry(names[i]);
  out << '\n';
}

void put_site(Output& out, const PointTable& points, std::size_t row) {
  const char* comma = "";
  for (const double coordinate : points.view()[row]) {
    out << comma << coordinate;
    comma = ",";
  }
  if (!points.weights.empty()) out << ',' << points.weights[row];
  for (const Attribute& attribute : points.attributes) {
    out << ',';
    attribute.texts.empty() ? out << attribute.numbers[row] : out << entry(attribute.texts[row]);
  }
}

void put_rows(Output& out, std::span<const Index> rows) {
  const char* blank = "";
  for (const Index row : rows) {
    out << blank << row;
    blank = " ";
  }
}

/// The rest of a line: what the cell measures, zeros for kNone.
void put_measures(Output& out, const std::vector<CellNumbers>& measures, std::size_t cell) {
  for (const CellNumbers& column : measures) out << ',' << (cell == kNone ? 0.0 : column.numbers[cell]);
  out << '\n';
}

}  // namespace

void write_diagram_csv(const std::string& path, const DiagramView& diagram) {
  const std::vector<CellNumbers> measures = measures_of(diagram);
  Output out(path);
  put_header(out, diagram, measures);
  if (diagram.subsets != nullptr) {
    for (std::size_t cell = 0; cell < diagram.shapes.size(); ++cell) {
      put_rows(out, (*diagram.subsets)[diagram.shapes.rows[cell]]);
      put_measures(out, measures, cell);
    }
    return out.commit();
  }
  std::vector<std::size_t> cell_of(diagram.points.size(), kNone);
  for (std::size_t cell = 0; cell < diagram.shapes.size(); ++cell) cell_of[diagram.shapes.rows[cell]] = cell;
  for (std::size_t row = 0; row < cell_of.size(); ++row) {
    put_site(out, diagram.points, row);
    put_measures(out, measures, cell_of[row]);
  }
  out.commit();
}

}  // namespace delone::io
