// delone edit: insert, remove and move points as a script says, and tell what became of each.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/io/edit_script.hpp"
#include "delone/mesh/export.hpp"
#include "delone/remove/move.hpp"
#include "delone/remove/remove.hpp"
#include "outputs.hpp"
#include "report.hpp"

namespace delone::cli {
namespace {

struct Options {
  PointInput input;
  std::string script;
  std::vector<std::string> outputs;
  std::string format;
  bool json = false, quiet = false;
};

/// What an operation did, in the words of the report.
struct Done {
  std::size_t line;
  const char* verb;
  Index row;
  std::string outcome;
};

Done carry_out(AnyTriangulation& t, const io::Operation& operation) {
  using Verb = io::Operation::Verb;
  switch (operation.verb) {
    case Verb::insert: {
      const Inserted inserted = insert(t, operation.point, operation.weight.value_or(0.0));
      return {operation.line, "insert", inserted.row, word(t.status(inserted.row).status)};
    }
    case Verb::move: {
      move(t, operation.row, operation.point, operation.weight);
      return {operation.line, "move", operation.row, word(t.status(operation.row).status)};
    }
    case Verb::remove:
      break;
  }
  const Removed removed = remove(t, operation.row);
  const std::string heir = removed.heir == kNone ? "" : fmt::format(", row {} takes its place", removed.heir);
  return {operation.line, "remove", operation.row, fmt::format("was {}{}", word(removed.was), heir)};
}

/// Carries out one operation after the other, up to the first that cannot be; `fault` says why.
std::vector<Done> carry_out(AnyTriangulation& t, const io::EditScript& script, std::string& fault) {
  std::vector<Done> done;
  for (const io::Operation& operation : script.operations) {
    try {
      done.push_back(carry_out(t, operation));
    } catch (const InputError& error) {
      fault = fmt::format("{}: line {}: {}", script.name, operation.line, error.what());
      return done;
    }
  }
  fault = script.fault;
  return done;
}

/// The points that are there, renumbered, with their rows so far as an attribute.
struct Remainder {
  io::PointTable points;
  CellTable cells;
  std::vector<std::string> row_status;
};

Remainder remainder_of(const AnyTriangulation& t, const std::vector<std::string>& coordinate_names) {
  Remainder rest;
  rest.points.dimension = t.dimension();
  rest.points.coordinate_names = coordinate_names;
  rest.points.attributes.push_back({"row", {}, {}});
  rest.cells = cells(t);
  std::vector<Index> position(t.row_count(), kNone);
  for (const Index row : t.present_rows()) {
    position[row] = static_cast<Index>(rest.points.size());
    const std::vector<double> point = t.point(row);
    rest.points.coordinates.insert(rest.points.coordinates.end(), point.begin(), point.end());
    if (t.weighted()) rest.points.weights.push_back(t.weight(row));
    rest.points.attributes.front().numbers.push_back(static_cast<double>(row));
    rest.row_status.emplace_back(word(t.status(row).status));
  }
  for (Index& row : rest.cells.vertices) row = position[row];
  return rest;
}

std::string to_words(const std::vector<Done>& done) {
  std::string text;
  for (const Done& d : done) text += fmt::format("line {}: {} row {}: {}\n", d.line, d.verb, d.row, d.outcome);
  return text;
}

Json to_json(const AnyTriangulation& t, const std::vector<Done>& done) {
  Json operations = Json::array();
  for (const Done& d : done) {
    operations.push_back({{"line", d.line}, {"operation", d.verb}, {"row", d.row}, {"outcome", d.outcome}});
  }
  return {{"rows", t.row_count()},
          {"removed", t.removed_count()},
          {"vertices", t.vertex_count()},
          {"duplicates", t.duplicate_count()},
          {"hidden", t.hidden_count()},
          {"cells", t.cell_count()},
          {"affine_dimension", t.affine_dimension()},
          {"canonical_hash", fmt::format("{:016x}", canonical_hash(t))},
          {"operations", std::move(operations)}};
}

void report(const Options& options, const AnyTriangulation& t, const std::vector<Done>& done) {
  const bool data_on_stdout = std::ranges::find(options.outputs, "-") != options.outputs.end();
  if (options.json || !options.quiet) {
    const std::string text = options.json ? to_text(to_json(t, done)) : to_words(done);
    data_on_stdout ? static_cast<void>(std::fputs(text.c_str(), stderr)) : print(text);
  }
  if (options.json || options.quiet) return;
  const std::string counts =
      joined({counted(t.vertex_count(), "vertex", "vertices"), counted(t.duplicate_count(), "duplicate", "duplicates"),
              grouped(t.hidden_count()) + " hidden", grouped(t.removed_count()) + " removed",
              counted(t.cell_count(), "cell", "cells")});
  std::fprintf(stderr, "%s: %s\n", counted(done.size(), "operation", "operations").c_str(), counts.c_str());
}

int run(const Options& options) {
  const std::vector<Output> outputs = plan_outputs(options.outputs, options.format, options.input.path);
  if (options.input.path == "-" && options.script == "-")
    throw UsageError("edit: only one of POINTS and the script can be standard input");
  const io::PointTable points = io::read_points(options.input.path, options.input.read_options());
  require_dimension(outputs, points.dimension);
  const io::EditScript script = io::read_edit_script(options.script, points.dimension, !points.weights.empty());

  AnyTriangulation t = build(points.view());
  std::string fault;
  const std::vector<Done> done = carry_out(t, script, fault);
  if (!outputs.empty()) {
    const Remainder rest = remainder_of(t, points.coordinate_names);
    write_meshes(outputs, {.points = rest.points,
                           .cells = rest.cells,
                           .affine_dimension = static_cast<std::size_t>(std::max(t.affine_dimension(), 0)),
                           .row_status = &rest.row_status,
                           .elevation = {}});
  }
  report(options, t, done);
  if (!fault.empty()) throw UsageError(fault + "; what stands before this line was done, and nothing after it");
  return kDone;
}

}  // namespace

void add_edit(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("edit", "Insert, remove and move points as a script says");
  add_point_input(*command, options->input, "POINTS");
  command->add_option("--script", options->script, "Lines: insert X Y .. [W], remove ROW, move ROW X Y .. [W]")
      ->required()
      ->option_text("FILE");
  command
      ->add_option("-o,--output", options->outputs,
                   "Write the result as this file, its format by its extension; -o again for more files")
      ->expected(1, -1)
      ->allow_extra_args(false)
      ->option_text("OUTPUT");
  command->add_option("--format", options->format, "Write this format, whatever the extension")->option_text("FORMAT");
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->add_flag("-q,--quiet", options->quiet, "No report");
  command->footer(
      "Rows are counted from 0; a new point gets the next number, and the row of a removed one is never used again.\n"
      "Outputs hold the points that are left, renumbered; their column row tells the numbers that scripts use.\n"
      "A line that cannot be carried out is named; what stands before it was done, nothing after it; exit code 2.\n\n"
      "Examples:\n"
      "  delone edit points.csv --script changes.txt -o after.vtu\n"
      "  echo 'remove 17' | delone edit cities.csv --columns lon,lat --script - -o cities.png");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
