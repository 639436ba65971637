// delone lab: what the papers' theorems say, beside what is counted here.
#include <fmt/format.h>

#include <memory>

#include "bench.hpp"
#include "command.hpp"
#include "delone/lab/experiment.hpp"
#include "progress.hpp"

namespace delone::cli {
namespace {

struct Options {
  std::string size;
  int runs = 0;
  std::uint64_t seed = 1;
  bool force = false, csv_to_stdout = false;
  std::string csv, svg;
};

constexpr double kPatience = 600;  // seconds

int run(const lab::Experiment& experiment, const Options& options) {
  require_writable_outputs(options.csv, options.svg);
  lab::LabOptions how;
  if (!options.size.empty()) how.n = parse_size("-n", options.size);
  how.runs = options.runs;
  how.seed = options.seed;
  if (const double seconds = experiment.seconds(how); seconds > kPatience && !options.force)
    throw UsageError(
        fmt::format("lab {}: this is likely to take about {:.0f} minutes; with --force it is done all the same",
                    experiment.name, std::ceil(seconds / 60)));
  ProgressBar bar(experiment.name);
  how.progress = bar.callback();
  const lab::LabReport report = experiment.run(how);
  print(to_words(report));
  write_outputs(
      options.csv, to_csv(report), options.svg,
      lab::draw_chart(report.chart_title, report.panels, report.panels.size() > 3 ? 3 : report.panels.size()));
  return kDone;
}

}  // namespace

void add_lab(CLI::App& app, Command& chosen) {
  CLI::App* lab = app.add_subcommand("lab", "The theorems of the papers, counted on this machine");
  lab->require_subcommand(1);
  for (const lab::Experiment& experiment : lab::experiments()) {
    auto options = std::make_shared<Options>();
    CLI::App* command = lab->add_subcommand(experiment.name, experiment.text);
    command->add_option("-n", options->size, "Points, such as 5000 or 1e5 [what suits the experiment]")
        ->option_text("N");
    command->add_option("--runs", options->runs, "Runs with other random numbers [what suits the experiment]")
        ->check(CLI::Range(1, 1000000))
        ->option_text("R");
    command->add_option("--seed", options->seed, "Of the random numbers [1]")
        ->check(CLI::NonNegativeNumber)
        ->option_text("S");
    command->add_flag("--force", options->force, "Run however long it takes");
    command->add_option("--csv", options->csv, "Write the numbers")->option_text("FILE");
    command->add_option("--svg", options->svg, "Draw them")->option_text("FILE");
    command->callback(
        [&experiment, options, &chosen] { chosen = [&experiment, options] { return run(experiment, *options); }; });
  }
}

}  // namespace delone::cli
