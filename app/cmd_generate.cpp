// delone generate: points to try things with.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "command.hpp"
#include "delone/io/generate.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"

namespace delone::cli {
namespace {

struct Options {
  std::string kind, count, output = "-";
  int dimension = 0, bits = 0;
  std::uint64_t seed = 1;
  bool list = false;
};

/// Whole numbers, also as 1e6.
std::size_t parse_count(const std::string& text) {
  double number = -1;
  if (!CLI::detail::lexical_cast(text, number) || !(number >= 0 && number <= 1e15) || number != std::floor(number))
    throw UsageError("-n " + text + ": expected how many points, such as 1000 or 1e6");
  return static_cast<std::size_t>(number);
}

int list_kinds() {
  std::string text;
  for (const std::string& name : io::kinds()) {
    const io::KindInfo info = io::kind_info(name);
    const std::string dimensions = info.least_dimension == info.most_dimension
                                       ? fmt::format("{}D", info.least_dimension)
                                       : fmt::format("{}D to {}D", info.least_dimension, info.most_dimension);
    text += fmt::format("{:<12} {:<9}  {}\n", name, dimensions, info.text);
  }
  print(text);
  return kDone;
}

int run(const Options& options) {
  if (options.list) return list_kinds();
  if (options.kind.empty()) throw UsageError("generate: which kind of points? There are " + joined(io::kinds()));
  if (options.count.empty()) throw UsageError("generate: how many points? Say -n N");
  if (!io::is_points_path(options.output))
    throw UsageError(options.output + ": points are written as .csv, .txt or .npy");
  const std::size_t count = parse_count(options.count);
  require_writable(options.output);
  const io::Generated points = io::generate(options.kind, count, options.dimension, options.seed, options.bits);
  const DeferInterrupt defer;
  unless_nobody_reads(options.output, [&] { io::write_points(options.output, points); });
  return kDone;
}

}  // namespace

void add_generate(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("generate", "Make points to try things with: random, degenerate, worst cases");
  command->add_option("KIND", options->kind, "What kind of points; --list tells them")->option_text(" ");
  command->add_option("-n", options->count, "How many points, such as 1000 or 1e6")->option_text("N");
  command->add_option("-d,--dim", options->dimension, "Dimension; each kind has its usual one")
      ->check(CLI::Range(1, 8))
      ->option_text("D");
  command->add_option("--seed", options->seed, "The same seed gives the same points on every machine [1]")
      ->check(CLI::NonNegativeNumber)
      ->option_text("S");
  command->add_option("--bits", options->bits, "Scale and round to integers 0 .. 2^B - 1")
      ->check(CLI::Range(1, 52))
      ->option_text("B");
  command->add_option("-o,--output", options->output, "File to write: .csv, .txt or .npy; - is stdout, as without -o")
      ->option_text("FILE");
  command->add_flag("--list", options->list, "List the kinds and what they are");
  command->footer(
      "Examples:\n"
      "  delone generate uniform -n 1e6 -d 3 -o points.npy\n"
      "  delone generate circle -n 500000 --bits 24 --seed 7 | delone triangulate - -o circle.png");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
