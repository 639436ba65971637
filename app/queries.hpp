// What `delone nearest` and `delone locate` share: two files in, one file of answers out, a summary.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "delone/io/points_file.hpp"
#include "delone/io/query_file.hpp"
#include "delone/mesh/triangulation.hpp"
#include "report.hpp"

namespace delone::cli {

struct QueryInput {
  PointInput points;
  std::string queries, queries_format;
  std::vector<std::string> query_columns;
  std::string output = "-", format;
  int threads = 0;
  bool json = false, quiet = false;
};

void add_query_input(CLI::App& command, QueryInput& input);

/// A run so far: the points triangulated, the queries read.
struct QueryRun {
  AnyTriangulation triangulation;
  io::PointTable queries;
  io::QueryFormat format = io::QueryFormat::csv;
  std::size_t point_count = 0;
  int threads = 1;
  double read_seconds = 0, triangulate_seconds = 0, query_seconds = 0, write_seconds = 0;

  PointsView view() const { return PointsView(queries.coordinates, triangulation.dimension()); }
};

/// Reads both files and triangulates the points.
/// @throws UsageError when the dimensions differ or the output cannot be written; InputError; Cancelled
QueryRun begin_queries(const QueryInput& input);

/// Prints the summary: words to stderr, or JSON to stdout (stderr when the answers go there).
/// @param counts  what was found, by name
void report_queries(const QueryInput& input, const QueryRun& run,
                    const std::vector<std::pair<std::string, std::size_t>>& counts);

}  // namespace delone::cli
