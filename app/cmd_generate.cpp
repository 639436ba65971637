// delone generate: points to try things with.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "command.hpp"
#include "delone/io/generate.hpp"
#include "output_file.hpp"

namespace delone::cli {
namespace {

struct Options {
  std::string kind, count, output = "-";
  int dimension = 0, bits = 0;
  std::uint64_t seed = 1;
  bool list = false;
};

enum class Form { text, npy };

Form form_of(const std::string& path) {
  if (path == "-") return Form::text;
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".npy") return Form::npy;
  if (extension == ".csv" || extension == ".txt") return Form::text;
  throw UsageError(path + ": points are written as .csv, .txt or .npy");
}

/// Whole numbers, also as 1e6.
std::size_t parse_count(const std::string& text) {
  double number = -1;
  if (!CLI::detail::lexical_cast(text, number) || !(number >= 0 && number <= 1e15) || number != std::floor(number))
    throw UsageError("-n " + text + ": expected how many points, such as 1000 or 1e6");
  return static_cast<std::size_t>(number);
}

std::string axis_name(int dimension, int axis) {
  if (dimension <= 3) return std::string(1, "xyz"[axis]);
  return fmt::format("x{}", axis + 1);
}

void write_text(OutputFile& file, const io::Generated& points) {
  fmt::memory_buffer text;
  const auto append = [&](auto&& value, bool last) {
    fmt::format_to(std::back_inserter(text), "{}{}", value, last ? '\n' : ',');
    if (text.size() > (std::size_t{1} << 16)) {
      file.write(text.data(), text.size());
      text.clear();
    }
  };
  const auto width = static_cast<std::size_t>(points.dimension);
  for (int axis = 0; axis < points.dimension; ++axis)
    append(axis_name(points.dimension, axis), axis + 1 == points.dimension);
  for (std::size_t i = 0; i < points.coordinates.size(); ++i) append(points.coordinates[i], i % width == width - 1);
  file.write(text.data(), text.size());
}

/// Format NPY 1.0: magic, length of the header, header padded to 64 bytes, data.
void write_npy(OutputFile& file, const io::Generated& points) {
  const std::size_t rows = points.coordinates.size() / static_cast<std::size_t>(points.dimension);
  const char order = std::endian::native == std::endian::little ? '<' : '>';
  std::string header =
      fmt::format("{{'descr': '{}f8', 'fortran_order': False, 'shape': ({}, {}), }}", order, rows, points.dimension);
  header.append((64 - (10 + header.size() + 1) % 64) % 64, ' ');
  header += '\n';
  const char start[] = {'\x93',
                        'N',
                        'U',
                        'M',
                        'P',
                        'Y',
                        1,
                        0,
                        static_cast<char>(header.size() % 256),
                        static_cast<char>(header.size() / 256)};
  file.write(start, sizeof start);
  file.write(header.data(), header.size());
  file.write(points.coordinates.data(), points.coordinates.size() * sizeof(double));
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
  const Form form = form_of(options.output);
  const std::size_t count = parse_count(options.count);
  OutputFile file(options.output);
  const io::Generated points = io::generate(options.kind, count, options.dimension, options.seed, options.bits);
  if (form == Form::npy) {
    write_npy(file, points);
  } else {
    write_text(file, points);
  }
  file.finish();
  return kDone;
}

}  // namespace

void add_generate(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("generate", "Make points to try things with: random, degenerate, worst cases");
  command->add_option("KIND", options->kind, joined(io::kinds()));
  command->add_option("-n", options->count, "How many points, such as 1000 or 1e6")->type_name("N");
  command->add_option("-d,--dim", options->dimension, "Dimension; each kind has its usual one")
      ->check(CLI::Range(1, 8))
      ->type_name("D");
  command->add_option("--seed", options->seed, "The same seed gives the same points on every machine [1]")
      ->type_name("S");
  command->add_option("--bits", options->bits, "Scale and round to integers 0 .. 2^B - 1")
      ->check(CLI::Range(1, 52))
      ->type_name("B");
  command->add_option("-o,--output", options->output, "File to write: .csv, .txt or .npy; - is stdout, as without -o")
      ->type_name("FILE");
  command->add_flag("--list", options->list, "List the kinds and what they are");
  command->footer(
      "\nExamples:\n"
      "  delone generate uniform -n 1e6 -d 3 -o points.npy\n"
      "  delone generate circle -n 500000 --bits 24 --seed 7 | delone triangulate - -o circle.png");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace delone::cli
