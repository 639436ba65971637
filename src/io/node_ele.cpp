// The .node and .ele files of Triangle and TetGen. Counts from 0 or from 1, told by the first row.
// Columns of a .node file, by name or by number as they stand in the file: index, x, y, z, ..., attribute_1, ...,
// marker.
// Written: STEM.node with attributes and then the weight, STEM.ele and STEM.neigh, all counting from 0.
#include <fmt/format.h>

#include "delone/base/ids.hpp"
#include "io/cell_rows.hpp"
#include "io/complain.hpp"
#include "io/facets.hpp"
#include "io/mesh_io.hpp"
#include "io/point_rows.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

/// The first line's numbers, absent ones taken as 0.
std::vector<std::size_t> read_counts(Rows& rows, std::size_t least, std::size_t most, const char* expected) {
  if (!rows.next())
    complain(rows.source().name(), fmt::format("expected a first line with {}, found nothing", expected));
  if (rows.size() < least || rows.size() > most) {
    rows.refuse_row(fmt::format("expected {}, found {}", expected, counted(rows.size(), "column")));
  }
  std::vector<std::size_t> counts(most, 0);
  for (std::size_t column = 0; column < rows.size(); ++column) {
    counts[column] = static_cast<std::size_t>(rows.whole(column, expected));
  }
  return counts;
}

/// Goes to row `done` of `count`. @throws InputError when the file ends before
void next_of(Rows& rows, std::size_t done, std::size_t count, std::string_view noun) {
  if (rows.next()) return;
  complain(rows.source().name(),
           fmt::format("expected {}, found {} before the end of the file", counted(count, noun), done));
}

void require_end(Rows& rows, std::size_t count, std::string_view noun) {
  if (rows.next()) rows.refuse_row(fmt::format("expected the end of the file after {}", counted(count, noun)));
}

/// The row numbers of a .node or .ele file.
class Numbering {
 public:
  void check(const Rows& rows) {
    const std::uint64_t number = rows.whole(0, "a row number");
    if (row_ == 0) {
      if (number > 1) rows.refuse(0, fmt::format("expected row number 0 or 1, found {}", number));
      base_ = static_cast<std::size_t>(number);
    }
    if (number != row_ + base_) rows.refuse(0, fmt::format("expected row number {}, found {}", row_ + base_, number));
    ++row_;
  }
  std::size_t base() const { return base_; }

 private:
  std::size_t row_ = 0;
  std::size_t base_ = 0;
};

Columns node_columns(std::size_t dimension, std::size_t attributes, bool marker) {
  std::vector<std::string> names{"index"};
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    names.push_back(dimension <= 3 ? std::string(1, "xyz"[axis]) : fmt::format("x{}", axis + 1));
  }
  for (std::size_t k = 1; k <= attributes; ++k) names.push_back(fmt::format("attribute_{}", k));
  if (marker) names.push_back("marker");
  const std::size_t width = names.size();
  Columns columns = Columns::with_names(std::move(names), width);
  columns.first_attribute = 1;
  for (std::size_t axis = 1; axis <= dimension; ++axis) columns.usual.push_back(axis);
  return columns;
}

}  // namespace

PointTable read_node(const Source& source, const ReadOptions& options) {
  Rows rows(source, kBlanks);
  const std::vector<std::size_t> counts =
      read_counts(rows, 2, 4, "the counts of points, dimensions, attributes and markers");
  const auto [count, dimension, attributes, markers] = std::tie(counts[0], counts[1], counts[2], counts[3]);
  if (dimension < 1 || dimension > kMaxDimension) {
    rows.refuse(1, fmt::format("expected 1 to {} dimensions, found {}", kMaxDimension, dimension));
  }
  if (attributes > 1000) rows.refuse(2, fmt::format("expected at most 1000 attributes, found {}", attributes));
  if (markers > 1) rows.refuse(3, fmt::format("expected 0 or 1 markers, found {}", markers));
  Columns columns = node_columns(dimension, attributes, markers == 1);
  if (count == 0) {
    require_end(rows, 0, "point");
    return empty_table(columns, choose(source.name(), columns, options));
  }
  next_of(rows, 0, count, "point");
  Rows numbers = rows;
  PointTable table = read_point_rows(rows, columns, options, count);
  if (table.size() < count) next_of(rows, table.size(), count, "point");
  require_end(rows, count, "point");
  Numbering numbering;
  for (std::size_t row = 0; row < count; ++row, numbers.next()) numbering.check(numbers);
  table.one_based = numbering.base() == 1;
  return table;
}

CellTable read_ele(const Source& source, std::size_t point_count) {
  Rows rows(source, kBlanks);
  const std::vector<std::size_t> counts = read_counts(rows, 2, 3, "the counts of cells, corners and attributes");
  const auto [count, corners, attributes] = std::tie(counts[0], counts[1], counts[2]);
  if (corners < 1 || corners > 1000) rows.refuse(1, fmt::format("expected a count of corners, found {}", corners));
  if (attributes > 1000) rows.refuse(2, fmt::format("expected at most 1000 attributes, found {}", attributes));
  Numbering numbering;
  CellRows cells(point_count);
  cells.set_corners(corners);
  for (std::size_t cell = 0; cell < count; ++cell) {
    next_of(rows, cell, count, "cell");
    rows.require_size(1 + corners + attributes);
    numbering.check(rows);
    if (cell == 0) {
      cells = CellRows(point_count, numbering.base());
      cells.set_corners(corners);
    }
    for (std::size_t column = 1; column <= corners; ++column) cells.add(rows, column);
  }
  require_end(rows, count, "cell");
  return cells.take();
}

std::vector<std::string> write_node_ele(const std::string& stem, const MeshView& mesh) {
  if (mesh.merged != nullptr) refuse_mesh("node", "cannot hold merged polytopes: write cells or csv");
  const PointTable& points = mesh.points;
  const auto dimension = static_cast<std::size_t>(points.dimension);
  const std::vector<NamedNumbers> numbers = point_numbers(mesh);
  const auto corners = static_cast<std::size_t>(mesh.cells.corners);
  std::vector<Output> outputs;
  for (const char* extension : {".node", ".ele", ".neigh"}) outputs.emplace_back(stem + extension);

  outputs[0].print("{} {} {} 0\n", points.size(), dimension, numbers.size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    outputs[0] << row;
    for (const double coordinate : points.view()[row]) outputs[0] << ' ' << coordinate;
    for (const NamedNumbers& column : numbers) outputs[0] << ' ' << (*column.numbers)[row];
    outputs[0] << '\n';
  }
  const std::vector<Index> neighbours = neighbours_of(mesh.cells);
  const std::size_t announced = corners == 0 ? dimension + 1 : corners;
  outputs[1].print("{} {} 0\n", mesh.cells.size(), announced);
  outputs[2].print("{} {}\n", mesh.cells.size(), announced);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    outputs[1] << cell;
    outputs[2] << cell;
    for (std::size_t i = 0; i < corners; ++i) {
      const Index across = neighbours[cell * corners + i];
      outputs[1] << ' ' << mesh.cells[cell][i];
      if (across == kNone) {
        outputs[2] << " -1";
      } else {
        outputs[2] << ' ' << across;
      }
    }
    outputs[1] << '\n';
    outputs[2] << '\n';
  }
  commit_all(outputs);
  return {outputs[0].path(), outputs[1].path(), outputs[2].path()};
}

}  // namespace delone::io
