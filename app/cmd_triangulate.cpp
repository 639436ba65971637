// delone triangulate: from a file of points to meshes, pictures and a summary.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "delone/build/build.hpp"
#include "delone/check/delaunay.hpp"
#include "delone/io/mesh_file.hpp"
#include "delone/mesh/export.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "summary.hpp"

namespace delone::cli {
namespace {

struct Options {
  PointInput input;
  std::vector<std::string> outputs;
  std::string format, elevation;
  int threads = 0;
  bool check = false, json = false, merged = false, quiet = false;
};

/// What is left of a triangulation once its numbers are in the summary.
struct Exported {
  CellTable cells;
  PolytopeTable merged;
  std::vector<std::string> row_status;
};

void require_elevation(const io::PointTable& points, const std::string& name) {
  if (name.empty()) return;
  if (points.dimension != 2)
    throw UsageError(
        fmt::format("--elevation {} lifts points of dimension 2, but these have dimension {}; choose their "
                    "coordinates with --columns",
                    name, points.dimension));
  std::vector<std::string> numeric;
  for (const io::Attribute& attribute : points.attributes) {
    if (attribute.numbers.empty() && !attribute.texts.empty()) {
      if (attribute.name == name) throw UsageError("--elevation " + name + ": this column holds text, not numbers");
      continue;
    }
    if (attribute.name == name) return;
    numeric.push_back(attribute.name);
  }
  throw UsageError(fmt::format("--elevation {}: no such column is left beside the coordinates; there {}", name,
                               numeric.empty() ? "is none" : "are " + joined(numeric)));
}

/// Builds, fills the summary, and lets the triangulation go before files are written: they need its memory.
Exported triangulate(const io::PointTable& points, const std::vector<Output>& outputs, const Options& options,
                     Summary& summary) {
  const DeferInterrupt defer;
  ProgressBar bar("triangulating");
  BuildOptions how;
  how.threads = summary.threads;
  how.progress = bar.callback();
  const AnyTriangulation triangulation = build(points.view(), how);
  count(triangulation, summary);

  Exported result;
  const Stopwatch exporting;
  if (options.check || !outputs.empty()) result.cells = cells(triangulation, want_neighbours(outputs));
  if (!outputs.empty()) result.row_status = status_words(triangulation);
  if (options.merged) {
    result.merged = merged_cells(triangulation);
    summary.merged_cells = result.merged.size();
  }
  summary.export_seconds = exporting.seconds();
  if (options.json) {
    const Stopwatch hashing;
    summary.canonical_hash = fmt::format("{:016x}", canonical_hash(triangulation));
    summary.hash_seconds = hashing.seconds();
  }
  if (interrupted() != 0) throw Cancelled();
  return result;
}

void write_outputs(const std::vector<Output>& outputs, const io::PointTable& points, const Exported& exported,
                   const Options& options, Summary& summary) {
  const io::MeshView mesh{.points = points,
                          .cells = exported.cells,
                          .affine_dimension = static_cast<std::size_t>(std::max(summary.affine_dimension, 0)),
                          .row_status = &exported.row_status,
                          .merged = options.merged ? &exported.merged : nullptr,
                          .elevation = options.elevation};
  summary.written = write_meshes(outputs, mesh);
}

void report(const Summary& summary, const Options& options) {
  const bool data_on_stdout = std::ranges::find(options.outputs, "-") != options.outputs.end();
  if (!options.json) {
    if (!options.quiet) std::fputs(to_words(summary).c_str(), stderr);
  } else if (data_on_stdout) {
    std::fputs(to_json_text(summary).c_str(), stderr);
  } else {
    print(to_json_text(summary));
  }
}

int run(const Options& options) {
  const Stopwatch total;
  io::ReadOptions reading = options.input.read_options();
  const std::vector<Output> outputs = plan_outputs(options.outputs, options.format, options.input.path);
  const int known =
      options.input.columns.empty() ? options.input.dimension : static_cast<int>(options.input.columns.size());
  require_dimension(outputs, known);
  if (options.merged) require_merged(outputs, known);
  reading.attributes = !outputs.empty() || !options.elevation.empty();

  Summary summary;
  summary.input = options.input.path;
  summary.threads = thread_count(options.threads);
  const Stopwatch read;
  const io::PointTable points = io::read_points(options.input.path, reading);
  summary.read_seconds = read.seconds();
  summary.rows = points.size();
  summary.dimension = points.dimension;
  summary.coordinate_names = points.coordinate_names;
  require_dimension(outputs, points.dimension);
  if (options.merged) require_merged(outputs, points.dimension);
  require_elevation(points, options.elevation);

  const Exported exported = triangulate(points, outputs, options, summary);
  if (options.check) {
    const Stopwatch checking;
    CheckOptions how;
    how.canonical = true;
    how.threads = summary.threads;
    summary.check = check(points.view(), exported.cells, how);
    summary.check_seconds = checking.seconds();
  }
  const bool good = !summary.check || summary.check->passed();
  if (good) write_outputs(outputs, points, exported, options, summary);
  summary.total_seconds = total.seconds();
  report(summary, options);
  if (good) return kDone;
  for (const std::string& violation : summary.check->violations) std::fprintf(stderr, "  %s\n", violation.c_str());
  std::fprintf(stderr, "delone: the exact check failed%s\n", outputs.empty() ? "" : "; no file was written");
  return kCheckFailed;
}

}  // namespace

void add_triangulate(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("triangulate", "Triangulate the points of a file; write meshes and pictures");
  add_point_input(*command, options->input, "INPUT");
  command
      ->add_option("-o,--output", options->outputs,
                   "Write this file, its format by its extension; - is stdout; -o again for more files")
      ->expected(1, -1)
      ->allow_extra_args(false)
      ->type_name("OUTPUT")
      ->option_text("OUTPUT");
  command
      ->add_option("--format", options->format,
                   "Write this format, whatever the extension; for -o - the usual one is cells")
      ->option_text("FORMAT");
  command
      ->add_option("--elevation", options->elevation, "Column that lifts 2D points in 3D formats and colours pictures")
      ->option_text("COLUMN");
  command->add_flag("--merged", options->merged, "Merge cells with a common circumscribing sphere");
  command->add_flag("--check", options->check, "Check the result with exact arithmetic; exit code 1 if it fails");
  command->add_flag("--json", options->json, "Print the summary as JSON: to stdout, or with -o - to stderr");
  command->add_flag("-q,--quiet", options->quiet, "No summary");
  add_threads(*command, options->threads);
  command->footer(
      "Outputs: .vtu .ply .obj .off .node (with .ele and .neigh) .npy .csv .cells; in 2D also .geojson .svg .png\n"
      "COLUMN is a name, a number counted from 1, or last. Without --columns all numeric columns are coordinates, but\n"
      "for the weight.\n\nExamples:\n"
      "  delone triangulate cities.csv.gz --columns lon,lat -o cities.png -o cities.vtu\n"
      "  delone triangulate survey.csv --columns x,y --elevation z -o terrain.ply\n"
      "  delone triangulate atoms.csv --columns x,y,z --radii radius --check --json\n"
      "  delone triangulate points.npy -o - | head");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
