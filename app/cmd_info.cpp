// delone info: what is in a file of points.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>

#include "command.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/io/points_file.hpp"
#include "report.hpp"

namespace delone::cli {
namespace {

struct Options {
  PointInput input;
  bool json = false;
};

/// How finely the numbers of a column are laid out.
struct Grid {
  int bits = 0;                 // every number is an integer of so many bits, and perhaps a sign, ...
  int exponent = 0;             // ... times 2^exponent
  std::optional<int> decimals;  // every number is the double nearest to one with so few decimals
};

struct Column {
  std::string name, kind;  // coordinate, weight, number or text
  double least = 0, greatest = 0;
  Grid grid;
};

/// The fewest decimals, up to 9, that spell every number. A decimal of less than 2^53 units divided by its power of ten
/// is the quotient of two exact doubles, so the division rounds to the very double that the decimal reads as.
std::optional<int> decimals_of(std::span<const double> numbers) {
  double power = 1;
  int decimals = 0;
  for (const double x : numbers) {
    for (;; ++decimals, power *= 10) {
      if (decimals > 9) return std::nullopt;
      const double units = std::nearbyint(x * power);
      if (std::abs(units) < 0x1p53 && units / power == x) break;
    }
  }
  return decimals;
}

Grid grid_of(std::span<const double> numbers) {
  int lowest = std::numeric_limits<int>::max(), highest = std::numeric_limits<int>::min();
  for (const double x : numbers) {
    if (x == 0) continue;
    int exponent = 0;
    const auto mantissa = static_cast<std::uint64_t>(std::abs(std::ldexp(std::frexp(x, &exponent), 53)));
    lowest = std::min(lowest, exponent - 53 + std::countr_zero(mantissa));
    highest = std::max(highest, exponent);
  }
  Grid grid;
  if (highest >= lowest) {
    grid.bits = highest - lowest;
    grid.exponent = lowest;
  }
  grid.decimals = decimals_of(numbers);
  return grid;
}

Column describe(std::string name, std::string kind, std::span<const double> numbers) {
  Column column{std::move(name), std::move(kind), 0, 0, {}};
  if (numbers.empty()) return column;
  const auto [least, greatest] = std::ranges::minmax(numbers);
  column.least = least;
  column.greatest = greatest;
  column.grid = grid_of(numbers);
  return column;
}

std::vector<Column> describe(const io::PointTable& points) {
  std::vector<Column> columns;
  const auto dimension = static_cast<std::size_t>(points.dimension);
  std::vector<double> numbers(points.size());
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    for (std::size_t row = 0; row < numbers.size(); ++row) numbers[row] = points.coordinates[row * dimension + axis];
    columns.push_back(describe(points.coordinate_names[axis], "coordinate", numbers));
  }
  if (!points.weights.empty()) columns.push_back(describe("(weight)", "weight", points.weights));
  for (const io::Attribute& attribute : points.attributes) {
    if (attribute.texts.empty()) {
      columns.push_back(describe(attribute.name, "number", attribute.numbers));
    } else {
      columns.push_back({attribute.name, "text", 0, 0, {}});
    }
  }
  return columns;
}

/// How many different positions there are.
std::size_t distinct_positions(const PointsView& points) {
  std::vector<std::size_t> rows(points.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::ranges::sort(
      rows, [&](std::size_t a, std::size_t b) { return std::ranges::lexicographical_compare(points[a], points[b]); });
  const auto repeated =
      std::ranges::unique(rows, [&](std::size_t a, std::size_t b) { return std::ranges::equal(points[a], points[b]); });
  return rows.size() - repeated.size();
}

std::string words(const Grid& grid) {
  std::string text = grid.decimals == 0 ? "integers, " : "";
  text += fmt::format("{} bit{}", grid.bits, grid.bits == 1 ? "" : "s");
  if (grid.exponent != 0) text += fmt::format(" x 2^{}", grid.exponent);
  if (grid.decimals.value_or(0) > 0)
    text += fmt::format(" ({} decimal{})", *grid.decimals, *grid.decimals == 1 ? "" : "s");
  return text;
}

std::string table(const std::vector<Column>& columns, std::size_t rows) {
  std::vector<std::array<std::string, 5>> lines{{"column", "kind", "least", "greatest", "numbers are"}};
  for (const Column& column : columns) {
    const bool numbers = column.kind != "text" && rows > 0;
    lines.push_back({column.name, column.kind, numbers ? fmt::format("{}", column.least) : "",
                     numbers ? fmt::format("{}", column.greatest) : "", numbers ? words(column.grid) : ""});
  }
  std::array<std::size_t, 5> width{};
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) width[i] = std::max(width[i], line[i].size());
  std::string text;
  for (const auto& line : lines) {
    std::string row = fmt::format("{:<{}}  {:<{}}  {:>{}}  {:>{}}  {}", line[0], width[0], line[1], width[1], line[2],
                                  width[2], line[3], width[3], line[4]);
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

Json to_json(const std::vector<Column>& columns, std::size_t rows) {
  Json list = Json::array();
  for (const Column& column : columns) {
    Json entry{{"name", column.name}, {"kind", column.kind}};
    if (column.kind != "text" && rows > 0) {
      entry["least"] = column.least;
      entry["greatest"] = column.greatest;
      entry["bits"] = column.grid.bits;
      entry["exponent"] = column.grid.exponent;
      entry["decimals"] = column.grid.decimals ? Json(*column.grid.decimals) : Json(nullptr);
    }
    list.push_back(std::move(entry));
  }
  return list;
}

int run(const Options& options) {
  io::ReadOptions reading = options.input.read_options();
  reading.attributes = true;
  const io::PointTable points = io::read_points(options.input.path, reading);
  const std::vector<Column> columns = describe(points);
  const std::size_t distinct = distinct_positions(points.view());
  const int affine = affine_dimension(points.view());
  if (options.json) {
    Json json;
    json["input"] = options.input.path;
    json["rows"] = points.size();
    json["dimension"] = points.dimension;
    json["affine_dimension"] = affine;
    json["weighted"] = !points.weights.empty();
    json["distinct_positions"] = distinct;
    json["duplicates"] = points.size() - distinct;
    json["columns"] = to_json(columns, points.size());
    print(to_text(json));
    return kDone;
  }
  const std::string coordinates =
      joined(points.coordinate_names) +
      (options.input.columns.empty() && points.dimension > 1 ? " (choose others with --columns)" : "");
  print(fmt::format("file              {}\nrows              {}\ncoordinates       {}\ndistinct          {}\n"
                    "duplicates        {}\naffine dimension  {}\n\n",
                    options.input.path, grouped(points.size()), coordinates, grouped(distinct),
                    grouped(points.size() - distinct), affine) +
        table(columns, points.size()));
  return kDone;
}

}  // namespace

void add_info(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "info", "What is in a file of points: rows, columns, ranges, duplicates, affine dimension, bits");
  add_point_input(*command, options->input, "FILE");
  command->add_flag("--json", options->json, "Print it as JSON");
  command->footer(
      "\"17 bits x 2^-8\": every number of the column is an integer of at most 17 bits, and a sign, divided by 2^8.\n"
      "\"(2 decimals)\": every number is the double nearest to a decimal with two digits after the "
      "point.\n\nExamples:\n"
      "  delone info cities.csv.gz --columns lon,lat\n"
      "  delone info points.npy --json");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
