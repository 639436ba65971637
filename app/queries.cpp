#include "queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "delone/build/build.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"
#include "progress.hpp"

namespace delone::cli {
namespace {

io::QueryFormat format_of(const QueryInput& input) {
  if (!input.format.empty()) {
    if (const auto known = io::query_format(input.format)) return *known;
    throw UsageError("--format " + input.format + ": there is no such format; there are csv, npy");
  }
  if (input.output == "-") return io::QueryFormat::csv;
  if (const auto known = io::query_format_of_path(input.output)) return *known;
  throw UsageError(input.output + ": the extension names no format (or say --format); there are csv, npy");
}

void require_output(const QueryInput& input) {
  require_writable(input.output);
  if (input.output == "-") return;
  for (const std::string& read : {input.points.path, input.queries}) {
    std::error_code ignored;
    if (read != "-" && std::filesystem::equivalent(read, input.output, ignored))
      throw UsageError("-o " + input.output + " would replace the input " + read);
  }
}

std::string name_of(const std::string& path) { return path == "-" ? "standard input" : path; }

void require_same_dimension(const QueryInput& input, const io::PointTable& points, const io::PointTable& queries) {
  if (points.size() == 0 || queries.size() == 0 || points.dimension == queries.dimension) return;
  throw UsageError(
      fmt::format("{} holds points of dimension {}, but {} queries of dimension {}; choose coordinates with --columns "
                  "and --query-columns",
                  name_of(input.points.path), points.dimension, name_of(input.queries), queries.dimension));
}

}  // namespace

void add_query_input(CLI::App& command, QueryInput& input) {
  add_point_input(command, input.points, "POINTS");
  command.add_option("QUERIES", input.queries, "Points to ask about, in any of the same formats")
      ->required()
      ->option_text(" ");
  command.add_option("--query-columns", input.query_columns, "Columns of QUERIES, all numeric ones if not given")
      ->delimiter(',')
      ->expected(1, -1)
      ->allow_extra_args(false)
      ->option_text("COLUMN,...");
  command.add_option("--query-format", input.queries_format, "Read QUERIES as this format, whatever its extension")
      ->option_text("FORMAT");
  command.add_option("-o,--output", input.output, "Write the answers to this file, .csv or .npy; stdout if not given")
      ->option_text("OUTPUT");
  command.add_option("--format", input.format, "Write csv or npy, whatever the extension")->option_text("FORMAT");
  command.add_flag("--json", input.json, "Print the summary as JSON: to stdout, or to stderr when answers go there");
  command.add_flag("-q,--quiet", input.quiet, "No summary");
  add_threads(command, input.threads);
}

QueryRun begin_queries(const QueryInput& input) {
  if (input.points.path == "-" && input.queries == "-")
    throw UsageError("only one of POINTS and QUERIES can be standard input");
  const io::ReadOptions reading = input.points.read_options();
  PointInput query_input;
  query_input.format = input.queries_format;
  query_input.columns = input.query_columns;
  const io::ReadOptions query_reading = query_input.read_options();
  const io::QueryFormat format = format_of(input);
  require_output(input);

  const Stopwatch read;
  const io::PointTable points = io::read_points(input.points.path, reading);
  io::PointTable queries = io::read_points(input.queries, query_reading);
  require_same_dimension(input, points, queries);
  const double read_seconds = read.seconds();

  const Stopwatch triangulating;
  const DeferInterrupt defer;
  ProgressBar bar("triangulating");
  BuildOptions how;
  how.threads = thread_count(input.threads);
  how.progress = bar.callback();
  AnyTriangulation triangulation = points.size() != 0 || queries.size() == 0
                                       ? build(points.view(), how)
                                       : AnyTriangulation(queries.dimension, !points.weights.empty());
  if (interrupted() != 0) throw Cancelled();
  return {.triangulation = std::move(triangulation),
          .queries = std::move(queries),
          .format = format,
          .point_count = points.size(),
          .threads = how.threads,
          .read_seconds = read_seconds,
          .triangulate_seconds = triangulating.seconds()};
}

void report_queries(const QueryInput& input, const QueryRun& run,
                    const std::vector<std::pair<std::string, std::size_t>>& counts) {
  if (input.json) {
    Json json;
    json["version"] = DELONE_VERSION;
    json["points"] = input.points.path;
    json["queries"] = input.queries;
    json["rows"] = run.point_count;
    json["query_rows"] = run.queries.size();
    json["dimension"] = run.triangulation.dimension();
    json["affine_dimension"] = run.triangulation.affine_dimension();
    json["weighted"] = run.triangulation.weighted();
    for (const auto& [name, count] : counts) json[name] = count;
    json["threads"] = run.threads;
    json["seconds"] = {{"read", rounded(run.read_seconds)},
                       {"triangulate", rounded(run.triangulate_seconds)},
                       {"query", rounded(run.query_seconds)},
                       {"write", rounded(run.write_seconds)}};
    json["written"] = input.output;
    if (input.output != "-") return print(to_text(json));
    std::fputs(to_text(json).c_str(), stderr);
    return;
  }
  if (input.quiet) return;
  std::vector<std::pair<std::string, std::size_t>> lines{{"points", run.point_count}, {"queries", run.queries.size()}};
  lines.insert(lines.end(), counts.begin(), counts.end());
  std::size_t width = 0;
  for (const auto& [name, count] : lines) width = std::max(width, grouped(count).size());
  std::string text;
  for (auto& [name, count] : lines) {
    std::ranges::replace(name, '_', ' ');
    text += fmt::format("{:<12}  {:>{}}\n", name, grouped(count), width);
  }
  text += fmt::format("{:<12}  {:.2f} s (read {:.2f}, triangulate {:.2f}, query {:.2f}, write {:.2f})\n", "time",
                      run.read_seconds + run.triangulate_seconds + run.query_seconds + run.write_seconds,
                      run.read_seconds, run.triangulate_seconds, run.query_seconds, run.write_seconds);
  if (input.output != "-") text += fmt::format("{:<12}  {}\n", "wrote", input.output);
  std::fputs(text.c_str(), stderr);
}

}  // namespace delone::cli
