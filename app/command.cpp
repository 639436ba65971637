#include "command.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <thread>

#include "delone/base/ids.hpp"

namespace delone::cli {

namespace {

std::string without_blanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

io::ReadOptions PointInput::read_options() const {
  io::ReadOptions options;
  if (!format.empty()) {
    const auto known = io::point_format(format);
    if (!known) throw UsageError("--input-format " + format + ": expected text, npy, node, xyz, ply, obj or off");
    options.format = *known;
  }
  if (dimension != 0 && !columns.empty() && columns.size() != static_cast<std::size_t>(dimension))
    throw UsageError("--dim " + std::to_string(dimension) + " does not fit --columns " + joined(columns, ",") +
                     ", which names " + std::to_string(columns.size()));
  if (columns.size() > static_cast<std::size_t>(kMaxDimension))
    throw UsageError("--columns names " + std::to_string(columns.size()) + " columns, but points have at most " +
                     std::to_string(kMaxDimension) + " coordinates");
  for (const std::string& column : columns) options.columns.push_back(without_blanks(column));  // "x, y"
  options.weights = weights;
  options.radii = radii;
  options.dimension = dimension;
  return options;
}

void add_point_input(CLI::App& command, PointInput& input, const std::string& name) {
  command
      .add_option(name, input.path, "Points: text, .npy, .node, .xyz, .ply, .obj or .off, also with .gz; - reads stdin")
      ->required()
      ->option_text(" ");
  command.add_option("--columns", input.columns, "Columns of the coordinates, separated by commas")
      ->delimiter(',')
      ->expected(1, -1)
      ->allow_extra_args(false)
      ->option_text("COLUMN,...");
  auto* weights = command.add_option("--weights", input.weights, "Column of weights: a regular triangulation");
  auto* radii = command.add_option("--radii", input.radii, "Column of radii: the weight is the radius squared");
  weights->option_text("COLUMN")->excludes(radii);
  radii->option_text("COLUMN");
  command.add_option("--dim", input.dimension, "Demand this many coordinates")
      ->check(CLI::Range(1, kMaxDimension))
      ->option_text("D");
  command.add_option("--input-format", input.format, "Read as text, npy, node, xyz, ply, obj or off")
      ->option_text("FORMAT");
}

const io::Attribute& number_column(const io::PointTable& points, const std::string& option, const std::string& name) {
  std::vector<std::string> numeric;
  for (const io::Attribute& attribute : points.attributes) {
    const bool text = attribute.numbers.empty() && !attribute.texts.empty();
    if (text && attribute.name == name) throw UsageError(option + " " + name + ": this column holds text, not numbers");
    if (attribute.name == name) return attribute;
    if (!text) numeric.push_back(attribute.name);
  }
  throw UsageError(option + " " + name + ": no such column is left beside the coordinates; there " +
                   (numeric.empty() ? "is none" : "are " + joined(numeric)));
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Threads to use; all of the machine if not given")
      ->check(CLI::Range(1, 1024))
      ->option_text("N");
}

int thread_count(int asked) {
  if (asked > 0) return asked;
  const unsigned available = std::thread::hardware_concurrency();
  return available == 0 ? 1 : static_cast<int>(available);
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, ",");
  return digits;
}

std::string counted(std::uint64_t number, const std::string& singular, const std::string& plural) {
  return grouped(number) + " " + (number == 1 ? singular : plural);
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

bool stdout_closed() {
  pollfd descriptor{STDOUT_FILENO, 0, 0};
  return poll(&descriptor, 1, 0) == 1 && (descriptor.revents & POLLERR) != 0;
}

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return;
  const int error = errno;
  if (error == EPIPE || stdout_closed()) return;
  throw std::runtime_error(std::string("cannot write standard output: ") + std::strerror(error));
}

}  // namespace delone::cli
