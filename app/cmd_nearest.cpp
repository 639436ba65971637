// delone nearest: the nearest points, the k nearest, or all within a radius, of every query.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "delone/query/nearest.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "queries.hpp"

namespace delone::cli {
namespace {

struct Options {
  QueryInput input;
  std::size_t k = 1;
  std::optional<double> radius;
};

NeighbourLists one_each(const std::vector<Neighbour>& found) {
  NeighbourLists lists;
  for (const Neighbour& neighbour : found) {
    if (neighbour.row != kNone) {
      lists.rows.push_back(neighbour.row);
      lists.squared_distances.push_back(neighbour.squared_distance);
    }
    lists.offsets.push_back(lists.rows.size());
  }
  return lists;
}

/// The first k of each.
NeighbourLists shortened(const NeighbourLists& all, std::size_t k) {
  NeighbourLists lists;
  for (std::size_t query = 0; query < all.size(); ++query) {
    const std::size_t end = std::min(all.offsets[query + 1], all.offsets[query] + k);
    for (std::size_t i = all.offsets[query]; i < end; ++i) {
      lists.rows.push_back(all.rows[i]);
      lists.squared_distances.push_back(all.squared_distances[i]);
    }
    lists.offsets.push_back(lists.rows.size());
  }
  return lists;
}

NeighbourLists search(const QueryRun& run, const Options& options, bool k_given) {
  const DeferInterrupt defer;
  ProgressBar bar("searching");
  const QueryOptions how{.threads = run.threads, .progress = bar.callback()};
  if (options.radius) {
    const NeighbourLists all = within(run.triangulation, run.view(), *options.radius, how);
    return k_given ? shortened(all, options.k) : all;
  }
  if (options.k == 1) return one_each(nearest(run.triangulation, run.view(), how));
  return nearest(run.triangulation, run.view(), options.k, how);
}

int run(const Options& options, bool k_given) {
  if (options.radius && (!std::isfinite(*options.radius) || *options.radius < 0.0))
    throw UsageError("--within: expected a finite radius that is not negative");
  QueryRun run = begin_queries(options.input);
  const Stopwatch searching;
  const NeighbourLists lists = search(run, options, k_given);
  run.query_seconds = searching.seconds();
  if (interrupted() != 0) throw Cancelled();
  const Stopwatch writing;
  {
    const DeferInterrupt defer;  // a file that is begun is finished
    unless_nobody_reads(options.input.output, [&] {
      io::write_neighbours(options.input.output, run.format, lists, run.triangulation.weighted());
    });
  }
  run.write_seconds = writing.seconds();
  report_queries(options.input, run, {{"neighbours", lists.rows.size()}});
  return kDone;
}

}  // namespace

void add_nearest(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("nearest", "Find the nearest points of every query, exactly");
  add_query_input(*command, options->input);
  const auto* k = command->add_option("-k", options->k, "How many of each; 1 if not given, all with --within")
                      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40))
                      ->option_text("K");
  command->add_option("--within", options->radius, "Only those at a distance (with weights: power^1/2) of at most R")
      ->option_text("R");
  command->footer(
      "Answers in the order of the queries: query, row and distance (with weights the power |q - p|^2 - w), nearest\n"
      "first, equal distances by row. Rows are counted from 0. A row that repeats another counts by itself; with -k 1\n"
      "the lowest row answers. Rows hidden by their weight are never answers.\n\nExamples:\n"
      "  delone nearest cities.csv.gz places.csv --columns lon,lat -k 5\n"
      "  delone nearest points.npy queries.npy --within 0.1 -o pairs.npy");
  command->callback([options, k, &chosen] {
    const bool k_given = k->count() != 0;
    chosen = [options, k_given] { return run(*options, k_given); };
  });
}

}  // namespace delone::cli
