// delone locate: in which cell, face or vertex every query lies.
#include <algorithm>
#include <memory>

#include "delone/query/locate.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "queries.hpp"

namespace delone::cli {
namespace {

std::vector<Location> search(const QueryRun& run) {
  const DeferInterrupt defer;
  ProgressBar bar("locating");
  return locate(run.triangulation, run.view(), {.threads = run.threads, .progress = bar.callback()});
}

int run(const QueryInput& input) {
  QueryRun run = begin_queries(input);
  const Stopwatch searching;
  const std::vector<Location> locations = search(run);
  run.query_seconds = searching.seconds();
  if (interrupted() != 0) throw Cancelled();
  const Stopwatch writing;
  {
    const DeferInterrupt defer;  // a file that is begun is finished
    const auto corners = static_cast<std::size_t>(run.triangulation.affine_dimension() + 1);
    unless_nobody_reads(input.output, [&] { io::write_locations(input.output, run.format, locations, corners); });
  }
  run.write_seconds = writing.seconds();
  const auto count = [&](Place place) {
    return static_cast<std::size_t>(std::ranges::count(locations, place, &Location::place));
  };
  report_queries(input, run,
                 {{"in_cells", count(Place::cell)},
                  {"on_faces", count(Place::face)},
                  {"at_vertices", count(Place::vertex)},
                  {"outside", count(Place::outside)}});
  return kDone;
}

}  // namespace

void add_locate(CLI::App& app, Command& chosen) {
  auto input = std::make_shared<QueryInput>();
  CLI::App* command = app.add_subcommand("locate", "Find the cell, face or vertex in which every query lies, exactly");
  add_query_input(*command, *input);
  command->footer(
      "Answers in the order of the queries: query, place and rows. The place is the face of lowest dimension that has\n"
      "the query: vertex, face (an edge, a triangle, ...), cell, or outside; the rows are those of its corners.\n"
      "In .npy every query has a row of its own, filled up with -1.\n\nExamples:\n"
      "  delone locate points.csv queries.csv\n"
      "  delone locate survey.csv grid.csv --columns x,y --query-columns x,y -o cells.npy");
  command->callback([input, &chosen] { chosen = [input] { return run(*input); }; });
}

}  // namespace delone::cli
