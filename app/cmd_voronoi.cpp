// delone voronoi: the cells of the points of a file, within a region, as files and pictures.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>

#include "command.hpp"
#include "delone/apps/capacity.hpp"
#include "delone/apps/furthest_voronoi.hpp"
#include "delone/apps/order_k.hpp"
#include "delone/apps/regions.hpp"
#include "delone/apps/relax.hpp"
#include "delone/build/build.hpp"
#include "delone/dual/clip.hpp"
#include "delone/io/diagram_file.hpp"
#include "delone/io/region_file.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "report.hpp"

namespace delone::cli {
namespace {

struct Options {
  PointInput input;
  std::vector<std::string> outputs;
  std::string format, clip = "box", colour = "size", capacity;
  int threads = 0, width = 1600, order = 0, relax = 0;
  bool furthest = false, json = false, quiet = false;

  bool weighted() const { return !input.weights.empty() || !input.radii.empty(); }
  bool clips_by_file() const { return clip != "box" && clip != "hull" && !clip_numbers(); }
  /// x0, y0, x1, y1 or x0, y0, z0, x1, y1, z1, where the region is told by numbers.
  std::optional<std::vector<double>> clip_numbers() const;
};

struct DiagramOutput {
  std::string path;
  io::DiagramFormat format;
};

/// Cells on their way from the points to the files.
struct Diagram {
  std::string kind = "voronoi";
  io::PointTable points;
  double region = 0;
  CellShapes shapes;  ///< none when nothing is to be written
  CellMeasures measures;
  std::vector<std::string> row_status;
  PolytopeTable subsets;
  std::optional<Relaxed> relaxed;
  std::optional<Capacities> capacities;
};

/// How long each phase took, in the order in which they ended.
class Phases {
 public:
  void end(const std::string& name) { seconds_.emplace_back(name, watch_.lap()); }
  double total() const {
    double sum = 0;
    for (const auto& [name, seconds] : seconds_) sum += seconds;
    return sum;
  }
  std::string to_words() const {
    std::vector<std::string> words;
    for (const auto& [name, seconds] : seconds_) words.push_back(fmt::format("{} {:.2f}", name, seconds));
    return fmt::format("{:.2f} s ({})", total(), joined(words));
  }
  Json to_json() const {
    Json json;
    for (const auto& [name, seconds] : seconds_) json[name] = rounded(seconds);
    json["total"] = rounded(total());
    return json;
  }

 private:
  Stopwatch watch_;
  std::vector<std::pair<std::string, double>> seconds_;
};

std::optional<std::vector<double>> Options::clip_numbers() const {
  std::vector<double> numbers;
  for (const std::string& part : CLI::detail::split(clip, ',')) {
    double number = 0;
    if (!CLI::detail::lexical_cast(part, number)) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

// --- before any file is read

io::DiagramFormat format_of(const std::string& path, const std::string& format) {
  constexpr const char* kFormats = "vtu, geojson, svg, png, csv";
  if (!format.empty()) {
    if (const auto known = io::diagram_format(format)) return *known;
    throw UsageError("--format " + format + ": there is no such format; there are " + kFormats);
  }
  if (path == "-") return io::DiagramFormat::csv;
  if (const auto known = io::diagram_format_of_path(path)) return *known;
  throw UsageError(path + ": the extension names no format (or say --format); there are " + kFormats);
}

std::vector<DiagramOutput> plan(const Options& options) {
  std::vector<DiagramOutput> outputs;
  std::vector<Target> targets;
  for (const std::string& path : options.outputs) {
    outputs.push_back({path, format_of(path, options.format)});
    targets.push_back({path, {path}});
  }
  std::vector<std::string> inputs{options.input.path};
  if (options.clips_by_file()) inputs.push_back(options.clip);
  if (inputs.size() == 2 && inputs[0] == "-" && inputs[1] == "-")
    throw UsageError("only one of POINTS and --clip can be standard input");
  require_apart(targets, inputs);
  // Standard output last: whoever reads it sees the files complete when it ends.
  std::ranges::stable_partition(outputs, [](const DiagramOutput& output) { return output.path != "-"; });
  return outputs;
}

/// The box that --clip tells by numbers.
std::optional<Region> clip_box(const Options& options) {
  const auto numbers = options.clip_numbers();
  if (!numbers) return std::nullopt;
  if (numbers->size() != 4 && numbers->size() != 6)
    throw UsageError("--clip " + options.clip + ": expected x0,y0,x1,y1, or in space x0,y0,z0,x1,y1,z1");
  const std::span<const double> corners(*numbers);
  try {
    return Region::box(corners.first(corners.size() / 2), corners.last(corners.size() / 2));
  } catch (const InputError& error) {
    throw UsageError("--clip " + options.clip + ": " + error.what());
  }
}

/// @param dimension  0 when it is not known yet
void require_dimension(const std::vector<DiagramOutput>& outputs, const Options& options,
                       const std::optional<Region>& box, int dimension) {
  if (dimension == 0 && box) dimension = box->dimension();
  if (dimension != 0 && dimension != 2 && dimension != 3)
    throw UsageError(fmt::format("cells have dimension 2 or 3, not {}; choose coordinates with --columns", dimension));
  if (box && box->dimension() != dimension)
    throw UsageError(fmt::format("--clip {}: a box of dimension {}, but the points have dimension {}", options.clip,
                                 box->dimension(), dimension));
  for (const DiagramOutput& output : outputs) {
    if (dimension == 3 && !io::holds_space(output.format))
      throw UsageError("-o " + output.path + ": this format shows cells of the plane; write .vtu or .csv");
  }
}

/// @param dimension  0 when it is not known yet
void require_kind(const Options& options, int dimension) {
  std::vector<std::string> kinds;
  if (options.furthest) kinds.emplace_back("--furthest");
  if (options.order != 0) kinds.emplace_back("--order");
  if (!options.capacity.empty()) kinds.emplace_back("--capacity");
  if (kinds.size() > 1) throw UsageError(joined(kinds, " and ") + " do not go together");
  if (options.relax != 0) kinds.emplace_back("--relax");
  if (!kinds.empty() && options.weighted()) throw UsageError(kinds.front() + " takes no weights");
  if (options.order != 0 && dimension == 3) throw UsageError("--order makes cells of the plane, not of space");
  if (options.order != 0 && options.colour != "size")
    throw UsageError("--colour " + options.colour + ": cells of --order belong to several rows; leave one of them out");
}

// --- the region

bool is_solid(const std::string& path) {
  return std::ranges::any_of(std::array{".off", ".obj", ".ply"}, [&](const std::string& extension) {
    return path.ends_with(extension) || path.ends_with(extension + ".gz");
  });
}

Region hull_of(PointsView points, int threads) {
  ProgressBar bar("finding the hull");
  return hull_region(points, {.threads = threads, .progress = bar.callback()});
}

Region region_of(const Options& options, const std::optional<Region>& box, const io::PointTable& points, int threads) {
  if (box) return *box;
  if (!options.clips_by_file() && points.size() == 0)
    throw UsageError((options.input.path == "-" ? "standard input" : options.input.path) +
                     " holds no points; say --clip x0,y0,x1,y1 or --clip FILE");
  if (options.clip == "box") return region_around(points.view());
  if (options.clip == "hull") return hull_of(points.view(), threads);
  if (!is_solid(options.clip)) return io::read_region(options.clip, points.dimension);
  return hull_of(io::read_points(options.clip, {.dimension = points.dimension}).view(), threads);
}

// --- the cells

AnyTriangulation triangulate(const io::PointTable& points, int threads) {
  ProgressBar bar("triangulating");
  BuildOptions how;
  how.threads = threads;
  how.progress = bar.callback();
  return build(points.view(), how);
}

/// Voronoi cells, or with weights power cells. Without shapes measuring takes less memory.
void cut_triangulation(Diagram& diagram, const Region& region, bool shapes, int threads, Phases& phases) {
  const AnyTriangulation t = triangulate(diagram.points, threads);
  phases.end("triangulate");
  if (t.weighted()) diagram.kind = "power";
  diagram.row_status = status_words(t);
  ProgressBar bar("cutting cells");
  const ClipOptions how{.threads = threads, .progress = bar.callback()};
  if (shapes) {
    diagram.shapes = clipped_cells(t, region, how);
    diagram.measures = measure_shapes(diagram.shapes, diagram.points.view());
  } else {
    diagram.measures = measure_cells(t, region, how);
  }
  phases.end("cells");
}

/// Sites of cells that belong to several rows: the means of those.
std::vector<double> means(const io::PointTable& points, const PolytopeTable& subsets) {
  std::vector<double> sites;
  for (std::size_t cell = 0; cell < subsets.size(); ++cell) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double sum = 0;
      for (const Index row : subsets[cell]) sum += points.coordinates[2 * row + axis];
      sites.push_back(sum / static_cast<double>(subsets[cell].size()));
    }
  }
  return sites;
}

void cut_order(Diagram& diagram, const Region& region, int k, int threads, Phases& phases) {
  ProgressBar bar(fmt::format("finding cells of order {}", k));
  const OrderK cells = order_k_voronoi(diagram.points.view(), k, {.progress = bar.callback()});
  phases.end("order");
  diagram.kind = fmt::format("order {}", k);
  diagram.row_status.assign(diagram.points.size(), "vertex");
  diagram.subsets.vertices = cells.subsets;
  for (std::size_t cell = 1; cell <= cells.size(); ++cell)
    diagram.subsets.offsets.push_back(cell * static_cast<std::size_t>(k));
  diagram.shapes = cut_cells(diagram.points.view(), region, cells.offsets, cells.borders, {.threads = threads});
  diagram.measures = measure_shapes(diagram.shapes, PointsView(means(diagram.points, diagram.subsets), 2));
  phases.end("cells");
}

void cut_furthest(Diagram& diagram, const Region& region, int threads, Phases& phases) {
  ProgressBar bar("finding what is furthest");
  BuildOptions how;
  how.threads = threads;
  how.progress = bar.callback();
  const FurthestVoronoi cells = furthest_voronoi(diagram.points.view(), how);
  phases.end("furthest");
  diagram.kind = "furthest";
  diagram.row_status.assign(diagram.points.size(), "hidden");
  std::vector<double> sites;
  for (const Index row : cells.rows) {
    diagram.row_status[row] = "vertex";
    std::ranges::copy(diagram.points.view()[row], std::back_inserter(sites));
  }
  diagram.shapes = cut_cells(diagram.points.view(), region, cells.offsets, cells.cuts, {.threads = threads});
  diagram.measures = measure_shapes(diagram.shapes, PointsView(sites, diagram.points.dimension));
  diagram.shapes.rows = cells.rows;
  phases.end("cells");
}

void relax_points(Diagram& diagram, const Region& region, int steps, int threads, Phases& phases) {
  ProgressBar bar("relaxing");
  diagram.relaxed =
      relax(diagram.points.view(), region, {.steps = steps, .threads = threads, .progress = bar.callback()});
  diagram.points.coordinates = diagram.relaxed->coordinates;
  phases.end("relax");
}

/// Weights with which the cells share the region out in proportion to a column.
void fit_weights(Diagram& diagram, const Region& region, const std::string& column, int threads, Phases& phases) {
  std::vector<double> wanted = number_column(diagram.points, "--capacity", column).numbers;
  const double share = region.measure() / std::accumulate(wanted.begin(), wanted.end(), 0.0);
  for (double& measure : wanted) measure *= share;
  ProgressBar bar("fitting weights");
  diagram.capacities =
      fit_capacities(diagram.points.view(), region, wanted, {.threads = threads, .progress = bar.callback()});
  diagram.points.weights = diagram.capacities->weights;
  phases.end("fit");
}

Diagram make(io::PointTable points, const Options& options, const std::optional<Region>& box, Phases& phases) {
  const DeferInterrupt defer;
  const int threads = thread_count(options.threads);
  Diagram diagram;
  diagram.points = std::move(points);
  const Region region = region_of(options, box, diagram.points, threads);
  diagram.region = region.measure();
  phases.end("region");
  if (options.relax != 0) relax_points(diagram, region, options.relax, threads, phases);
  if (!options.capacity.empty()) fit_weights(diagram, region, options.capacity, threads, phases);
  if (options.order != 0) {
    cut_order(diagram, region, options.order, threads, phases);
  } else if (options.furthest) {
    cut_furthest(diagram, region, threads, phases);
  } else {
    cut_triangulation(diagram, region, !options.outputs.empty(), threads, phases);
  }
  if (interrupted() != 0) throw Cancelled();
  return diagram;
}

/// Per cell the rank of its row's number among all, from 0 to 1: equal numbers have equal tones.
std::vector<float> ranks(const std::vector<double>& numbers, const std::vector<Index>& rows) {
  std::vector<double> sorted = numbers;
  std::ranges::sort(sorted);
  std::vector<float> tones;
  for (const Index row : rows) {
    const auto below = std::ranges::lower_bound(sorted, numbers[row]) - sorted.begin();
    tones.push_back(static_cast<float>(below) / static_cast<float>(std::max<std::size_t>(sorted.size() - 1, 1)));
  }
  return tones;
}

std::vector<Written> write(const std::vector<DiagramOutput>& outputs, const Diagram& diagram, const Options& options) {
  std::vector<float> tone;
  if (options.colour != "size" && !outputs.empty())
    tone = ranks(number_column(diagram.points, "--colour", options.colour).numbers, diagram.shapes.rows);
  const io::DiagramView view{.points = diagram.points,
                             .shapes = diagram.shapes,
                             .measures = diagram.measures,
                             .row_status = &diagram.row_status,
                             .tone = tone.empty() ? nullptr : &tone,
                             .subsets = diagram.subsets.size() == 0 ? nullptr : &diagram.subsets};
  std::vector<Written> all;
  for (const DiagramOutput& output : outputs) {
    all.push_back(write_one(output.path, [&] {
      io::write_diagram(output.path, output.format, view, {.width = options.width});
      return std::vector{output.path};
    }));
  }
  return all;
}

// --- the summary

struct Counts {
  std::size_t cells = 0, empty = 0;
  double sum = 0, least = 0, greatest = 0, mean_neighbours = 0;
};

Counts count(const Diagram& diagram) {
  const CellMeasures& measures = diagram.measures;
  Counts counts;
  for (const double volume : measures.volume) {
    if (volume <= 0) continue;
    counts.sum += volume;
    counts.least = counts.cells == 0 ? volume : std::min(counts.least, volume);
    counts.greatest = std::max(counts.greatest, volume);
    ++counts.cells;
  }
  counts.empty = (diagram.subsets.size() == 0 ? diagram.points.size() : measures.size()) - counts.cells;
  const auto divisor = static_cast<double>(std::max<std::size_t>(counts.cells, 1));
  counts.mean_neighbours = static_cast<double>(measures.neighbours.size()) / divisor;
  return counts;
}

/// What relaxing and fitting came to.
std::string remarks(const Diagram& diagram) {
  std::string text;
  if (diagram.relaxed && !diagram.relaxed->moved.empty())
    text += fmt::format("relaxed     {}; the last moved a point by {:.3g}\n",
                        counted(diagram.relaxed->moved.size(), "step", "steps"), diagram.relaxed->moved.back());
  if (diagram.capacities)
    text += fmt::format("fitted      {}; the largest error is {:.2g} of the mean{}\n",
                        counted(static_cast<std::uint64_t>(diagram.capacities->steps), "step", "steps"),
                        diagram.capacities->error, diagram.capacities->converged ? "" : ": NOT CONVERGED");
  return text;
}

std::string to_words(const Diagram& diagram, const std::vector<Written>& written, const Phases& phases) {
  const Counts counts = count(diagram);
  const bool plane = diagram.measures.dimension == 2;
  std::string text = fmt::format(
      "points      {}  {} dimensions{}\ncells       {}\nempty       {}\n{}{:.12g} in cells, {:.12g} in the region\n"
      "neighbours  {:.4g} a cell\n{}time        {}\n",
      grouped(diagram.points.size()), diagram.points.dimension, diagram.points.weights.empty() ? "" : "; weighted",
      grouped(counts.cells), grouped(counts.empty), plane ? "area        " : "volume      ", counts.sum, diagram.region,
      counts.mean_neighbours, remarks(diagram), phases.to_words());
  for (const Written& one : written)
    if (one.path != "-") text += "wrote       " + one.path + "\n";
  return text;
}

Json to_json(const Diagram& diagram, const Options& options, const std::vector<Written>& written,
             const Phases& phases) {
  const Counts counts = count(diagram);
  Json json;
  json["version"] = DELONE_VERSION;
  json["input"] = options.input.path;
  json["clip"] = options.clip;
  json["diagram"] = diagram.kind;
  json["rows"] = diagram.points.size();
  json["dimension"] = diagram.points.dimension;
  json["cells"] = counts.cells;
  json["empty"] = counts.empty;
  json["region_measure"] = diagram.region;
  json["cells_measure"] = counts.sum;
  json["least_measure"] = counts.least;
  json["greatest_measure"] = counts.greatest;
  json["mean_neighbours"] = counts.mean_neighbours;
  if (diagram.relaxed) json["relax"] = {{"moved", diagram.relaxed->moved}, {"energy", diagram.relaxed->energy}};
  if (diagram.capacities)
    json["capacity"] = {{"steps", diagram.capacities->steps},
                        {"error", diagram.capacities->error},
                        {"converged", diagram.capacities->converged}};
  json["threads"] = thread_count(options.threads);
  json["seconds"] = phases.to_json();
  json["written"] = Json::array();
  for (const Written& one : written)
    json["written"].push_back({{"output", one.path}, {"seconds", rounded(one.seconds)}});
  return json;
}

int run(const Options& options) {
  Phases phases;
  io::ReadOptions reading = options.input.read_options();
  const std::vector<DiagramOutput> outputs = plan(options);
  const std::optional<Region> box = clip_box(options);
  const int known =
      options.input.columns.empty() ? options.input.dimension : static_cast<int>(options.input.columns.size());
  require_dimension(outputs, options, box, known);
  require_kind(options, known);
  reading.attributes = !outputs.empty() || options.colour != "size" || !options.capacity.empty();
  io::PointTable points = io::read_points(options.input.path, reading);
  phases.end("read");
  require_dimension(outputs, options, box, points.dimension);
  require_kind(options, points.dimension);
  if (options.colour != "size") static_cast<void>(number_column(points, "--colour", options.colour));
  if (!options.capacity.empty()) static_cast<void>(number_column(points, "--capacity", options.capacity));

  const Diagram diagram = make(std::move(points), options, box, phases);
  const std::vector<Written> written = write(outputs, diagram, options);
  if (!outputs.empty()) phases.end("write");
  const bool data_on_stdout = std::ranges::find(options.outputs, "-") != options.outputs.end();
  if (options.json) {
    const std::string text = to_text(to_json(diagram, options, written, phases));
    data_on_stdout ? static_cast<void>(std::fputs(text.c_str(), stderr)) : print(text);
  } else if (!options.quiet) {
    std::fputs(to_words(diagram, written, phases).c_str(), stderr);
  }
  return diagram.capacities && !diagram.capacities->converged ? kCheckFailed : kDone;
}

}  // namespace

void add_voronoi(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("voronoi", "Voronoi and power cells within a region: shapes, areas, pictures");
  add_point_input(*command, options->input, "POINTS");
  command
      ->add_option("--clip", options->clip,
                   "The region: box, a tenth wider than the points; hull; x0,y0,x1,y1; or a file of rings or "
                   "half-spaces [box]")
      ->option_text("REGION");
  command
      ->add_option("-o,--output", options->outputs,
                   "Write the cells to this file, its format by its extension; - is stdout; -o again for more files")
      ->expected(1, -1)
      ->allow_extra_args(false)
      ->type_name("OUTPUT")
      ->option_text("OUTPUT");
  command
      ->add_option("--format", options->format,
                   "Write this format, whatever the extension; for -o - the usual one is csv")
      ->option_text("FORMAT");
  command->add_flag("--furthest", options->furthest, "Cells of what is furthest, not nearest");
  command
      ->add_option("--order", options->order, "Cells of the places that have the same K nearest points, in the plane")
      ->check(CLI::Range(1, 1 << 20))
      ->option_text("K");
  command->add_option("--relax", options->relax, "First move each point to the centroid of its cell, N times")
      ->check(CLI::Range(1, 1 << 20))
      ->option_text("N");
  command
      ->add_option("--capacity", options->capacity,
                   "Power cells that share the region out in proportion to this column; exit code 1 if none are found")
      ->option_text("COLUMN");
  command->add_option("--colour", options->colour, "Colour pictures by the size of cells, or by a column [size]")
      ->option_text("size|COLUMN");
  command->add_option("--width", options->width, "Of pictures, in pixels [1600]")
      ->check(CLI::Range(16, 16384))
      ->option_text("PIXELS");
  command->add_flag("--json", options->json, "Print the summary as JSON: to stdout, or with -o - to stderr");
  command->add_flag("-q,--quiet", options->quiet, "No summary");
  add_threads(*command, options->threads);
  command->footer(
      "Outputs: .vtu .csv; in 2D also .geojson .svg .png. With weights cells are those of the power diagram.\n"
      "A region in a file: rings as text (ring, ..., x, y) or GeoJSON; half-spaces under a header a,b,d or a,b,c,d\n"
      "(a x + b y + c z <= d); or the hull of an .off, .obj or .ply. Its rings count by even and odd.\n\nExamples:\n"
      "  delone voronoi cities.csv.gz --columns lon,lat -o cells.png\n"
      "  delone voronoi shops.csv --columns x,y --clip town.geojson -o shops.geojson --colour turnover\n"
      "  delone voronoi atoms.csv --columns x,y,z --radii radius --clip hull -o atoms.vtu\n"
      "  delone voronoi points.csv --clip 0,0,1,1 -o - | head\n"
      "  delone voronoi shops.csv --columns x,y --capacity turnover -o shares.svg");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
