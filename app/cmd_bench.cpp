// delone bench: experiments of papers and comparisons with peers, run on this machine.
#include <cmath>
#include <filesystem>
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

std::optional<std::string> find_worker(const std::string& named) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  std::vector<fs::path> places{here / "bench_worker", here / "bench/bench_worker",
                               here.parent_path() / "build-bench/bench/bench_worker", "build-bench/bench/bench_worker"};
  if (!named.empty()) places = {named};
  for (const fs::path& place : places)
    if (fs::is_regular_file(place, ignored)) return fs::absolute(place).string();
  if (!named.empty()) throw UsageError("--worker " + named + ": there is no such program");
  return std::nullopt;
}

std::string require_worker(const std::string& named) {
  if (const auto found = find_worker(named)) return *found;
  throw UsageError(
      "there is no bench_worker beside delone or in build-bench: build it with `make bench-worker`, or name it with "
      "--worker");
}

std::size_t parse_size(const std::string& option, const std::string& text) {
  double number = -1;
  if (!CLI::detail::lexical_cast(text, number) || !(number >= 4 && number <= 1e9) || number != std::floor(number))
    throw UsageError(option + " " + text + ": expected a number of points, such as 50000 or 1e5");
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
  add_bench_fortune(*bench, chosen);
}

}  // namespace delone::cli
