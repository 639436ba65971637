// What the subcommands share: exit codes, the choice of a command, the options that say how points are read, and words.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "delone/base/stopwatch.hpp"
#include "delone/io/points_file.hpp"

namespace delone::cli {

inline constexpr int kDone = 0;
inline constexpr int kCheckFailed = 1;
inline constexpr int kBadInput = 2;

/// The command line asks for something that cannot be done; main prints the message and leaves with kBadInput.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Filled by the parser with the command that was chosen; returns an exit code.
using Command = std::function<int()>;

void add_triangulate(CLI::App& app, Command& chosen);
void add_hull(CLI::App& app, Command& chosen);
void add_voronoi(CLI::App& app, Command& chosen);
void add_info(CLI::App& app, Command& chosen);
void add_check(CLI::App& app, Command& chosen);
void add_nearest(CLI::App& app, Command& chosen);
void add_locate(CLI::App& app, Command& chosen);
void add_generate(CLI::App& app, Command& chosen);
void add_edit(CLI::App& app, Command& chosen);
void add_bench(CLI::App& app, Command& chosen);
void add_lab(CLI::App& app, Command& chosen);

/// How points are read; the same options in every command that reads some.
struct PointInput {
  std::string path;
  std::string format;
  std::vector<std::string> columns;
  std::string weights, radii;
  int dimension = 0;

  /// @throws UsageError before any file is opened
  io::ReadOptions read_options() const;
};

/// Adds the options of `input` to `command`; `name` is what help calls the file.
void add_point_input(CLI::App& command, PointInput& input, const std::string& name);

/// The attribute of this name, which must be one of numbers.
/// @throws UsageError naming the option and the columns that there are
const io::Attribute& number_column(const io::PointTable& points, const std::string& option, const std::string& name);

/// Adds --threads; 0 stands for all the machine has.
void add_threads(CLI::App& command, int& threads);
int thread_count(int asked);

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);
/// "1 cell", "2,000 cells".
std::string counted(std::uint64_t number, const std::string& singular, const std::string& plural);
/// "a, b, c".
std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ");

/// Prints to standard output. When nobody reads any more (a closed pipe) the rest is dropped.
/// @throws std::runtime_error when it cannot be written for another reason
void print(const std::string& text);
/// Is standard output a pipe that nobody reads any more?
bool stdout_closed();
/// Calls `write`; when that fails because nobody reads standard output any more, it is not an error.
template <class Write>
void unless_nobody_reads(const std::string& path, Write write) {
  try {
    write();
  } catch (const std::runtime_error&) {
    if (path != "-" || !stdout_closed()) throw;
  }
}

}  // namespace delone::cli
