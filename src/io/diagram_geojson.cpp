// Diagrams of the plane as GeoJSON (RFC 7946): a feature per cell, a Polygon or a MultiPolygon.
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/diagram_io.hpp"
#include "io/output.hpp"

namespace delone::io {
namespace {

std::string quoted_json(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Properties of all features: their names are made JSON once.
class Properties {
 public:
  explicit Properties(const DiagramView& diagram) : diagram_(diagram), measures_(measures_of(diagram)) {
    row_ = key(free_name(diagram.points, diagram.subsets == nullptr ? "row" : "rows"));
    weight_ = key(free_name(diagram.points, "weight"));
    for (const Attribute& attribute : diagram.points.attributes) attributes_.push_back(key(attribute.name));
    for (const CellNumbers& column : measures_) measure_keys_.push_back(key(column.name));
  }

  void put(Output& out, std::size_t cell) const {
    const std::size_t row = diagram_.shapes.rows[cell];
    out << '{' << row_;
    diagram_.subsets == nullptr ? put_site(out, row) : put_rows(out, (*diagram_.subsets)[row]);
    for (std::size_t i = 0; i < measures_.size(); ++i) {
      out << ',' << measure_keys_[i];
      put_number(out, measures_[i].numbers[cell]);
    }
    out << '}';
  }

 private:
  static std::string key(const std::string& name) { return quoted_json(name) + ':'; }

  /// JSON has no word for what is not finite.
  static void put_number(Output& out, double number) { std::isfinite(number) ? out << number : out << "null"; }

  void put_site(Output& out, std::size_t row) const {
    const PointTable& points = diagram_.points;
    out << row;
    for (std::size_t i = 0; i < attributes_.size(); ++i) {
      const Attribute& attribute = points.attributes[i];
      out << ',' << attributes_[i];
      attribute.texts.empty() ? put_number(out, attribute.numbers[row])
                              : static_cast<void>(out << quoted_json(attribute.texts[row]));
    }
    if (!points.weights.empty()) out << ',' << weight_ << points.weights[row];
  }

  static void put_rows(Output& out, std::span<const Index> rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) out << (i == 0 ? '[' : ',') << rows[i];
    out << ']';
  }

  const DiagramView& diagram_;
  std::vector<CellNumbers> measures_;
  std::string row_, weight_;
  std::vector<std::string> attributes_, measure_keys_;
};

/// A ring is closed: its first position comes again at the end.
void put_ring(Output& out, const CellShapes& shapes, std::size_t loop) {
  const auto put_position = [&](std::size_t corner) {
    out << '[' << shapes.corners[2 * corner] << ',' << shapes.corners[2 * corner + 1] << ']';
  };
  out << '[';
  for (std::size_t corner = shapes.loops[loop]; corner < shapes.loops[loop + 1]; ++corner) {
    put_position(corner);
    out << ',';
  }
  put_position(shapes.loops[loop]);
  out << ']';
}

void put_piece(Output& out, const CellShapes& shapes, std::size_t first, std::size_t last) {
  for (std::size_t loop = first; loop < last; ++loop) {
    out << (loop == first ? '[' : ',');
    put_ring(out, shapes, loop);
  }
  out << ']';
}

void put_geometry(Output& out, const CellShapes& shapes, std::size_t cell) {
  if (shapes.empty(cell)) {
    out << "null";
    return;
  }
  const std::size_t first = shapes.cells[cell];
  const std::size_t last = shapes.cells[cell + 1];
  const bool one = piece_end(shapes, cell, first) == last;
  out << (one ? "{\"type\":\"Polygon\",\"coordinates\":" : "{\"type\":\"MultiPolygon\",\"coordinates\":[");
  for (std::size_t loop = first; loop < last;) {
    if (loop != first) out << ',';
    const std::size_t end = piece_end(shapes, cell, loop);
    put_piece(out, shapes, loop, end);
    loop = end;
  }
  out << (one ? "}" : "]}");
}

}  // namespace

void write_diagram_geojson(const std::string& path, const DiagramView& diagram) {
  const Properties properties(diagram);
  Output out(path);
  out << "{\"type\":\"FeatureCollection\",\"features\":[";
  for (std::size_t cell = 0; cell < diagram.shapes.size(); ++cell) {
    out << (cell == 0 ? "\n" : ",\n") << "{\"type\":\"Feature\",\"properties\":";
    properties.put(out, cell);
    out << ",\"geometry\":";
    put_geometry(out, diagram.shapes, cell);
    out << '}';
  }
  out << "\n]}\n";
  out.commit();
}

}  // namespace delone::io
