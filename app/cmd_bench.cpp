// delone bench: experiments of papers and comparisons with peers, run on this machine.
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "bench.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"

namespace delone::cli {
namespace {

void write_file(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

std::size_t parse_size(const std::string& text) {
  double number = -1;
  if (!CLI::detail::lexical_cast(text, number) || !(number >= 4 && number <= 1e9) || number != std::floor(number))
    throw UsageError("--sizes " + text + ": expected numbers of points, such as 5000,50000 or 1e5");
  return static_cast<std::size_t>(number);
}

void require_writable_outputs(const std::string& csv_path, const std::string& svg_path) {
  for (const std::string& path : {csv_path, svg_path})
    if (!path.empty()) require_writable(path);
}

void write_outputs(const std::string& csv_path, const std::string& csv, const std::string& svg_path,
                   const std::string& svg) {
  const DeferInterrupt defer;
  write_file(csv_path, csv);
  write_file(svg_path, svg);
}

void add_bench(CLI::App& app, Command& chosen) {
  CLI::App* bench = app.add_subcommand("bench", "Delone beside its peers, and experiments of papers, on this machine");
  bench->require_subcommand(1);
  add_bench_peers(*bench, chosen);
  add_bench_devillers(*bench, chosen);
}

}  // namespace delone::cli
