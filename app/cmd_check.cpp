// delone check: is a list of cells, by whatever program, a Delaunay (regular) triangulation of the points?
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "delone/check/delaunay.hpp"
#include "delone/io/cells_file.hpp"
#include "report.hpp"

namespace delone::cli {
namespace {

struct Options {
  PointInput input;
  std::string cells, cells_format;
  int threads = 0;
  bool canonical = false, furthest = false, json = false;
};

std::string counts(const CheckReport& report) {
  return joined({counted(report.vertices, "vertex", "vertices"), counted(report.duplicates, "duplicate", "duplicates"),
                 grouped(report.hidden) + " hidden", counted(report.cells, "cell", "cells"),
                 counted(report.hull_facets, "hull facet", "hull facets")}) +
         fmt::format(", affine dimension {}", report.affine_dimension);
}

std::string words(const CheckReport& report) {
  if (report.passed()) return "valid: " + counts(report) + "\n";
  std::string text = "not valid: " + counted(report.violation_count, "violation", "violations") + "\n";
  for (const std::string& violation : report.violations) text += "  " + violation + "\n";
  if (report.violation_count > report.violations.size())
    text += fmt::format("  ... and {} more\n", grouped(report.violation_count - report.violations.size()));
  return text;
}

int run(const Options& options) {
  const Stopwatch reading;
  const io::PointTable points = io::read_points(options.input.path, options.input.read_options());
  if (options.input.path == "-" && options.cells == "-")
    throw UsageError("check: only one of POINTS and CELLS can be standard input");
  const CellTable cells = io::read_cells(options.cells, points.size(), options.cells_format);
  const double read_seconds = reading.seconds();

  const Stopwatch checking;
  CheckOptions how;
  how.canonical = options.canonical;
  how.furthest = options.furthest;
  how.threads = thread_count(options.threads);
  const CheckReport report = check(points.view(), cells, how);
  if (options.json) {
    Json json = to_json(report);
    json["rows"] = points.size();
    json["dimension"] = points.dimension;
    json["weighted"] = !points.weights.empty();
    json["canonical"] = options.canonical;
    json["seconds"] = {{"read", rounded(read_seconds)}, {"check", rounded(checking.seconds())}};
    print(to_text(json));
  } else {
    print(words(report));
  }
  return report.passed() ? kDone : kCheckFailed;
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "check", "Check with exact arithmetic that cells of any program are a Delaunay triangulation of points");
  add_point_input(*command, options->input, "POINTS");
  command
      ->add_option("CELLS", options->cells,
                   "Cells as rows of zero-based ids (.cells, .csv, .npy), or .ele, .vtu, .ply, .off, .obj or .geojson")
      ->required()
      ->option_text(" ");
  command->add_option("--cells-format", options->cells_format, "Read CELLS as this format, whatever its extension")
      ->option_text("FORMAT");
  command->add_flag("--furthest", options->furthest, "Of furthest sites: all points in every circumscribing ball");
  command->add_flag("--canonical", options->canonical, "Also demand Delone's own choice among cospherical ties");
  command->add_flag("--json", options->json, "Print the report as JSON");
  add_threads(*command, options->threads);
  command->footer(
      "Checked: positive volumes, matched facets, empty orthospheres, a convex hull covered once, no row unaccounted "
      "for.\n"
      "Exit code 0 when valid, 1 when not, 2 when a file cannot be read.\n\nExamples:\n"
      "  delone check points.csv cells.csv\n"
      "  delone check atoms.csv atoms.vtu --columns x,y,z --radii radius --canonical");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
