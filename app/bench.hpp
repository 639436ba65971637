// What the experiments of `delone bench` share.
#pragma once

#include <string>

#include "command.hpp"

namespace delone::cli {

// Each adds its experiment to `delone bench`.
void add_bench_devillers(CLI::App& bench, Command& chosen);
void add_bench_peers(CLI::App& bench, Command& chosen);

/// A number of points, such as 5000 or 1e5. @throws UsageError
std::size_t parse_size(const std::string& text);

/// Refuses files that can be seen to be unwritable; empty paths are none. @throws UsageError
void require_writable_outputs(const std::string& csv_path, const std::string& svg_path);

/// Writes each text where its path is not empty.
void write_outputs(const std::string& csv_path, const std::string& csv, const std::string& svg_path,
                   const std::string& svg);

}  // namespace delone::cli
