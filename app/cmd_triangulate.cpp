// delone triangulate: from a file of points to meshes, pictures and a summary.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "delone/apps/equiangular.hpp"
#include "delone/apps/furthest.hpp"
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
  std::string format, elevation, colour = "size", method = "automatic", order = "automatic", ties = "canonical";
  std::uint64_t seed = 1;
  int threads = 0;
  bool check = false, furthest = false, json = false, merged = false, quiet = false;
};

/// What is left of a triangulation once its numbers are in the summary.
struct Exported {
  CellTable cells;
  PolytopeTable merged;
  std::vector<std::string> row_status;
  std::vector<float> tone;
};

void require_elevation(const io::PointTable& points, const std::string& name) {
  if (name.empty()) return;
  if (points.dimension != 2)
    throw UsageError(
        fmt::format("--elevation {} lifts points of dimension 2, but these have dimension {}; choose their "
                    "coordinates with --columns",
                    name, points.dimension));
  static_cast<void>(number_column(points, "--elevation", name));
}

/// What can be refused before a file is read. @param dimension  0 when it is not known yet
void require_method(const Options& options, int dimension) {
  const Method method = method_named(options.method);
  if (options.colour == "age" &&
      (options.furthest || options.merged || options.ties != "canonical" || !options.elevation.empty()))
    throw UsageError(
        "--colour age is for the cells of a method: leave out --furthest, --merged, --ties and --elevation");
  if (options.furthest && options.ties != "canonical") throw UsageError("--furthest and --ties do not go together");
  if (options.furthest && (method != Method::automatic || options.order != "automatic"))
    throw UsageError("--furthest has a method of its own; leave out --method and --order");
  if (options.furthest && options.merged) throw UsageError("--furthest and --merged do not go together");
  if (options.furthest && !(options.input.weights.empty() && options.input.radii.empty()))
    throw UsageError("--furthest takes no weights");
  require_ordered(method, order_named(options.order));
  if (dimension != 0) require_served(method, dimension, !options.input.weights.empty() || !options.input.radii.empty());
}

/// Per cell when it came, from 0 to 1: with its newest vertex where points were inserted one by one, else in the order
/// in which the method made it.
std::vector<float> ages(const AnyTriangulation& t, Method method) {
  std::vector<std::pair<Index, std::size_t>> born;
  for (const CellId c : cell_ids(t)) {
    Index age = raw(c);
    if (method != Method::automatic && info(method).ordered) {
      age = 0;
      for (int i = 0; i < t.complex().corners(); ++i) age = std::max(age, raw(t.complex().vertex(c, i)));
    }
    born.emplace_back(age, born.size());
  }
  std::ranges::sort(born);
  std::vector<float> tone(born.size());
  for (std::size_t i = 0; i < born.size(); ++i)
    tone[born[i].second] = static_cast<float>(i) / static_cast<float>(std::max<std::size_t>(born.size() - 1, 1));
  return tone;
}

/// What can be refused before a file is read. @param dimension  0 when it is not known yet
void require_ties(const Options& options, int dimension, bool weighted) {
  if (options.ties == "canonical") return;
  if (dimension > 2 || dimension == 1)
    throw UsageError(
        fmt::format("--ties equiangular compares the angles of triangles: points have dimension 2, not {}", dimension));
  if (weighted)
    throw UsageError("--ties equiangular is for points without weights: cells with equal power have no common circle");
}

/// Builds, fills the summary, and lets the triangulation go before files are written: they need its memory.
Exported triangulate(const io::PointTable& points, const std::vector<Output>& outputs, const Options& options,
                     Summary& summary) {
  const DeferInterrupt defer;
  ProgressBar bar("triangulating");
  BuildOptions how;
  how.threads = summary.threads;
  how.progress = bar.callback();
  how.method = method_named(options.method);
  how.order = order_named(options.order);
  how.seed = options.seed;
  Exported result;
  if (options.furthest) {
    FurthestDelaunay furthest = furthest_delaunay(points.view(), how);
    count(furthest, summary);
    result.cells = std::move(furthest.cells);
    for (const RowStatus& row : furthest.status) result.row_status.emplace_back(word(row.status));
    return result;
  }
  const AnyTriangulation triangulation = build(points.view(), how);
  count(triangulation, summary);
  const Stopwatch exporting;
  if (options.check || !outputs.empty()) {
    const auto table = options.ties == "canonical" ? cells : equiangular_cells;
    result.cells = table(triangulation, want_neighbours(outputs));
  }
  if (!outputs.empty()) result.row_status = status_words(triangulation);
  if (options.colour == "age") {
    const bool inserts = how.order != Order::automatic || triangulation.weighted();
    result.tone = ages(triangulation, how.method == Method::automatic && inserts ? Method::cavity : how.method);
  }
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
                          .elevation = options.elevation,
                          .tone = exported.tone.empty() ? nullptr : &exported.tone};
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
  require_method(options, known);
  require_ties(options, known, !options.input.weights.empty() || !options.input.radii.empty());
  reading.attributes = !outputs.empty() || !options.elevation.empty();

  Summary summary;
  summary.input = options.input.path;
  summary.threads = thread_count(options.threads);
  summary.method = options.method;
  const Stopwatch read;
  const io::PointTable points = io::read_points(options.input.path, reading);
  summary.read_seconds = read.seconds();
  summary.rows = points.size();
  summary.dimension = points.dimension;
  summary.coordinate_names = points.coordinate_names;
  require_dimension(outputs, points.dimension);
  if (options.merged) require_merged(outputs, points.dimension);
  require_elevation(points, options.elevation);
  require_served(method_named(options.method), points.dimension, points.view().weighted());
  require_ties(options, points.dimension, points.view().weighted());

  const Exported exported = triangulate(points, outputs, options, summary);
  if (options.check) {
    const Stopwatch checking;
    CheckOptions how;
    how.canonical = options.ties == "canonical";
    how.furthest = options.furthest;
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
  command->add_option("--colour", options->colour, "Colour pictures by the size of cells, or by their age [size]")
      ->check(CLI::IsMember({"size", "age"}))
      ->option_text("size|age");
  command->add_option("--method", options->method, "How to build; all ways lead to the same cells [automatic]")
      ->option_text("METHOD");
  command->add_option("--order", options->order, "Order of insertion, where points are inserted one by one [automatic]")
      ->option_text("ORDER");
  command->add_option("--seed", options->seed, "Of a random order [1]")
      ->check(CLI::NonNegativeNumber)
      ->option_text("S");
  command
      ->add_option("--ties", options->ties,
                   "How polygons of cocircular points in the plane are cut: canonical, or equiangular, which makes the "
                   "sequence of angles largest [canonical]")
      ->check(CLI::IsMember({"canonical", "equiangular"}))
      ->option_text("TIES");
  command->add_flag("--furthest", options->furthest, "Cells whose circumscribing balls hold all points, not none");
  command->add_flag("--merged", options->merged, "Merge cells with a common circumscribing sphere");
  command->add_flag("--check", options->check, "Check the result with exact arithmetic; exit code 1 if it fails");
  command->add_flag("--json", options->json, "Print the summary as JSON: to stdout, or with -o - to stderr");
  command->add_flag("-q,--quiet", options->quiet, "No summary");
  add_threads(*command, options->threads);
  std::string names;
  for (const MethodInfo& method : methods()) names += fmt::format("  {:<18} {}\n", method.name, method.text);
  names += "\nOrders:\n";
  for (const OrderInfo& order : orders()) names += fmt::format("  {:<18} {}\n", order.name, order.text);
  command->footer(
      "Outputs: .vtu .ply .obj .off .node (with .ele and .neigh) .npy .csv .cells; in 2D also .geojson .svg .png\n"
      "COLUMN is a name, a number counted from 1, or last. Without --columns all numeric columns are coordinates, but\n"
      "for the weight.\n\nMethods:\n" +
      names +
      "\nExamples:\n"
      "  delone triangulate cities.csv.gz --columns lon,lat -o cities.png -o cities.vtu\n"
      "  delone triangulate survey.csv --columns x,y --elevation z -o terrain.ply\n"
      "  delone triangulate atoms.csv --columns x,y,z --radii radius --check --json\n"
      "  delone triangulate points.npy -o - | head");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
