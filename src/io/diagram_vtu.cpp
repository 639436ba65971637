// Diagrams as VTK files. In the plane a cell is a polygon (type 7) for each of its pieces, in space a polyhedron (type
// 42) with its faces in an array of their own: their number, and each with its corners behind their number.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "io/diagram_io.hpp"
#include "io/vtu.hpp"

namespace delone::io {
namespace {

constexpr unsigned char kPolygon = 7;
constexpr unsigned char kPolyhedron = 42;

struct Grid {
  std::vector<double> points;                  // 3 coordinates each
  std::vector<std::size_t> corners, ends;      // points of each VTK cell
  std::vector<std::size_t> faces, faces_ends;  // of polyhedra
  std::vector<std::size_t> cell_of;            // the cell of the diagram that each is, or is a piece of

  void end_cell(std::size_t cell) {
    ends.push_back(corners.size());
    cell_of.push_back(cell);
  }
};

Grid polygons_of(const CellShapes& shapes) {
  Grid grid;
  for (std::size_t corner = 0; 2 * corner < shapes.corners.size(); ++corner)
    grid.points.insert(grid.points.end(), {shapes.corners[2 * corner], shapes.corners[2 * corner + 1], 0.0});
  for (std::size_t cell = 0; cell < shapes.size(); ++cell) {
    for (std::size_t loop = shapes.cells[cell]; loop < shapes.cells[cell + 1];) {
      const std::size_t end = piece_end(shapes, cell, loop);
      append_bridged(shapes, loop, end, grid.corners);
      grid.end_cell(cell);
      loop = end;
    }
  }
  return grid;
}

/// The corners of one cell of space, each place once. Faces are computed each by itself, so what two of them have in
/// common differs by rounding: corners nearer than 2^-30 of the cell's longest side are one place, that of the first.
class CellCorners {
 public:
  CellCorners(const CellShapes& shapes, std::size_t cell)
      : first_(shapes.loops[shapes.cells[cell]]), place_(shapes.loops[shapes.cells[cell + 1]] - first_) {
    std::vector<std::pair<Place, std::size_t>> sorted;
    for (std::size_t i = 0; i < place_.size(); ++i) {
      const double* const x = &shapes.corners[3 * (first_ + i)];
      sorted.push_back({{x[0], x[1], x[2]}, i});
    }
    std::ranges::sort(sorted);
    const double narrow = 0x1p-30 * longest_side(sorted);
    for (const auto& [at, i] : sorted) place_[i] = find_or_add(at, narrow);
  }

  const std::vector<std::array<double, 3>>& places() const { return places_; }
  /// The places round a face; none where fewer than three are left.
  std::vector<std::size_t> face(std::size_t begin, std::size_t end) const {
    std::vector<std::size_t> round(place_.begin() + static_cast<std::ptrdiff_t>(begin - first_),
                                   place_.begin() + static_cast<std::ptrdiff_t>(end - first_));
    round.erase(std::unique(round.begin(), round.end()), round.end());
    while (round.size() > 1 && round.back() == round.front()) round.pop_back();
    if (round.size() < 3) round.clear();
    return round;
  }

 private:
  using Place = std::array<double, 3>;

  static double longest_side(const std::vector<std::pair<Place, std::size_t>>& corners) {
    double longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::ranges::minmax(corners | std::views::keys |
                                                   std::views::transform([&](const Place& p) { return p[axis]; }));
      longest = std::max(longest, high - low);
    }
    return longest;
  }

  /// Corners come with x ascending.
  std::size_t find_or_add(const Place& at, double narrow) {
    for (std::size_t i = places_.size(); i-- > 0 && at[0] - places_[i][0] <= narrow;) {
      if (std::abs(at[1] - places_[i][1]) <= narrow && std::abs(at[2] - places_[i][2]) <= narrow) return i;
    }
    places_.push_back(at);
    return places_.size() - 1;
  }

  std::size_t first_;
  std::vector<std::size_t> place_;  // of each corner
  std::vector<Place> places_;
};

void add_polyhedron(const CellShapes& shapes, std::size_t cell, Grid& grid) {
  const CellCorners corners(shapes, cell);
  const std::size_t base = grid.points.size() / 3;
  for (const auto& place : corners.places()) {
    grid.corners.push_back(grid.points.size() / 3);
    grid.points.insert(grid.points.end(), place.begin(), place.end());
  }
  const std::size_t count = grid.faces.size();
  grid.faces.push_back(0);
  for (std::size_t loop = shapes.cells[cell]; loop < shapes.cells[cell + 1]; ++loop) {
    const std::vector<std::size_t> face = corners.face(shapes.loops[loop], shapes.loops[loop + 1]);
    if (face.empty()) continue;
    ++grid.faces[count];
    grid.faces.push_back(face.size());
    for (const std::size_t place : face) grid.faces.push_back(base + place);
  }
  grid.faces_ends.push_back(grid.faces.size());
  grid.end_cell(cell);
}

Grid polyhedra_of(const CellShapes& shapes) {
  Grid grid;
  for (std::size_t cell = 0; cell < shapes.size(); ++cell) {
    if (!shapes.empty(cell)) add_polyhedron(shapes, cell, grid);
  }
  return grid;
}

/// What is told of every cell: columns of numbers, each by the cells of the diagram.
std::vector<CellNumbers> columns_of(const DiagramView& diagram) {
  std::vector<CellNumbers> columns = measures_of(diagram);
  if (diagram.subsets != nullptr) return columns;
  const auto by_row = [&](const std::string& name, const auto& value, bool whole) {
    CellNumbers& column = columns.emplace_back(CellNumbers{name, {}, whole});
    for (const Index row : diagram.shapes.rows) column.numbers.push_back(static_cast<double>(value(row)));
  };
  const PointTable& points = diagram.points;
  by_row(
      free_name(points, "row"), [](Index row) { return row; }, true);
  for (const Attribute& attribute : points.attributes) {
    if (attribute.texts.empty())
      by_row(
          attribute.name, [&](Index row) { return attribute.numbers[row]; }, false);
  }
  if (!points.weights.empty())
    by_row(
        free_name(points, "weight"), [&](Index row) { return points.weights[row]; }, false);
  return columns;
}

/// Rows of the subsets, all of them as long as the first.
std::size_t subset_size(const DiagramView& diagram) {
  return diagram.subsets == nullptr || diagram.subsets->size() == 0 ? 0 : (*diagram.subsets)[0].size();
}

constexpr std::size_t kWord = 8;  // bytes of a double, and of an integer

std::string announce(const DiagramView& diagram, const Grid& grid, const std::vector<CellNumbers>& columns) {
  const std::size_t n = grid.cell_of.size();
  VtuHead xml(grid.points.size() / 3, n);
  xml.begin("Points");
  xml.array("Float64", "Points", grid.points.size() * kWord, " NumberOfComponents=\"3\"");
  xml.end("Points");
  xml.begin("Cells");
  xml.array("Int64", "connectivity", grid.corners.size() * kWord);
  xml.array("Int64", "offsets", n * kWord);
  xml.array("UInt8", "types", n);
  if (diagram.shapes.dimension == 3) {
    xml.array("Int64", "faces", grid.faces.size() * kWord);
    xml.array("Int64", "faceoffsets", n * kWord);
  }
  xml.end("Cells");
  xml.begin("CellData");
  for (const CellNumbers& column : columns) xml.array(column.whole ? "Int64" : "Float64", column.name, n * kWord);
  if (const std::size_t size = subset_size(diagram); size != 0)
    xml.array("Int64", "rows", n * size * kWord, fmt::format(" NumberOfComponents=\"{}\"", size));
  xml.end("CellData");
  return xml.finish();
}

void put_data(Output& out, const DiagramView& diagram, const Grid& grid, const std::vector<CellNumbers>& columns) {
  for (const CellNumbers& column : columns) {
    const auto numbers = grid.cell_of | std::views::transform([&](std::size_t cell) { return column.numbers[cell]; });
    column.whole ? put_array<std::int64_t>(out, numbers) : put_array<double>(out, numbers);
  }
  const std::size_t size = subset_size(diagram);
  if (size == 0) return;
  std::vector<Index> rows;
  for (const std::size_t cell : grid.cell_of)
    std::ranges::copy((*diagram.subsets)[diagram.shapes.rows[cell]], std::back_inserter(rows));
  put_array<std::int64_t>(out, rows);
}

}  // namespace

void write_diagram_vtu(const std::string& path, const DiagramView& diagram) {
  const bool plane = diagram.shapes.dimension == 2;
  const Grid grid = plane ? polygons_of(diagram.shapes) : polyhedra_of(diagram.shapes);
  const std::vector<CellNumbers> columns = columns_of(diagram);
  Output out(path);
  out << announce(diagram, grid, columns);
  put_array<double>(out, grid.points);
  put_array<std::int64_t>(out, grid.corners);
  put_array<std::int64_t>(out, grid.ends);
  put_array<unsigned char>(out, std::vector(grid.cell_of.size(), plane ? kPolygon : kPolyhedron));
  if (!plane) {
    put_array<std::int64_t>(out, grid.faces);
    put_array<std::int64_t>(out, grid.faces_ends);
  }
  put_data(out, diagram, grid, columns);
  out << kVtuTail;
  out.commit();
}

}  // namespace delone::io
