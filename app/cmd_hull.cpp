// delone hull: the convex hull of the points of a file.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "delone/apps/hull.hpp"
#include "delone/io/mesh_file.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "report.hpp"

namespace delone::cli {
namespace {

struct Options {
  PointInput input;
  std::vector<std::string> outputs;
  std::string format;
  int threads = 0;
  bool json = false, merged = false, quiet = false;
};

struct Times {
  double read = 0, hull = 0, total = 0;
};

ConvexHull hull_of(const io::PointTable& points, int threads) {
  const DeferInterrupt defer;
  ProgressBar bar("finding the hull");
  HullOptions how;
  how.threads = threads;
  how.progress = bar.callback();
  ConvexHull hull = convex_hull(points.view(), how);
  if (interrupted() != 0) throw Cancelled();
  return hull;
}

/// Corners are the vertices of the facets; what is none is hidden by them.
std::vector<std::string> status_words(std::size_t rows, const ConvexHull& hull) {
  std::vector<std::string> words(rows, word(Status::hidden));
  for (const Index row : hull.corners) words[row] = word(Status::vertex);
  return words;
}

std::string to_words(const io::PointTable& points, const ConvexHull& hull, const Times& times) {
  const std::string flat = hull.affine_dimension < points.dimension
                               ? fmt::format("; all in a flat of dimension {}", hull.affine_dimension)
                               : "";
  return fmt::format(
      "points   {}  {} dimension{}{}\ncorners  {}\nfacets   {}\nfaces    {}\nvolume   {:.12g}\narea     {:.12g}\n"
      "time     {:.2f} s (read {:.2f}, hull {:.2f})\n",
      grouped(points.size()), points.dimension, points.dimension == 1 ? "" : "s", flat, grouped(hull.corners.size()),
      grouped(hull.facets.size()), grouped(hull.faces.size()), hull.volume, hull.area, times.total, times.read,
      times.hull);
}

Json to_json(const io::PointTable& points, const ConvexHull& hull, const Times& times) {
  Json json;
  json["version"] = DELONE_VERSION;
  json["rows"] = points.size();
  json["dimension"] = points.dimension;
  json["affine_dimension"] = hull.affine_dimension;
  json["corners"] = hull.corners.size();
  json["facets"] = hull.facets.size();
  json["faces"] = hull.faces.size();
  json["volume"] = hull.volume;
  json["area"] = hull.area;
  json["seconds"] = {{"read", rounded(times.read)}, {"hull", rounded(times.hull)}, {"total", rounded(times.total)}};
  return json;
}

void require_outputs(const std::vector<Output>& outputs, const Options& options, int dimension) {
  require_dimension(outputs, dimension);
  if (options.merged) require_merged(outputs, kMaxDimension);  // faces are no polygons of a plane
}

int run(const Options& options) {
  const Stopwatch total;
  const io::ReadOptions reading = options.input.read_options();
  const std::vector<Output> outputs = plan_outputs(options.outputs, options.format, options.input.path);
  require_outputs(outputs, options, 0);
  const Stopwatch watch;
  const io::PointTable points = io::read_points(options.input.path, reading);
  Times times{.read = watch.seconds()};
  require_outputs(outputs, options, points.dimension);

  const Stopwatch finding;
  const ConvexHull hull = hull_of(points, thread_count(options.threads));
  times.hull = finding.seconds();
  const std::vector<std::string> status = status_words(points.size(), hull);
  write_meshes(outputs,
               io::MeshView{.points = points,
                            .cells = hull.facets,
                            .affine_dimension = static_cast<std::size_t>(std::max(hull.affine_dimension - 1, 0)),
                            .row_status = &status,
                            .merged = options.merged ? &hull.faces : nullptr,
                            .elevation = {}});
  times.total = total.seconds();
  const bool data_on_stdout = std::ranges::find(options.outputs, "-") != options.outputs.end();
  if (options.json) {
    const std::string text = to_text(to_json(points, hull, times));
    data_on_stdout ? static_cast<void>(std::fputs(text.c_str(), stderr)) : print(text);
  } else if (!options.quiet) {
    std::fputs(to_words(points, hull, times).c_str(), stderr);
  }
  return kDone;
}

}  // namespace

void add_hull(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("hull", "The convex hull of the points of a file: corners, facets, measures");
  add_point_input(*command, options->input, "INPUT");
  command
      ->add_option("-o,--output", options->outputs,
                   "Write the facets to this file, its format by its extension; - is stdout; -o again for more files")
      ->expected(1, -1)
      ->allow_extra_args(false)
      ->type_name("OUTPUT")
      ->option_text("OUTPUT");
  command->add_option("--format", options->format, "Write this format, whatever the extension")->option_text("FORMAT");
  command->add_flag("--merged", options->merged, "Merge facets of one hyperplane to faces");
  command->add_flag("--json", options->json, "Print the summary as JSON: to stdout, or with -o - to stderr");
  command->add_flag("-q,--quiet", options->quiet, "No summary");
  add_threads(*command, options->threads);
  command->footer(
      "Corners are the extreme points; what lies within a face or an edge is none. Weights do not matter.\n"
      "Outputs are those of delone triangulate; merged faces want .cells or .csv.\n\nExamples:\n"
      "  delone hull cities.csv.gz --columns lon,lat -o hull.svg\n"
      "  delone hull scan.ply -o hull.off --json\n"
      "  delone hull points.npy -o - --merged | head");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
