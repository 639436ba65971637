// What the experiments of `delone bench` and `delone lab` share.
#pragma once

#include <optional>
#include <string>

#include "command.hpp"

namespace delone::cli {

// Each adds its experiment to `delone bench`.
void add_bench_devillers(CLI::App& bench, Command& chosen);
void add_bench_fortune(CLI::App& bench, Command& chosen);
void add_bench_peers(CLI::App& bench, Command& chosen);

/// The program that runs rivals: beside this one, or where the presets build it, unless somebody names it.
/// @throws UsageError when the named one is not there
std::optional<std::string> find_worker(const std::string& named);
/// @throws UsageError when there is none
std::string require_worker(const std::string& named);

/// A number of points, such as 5000 or 1e5. @throws UsageError naming the option
std::size_t parse_size(const std::string& option, const std::string& text);

/// Refuses files that can be seen to be unwritable; empty paths are none. @throws UsageError
void require_writable_outputs(const std::string& csv_path, const std::string& svg_path);

/// Writes each text where its path is not empty.
void write_outputs(const std::string& csv_path, const std::string& csv, const std::string& svg_path,
                   const std::string& svg);

}  // namespace delone::cli
